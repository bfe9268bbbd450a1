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
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Finds the neighbours of the triangles of a closed mesh with n vertices, in linear time: each edge is looked for at its
// end with fewer triangles, and there are less than three edges for each vertex of a triangulated sphere, in all of its
// parts as well.
inline std::vector<Linked_triangle> link_triangles(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                                   std::size_t n)
{
  std::vector<std::uint32_t> degrees(n, 0);
  for(const auto& t : triangles)
    for(const std::uint32_t v : t)
      ++degrees[v];
  struct Side
  {
    std::uint32_t other_end, triangle, corner; // the corner is opposite to the edge
  };
  // The sides of edges whose neighbour has not been found, at most as many for each vertex as it has triangles.
  std::vector<std::size_t> ends(n, 0);
  for(std::size_t v = 1; v < n; ++v)
    ends[v] = ends[v - 1] + degrees[v - 1];
  const std::vector<std::size_t> begins = ends;
  std::vector<Side> open(3 * triangles.size());

  std::vector<Linked_triangle> result(triangles.size());
  for(std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    result[t].vertices = triangles[t];
    for(std::uint32_t i = 0; i < 3; ++i)
    {
      std::uint32_t a = triangles[t][(i + 1) % 3], b = triangles[t][(i + 2) % 3];
      if(degrees[a] > degrees[b] || (degrees[a] == degrees[b] && a > b))
        std::swap(a, b);
      std::size_t k = begins[a];
      while(k < ends[a] && open[k].other_end != b)
        ++k;
      if(k == ends[a])
        open[ends[a]++] = {b, t, i};
      else
      {
        result[t].neighbors[i] = open[k].triangle;
        result[open[k].triangle].neighbors[open[k].corner] = t;
        open[k] = open[--ends[a]];
      }
    }
  }
  return result;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_LINK_TRIANGLES_H
