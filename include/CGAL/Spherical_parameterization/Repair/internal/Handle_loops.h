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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_HANDLE_LOOPS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_HANDLE_LOOPS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Repair/internal/Border_closer.h>
#include <CGAL/Spherical_parameterization/Repair/internal/Glued_triangles.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Closed paths on a closed connected surface along which it can be cut all at once without falling apart: each cut removes a handle.
//
// A tree of shortest paths from a vertex, and a tree of the dual graph that crosses none of its edges, leave 2 g edges. Each of them
// closes a loop, and these generate the first homology (tree-cotree decomposition; Eppstein 2003); where the dual tree takes the edges of
// long loops first, they are the shortest such loops through the vertex (Erickson and Whittlesey 2005). Any of them that have no vertex
// in common are independent, so no union of them separates the surface.
class Handle_loops
{
public:
  using Index = Glued_triangles::Index;
  using Loop = std::vector<Index>; // sides, each of which begins where the one before ends

  explicit Handle_loops(const Repaired_triangles& mesh)
    : m_mesh(mesh)
    , m_surface(mesh.surface)
    , m_points(mesh.points)
    , m_corners(mesh.points.size(), Glued_triangles::none)
  {
    for(Index corner = m_surface.number_of_sides(); corner-- > 0;)
      m_corners[m_surface.source(corner)] = corner;
  }

  // Half of what Euler's formula leaves: V - E + F = 2 - 2 g.
  std::size_t genus() const
  {
    const auto n = static_cast<std::size_t>(
        std::count_if(m_corners.begin(), m_corners.end(), [](Index c) { return c != Glued_triangles::none; }));
    return (2 + m_surface.number_of_sides() / 2 - n - m_surface.number_of_triangles()) / 2;
  }

  // Loops along which the surface is to be cut next, at least one if it has a handle. They close with little area: where there are
  // few left, the least one is tightened, by trees from its own vertices; of many, those are left for later that take much more area
  // than the others, as the next tree may have better ones.
  std::vector<Loop> find() const
  {
    constexpr std::size_t few = 4;
    constexpr int max_tightenings = 3;
    constexpr double large = 4.; // over the median
    std::vector<Costly_loop> loops = disjoint_loops(m_surface.source(0));
    if(loops.size() > few)
    {
      const double limit = large * loops[loops.size() / 2].first;
      while(loops.back().first > limit)
        loops.pop_back();
    }
    else if(!loops.empty())
    {
      loops.resize(1);
      for(int k = 0; k < max_tightenings; ++k)
      {
        const Loop& loop = loops[0].second;
        Costly_loop other = std::move(disjoint_loops(m_surface.source(loop[loop.size() / 2])).front());
        if(!(other.first < loops[0].first))
          break;
        loops[0] = std::move(other);
      }
    }
    std::vector<Loop> result;
    for(Costly_loop& loop : loops)
      result.push_back(std::move(loop.second));
    return result;
  }

  double length_of(const Loop& loop) const
  {
    return std::accumulate(loop.begin(), loop.end(), 0., [&](double sum, Index side) { return sum + length_of(side); });
  }

private:
  using Costly_loop = std::pair<double, Loop>; // the area that one side of it takes to be closed

  struct Tree
  {
    std::vector<double> distances;
    std::vector<Index> arrivals; // the side that a vertex is reached by
  };

  // No loop leads across a patch, whose triangles are no part of the surface.
  double length_of(Index side) const
  {
    return m_mesh.is_of_patch(side) ? (std::numeric_limits<double>::infinity)()
                                    : std::sqrt(m_mesh.squared_length_of(side));
  }

  // of triangles from the centre of the loop
  double area_across(const Loop& loop) const
  {
    Vector_3d center = {0., 0., 0.};
    for(const Index side : loop)
      center = center + (1. / static_cast<double>(loop.size())) * m_points[m_surface.source(side)];
    double result = 0.;
    for(const Index side : loop)
      result += 0.5 * doubled_area(center, m_points[m_surface.source(side)], m_points[m_surface.target(side)]);
    return result;
  }

  // Loops without a vertex in common, those first that close with least area, all of them by a tree from a root.
  std::vector<Costly_loop> disjoint_loops(Index root) const
  {
    std::vector<Costly_loop> loops;
    for(Loop& loop : loops_of_basis(root))
      loops.emplace_back(area_across(loop), std::move(loop));
    std::stable_sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<char> is_taken(m_points.size(), 0);
    const auto crosses_other = [&](const Costly_loop& loop) {
      if(std::any_of(loop.second.begin(), loop.second.end(),
                     [&](Index side) { return is_taken[m_surface.source(side)]; }))
        return true;
      for(const Index side : loop.second)
        is_taken[m_surface.source(side)] = 1;
      return false;
    };
    std::vector<Costly_loop> result;
    for(Costly_loop& loop : loops)
      if(!crosses_other(loop))
        result.push_back(std::move(loop));
    return result;
  }

