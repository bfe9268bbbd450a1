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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_FILL_HOLES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_FILL_HOLES_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Repair/fill_holes.h>
#include <CGAL/Spherical_parameterization/Repair/internal/Border_closer.h>

#include <cmath>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Border_patches close_borders(const Index_triangles& triangles,
                                                                    const std::vector<std::uint32_t>& mates,
                                                                    std::vector<Vector_3d> points,
                                                                    const std::vector<Border_sides>& borders)
{
  using Index = Glued_triangles::Index;
  const std::size_t n_vertices = points.size();
  Vector_3d origin;
  const int exponent = normalize(points, &origin);
  Repaired_triangles mesh(Glued_triangles(triangles, mates), std::move(points));
  Border_closer closer(mesh);
  std::vector<Index> patches;
  for(const Border_sides& border : borders)
    patches.push_back(closer.close(border));
  for(const Index patch : patches)
    closer.refine(patch);
  split_repeated_edges(mesh, [](Index) {});

  Border_patches result;
  for(std::size_t v = n_vertices; v < mesh.points.size(); ++v)
  {
    const Vector_3d& p = mesh.points[v];
    result.points.push_back(
        origin + Vector_3d{std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent)});
  }
  std::vector<std::size_t> sizes(patches.size() + 1, 0);
  for(const Index patch : mesh.patches)
    if(patch != Glued_triangles::none)
      ++sizes[patch + 1];
  std::partial_sum(sizes.begin(), sizes.end(), sizes.begin());
  result.first = sizes;
  result.triangles.resize(sizes.back());
  for(Index t = 0; t < mesh.surface.number_of_triangles(); ++t)
    if(mesh.patches[t] != Glued_triangles::none)
      result.triangles[sizes[mesh.patches[t]]++] = mesh.surface.triangle(t);
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_FILL_HOLES_IMPL_H
