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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_MEASURE_DISTORTION_BETWEEN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_MEASURE_DISTORTION_BETWEEN_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/overlay.h>

#include <array>
#include <cstddef>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// measures the distortion of the map between two surfaces, in each triangle of their common refinement.
///
/// \tparam TriangleMesh1,TriangleMesh2 the types of the surfaces
///
/// <b>Complexity.</b> The running time is linear in the number of triangles of the refinement.
///
/// \param overlay the refinement computed by `overlay()`
/// \param distortion receives the distortion; all measures are infinite if a surface has no area, or if all triangles are
///        excluded
/// \param smallest_area the fraction of the area: triangles with a smaller fraction of the area on one of the surfaces are
///        excluded and counted, because the measures of triangles caused by ties or rounding errors are meaningless
///
/// \return `OK`; `ERROR_EMPTY_MESH` if the refinement has no triangle; or `ERROR_WRONG_PARAMETER` if `smallest_area` is not in
///         \f$ [ 0, 1 ) \f$. `distortion` is not changed if an error is returned.
template <class TriangleMesh1, class TriangleMesh2>
Error_code measure_distortion_between(const Surface_overlay_3<TriangleMesh1, TriangleMesh2>& overlay,
                                      Distortion_between& distortion, double smallest_area = 1e-10)
{
  if(!(smallest_area >= 0. && smallest_area < 1.))
    return ERROR_WRONG_PARAMETER;
  if(overlay.triangles.empty())
    return ERROR_EMPTY_MESH;
  std::array<std::vector<internal::Vector_3d>, 2> points;
  for(std::size_t surface = 0; surface < 2; ++surface)
    for(const auto& corresponding : overlay.points)
    {
      const auto& p = corresponding[surface];
      points[surface].push_back({p.x(), p.y(), p.z()});
    }
  distortion = internal::distortion_between(points, overlay.triangles, smallest_area);
  return OK;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_MEASURE_DISTORTION_BETWEEN_H
