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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_FIND_HANDLES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_FIND_HANDLES_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Repair/find_handles.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Finds handles of a closed connected surface, one after the other: a short closed path of edges that does not separate the
// surface, along which it is then cut. Both sides of the cut become faces of many corners, so that the genus is one less.
//
// A path is found by a tree and a cotree [Eppstein, Dynamic generators of topologically embedded graphs, 2003; Erickson and
// Whittlesey, Greedy optimal homotopy and homology generators, 2005]: a tree of shortest paths from a root on the edges, and one
// of faces across the other edges, those first that close the longest loops. The edges that neither tree uses are two for each
// handle, and each closes a loop with the tree that does not separate the surface; without the way to the root that both of its
// parts have in common, it is a simple path. The shortest is taken, and looked for again from its own middle, until it gets no
// shorter.
class Handle_finder
{
public:
  // The triangles are those of a closed connected mesh.
  Handle_finder(const std::vector<Linked_triangle>& triangles, std::vector<Vector_3d> points)
    : m_points(std::move(points))
    , m_origins(m_points.size())
    , m_n_faces(triangles.size())
  {
    std::iota(m_origins.begin(), m_origins.end(), 0u);
    m_into.resize(m_points.size());
    m_halfedges.reserve(3 * triangles.size());
    for(std::uint32_t t = 0; t < triangles.size(); ++t)
      for(std::uint32_t i = 0; i < 3; ++i)
      {
        // from corner i to the next one, across from corner i + 2
        const std::uint32_t other = triangles[t].neighbors[(i + 2) % 3];
        const std::uint32_t to = triangles[t][(i + 1) % 3];
        const std::uint32_t opposite = 3 * other + static_cast<std::uint32_t>(triangles[other].corner_of(to));
        m_halfedges.push_back({3 * t + (i + 1) % 3, opposite, to, t});
        m_into[to] = 3 * t + i;
      }
  }

  std::size_t genus() const
  {
    // Euler: V - E + F = 2 - 2 g
    return (2 + m_halfedges.size() / 2 - m_points.size() - m_n_faces) / 2;
  }

  // Finds a path around a handle, if there is one left, and cuts the surface along it.
  Handle_path find()
  {
    if(genus() == 0)
      return {};
    constexpr int max_rounds = 6;
    Loop best;
    Index root = 0;
    for(int round = 0; round < max_rounds; ++round)
    {
      Loop loop = shortest_loop(root);
      if(round > 0 && !(loop.length < best.length))
        break;
      best = std::move(loop);
      root = m_halfedges[best.halfedges[best.halfedges.size() / 2]].target;
    }
    Handle_path result;
    result.length = best.length;
    for(const Index h : best.halfedges)
      result.vertices.push_back(m_origins[m_halfedges[h].target]);
    cut(best.halfedges);
    return result;
  }

private:
  using Index = std::uint32_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  struct Halfedge
  {
    Index next, opposite, target, face;
  };

  struct Loop
  {
    std::vector<Index> halfedges; // each begins where the one before ends
    double length = 0.;
  };

  Index source(Index h) const { return m_halfedges[m_halfedges[h].opposite].target; }
  double length_of(Index h) const { return length(m_points[m_halfedges[h].target] - m_points[source(h)]); }

  // The shortest of the loops that a tree of shortest paths from the root leaves.
  Loop shortest_loop(Index root) const
  {
    const std::size_t n = m_points.size();
    std::vector<double> distances(n, (std::numeric_limits<double>::infinity)());
    std::vector<Index> arrivals(n, none); // the halfedge that a vertex is reached by
    std::vector<char> is_in_tree(m_halfedges.size(), 0);
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    distances[root] = 0.;
    queue.emplace(0., root);
    while(!queue.empty())
    {
      const auto [distance, v] = queue.top();
      queue.pop();
      if(distance > distances[v])
        continue;
      Index h = m_into[v];
      do
      {
        const Index out = m_halfedges[h].next, w = m_halfedges[out].target;
        const double d = distance + length_of(out);
        if(d < distances[w])
        {
          distances[w] = d;
          arrivals[w] = out;
          queue.emplace(d, w);
        }
        h = m_halfedges[out].opposite;
      } while(h != m_into[v]);
    }
    for(const Index h : arrivals)
      if(h != none)
        is_in_tree[h] = is_in_tree[m_halfedges[h].opposite] = 1;

    std::vector<std::pair<double, Index>> others; // length of the loop through the root, halfedge
    for(Index h = 0; h < m_halfedges.size(); ++h)
      if(h < m_halfedges[h].opposite && !is_in_tree[h])
        others.emplace_back(distances[source(h)] + distances[m_halfedges[h].target] + length_of(h), h);
    std::sort(others.begin(), others.end(), std::greater<std::pair<double, Index>>());
    std::vector<Index> roots(m_n_faces);
    std::iota(roots.begin(), roots.end(), 0u);
    const auto root_of = [&](Index f) {
      while(roots[f] != f)
        f = roots[f] = roots[roots[f]];
      return f;
    };
    Loop best;
    for(const auto& [loop_length, h] : others)
    {
      const Index f = root_of(m_halfedges[h].face), g = root_of(m_halfedges[m_halfedges[h].opposite].face);
      if(f != g)
      {
        roots[f] = g;
        continue;
      }
      Loop loop = loop_with(h, arrivals, distances);
      if(best.halfedges.empty() || loop.length < best.length)
        best = std::move(loop);
    }
    return best;
  }

