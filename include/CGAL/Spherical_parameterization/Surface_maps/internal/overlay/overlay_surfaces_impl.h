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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_SURFACES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_SURFACES_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/overlay_surfaces.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/refine_in_common.h>
#include <CGAL/Spherical_parameterization/internal/measuring/distortion.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code make_overlay(Surface_on_sphere first, Surface_on_sphere second, std::optional<std::size_t> max_vertices,
                        Overlay_arrays& overlay, Run_control& control, const Execution& execution)
{
  Sphere_mesh sphere1, sphere2;
  sphere1.assign(std::move(first.images), std::move(first.triangles));
  sphere2.assign(std::move(second.images), std::move(second.triangles));
  return refine_in_common(sphere1, first.points, sphere2, second.points, max_vertices, overlay, control, execution);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Distortion_between distortion_between(const std::array<std::vector<Vector_3d>, 2>& points,
                                      const Index_triangles& triangles, double smallest_area,
                                      const Execution& execution, std::vector<double>* bending)
{
  constexpr std::size_t block_size = 4096; // about 0.3 ms
  const std::size_t n = triangles.size(), n_blocks = (n + block_size - 1) / block_size;
  const auto for_all_blocks = [&](const auto& f) {
    for_each_block(execution, 0, n, block_size,
                   [&](std::size_t begin, std::size_t end) { f(begin / block_size, begin, end); });
  };
  // Points are scaled by powers of two, which is exact, so that areas neither overflow nor underflow.
  std::array<int, 2> exponents = {0, 0};
  for(std::size_t surface = 0; surface < 2; ++surface)
  {
    double size = 0.;
    for(const Vector_3d& p : points[surface])
      size = (std::max)({size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    std::frexp(size, &exponents[surface]);
  }
  const auto corners = [&](std::size_t k, std::size_t surface) {
    std::array<Vector_3d, 3> result;
    for(std::size_t i = 0; i < 3; ++i)
    {
      result[i] = points[surface][triangles[k][i]];
      if(exponents[surface] != 0)
        for(double& x : result[i])
          x = std::ldexp(x, -exponents[surface]);
    }
    return result;
  };
  std::vector<std::array<double, 2>> areas(n), of_blocks(n_blocks, {0., 0.});
  for_all_blocks([&](std::size_t block, std::size_t begin, std::size_t end) {
    for(std::size_t k = begin; k < end; ++k)
      for(std::size_t surface = 0; surface < 2; ++surface)
      {
        const std::array<Vector_3d, 3> p = corners(k, surface);
        areas[k][surface] = 0.5 * length(cross(p[1] - p[0], p[2] - p[0]));
        of_blocks[block][surface] += areas[k][surface];
      }
  });
  std::array<double, 2> sums = {0., 0.};
  for(const std::array<double, 2>& of_block : of_blocks)
    for(std::size_t surface = 0; surface < 2; ++surface)
      sums[surface] += of_block[surface];
  if(bending)
    bending->assign(n, 0.);

  struct Part
  {
    Distortion_between distortion; // sums instead of means
    std::array<double, 2> weights = {0., 0.};
  };
  using Statistics = Distortion_between::Statistics;
  constexpr std::array<Statistics Distortion_between::*, 4> measures = {
      &Distortion_between::isometric, &Distortion_between::area, &Distortion_between::angle,
      &Distortion_between::energy};
  const double factor = std::sqrt(sums[0] / sums[1]); // the scale of lengths on the second surface
  std::vector<Part> parts(n_blocks);
  for_all_blocks([&](std::size_t block, std::size_t begin, std::size_t end) {
    Part part;
    for(std::size_t k = begin; k < end; ++k)
    {
      const std::array<double, 2> shares = {areas[k][0] / sums[0], areas[k][1] / sums[1]};
      const Triangle_stretch stretch(scaled_edges(corners(k, 0), 1.), scaled_edges(corners(k, 1), factor));
      if(!(shares[0] > smallest_area) || !(shares[1] > smallest_area) || stretch.is_degenerate)
      {
        ++part.distortion.number_of_slivers;
        continue;
      }
      const double energy = 0.5 * stretch.angle * stretch.area; // (I / d) (d + 1 / d) / 2
      const std::array<double, 4> values = {stretch.isometric, stretch.area, stretch.angle, energy};
      for(std::size_t i = 0; i < 4; ++i)
      {
        Statistics& statistics = part.distortion.*measures[i];
        statistics.maximum = (std::max)(statistics.maximum, values[i]);
        statistics.average_over_first += shares[0] * values[i];
        statistics.average_over_second += shares[1] * values[i];
      }
      part.weights[0] += shares[0];
      part.weights[1] += shares[1];
      if(bending)
        (*bending)[k] = 0.5 * (shares[0] + shares[1]) * logarithm(0.5 * energy);
    }
    parts[block] = part;
  });
  Part all;
  for(const Part& part : parts)
  {
    for(const auto measure : measures)
    {
      Statistics& sum = all.distortion.*measure;
      const Statistics& more = part.distortion.*measure;
      sum = {(std::max)(sum.maximum, more.maximum), sum.average_over_first + more.average_over_first,
             sum.average_over_second + more.average_over_second};
    }
    for(std::size_t surface = 0; surface < 2; ++surface)
      all.weights[surface] += part.weights[surface];
    all.distortion.number_of_slivers += part.distortion.number_of_slivers;
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for(const auto measure : measures)
  {
    Statistics& s = all.distortion.*measure;
    s = all.weights[0] > 0.
            ? Statistics{s.maximum, s.average_over_first / all.weights[0], s.average_over_second / all.weights[1]}
            : Statistics{infinity, infinity, infinity};
  }
  all.distortion.number_of_triangles = n;
  return all.distortion;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code find_bent_sides(Surface_on_sphere first, Surface_on_sphere second, std::optional<std::size_t> max_vertices,
                           std::size_t max_edges, std::vector<std::size_t>& result, Run_control& control,
                           const Execution& execution)
{
  constexpr double part = 0.3; // the fraction of the sum
  Sphere_mesh sphere, other_sphere;
  sphere.assign(std::move(first.images), std::move(first.triangles));
  other_sphere.assign(std::move(second.images), std::move(second.triangles));
  Overlay_arrays overlay;
  if(const Error_code error =
         refine_in_common(sphere, first.points, other_sphere, second.points, max_vertices, overlay, control, execution))
    return error;
  std::vector<double> bending, energies(sphere.triangles().size(), 0.);
  distortion_between(overlay.points, overlay.triangles, default_smallest_area, execution, &bending);
  for(std::size_t k = 0; k < bending.size(); ++k)
    energies[overlay.parents[k][0]] += bending[k];

  const Triangle_sides sides(sphere.triangles());
  const auto squared_length_of = [&](std::size_t side) {
    return squared_length(sphere.direction(sides.target(side)) - sphere.direction(sides.source(side)));
  };
  using Weighted_side = std::pair<double, std::size_t>;
  const auto has_more = [](const Weighted_side& a, const Weighted_side& b) { return a.first > b.first; };
  std::vector<Weighted_side> longest; // the longest side of each face, with the energy of the face
  double left = 0.;
  for(std::size_t t = 0; t < energies.size(); ++t)
    if(energies[t] > 0. && is_finite(energies[t]))
    {
      const std::array<std::size_t, 3> all = {3 * t + 2, 3 * t, 3 * t + 1};
      longest.emplace_back(energies[t], *std::max_element(all.begin(), all.end(), [&](std::size_t a, std::size_t b) {
                             return squared_length_of(a) < squared_length_of(b);
                           }));
      left += part * energies[t];
    }
  std::stable_sort(longest.begin(), longest.end(), has_more);
  std::vector<bool> is_chosen(sides.size(), false); // for each edge
  std::vector<Weighted_side> chosen;                // the selected sides, with their squared lengths
  for(std::size_t k = 0; k < longest.size() && left > 0. && chosen.size() < max_edges; ++k)
  {
    const auto [energy, side] = longest[k];
    left -= energy;
    if(!is_chosen[sides.edge(side)])
      chosen.emplace_back(squared_length_of(side), side);
    is_chosen[sides.edge(side)] = true;
  }
  // A face with two selected edges is halved at the longer one, which yields rounder halves.
  std::stable_sort(chosen.begin(), chosen.end(), has_more);
  for(const Weighted_side& side : chosen)
    result.push_back(side.second);
  return OK;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_SURFACES_IMPL_H
