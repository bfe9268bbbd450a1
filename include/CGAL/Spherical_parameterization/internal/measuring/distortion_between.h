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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_BETWEEN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_BETWEEN_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Distortion_between.h>
#include <CGAL/Spherical_parameterization/internal/measuring/Triangle_stretch.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

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

// The distortion of a map that is linear in each of n triangles: corners_of(k, surface) are those of triangle k.
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
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_BETWEEN_H
