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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_BORDER_CLOSER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_BORDER_CLOSER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Repair/internal/Glued_triangles.h>
#include <CGAL/Spherical_parameterization/Repair/internal/triangulate_path.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A surface under repair, and the sources of its vertices and triangles.
struct Repaired_triangles
{
  using Index = Glued_triangles::Index;

  Repaired_triangles() = default;
  Repaired_triangles(Glued_triangles triangles, std::vector<Vector_3d> all_points)
    : surface(std::move(triangles))
    , points(std::move(all_points))
    , vertices(points.size())
    , faces(surface.number_of_triangles())
    , patches(surface.number_of_triangles(), Glued_triangles::none)
  {
    std::iota(vertices.begin(), vertices.end(), 0u);
    std::iota(faces.begin(), faces.end(), 0u);
  }

  Glued_triangles surface;
  std::vector<Vector_3d> points;
  std::vector<Index> vertices; // for each vertex, the vertex of the input, or none
  std::vector<Index> faces;    // for each triangle, the polygon of the input that contains it, or none
  std::vector<Index> patches;  // for each triangle, its patch, or none

  Index add_vertex(const Vector_3d& p, Index source = Glued_triangles::none)
  {
    points.push_back(p);
    vertices.push_back(source);
    return static_cast<Index>(points.size() - 1);
  }

  Vector_3d middle_of(Index side) const
  {
    return 0.5 * points[surface.source(side)] + 0.5 * points[surface.target(side)];
  }

  double squared_length_of(Index side) const
  {
    return squared_length(points[surface.target(side)] - points[surface.source(side)]);
  }

  // Whether both triangles of a side belong to the same patch.
  bool is_of_patch(Index side) const
  {
    return patches[side / 3] != Glued_triangles::none && patches[side / 3] == patches[surface.mate(side) / 3];
  }

  double area_of(Index t) const
  {
    const auto [a, b, c] = surface.triangle(t);
    return 0.5 * doubled_area(points[a], points[b], points[c]);
  }

  // Splits a side at its midpoint. Returns the new vertex.
  Index split(Index side)
  {
    const Index t = side / 3, u = surface.mate(side) / 3, result = add_vertex(middle_of(side));
    surface.split(side, result);
    for(const Index triangle : {t, u})
    {
      faces.push_back(Index(faces[triangle]));
      patches.push_back(Index(patches[triangle]));
    }
    return result;
  }

  // Duplicates vertices so that each fan of triangles has its own. Returns the number of new vertices.
  std::size_t separate_fans()
  {
    const std::vector<Index> sources = surface.separate_fans(static_cast<Index>(points.size()));
    for(const Index v : sources)
      add_vertex(Vector_3d(points[v]), Index(vertices[v]));
    return sources.size();
  }
};

// Splits all but one of the edges that connect the same two vertices, those of patches first. Calls f(side) before each
// split. Afterwards, the surface is a simplicial complex.
template <class Function>
void split_repeated_edges(Repaired_triangles& mesh, const Function& f)
{
  using Index = Glued_triangles::Index;
  using Edge = std::tuple<std::uint64_t, bool, Index>; // the end points, whether it belongs to a patch, and a side
  for(bool has_changed = true; has_changed;)
  {
    std::vector<Edge> edges;
    edges.reserve(mesh.surface.number_of_sides() / 2);
    for(Index side = 0; side < mesh.surface.number_of_sides(); ++side)
      if(!mesh.surface.is_border(side) && side < mesh.surface.mate(side))
      {
        const auto [a, b] = std::minmax({mesh.surface.source(side), mesh.surface.target(side)});
        edges.emplace_back(std::uint64_t(a) << 32 | b, mesh.is_of_patch(side), side);
      }
    std::sort(edges.begin(), edges.end());
    has_changed = false;
    for(std::size_t k = 1; k < edges.size(); ++k)
      if(std::get<0>(edges[k]) == std::get<0>(edges[k - 1]))
      {
        f(std::get<Index>(edges[k]));
        mesh.split(std::get<Index>(edges[k]));
        has_changed = true;
      }
  }
}

