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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_SOUP_GLUER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_SOUP_GLUER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Repair/internal/Glued_triangles.h>
#include <CGAL/Spherical_parameterization/Repair/internal/triangulate_path.h>
#include <CGAL/Spherical_parameterization/Repair/repair_surface.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Builds an oriented surface from any polygons by gluing the sides of triangles. An edge with two faces glues these.
// For an edge with more faces, faces that are connected around one of its ends are glued first, followed by those of
// the largest components.
class Soup_gluer
{
public:
  using Index = Glued_triangles::Index;
  static constexpr Index none = Glued_triangles::none;

  Soup_gluer(const std::vector<Vector_3d>& points, const Polygon_corners& polygons, Repair_report& report)
    : m_points(points)
    , m_polygons(polygons)
    , m_report(report)
    , m_merged(points.size())
  {
    std::iota(m_merged.begin(), m_merged.end(), 0u);
    make_triangles();
    std::vector<Side> sides = sorted_sides();
    if(merge_vertices_on_borders(sides))
    {
      make_triangles();
      sides = sorted_sides();
    }
    const std::vector<Index> mates = orient(sides);
    glue(sides, mates);
  }

  Glued_triangles surface;
  std::vector<Index> faces; // for each triangle, its polygon

private:
  // A side: its end points, the smaller one first, and its number.
  using Side = std::pair<std::uint64_t, Index>;

  Index corner_of(std::size_t polygon, std::size_t k) const
  {
    return m_merged[m_polygons.corners[m_polygons.first[polygon] + k]];
  }

  // Triangulates the polygons, and omits degenerate and duplicate triangles.
  void make_triangles()
  {
    m_triangles.clear();
    faces.clear();
    m_report.triangulated_polygons = m_report.degenerate_faces = m_report.repeated_faces = Repair_count();
    std::vector<Index> corners;
    for(std::size_t f = 0; f + 1 < m_polygons.first.size(); ++f)
    {
      const std::size_t size = m_polygons.first[f + 1] - m_polygons.first[f];
      corners.clear();
      for(std::size_t k = 0; k < size; ++k)
        if(corner_of(f, k) != corner_of(f, k + 1 < size ? k + 1 : 0))
          corners.push_back(corner_of(f, k));
      if(corners.size() < 3)
        m_report.degenerate_faces.add(f);
      else if(corners.size() == 3)
        add_triangle(f, {corners[0], corners[1], corners[2]});
      else
      {
        m_report.triangulated_polygons.add(f);
        divide(f, corners);
      }
    }
    remove_repeated_triangles();
  }

