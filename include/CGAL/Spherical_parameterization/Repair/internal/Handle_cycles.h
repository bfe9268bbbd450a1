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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_HANDLE_CYCLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_HANDLE_CYCLES_H

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

// Disjoint cycles on a closed connected surface along which it can be cut simultaneously without becoming disconnected.
// Each cut removes a handle.
//
// A tree of shortest paths from a vertex, and a tree of the dual graph that crosses none of its edges, leave 2 g edges.
// Each of these edges closes a cycle, and the cycles generate the first homology (tree-cotree decomposition; Eppstein
// 2003). If the dual tree takes the edges of long cycles first, the cycles are the shortest such cycles through the
// vertex (Erickson and Whittlesey 2005). Cycles of this basis without common vertices are independent, so no union of
// them separates the surface.
class Handle_cycles
{
public:
  using Index = Glued_triangles::Index;
  using Cycle = std::vector<Index>; // consecutive sides

  explicit Handle_cycles(const Repaired_triangles& mesh)
    : m_mesh(mesh)
    , m_surface(mesh.surface)
    , m_points(mesh.points)
    , m_corners(mesh.points.size(), Glued_triangles::none)
  {
    for(Index corner = m_surface.number_of_sides(); corner-- > 0;)
      m_corners[m_surface.source(corner)] = corner;
  }

  // From Euler's formula, V - E + F = 2 - 2 g.
  std::size_t genus() const
  {
    const auto n = static_cast<std::size_t>(
        std::count_if(m_corners.begin(), m_corners.end(), [](Index c) { return c != Glued_triangles::none; }));
    return (2 + m_surface.number_of_sides() / 2 - n - m_surface.number_of_triangles()) / 2;
  }

  // Finds the next cycles to cut, at least one if the surface has a handle. Cycles whose filling has a small area are
  // preferred. If there are few cycles, only the best one is returned, improved by trees from its own vertices. If
  // there are many, those with a much larger area than the others are postponed, since the next tree may give better
  // ones.
  std::vector<Cycle> find() const
  {
    constexpr std::size_t few = 4;
    constexpr int max_tightenings = 3;
    constexpr double large = 4.; // relative to the median
    std::vector<Costly_cycle> cycles = disjoint_cycles(m_surface.source(0));
    if(cycles.size() > few)
    {
      const double limit = large * cycles[cycles.size() / 2].first;
      while(cycles.back().first > limit)
        cycles.pop_back();
    }
    else if(!cycles.empty())
    {
      cycles.resize(1);
      for(int k = 0; k < max_tightenings; ++k)
      {
        const Cycle& cycle = cycles[0].second;
        Costly_cycle other = std::move(disjoint_cycles(m_surface.source(cycle[cycle.size() / 2])).front());
        if(!(other.first < cycles[0].first))
          break;
        cycles[0] = std::move(other);
      }
    }
    std::vector<Cycle> result;
    for(Costly_cycle& cycle : cycles)
      result.push_back(std::move(cycle.second));
    return result;
  }

  double length_of(const Cycle& cycle) const
  {
    return std::accumulate(cycle.begin(), cycle.end(), 0.,
                           [&](double sum, Index side) { return sum + length_of(side); });
  }

private:
  using Costly_cycle = std::pair<double, Cycle>; // the area of a fill of one side, and the cycle

  struct Tree
  {
    std::vector<double> distances;
    std::vector<Index> arrivals; // the side of the tree that ends at a vertex
  };

  // Triangles of patches are not part of the input surface, so no cycle may cross a patch.
  double length_of(Index side) const
  {
    return m_mesh.is_of_patch(side) ? (std::numeric_limits<double>::infinity)()
                                    : std::sqrt(m_mesh.squared_length_of(side));
  }

  // area of the triangles between the cycle and its centroid
  double area_across(const Cycle& cycle) const
  {
    Vector_3d center = {0., 0., 0.};
    for(const Index side : cycle)
      center = center + (1. / static_cast<double>(cycle.size())) * m_points[m_surface.source(side)];
    double result = 0.;
    for(const Index side : cycle)
      result += 0.5 * doubled_area(center, m_points[m_surface.source(side)], m_points[m_surface.target(side)]);
    return result;
  }