// Closes borders by patches of triangles.
class Border_closer
{
public:
  using Index = Glued_triangles::Index;

  explicit Border_closer(Repaired_triangles& mesh)
    : m_mesh(mesh)
  {}

  // Closes a border, given by consecutive sides, with triangles between its vertices. Two sides are glued instead.
  // Returns the number of the patch, or none.
  Index close(const std::vector<Index>& border)
  {
    const std::size_t n = border.size();
    if(n == 2)
    {
      m_mesh.surface.glue(border[0], border[1]);
      return Glued_triangles::none;
    }
    // The patch has the opposite direction: its side k is glued to side n - 1 - k of the border.
    std::vector<Index> corners;
    for(std::size_t k = 0; k < n; ++k)
      corners.push_back(m_mesh.surface.target(border[n - 1 - k]));
    std::vector<Path_triangle> triangles;
    if(std::any_of(border.begin(), border.end(), [&](Index side) { return side / 3 != border[0] / 3; }))
    {
      std::vector<Vector_3d> path;
      for(const Index v : corners)
        path.push_back(m_mesh.points[v]);
      triangles = triangulate_path(path);
    }
    else // a single triangle: a patch without a new vertex would have the same corners
    {
      triangles = {{0, 1, n}, {1, 2, n}, {2, 0, n}};
      corners.push_back(m_mesh.add_vertex(0.5 * m_mesh.middle_of(border[0]) + 0.5 * m_mesh.middle_of(border[1])));
    }
    const Index patch = static_cast<Index>(m_first.size());
    m_first.push_back(m_mesh.surface.number_of_triangles());
    std::vector<std::pair<std::uint64_t, Index>> inner; // end points and number of each side between two triangles
    for(const Path_triangle& t : triangles)
    {
      const Index first = m_mesh.surface.add({corners[t[0]], corners[t[1]], corners[t[2]]});
      m_mesh.faces.push_back(Glued_triangles::none);
      m_mesh.patches.push_back(patch);
      for(std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t from = t[i], to = t[(i + 1) % 3];
        const Index side = first + static_cast<Index>(i);
        if(from < n && to == (from + 1) % n)
          m_mesh.surface.glue(side, border[n - 1 - from]);
        else
          inner.emplace_back(std::uint64_t((std::min)(from, to)) << 32 | (std::max)(from, to), side);
      }
    }
    std::sort(inner.begin(), inner.end());
    for(std::size_t k = 0; k + 1 < inner.size(); k += 2)
      m_mesh.surface.glue(inner[k].second, inner[k + 1].second);
    m_ends.push_back(m_mesh.surface.number_of_triangles());
    return patch;
  }

  // Splits the triangles of a patch until their sides are about as long as those of its border.
  void refine(Index patch)
  {
    constexpr int max_rounds = 200, flips_per_round = 3, smoothings = 8;
    std::vector<Index> triangles(m_ends[patch] - m_first[patch]);
    std::iota(triangles.begin(), triangles.end(), m_first[patch]);
    const auto is_inner = [&](Index side) { return m_mesh.patches[m_mesh.surface.mate(side) / 3] == patch; };
    m_sizes.resize(m_mesh.points.size());
    for(const Index t : triangles)
      for(const Index v : m_mesh.surface.triangle(t))
        m_sizes[v] = 0.;
    for(const Index t : triangles)
      for(Index side = 3 * t; side < 3 * t + 3; ++side)
        if(!is_inner(side)) // each border vertex has two such sides
        {
          const double half = 0.5 * std::sqrt(m_mesh.squared_length_of(side));
          m_sizes[m_mesh.surface.source(side)] += half;
          m_sizes[m_mesh.surface.target(side)] += half;
        }
    const Index first_vertex = static_cast<Index>(m_mesh.points.size());
    for(int round = 0; round < max_rounds; ++round)
    {
      const std::size_t n_before = triangles.size();
      for(std::size_t k = 0; k < n_before; ++k)
        for(Index side = 3 * triangles[k]; side < 3 * triangles[k] + 3; ++side)
          if(side < m_mesh.surface.mate(side) && is_inner(side) && is_long(side) && is_longest(side, is_inner))
            split(side, triangles);
      for(int flip = 0; flip < flips_per_round; ++flip)
        make_delaunay(triangles, is_inner);
      if(triangles.size() == n_before)
        break;
    }
    for(int k = 0; k < smoothings; ++k)
      smooth(triangles, first_vertex);
  }

private:
  bool is_long(Index side) const
  {
    constexpr double longest = 4. / 3.; // splitting shorter sides would not bring the lengths closer to the size
    const double size = 0.5 * (m_sizes[m_mesh.surface.source(side)] + m_sizes[m_mesh.surface.target(side)]);
    return m_mesh.squared_length_of(side) > longest * longest * size * size;
  }

