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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_LINK_TRIANGLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_LINK_TRIANGLES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/sampling/Sphere_triangulation.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Finds the neighbours of the triangles of a closed mesh with n vertices, in linear time: each edge is looked for at its
// end with fewer triangles, and there are less than three edges for each vertex of a triangulated sphere, in all of its
// parts as well. Returns nothing if the sides of triangles are not paired, in opposite directions.
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
  // The sides of edges whose neighbour has not been found, at most as many for each vertex as it has triangles.
  const std::unique_ptr<Side[]> open(new Side[3 * triangles.size()]);
  std::vector<Range> open_at(n);
  for(std::uint32_t v = 0, begin = 0; v < n; begin += degrees[v++])
    open_at[v] = {begin, begin};
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
      Range& sides = open_at[a];
      std::uint32_t k = sides.begin;
      while(k < sides.end && open[k].other_end != b)
        ++k;
      if(k == sides.end)
      {
        if(k == sides.begin + degrees[a])
          return {};
        open[sides.end++] = {b, 4 * t + i};
        ++n_open;
        continue;
      }
      const std::uint32_t s = open[k].corner / 4, j = open[k].corner % 4;
      if(from == triangles[s][(j + 1) % 3])
        return {};
      result[t].neighbors[i] = s;
      result[s].neighbors[j] = t;
      open[k] = open[--sides.end];
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

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_LINK_TRIANGLES_H