  // Dijkstra's
  Tree shortest_paths(Index root) const
  {
    Tree tree = {std::vector<double>(m_points.size(), (std::numeric_limits<double>::infinity)()),
                 std::vector<Index>(m_points.size(), Glued_triangles::none)};
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    tree.distances[root] = 0.;
    queue.emplace(0., root);
    while(!queue.empty())
    {
      const auto [distance, v] = queue.top();
      queue.pop();
      if(distance > tree.distances[v])
        continue;
      m_surface.for_each_corner(m_corners[v], [&, distance = distance](Index side) {
        const Index w = m_surface.target(side);
        const double d = distance + length_of(side);
        if(d < tree.distances[w])
        {
          tree.distances[w] = d;
          tree.arrivals[w] = side;
          queue.emplace(d, w);
        }
      });
    }
    return tree;
  }

  std::vector<Loop> loops_of_basis(Index root) const
  {
    const Tree tree = shortest_paths(root);
    std::vector<char> is_in_tree(m_surface.number_of_sides(), 0);
    for(const Index side : tree.arrivals)
      if(side != Glued_triangles::none)
        is_in_tree[side] = is_in_tree[m_surface.mate(side)] = 1;
    std::vector<std::pair<double, Index>> others; // length of the loop through the root, side
    for(Index side = 0; side < m_surface.number_of_sides(); ++side)
      if(side < m_surface.mate(side) && !is_in_tree[side])
        others.emplace_back(
            tree.distances[m_surface.source(side)] + tree.distances[m_surface.target(side)] + length_of(side), side);
    std::sort(others.begin(), others.end(), std::greater<std::pair<double, Index>>());
    std::vector<Index> roots(m_surface.number_of_triangles());
    std::iota(roots.begin(), roots.end(), 0u);
    const auto root_of = [&](Index t) {
      while(roots[t] != t)
        t = roots[t] = Index(roots[roots[t]]);
      return t;
    };
    std::vector<Loop> result;
    for(const auto& [loop_length, side] : others)
    {
      const Index t = root_of(side / 3), u = root_of(m_surface.mate(side) / 3);
      if(t == u)
        result.push_back(loop_with(side, tree.arrivals));
      roots[t] = u;
    }
    return result;
  }

  // The loop that an edge closes, without the way to the root that both of its parts have in common.
  Loop loop_with(Index side, const std::vector<Index>& arrivals) const
  {
    const auto way_to_root = [&](Index v) {
      Loop result;
      for(; arrivals[v] != Glued_triangles::none; v = m_surface.source(arrivals[v]))
        result.push_back(arrivals[v]);
      return result;
    };
    Loop to_source = way_to_root(m_surface.source(side)), to_target = way_to_root(m_surface.target(side));
    while(!to_source.empty() && !to_target.empty() && to_source.back() == to_target.back())
    {
      to_source.pop_back();
      to_target.pop_back();
    }
    Loop result(to_source.rbegin(), to_source.rend());
    result.push_back(side);
    for(const Index arrival : to_target)
      result.push_back(m_surface.mate(arrival));
    return result;
  }

  const Repaired_triangles& m_mesh;
  const Glued_triangles& m_surface;
  const std::vector<Vector_3d>& m_points;
  std::vector<Index> m_corners; // of the vertices, one each
};

// Cuts at most so many handles of a closed connected surface. Calls on_cut(loop, length) for each cut before, and close(border) for
// both of its sides afterwards.
template <class On_cut, class Close>
void cut_handles(Repaired_triangles& mesh, std::size_t max_handles, const On_cut& on_cut, const Close& close)
{
  std::size_t n_cut = 0;
  while(n_cut < max_handles)
  {
    const Handle_loops handles(mesh);
    if(handles.genus() == 0)
      return;
    std::vector<Handle_loops::Loop> loops = handles.find();
    if(loops.size() > max_handles - n_cut)
      loops.resize(max_handles - n_cut);
    n_cut += loops.size();
    for(const Handle_loops::Loop& loop : loops)
    {
      on_cut(loop, handles.length_of(loop));
      for(const Glued_triangles::Index side : loop)
        mesh.surface.cut(side);
    }
    mesh.separate_fans();
    for(const std::vector<Glued_triangles::Index>& border : mesh.surface.borders())
      close(border);
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_HANDLE_LOOPS_H