  void add_triangle(std::size_t polygon, const std::array<Index, 3>& triangle)
  {
    if(triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      return;
    m_triangles.push_back(triangle);
    faces.push_back(static_cast<Index>(polygon));
  }

  void divide(std::size_t polygon, const std::vector<Index>& corners)
  {
    std::vector<Vector_3d> path;
    for(const Index v : corners)
      path.push_back(m_points[v]);
    for(const auto& [a, b, c] : triangulate_path(path))
      add_triangle(polygon, {corners[a], corners[b], corners[c]});
  }

  void remove_repeated_triangles()
  {
    std::vector<std::pair<std::array<Index, 3>, Index>> sorted;
    sorted.reserve(m_triangles.size());
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
    {
      sorted.emplace_back(m_triangles[t], static_cast<Index>(t));
      std::sort(sorted.back().first.begin(), sorted.back().first.end());
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<char> is_repeated(m_triangles.size(), 0);
    for(std::size_t k = 1; k < sorted.size(); ++k)
      is_repeated[sorted[k].second] = sorted[k].first == sorted[k - 1].first;
    std::size_t n = 0;
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      if(is_repeated[t])
        m_report.repeated_faces.add(faces[t]);
      else
      {
        m_triangles[n] = m_triangles[t];
        faces[n++] = Index(faces[t]);
      }
    m_triangles.resize(n);
    faces.resize(n);
  }

  std::vector<Side> sorted_sides() const
  {
    std::vector<Side> sides;
    sides.reserve(3 * m_triangles.size());
    for(Index t = 0; t < m_triangles.size(); ++t)
      for(Index i = 0; i < 3; ++i)
      {
        const auto [a, b] = std::minmax(m_triangles[t][i], m_triangles[t][(i + 1) % 3]);
        sides.emplace_back(std::uint64_t(a) << 32 | b, 3 * t + i);
      }
    std::sort(sides.begin(), sides.end());
    return sides;
  }

  // Calls f(begin, end) for the sides of each edge.
  template <class Function>
  static void for_each_edge(const std::vector<Side>& sides, const Function& f)
  {
    for(std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
    {
      while(end < sides.size() && sides[end].first == sides[begin].first)
        ++end;
      f(begin, end);
    }
  }

  // Merges border vertices at the same point; elsewhere, coincident vertices are no defect. Returns whether there are
  // any.
  bool merge_vertices_on_borders(const std::vector<Side>& sides)
  {
    std::vector<Index> vertices;
    for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
      if(end == begin + 1)
        for(const std::uint64_t v : {sides[begin].first >> 32, sides[begin].first & 0xffffffff})
          vertices.push_back(static_cast<Index>(v));
    });
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::stable_sort(vertices.begin(), vertices.end(), [&](Index a, Index b) { return m_points[a] < m_points[b]; });
    for(std::size_t k = 1; k < vertices.size(); ++k)
      if(m_points[vertices[k]] == m_points[vertices[k - 1]])
      {
        m_merged[vertices[k]] = Index(m_merged[vertices[k - 1]]);
        m_report.merged_vertices.add(vertices[k]);
      }
    return m_report.merged_vertices.number > 0;
  }

  // Reverses triangles so that triangles that share an edge of two faces have consistent orientations. Each component
  // keeps the orientation of most of its area, or is oriented outwards if this is less than two thirds. Returns the
  // mates of the sides.
  std::vector<Index> orient(std::vector<Side>& sides)
  {
    const std::size_t n = m_triangles.size();
    std::vector<Index> mates(3 * n, none), stack;
    for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
      if(end == begin + 2)
      {
        mates[sides[begin].second] = sides[begin + 1].second;
        mates[sides[begin + 1].second] = sides[begin].second;
      }
    });
    const auto source = [&](Index side) { return m_triangles[side / 3][side % 3]; };
    enum : char
    {
      unknown,
      kept,
      reversed
    };
    std::vector<char> state(n, unknown);
    for(Index start = 0; start < n; ++start)
    {
      if(state[start] != unknown)
        continue;
      std::vector<Index> part;
      std::array<double, 3> areas = {0., 0., 0.};
      state[start] = kept;
      stack = {start};
      while(!stack.empty())
      {
        const Index t = stack.back();
        stack.pop_back();
        part.push_back(t);
        areas[static_cast<std::size_t>(state[t])] += area_of(t);
        for(Index side = 3 * t; side < 3 * t + 3; ++side)
        {
          const Index mate = mates[side];
          if(mate == none)
            continue;
          const char expected = (source(side) == source(mate)) == (state[t] == kept) ? reversed : kept;
          if(state[mate / 3] == unknown)
          {
            state[mate / 3] = expected;
            stack.push_back(mate / 3);
          }
          else if(state[mate / 3] != expected) // a one-sided component, such as a Möbius strip
            mates[side] = mates[mate] = none;
        }
      }
      const auto [less, more] = std::minmax(areas[kept], areas[reversed]);
      if(2. * less > more ? volume_of(part, [&](Index t) { return state[t] == reversed; }) < 0.
                          : areas[reversed] > areas[kept])
        for(const Index t : part)
          state[t] = state[t] == kept ? reversed : kept;
    }
    for(Index t = 0; t < n; ++t)
      if(state[t] == reversed)
      {
        std::swap(m_triangles[t][1], m_triangles[t][2]);
        m_report.reversed_faces.add(faces[t]);
      }
    const auto turned = [&](Index side) {
      return side == none || state[side / 3] == kept || side % 3 == 1 ? side : side % 3 == 0 ? side + 2 : side - 2;
    };
    for(Side& side : sides)
      side.second = turned(side.second);
    std::vector<Index> result(3 * n);
    for(Index side = 0; side < 3 * n; ++side)
      result[turned(side)] = turned(mates[side]);
    return result;
  }

  // Six times the volume between the triangles and their centroid, if some of them are reversed.
  template <class Function>
  double volume_of(const std::vector<Index>& part, const Function& is_reversed) const
  {
    Vector_3d middle = {0., 0., 0.};
    for(const Index t : part)
      for(const Index v : m_triangles[t])
        middle = middle + (1. / (3. * static_cast<double>(part.size()))) * m_points[v];
    double result = 0.;
    for(const Index t : part)
    {
      const auto& [a, b, c] = m_triangles[t];
      const double volume = dot(m_points[a] - middle, cross(m_points[b] - middle, m_points[c] - middle));
      result += is_reversed(t) ? -volume : volume;
    }
    return result;
  }

  double area_of(Index t) const
  {
    const auto& [a, b, c] = m_triangles[t];
    return 0.5 * doubled_area(m_points[a], m_points[b], m_points[c]);
  }

  void glue(const std::vector<Side>& sides, const std::vector<Index>& mates)
  {
    surface = Glued_triangles(m_triangles);
    for(Index side = 0; side < mates.size(); ++side)
      if(mates[side] != none && mates[side] > side)
        surface.glue(side, mates[side]);
    std::vector<Index> crowded; // sides of edges with more than two faces
    for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
      if(end <= begin + 2)
        return;
      m_report.non_manifold_edges.add(static_cast<std::size_t>(sides[begin].first >> 32));
      for(std::size_t k = begin; k < end; ++k)
        crowded.push_back(sides[k].second);
    });
    zip(crowded);
    glue_largest(crowded);
  }

  // Glues consecutive border sides with opposite end points, repeatedly.
  void zip(std::vector<Index> sides)
  {
    while(!sides.empty())
    {
      const Index side = sides.back();
      sides.pop_back();
      if(!surface.is_border(side))
        continue;
      const Index other = surface.next_on_border(side);
      if(other == side || surface.target(other) != surface.source(side))
        continue;
      const Index before = surface.previous_on_border(side);
      surface.glue(side, other);
      if(before != other)
        sides.push_back(before);
    }
  }

  // Glues the remaining sides of edges with more than two faces, those of large components first.
  void glue_largest(const std::vector<Index>& crowded)
  {
    const std::vector<Index> part = surface.components();
    std::vector<double> areas(part.size(), 0.);
    for(Index t = 0; t < part.size(); ++t)
      areas[part[t]] += area_of(t);
    const auto key = [&](Index side) { return std::minmax({surface.source(side), surface.target(side)}); };
    for(std::size_t begin = 0, end = 0; begin < crowded.size(); begin = end)
    {
      std::vector<Index> open;
      for(; end < crowded.size() && key(crowded[end]) == key(crowded[begin]); ++end)
        if(surface.is_border(crowded[end]))
          open.push_back(crowded[end]);
      std::stable_sort(open.begin(), open.end(),
                       [&](Index a, Index b) { return areas[part[a / 3]] > areas[part[b / 3]]; });
      for(std::size_t k = 0; k < open.size(); ++k)
        for(std::size_t l = k + 1; l < open.size() && surface.is_border(open[k]); ++l)
          if(surface.is_border(open[l]) && surface.source(open[k]) == surface.target(open[l]))
            surface.glue(open[k], open[l]);
    }
  }

  const std::vector<Vector_3d>& m_points;
  const Polygon_corners& m_polygons;
  Repair_report& m_report;
  std::vector<Index> m_merged; // for each vertex, the vertex it is merged into
  Index_triangles m_triangles;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_SOUP_GLUER_H
