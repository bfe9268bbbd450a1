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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_LINKED_TRIANGLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_LINKED_TRIANGLE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/Large_array.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Triangles as triples of vertex indices.
using Index_triangles = std::vector<std::array<std::uint32_t, 3>>;

// A triangle of a closed mesh: neighbor i is across the edge that is opposite to vertex i.
struct Linked_triangle
{
  std::array<std::uint32_t, 3> vertices, neighbors;

  std::uint32_t operator[](std::size_t i) const { return vertices[i]; }

  // The corner with this vertex, or opposite to this neighbor; the last one if it is none of the others.
  std::size_t corner_of(std::uint32_t vertex) const { return place_of(vertex, vertices); }
  std::size_t side_of(std::uint32_t triangle) const { return place_of(triangle, neighbors); }

  static std::size_t place_of(std::uint32_t number, const std::array<std::uint32_t, 3>& numbers)
  {
    return numbers[0] == number ? 0 : numbers[1] == number ? 1 : 2;
  }
};

// Finds the neighbors of the triangles of a closed mesh with n vertices, in linear time: each edge is searched for at
// its end with fewer triangles, and a triangulated sphere has fewer than three edges per vertex, in all of its parts as
// well. Returns an empty vector unless each edge has two triangles with opposite directions, and no two edges have the
// same ends.
inline std::vector<Linked_triangle> link_triangles(const Index_triangles& triangles, std::size_t n)
{
  std::vector<std::uint32_t> degrees(n, 0);
  for(const auto& t : triangles)
    for(const std::uint32_t v : t)
      ++degrees[v];
  // Without the branches of a comparison of pairs.
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
  Large_array<Side> first_sides(3 * triangles.size(), boost::container::default_init);
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

// Calls visit(v, w) for each vertex v of a closed connected mesh with n vertices, where w is a neighbor of v that has
// been visited before, and `none` for the first vertex: so results for w can be used for v.
template <class Visit>
void visit_from_neighbors(const std::vector<Linked_triangle>& triangles, std::size_t n, std::uint32_t none,
                          const Visit& visit)
{
  std::vector<bool> is_reached(triangles.size(), false), is_visited(n, false);
  std::vector<std::uint32_t> stack = {0};
  is_reached[0] = true;
  std::uint32_t visited = none;
  while(!stack.empty())
  {
    const Linked_triangle& t = triangles[stack.back()];
    stack.pop_back();
    for(const std::uint32_t v : t.vertices)
      if(is_visited[v])
        visited = v;
    for(const std::uint32_t v : t.vertices)
      if(!is_visited[v])
      {
        visit(v, visited);
        is_visited[v] = true;
        visited = v;
      }
    for(const std::uint32_t neighbor : t.neighbors)
      if(!is_reached[neighbor])
      {
        is_reached[neighbor] = true;
        stack.push_back(neighbor);
      }
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_LINKED_TRIANGLE_H
