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

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/overlay.h>
#include <CGAL/Spherical_parameterization/internal/measuring/distortion.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <array>
#include <cstddef>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// The distortion of a map between two surfaces, both scaled to the same area. With \f$ s_1 \leq s_2 \f$ the singular values
/// of its linear part in a triangle, all measures are the same for the map and for its inverse; their averages are weighted
/// with areas, and so they depend on which of the two surfaces that is.
struct Distortion_between
{
  /// Statistics of one measure
  struct Statistics
  {
    double maximum = 0.;             ///< The largest value
    double average_over_first = 0.;  ///< The mean, weighted with areas on the first surface
    double average_over_second = 0.; ///< The mean, weighted with areas on the second surface
  };

  Statistics isometric; ///< \f$ \max(s_2, 1 / s_1) \f$
  Statistics area;      ///< \f$ s_1 s_2 + 1 / (s_1 s_2) \f$
  Statistics angle;     ///< \f$ s_1 / s_2 + s_2 / s_1 \f$
  Statistics energy;    ///< \f$ ( s_1^2 + s_2^2 + 1 / s_1^2 + 1 / s_2^2 ) / 2 \f$, the symmetric Dirichlet energy

  std::size_t number_of_triangles = 0; ///< All triangles of the refinement
  std::size_t number_of_slivers = 0;   ///< Those that are left out because they are too small
};

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// measures the distortion of the map between two surfaces, in each triangle of their common refinement.
///
/// \tparam TriangleMesh1,TriangleMesh2 the types of the surfaces
///
/// \param overlay the refinement, made by `overlay()`
/// \param distortion receives the distortion; all measures are infinite if a surface has no area, or all triangles are left out
/// \param smallest_area triangles with less than this share of the area on one of the surfaces are left out, and counted:
///        of those that ties or rounding make, nothing can be said
///
/// \return `OK`; `ERROR_EMPTY_MESH` if the refinement has no triangle, `ERROR_WRONG_PARAMETER` if `smallest_area` is not in
///         \f$ [ 0, 1 ) \f$, and `distortion` is as it was
template <class TriangleMesh1, class TriangleMesh2>
Error_code measure_distortion_between(const Surface_overlay_3<TriangleMesh1, TriangleMesh2>& overlay,
                                      Distortion_between& distortion, double smallest_area = 1e-10)
{
  if(!(smallest_area >= 0. && smallest_area < 1.))
    return ERROR_WRONG_PARAMETER;
  if(overlay.triangles.empty())
    return ERROR_EMPTY_MESH;
  const internal::Measured_map measured =
      internal::distortion_between(overlay.triangles.size(), smallest_area, [&](std::size_t k, std::size_t surface) {
        std::array<internal::Vector_3d, 3> corners;
        for(std::size_t i = 0; i < 3; ++i)
        {
          const auto& p = overlay.points[overlay.triangles[k][i]][surface];
          corners[i] = {p.x(), p.y(), p.z()};
        }
        return corners;
      });
  const auto statistics = [](const internal::Weighted_statistics& of) {
    return Distortion_between::Statistics{of.maximum, of.averages[0], of.averages[1]};
  };
  distortion = {statistics(measured.isometric), statistics(measured.area), statistics(measured.angle),
                statistics(measured.energy),    overlay.triangles.size(),  measured.number_of_slivers};
  return OK;
}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_BETWEEN_H
