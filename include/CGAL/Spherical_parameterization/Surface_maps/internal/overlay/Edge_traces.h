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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_EDGE_TRACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_EDGE_TRACES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Sphere_mesh.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>

#include <CGAL/enum.h>

#include <atomic>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The index of a side of triangle t is 3 t + i if it is opposite to vertex i of the triangle, from vertex i + 1 to vertex i + 2. The index
// of an edge is that of its side in the triangle with the smaller index.
class Triangle_sides
{
public:
  using Index = std::uint32_t;

  explicit Triangle_sides(const std::vector<Linked_triangle>& triangles)
    : m_triangles(triangles)
  {}

  std::size_t size() const { return 3 * m_triangles.size(); }
  Index source(std::size_t side) const { return m_triangles[side / 3][(side % 3 + 1) % 3]; }
  Index target(std::size_t side) const { return m_triangles[side / 3][(side % 3 + 2) % 3]; }
  Index triangle(std::size_t side) const { return static_cast<Index>(side / 3); }
  Index opposite_triangle(std::size_t side) const { return m_triangles[side / 3].neighbors[side % 3]; }

  std::size_t opposite(std::size_t side) const
  {
    const Index t = opposite_triangle(side);
    return 3 * std::size_t(t) + m_triangles[t].side_of(triangle(side));
  }

  bool is_edge(std::size_t side) const { return triangle(side) < opposite_triangle(side); }
  std::size_t edge(std::size_t side) const { return is_edge(side) ? side : opposite(side); }

private:
  const std::vector<Linked_triangle>& m_triangles;
};

// For each edge of a triangulation, in the order of indices, the edges of the other one that it crosses, in order, and the triangles that
// it passes through, one more.
struct Edge_traces
{
  std::vector<std::size_t> ends; // of the crossed edges; the ends of the triangles of edge k are larger by k + 1
  std::vector<std::size_t> crossed;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> edges; // the indices of all edges, in increasing order
};

// Calls the control once in a fixed number of calls, every few milliseconds.
class Patience
{
public:
  explicit Patience(Run_control& control)
    : m_control(control)
  {}

  bool has_ended()
  {
    constexpr std::size_t calls = 1 << 14;
    return m_control.is_stopped() || (++m_n_calls % calls == 0 && !m_control.go_further(0, 0.));
  }

private:
  Run_control& m_control;
  std::size_t m_n_calls = 0;
};

// The triangles of `in` that contain the vertices of `of`, each found by a walk from the triangle of a neighbor; none for a vertex that
// is in no triangle, or if the control has stopped the run.
template <class Side>
std::vector<std::uint32_t> locate_vertices(const Sphere_mesh& of, const Sphere_mesh& in, const Side& side,
                                           Run_control& control)
{
  std::vector<std::uint32_t> result(of.points().size(), Sphere_mesh::none);
  Patience patience(control);
  visit_from_neighbors(of.triangles(), result.size(), Sphere_mesh::none, [&](std::uint32_t v, std::uint32_t w) {
    if(!patience.has_ended())
      result[v] = in.triangle_from(w == Sphere_mesh::none ? 0 : result[w], of.points()[v], side);
  });
  return result;
}

// An edge enters a triangle from an adjacent one, and leaves it through the side whose source is on its right and whose target is on its
// left: the orientation of one vertex determines this side. Crossings are counted while they are found, so that no more are stored than
// the bound allows. `located` are the triangles that contain the vertices.
template <class Side>
Error_code trace_edges(const Sphere_mesh& of, const Sphere_mesh& in, const std::vector<std::uint32_t>& located,
                       const Side& side, std::size_t max_vertices, Edge_traces& result, Run_control& control,
                       const Execution& execution)
{
  if(control.is_stopped())
    return ERROR_STOPPED;
  if(std::count(located.begin(), located.end(), Sphere_mesh::none) > 0)
    return ERROR_NO_1_TO_1_MAPPING;
  const std::size_t n_vertices = of.points().size() + in.points().size();
  if(n_vertices > max_vertices)
    return ERROR_TOO_LARGE_OVERLAY;
  const std::size_t max_crossings = max_vertices - n_vertices;
  std::atomic<std::size_t> n_crossings{0};
  constexpr std::size_t block_size = 256; // edges; at vertices of high degree, each may have thousands of crossings
  const Triangle_sides edges(of.triangles()), sides(in.triangles());
  for(std::size_t e = 0; e < edges.size(); ++e)
    if(edges.is_edge(e))
      result.edges.push_back(static_cast<std::uint32_t>(e));
  const std::size_t n = result.edges.size();
  struct Block
  {
    std::vector<std::size_t> counts, crossed;
    std::vector<std::uint32_t> triangles;
  };
  std::vector<Block> blocks((n + block_size - 1) / block_size);
  const auto trace = [&](std::size_t begin, std::size_t end) {
    Block& block = blocks[begin / block_size];
    for(std::size_t k = begin; k < end && n_crossings <= max_crossings; ++k)
    {
      const std::size_t e = result.edges[k];
      const auto &p = of.points()[edges.source(e)], &q = of.points()[edges.target(e)];
      const std::uint32_t last = located[edges.target(e)];
      std::uint32_t current = located[edges.source(e)];
      const std::size_t old_size = block.crossed.size();
      block.triangles.push_back(current);
      const auto is_left = [&](std::uint32_t v) { return side(p, q, in.points()[v]) == POSITIVE; };
      std::size_t exit = 0;
      if(current != last)
      {
        const Linked_triangle& t = in.triangles()[current];
        const std::array<bool, 3> left = {is_left(t[0]), is_left(t[1]), is_left(t[2])};
        while(exit < 2 && !(left[(exit + 2) % 3] && !left[(exit + 1) % 3]))
          ++exit;
      }
      while(current != last && block.crossed.size() - old_size < sides.size())
      {
        const std::size_t s = 3 * std::size_t(current) + exit;
        block.crossed.push_back(sides.edge(s));
        const std::size_t entry = sides.opposite(s);
        current = static_cast<std::uint32_t>(entry / 3);
        block.triangles.push_back(current);
        // The next side starts on the right and ends at the apex; the one after it ends on the left.
        exit = (entry % 3 + (is_left(in.triangles()[current][entry % 3]) ? 1 : 2)) % 3;
      }
      block.counts.push_back(block.crossed.size() - old_size);
      n_crossings += block.counts.back();
    }
  };
  if(!for_each_block_until_stopped(control, execution, n, block_size, trace))
    return ERROR_STOPPED;
  if(n_crossings > max_crossings)
    return ERROR_TOO_LARGE_OVERLAY;
  result.ends.reserve(n);
  for(const Block& block : blocks)
  {
    for(const std::size_t count : block.counts)
      result.ends.push_back((result.ends.empty() ? 0 : result.ends.back()) + count);
    result.crossed.insert(result.crossed.end(), block.crossed.begin(), block.crossed.end());
    result.triangles.insert(result.triangles.end(), block.triangles.begin(), block.triangles.end());
  }
  return OK;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_EDGE_TRACES_H
