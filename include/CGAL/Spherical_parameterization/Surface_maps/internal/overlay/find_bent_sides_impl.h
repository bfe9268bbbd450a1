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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_FIND_BENT_SIDES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_FIND_BENT_SIDES_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Sphere_mesh.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/Triangle_sides.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/find_bent_sides.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/refine_in_common.h>

#include <algorithm>
#include <array>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code find_bent_sides(Surface_on_sphere first, Surface_on_sphere second, std::optional<std::size_t> max_vertices,
                           std::size_t max_edges, std::vector<std::size_t>& result, Run_control& control,
                           const Execution& execution)
{
  constexpr double part = 0.3; // of the sum
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
  std::vector<Weighted_side> longest; // with the energies of the faces
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
  std::vector<bool> is_chosen(sides.size(), false); // of the edges
  std::vector<Weighted_side> chosen;                // with their squared lengths
  for(std::size_t k = 0; k < longest.size() && left > 0. && chosen.size() < max_edges; ++k)
  {
    const auto [energy, side] = longest[k];
    left -= energy;
    if(!is_chosen[sides.edge(side)])
      chosen.emplace_back(squared_length_of(side), side);
    is_chosen[sides.edge(side)] = true;
  }
  // A face with two of them is halved at the longer one, whose halves are rounder.
  std::stable_sort(chosen.begin(), chosen.end(), has_more);
  for(const Weighted_side& side : chosen)
    result.push_back(side.second);
  return OK;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_FIND_BENT_SIDES_IMPL_H
