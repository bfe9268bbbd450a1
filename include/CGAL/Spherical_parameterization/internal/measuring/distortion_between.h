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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_BETWEEN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_BETWEEN_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/measuring/Triangle_stretch.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

inline Triangle_edges scaled_edges(const std::array<Vector_3d, 3>& p, double factor)
{
  return {factor * (p[2] - p[1]), factor * (p[0] - p[2]), factor * (p[1] - p[0])};
}

inline double triangle_area(const std::array<Vector_3d, 3>& p)
{
  return 0.5 * length(cross(p[1] - p[0], p[2] - p[0]));
}

// Of one measure: the largest value, and the means weighted with areas on the first surface and on the second one.
struct Weighted_statistics
{
  double maximum = 0.;
  std::array<double, 2> averages = {0., 0.};
};

struct Measured_map
{
  Weighted_statistics isometric, area, angle, energy;
  std::size_t number_of_slivers = 0;
};

// The distortion of a map that is linear in each of n triangles: corners_of(k, surface) are those of triangle k. What has a
// share of at most `smallest_area` of the area of a surface is a sliver and left out. If nothing is left, as where a surface
// has no area, all measures are infinite.
template <class Corners>
Measured_map distortion_between(std::size_t n, double smallest_area, const Corners& corners_of)
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
  std::array<std::vector<double>, 2> areas;
  std::array<double, 2> sums = {0., 0.};
  for(std::size_t surface = 0; surface < 2; ++surface)
    for(std::size_t k = 0; k < n; ++k)
    {
      areas[surface].push_back(triangle_area(corners(k, surface)));
      sums[surface] += areas[surface].back();
    }

  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double factor = std::sqrt(sums[0] / sums[1]); // of the lengths on the second surface
  Measured_map result;
  std::array<double, 2> weights = {0., 0.};
  for(std::size_t k = 0; k < n; ++k)
  {
    const std::array<double, 2> shares = {areas[0][k] / sums[0], areas[1][k] / sums[1]};
    const Triangle_stretch stretch(scaled_edges(corners(k, 0), 1.), scaled_edges(corners(k, 1), factor));
    if(!(shares[0] > smallest_area) || !(shares[1] > smallest_area) || stretch.is_degenerate())
    {
      ++result.number_of_slivers;
      continue;
    }
    const auto add = [&](Weighted_statistics& statistics, double value) {
      statistics.maximum = (std::max)(statistics.maximum, value);
      statistics.averages[0] += shares[0] * value;
      statistics.averages[1] += shares[1] * value;
    };
    add(result.isometric, stretch.isometric());
    add(result.area, stretch.area());
    add(result.angle, stretch.angle());
    add(result.energy, 0.5 * stretch.angle() * stretch.area()); // (I / d) (d + 1 / d) / 2
    weights[0] += shares[0];
    weights[1] += shares[1];
  }
  for(Weighted_statistics* statistics : {&result.isometric, &result.area, &result.angle, &result.energy})
    if(weights[0] > 0.)
      statistics->averages = {statistics->averages[0] / weights[0], statistics->averages[1] / weights[1]};
    else
      *statistics = {infinity, {infinity, infinity}};
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_BETWEEN_H