  // Cycles without common vertices, from a tree with this root, chosen in ascending order of area.
  std::vector<Costly_cycle> disjoint_cycles(Index root) const
  {
    std::vector<Costly_cycle> cycles;
    for(Cycle& cycle : cycles_of_basis(root))
      cycles.emplace_back(area_across(cycle), std::move(cycle));
    std::stable_sort(cycles.begin(), cycles.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<char> is_taken(m_points.size(), 0);
    const auto crosses_other = [&](const Costly_cycle& cycle) {
      if(std::any_of(cycle.second.begin(), cycle.second.end(),
                     [&](Index side) { return is_taken[m_surface.source(side)]; }))
        return true;
      for(const Index side : cycle.second)
        is_taken[m_surface.source(side)] = 1;
      return false;
    };
    std::vector<Costly_cycle> result;
    for(Costly_cycle& cycle : cycles)
      if(!crosses_other(cycle))
        result.push_back(std::move(cycle));
    return result;
  }

  // Dijkstra's algorithm
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

  std::vector<Cycle> cycles_of_basis(Index root) const
  {
    const Tree tree = shortest_paths(root);
    std::vector<char> is_in_tree(m_surface.number_of_sides(), 0);
    for(const Index side : tree.arrivals)
      if(side != Glued_triangles::none)
        is_in_tree[side] = is_in_tree[m_surface.mate(side)] = 1;
    std::vector<std::pair<double, Index>> others; // length of the cycle through the root, and side
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
    std::vector<Cycle> result;
    for(const auto& [cycle_length, side] : others)
    {
      const Index t = root_of(side / 3), u = root_of(m_surface.mate(side) / 3);
      if(t == u)
        result.push_back(cycle_with(side, tree.arrivals));
      roots[t] = u;
    }
    return result;
  }

  // The cycle that an edge closes, without the path to the root that is common to both of its parts.
  Cycle cycle_with(Index side, const std::vector<Index>& arrivals) const
  {
    const auto way_to_root = [&](Index v) {
      Cycle result;
      for(; arrivals[v] != Glued_triangles::none; v = m_surface.source(arrivals[v]))
        result.push_back(arrivals[v]);
      return result;
    };
    Cycle to_source = way_to_root(m_surface.source(side)), to_target = way_to_root(m_surface.target(side));
    while(!to_source.empty() && !to_target.empty() && to_source.back() == to_target.back())
    {
      to_source.pop_back();
      to_target.pop_back();
    }
    Cycle result(to_source.rbegin(), to_source.rend());
    result.push_back(side);
    for(const Index arrival : to_target)
      result.push_back(m_surface.mate(arrival));
    return result;
  }

  const Repaired_triangles& m_mesh;
  const Glued_triangles& m_surface;
  const std::vector<Vector_3d>& m_points;
  std::vector<Index> m_corners; // one corner of each vertex
};

// Cuts at most `max_handles` handles of a closed connected surface. Calls on_cut(cycle, length) before each cut, and
// close(border) for both of its sides afterwards.
template <class On_cut, class Close>
void cut_handles(Repaired_triangles& mesh, std::size_t max_handles, const On_cut& on_cut, const Close& close)
{
  std::size_t n_cut = 0;
  while(n_cut < max_handles)
  {
    const Handle_cycles handles(mesh);
    if(handles.genus() == 0)
      return;
    std::vector<Handle_cycles::Cycle> cycles = handles.find();
    if(cycles.size() > max_handles - n_cut)
      cycles.resize(max_handles - n_cut);
    n_cut += cycles.size();
    for(const Handle_cycles::Cycle& cycle : cycles)
    {
      on_cut(cycle, handles.length_of(cycle));
      for(const Glued_triangles::Index side : cycle)
        mesh.surface.cut(side);
    }
    mesh.separate_fans();
    for(const std::vector<Glued_triangles::Index>& border : mesh.surface.borders())
      close(border);
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_HANDLE_CYCLES_H
