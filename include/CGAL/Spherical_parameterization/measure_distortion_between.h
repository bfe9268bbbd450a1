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

#include <CGAL/Spherical_parameterization/Surface_overlay_3.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Triangle_stretch.h>
#include <CGAL/Spherical_parameterization/internal/simd/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// \file measure_distortion_between.h

namespace CGAL {
namespace Spherical_parameterization {

namespace internal {

inline Triangle_edges scaled_edges(const std::array<Vector_3d, 3>& p, double factor)
{
  return {factor * (p[2] - p[1]), factor * (p[0] - p[2]), factor * (p[1] - p[0])};
}

inline double triangle_area(const std::array<Vector_3d, 3>& p)
{
  return 0.5 * length(cross(p[1] - p[0], p[2] - p[0]));
}

} // namespace internal

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

namespace internal {

// The same of n triangles: corners_of(k, surface) are those of triangle k.
template <class Corners>
Distortion_between distortion_between(std::size_t n, double smallest_area, const Corners& corners_of)
{
  // Scaled by powers of two, which is exact, so that no area overflows or underflows.
  std::array<int, 2> exponents = {0, 0};
  for(std::size_t surface = 0; surface < 2; ++surface)
  {
    double size = 0.;
    for(std::size_t k = 0; k < n; ++k)
      for(const Vector_3d& p : corners_of(k, surface))
        size = (std::max)({size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    std::frexp(size, &exponents[surface]);
  }
  const auto corners = [&](std::size_t k, std::size_t surface) {
    std::array<Vector_3d, 3> result = corners_of(k, surface);
    if(exponents[surface] != 0)
      for(Vector_3d& p : result)
        for(double& x : p)
          x = std::ldexp(x, -exponents[surface]);
    return result;
  };
  Distortion_between result;
  result.number_of_triangles = n;
  std::array<std::vector<double>, 2> areas;
  std::array<double, 2> sums = {0., 0.};
  for(std::size_t surface = 0; surface < 2; ++surface)
    for(std::size_t k = 0; k < n; ++k)
    {
      areas[surface].push_back(triangle_area(corners(k, surface)));
      sums[surface] += areas[surface].back();
    }
  if(!(sums[0] > 0.) || !(sums[1] > 0.))
    return result;

  const double factor = std::sqrt(sums[0] / sums[1]); // of the lengths on the second surface
  std::array<double, 2> weights = {0., 0.};
  const auto add = [](Distortion_between::Statistics& statistics, double value, double weight1, double weight2) {
    statistics.maximum = (std::max)(statistics.maximum, value);
    statistics.average_over_first += weight1 * value;
    statistics.average_over_second += weight2 * value;
  };
  for(std::size_t k = 0; k < n; ++k)
  {
    const double w1 = areas[0][k] / sums[0], w2 = areas[1][k] / sums[1];
    const Triangle_stretch stretch(scaled_edges(corners(k, 0), 1.), scaled_edges(corners(k, 1), factor));
    if(!(w1 > smallest_area) || !(w2 > smallest_area) || stretch.is_degenerate())
    {
      ++result.number_of_slivers;
      continue;
    }
    weights[0] += w1;
    weights[1] += w2;
    add(result.isometric, stretch.isometric(), w1, w2);
    add(result.area, stretch.area(), w1, w2);
    add(result.angle, stretch.angle(), w1, w2);
    add(result.energy, 0.5 * stretch.angle() * stretch.area(), w1, w2); // (I / d) (d + 1 / d) / 2
  }
  if(!(weights[0] > 0.))
    return result;
  for(auto* statistics : {&result.isometric, &result.area, &result.angle, &result.energy})
  {
    statistics->average_over_first /= weights[0];
    statistics->average_over_second /= weights[1];
  }
  return result;
}

} // namespace internal

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