  // Whether no other inner side of its two triangles is longer. Splitting only such sides creates no longer sides
  // (Rivara 1984).
  template <class Function>
  bool is_longest(Index side, const Function& is_inner) const
  {
    const double squared_length = m_mesh.squared_length_of(side);
    for(const Index s : {side, m_mesh.surface.mate(side)})
      for(const Index other : {Glued_triangles::next(s), Glued_triangles::previous(s)})
        if(is_inner(other) && m_mesh.squared_length_of(other) > squared_length)
          return false;
    return true;
  }

  void split(Index side, std::vector<Index>& triangles)
  {
    m_sizes.push_back(0.5 * (m_sizes[m_mesh.surface.source(side)] + m_sizes[m_mesh.surface.target(side)]));
    m_mesh.split(side);
    const Index n = m_mesh.surface.number_of_triangles();
    triangles.push_back(n - 2);
    triangles.push_back(n - 1);
  }

  // Flips sides whose opposite angles have a sum above 180 degrees if this makes them shorter. Therefore it terminates,
  // and no side that was split reappears.
  template <class Function>
  void make_delaunay(const std::vector<Index>& triangles, const Function& is_inner)
  {
    for(const Index t : triangles)
      for(Index side = 3 * t; side < 3 * t + 3; ++side)
        if(side < m_mesh.surface.mate(side) && is_inner(side) && is_to_be_flipped(side))
          m_mesh.surface.flip(side);
  }

  bool is_to_be_flipped(Index side) const
  {
    const Glued_triangles& surface = m_mesh.surface;
    const Index apex = surface.apex(side), other_apex = surface.apex(surface.mate(side));
    const Vector_3d &a = m_mesh.points[surface.source(side)], &b = m_mesh.points[surface.target(side)],
                    &c = m_mesh.points[apex], &d = m_mesh.points[other_apex];
    const double sine = dot(a - c, b - c) * doubled_area(a, b, d) + dot(a - d, b - d) * doubled_area(a, b, c);
    if(!(sine < 0.) || !(squared_length(c - d) < squared_length(a - b)) || apex == other_apex)
      return false;
    bool is_there = false; // whether the new side exists
    surface.for_each_corner(Glued_triangles::previous(side),
                            [&](Index k) { is_there = is_there || surface.target(k) == other_apex; });
    return !is_there;
  }

  // Moves each new vertex to the centroid of its neighbors.
  void smooth(const std::vector<Index>& triangles, Index first_vertex)
  {
    const std::size_t n = m_mesh.points.size() - first_vertex;
    std::vector<Vector_3d> sums(n, Vector_3d{0., 0., 0.});
    std::vector<double> counts(n, 0.);
    for(const Index t : triangles)
      for(Index side = 3 * t; side < 3 * t + 3; ++side)
        if(const Index v = m_mesh.surface.source(side); v >= first_vertex)
        {
          sums[v - first_vertex] = sums[v - first_vertex] + m_mesh.points[m_mesh.surface.target(side)];
          counts[v - first_vertex] += 1.;
        }
    for(std::size_t k = 0; k < n; ++k)
      m_mesh.points[first_vertex + k] = (1. / counts[k]) * sums[k];
  }

  Repaired_triangles& m_mesh;
  std::vector<Index> m_first, m_ends; // triangles of each patch, before refinement
  std::vector<double> m_sizes;        // edge lengths at the vertices of patches
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_BORDER_CLOSER_H
