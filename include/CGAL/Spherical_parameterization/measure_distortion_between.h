// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_BETWEEN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_BETWEEN_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_overlay_3.h>
#include <CGAL/Spherical_parameterization/internal/measuring/distortion_between.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <array>
#include <cstddef>

/// \file measure_distortion_between.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// measures the distortion of the map between two surfaces, in each triangle of their common refinement.
///
/// \tparam TriangleMesh1 the type of the first surface
/// \tparam TriangleMesh2 the type of the second one
///
/// \param overlay the refinement, made by `overlay()`
/// \param smallest_area triangles with less than this share of the area on one of the surfaces are left out, and counted:
///        of those that ties or rounding make, nothing can be said
///
/// \return the distortion; all measures are 0 if a surface has no area, or if all triangles are left out
template <class TriangleMesh1, class TriangleMesh2>
Distortion_between measure_distortion_between(const Surface_overlay_3<TriangleMesh1, TriangleMesh2>& overlay,
                                              double smallest_area = 1e-10)
{
  return internal::distortion_between(overlay.triangles.size(), smallest_area, [&](std::size_t k, std::size_t surface) {
    std::array<internal::Vector_3d, 3> corners;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const auto& p = overlay.points[overlay.triangles[k][i]][surface];
      corners[i] = {p.x(), p.y(), p.z()};
    }
    return corners;
  });
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_BETWEEN_H
