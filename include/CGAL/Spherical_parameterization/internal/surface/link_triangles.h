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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_LINK_TRIANGLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_LINK_TRIANGLES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Finds the neighbours of the triangles of a closed mesh with n vertices, in linear time: each edge is looked for at its
// end with fewer triangles, and there are less than three edges for each vertex of a triangulated sphere, in all of its
// parts as well. Returns nothing unless each edge has two triangles, in opposite directions.
inline std::vector<Linked_triangle> link_triangles(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                                   std::size_t n)
{
  std::vector<std::uint32_t> degrees(n, 0);
  for(const auto& t : triangles)
    for(const std::uint32_t v : t)
      ++degrees[v];
  // without the branches that comparing pairs would take
  const auto rank = [&](std::uint32_t v) { return std::uint64_t(degrees[v]) << 32 | v; };
  struct Side
  {
    std::uint32_t other_end, corner; // opposite to the edge: 4 t + i for the corner i of the triangle t
  };
  struct Range
  {
    std::uint32_t begin, end;
  };
  constexpr std::uint32_t is_paired = (std::numeric_limits<std::uint32_t>::max)();
  // The first side of each edge, at most as many for each vertex as it has triangles.
  const std::unique_ptr<Side[]> first_sides(new Side[3 * triangles.size()]);
  std::vector<Range> sides_at(n);
  for(std::uint32_t v = 0, begin = 0; v < n; begin += degrees[v++])
    sides_at[v] = {begin, begin};
  std::size_t n_open = 0;

  std::vector<Linked_triangle> result(triangles.size());
  for(std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    result[t].vertices = triangles[t];
    for(std::uint32_t i = 0; i < 3; ++i)
    {
      const std::uint32_t from = triangles[t][(i + 1) % 3], to = triangles[t][(i + 2) % 3];
      const bool is_from = rank(from) < rank(to);
      const std::uint32_t a = is_from ? from : to, b = is_from ? to : from;
      Range& sides = sides_at[a];
      std::uint32_t k = sides.begin;
      while(k < sides.end && first_sides[k].other_end != b)
        ++k;
      if(k == sides.end)
      {
        if(k == sides.begin + degrees[a])
          return {};
        first_sides[sides.end++] = {b, 4 * t + i};
        ++n_open;
        continue;
      }
      std::uint32_t& corner = first_sides[k].corner;
      const std::uint32_t s = corner / 4, j = corner % 4;
      if(corner == is_paired || from == triangles[s][(j + 1) % 3])
        return {};
      result[t].neighbors[i] = s;
      result[s].neighbors[j] = t;
      corner = is_paired;
      --n_open;
    }
  }
  if(n_open > 0)
    return {};
  return result;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_LINK_TRIANGLES_H