  // The loop that an edge closes, without the way to the root that both of its parts have in common.
  Loop loop_with(Index h, const std::vector<Index>& arrivals, const std::vector<double>& distances) const
  {
    const auto way_to_root = [&](Index v) {
      std::vector<Index> result;
      for(; arrivals[v] != none; v = source(arrivals[v]))
        result.push_back(arrivals[v]);
      return result;
    };
    std::vector<Index> to_source = way_to_root(source(h)), to_target = way_to_root(m_halfedges[h].target);
    while(!to_source.empty() && !to_target.empty() && to_source.back() == to_target.back())
    {
      to_source.pop_back();
      to_target.pop_back();
    }
    Loop result;
    result.halfedges.assign(to_source.rbegin(), to_source.rend());
    result.halfedges.push_back(h);
    for(const Index arrival : to_target)
      result.halfedges.push_back(m_halfedges[arrival].opposite);
    const double common = to_source.empty() ? distances[source(h)] : distances[source(to_source.back())];
    result.length = distances[source(h)] + distances[m_halfedges[h].target] + length_of(h) - 2. * common;
    return result;
  }

  // Gives the left side of a simple path vertices of its own, and both sides a face.
  void cut(const std::vector<Index>& path)
  {
    const Index n = static_cast<Index>(path.size()), first_vertex = static_cast<Index>(m_points.size()),
                first = static_cast<Index>(m_halfedges.size()), left_face = static_cast<Index>(m_n_faces);
    m_n_faces += 2;
    for(Index k = 0; k < n; ++k)
    {
      const Index v = m_halfedges[path[k]].target;
      m_points.push_back(Vector_3d(m_points[v]));
      m_origins.push_back(Index(m_origins[v]));
    }
    // The halfedges to the left of the path that lead to its vertices, each from one edge of the path to the next one.
    for(Index k = 0; k < n; ++k)
    {
      const Index end = path[(k + 1) % n];
      for(Index h = path[k];; h = m_halfedges[m_halfedges[h].next].opposite)
      {
        m_halfedges[h].target = first_vertex + k;
        if(m_halfedges[h].next == end)
          break;
      }
      m_into.push_back(path[k]);
    }
    // The new ones: to the right of what is left of the path, backwards; and to the left of what is right of it.
    for(Index k = 0; k < n; ++k)
    {
      const Index before = (k + n - 1) % n, behind = (k + 1) % n, right = m_halfedges[path[k]].opposite;
      m_halfedges.push_back({first + 2 * before, path[k], first_vertex + before, left_face});
      m_halfedges.push_back(
          {first + 2 * behind + 1, right, m_halfedges[m_halfedges[path[behind]].opposite].target, left_face + 1});
    }
    for(Index k = 0; k < n; ++k)
    {
      const Index right = m_halfedges[path[k]].opposite;
      m_halfedges[right].opposite = first + 2 * k + 1;
      m_halfedges[path[k]].opposite = first + 2 * k;
      m_into[m_halfedges[right].target] = right;
    }
  }

  std::vector<Vector_3d> m_points;
  std::vector<Index> m_origins; // of the vertices: copies made by cuts have the numbers of the caller's
  std::vector<Index> m_into;    // a halfedge to each vertex
  std::vector<Halfedge> m_halfedges;
  std::size_t m_n_faces;
};

CGAL_SPHERICAL_PARAMETERIZATION_INLINE std::vector<Handle_path> find_handle_paths(const Index_triangles& triangles,
                                                                                  std::vector<Vector_3d> points,
                                                                                  std::size_t max_handles)
{
  const int exponent = normalize(points);
  const std::vector<Linked_triangle> linked = link_triangles(triangles, points.size());
  Handle_finder finder(linked, std::move(points));
  std::vector<Handle_path> result;
  while(result.size() < max_handles && finder.genus() > 0)
  {
    result.push_back(finder.find());
    result.back().length = std::ldexp(result.back().length, exponent);
  }
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_FIND_HANDLES_IMPL_H
