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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_SPHERE_OVERLAY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_SPHERE_OVERLAY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/Perturbed_orientation.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// A side of a triangle is numbered 3 t + i if it is opposite to vertex i of triangle t, from vertex i + 1 to vertex
// i + 2. An edge has the number of its side in the triangle with the smaller number.
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

// The common refinement of two triangulations of the sphere, exact but for ties, which are broken as if the points of the
// first one were perturbed; see Perturbed_orientation. The vertices are those of the first triangulation, those of the
// second one, and the crossings of their edges, in the order along the edges of the first.
template <class K>
class Sphere_overlay
{
public:
  using Index = std::uint32_t;
  using Point_3 = typename K::Point_3;
  using Triangulation = Sphere_triangulation<K>;

  // the part of a triangle of the first triangulation that is in one of the second: a convex polygon
  struct Cell
  {
    std::array<Index, 2> parents;
    std::size_t end; // of its corners, which are counterclockwise
  };

  using Crossing = std::array<std::size_t, 2>; // an edge of each triangulation

  // At most so many vertices are made, some 200 bytes each; they are counted in 32 bits.
  explicit Sphere_overlay(std::size_t max_vertices = (std::numeric_limits<std::size_t>::max)())
    : m_max_vertices((std::min)(max_vertices, std::size_t((std::numeric_limits<Index>::max)() - 1)))
  {}

  // The bound for those who know no better. Surfaces of faces that are no needles have 4 to 6 times as many vertices in
  // common as alone; two hubs of degree d have d^2 / 2 more.
  static std::size_t default_max_vertices(const Triangulation& first, const Triangulation& second)
  {
    constexpr std::size_t always_allowed = std::size_t(1) << 22, factor = 32;
    return (std::max)(always_allowed, factor * (first.points().size() + second.points().size()));
  }

  // Returns ERROR_NO_1_TO_1_MAPPING if the certificate fails: both traces find the same crossings, every cell is one polygon,
  // and V - E + F = 2; ERROR_TOO_LARGE_OVERLAY if there are too many vertices, before most memory is taken; ERROR_STOPPED if
  // the control has ended it. The triangulations have to be bijections, and to live longer.
  Error_code assign(const Triangulation& first, const Triangulation& second, Run_control& control,
                    const Execution& execution)
  {
    m_n_first = static_cast<Index>(first.points().size());
    m_n_second = static_cast<Index>(second.points().size());
    const Perturbed_orientation<K> of_first(true), of_second(false); // the edges
    m_places_of_first = locate_vertices(first, second, of_second, control);
    m_places_of_second = locate_vertices(second, first, of_first, control);
    Traces traces_of_first, traces_of_second;
    if(const Error_code error =
           trace_edges(first, second, m_places_of_first, of_first, traces_of_first, control, execution))
      return error;
    if(const Error_code error =
           trace_edges(second, first, m_places_of_second, of_second, traces_of_second, control, execution))
      return error;
    std::vector<Index> crossings_of_second; // in the order along the edges of the second triangulation
    const bool is_certified =
        match(traces_of_first, traces_of_second, crossings_of_second, control) &&
        make_cells(first, second, traces_of_first, traces_of_second, crossings_of_second, control, execution);
    return control.is_stopped() ? ERROR_STOPPED : is_certified ? OK : ERROR_NO_1_TO_1_MAPPING;
  }

  std::size_t number_of_vertices() const { return std::size_t(m_n_first) + m_n_second + m_crossings.size(); }

  // the triangles of the other triangulation that vertices are in
  const std::vector<Index>& places_of_first() const { return m_places_of_first; }
  const std::vector<Index>& places_of_second() const { return m_places_of_second; }

  const std::vector<Crossing>& crossings() const { return m_crossings; }
  const std::vector<Cell>& cells() const { return m_cells; }

  // the corners of all cells
  const std::vector<Index>& corners() const { return m_corners; }

private:
  // For each edge of a triangulation, by its number, the edges of the other one that it crosses, in order, and the
  // triangles that it runs through, one more.
  struct Traces
  {
    std::vector<std::size_t> ends; // of the crossed edges; those of the triangles are larger by the number of the edges
    std::vector<std::size_t> crossed;
    std::vector<Index> triangles;
    std::vector<Index> edges; // that there are, in order
  };

  // a part of an edge, seen from the cell on its left
  struct Part
  {
    std::array<Index, 2> parents;
    Index source, target;
  };

  // Asks the control once in so many calls, some milliseconds of work.
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

  // The triangles of `in` that the vertices of `of` are in, each found by a walk from that of a neighbour; none for a vertex
  // that is in none, or once the control has ended it.
  template <class Side>
  static std::vector<Index> locate_vertices(const Triangulation& of, const Triangulation& in, const Side& side,
                                            Run_control& control)
  {
    std::vector<Index> places(of.points().size(), Triangulation::none);
    Patience patience(control);
    visit_from_neighbors(of.triangles(), places.size(), Triangulation::none, [&](Index v, Index w) {
      if(!patience.has_ended())
        places[v] = in.triangle_from(w == Triangulation::none ? 0 : places[w], of.points()[v], side);
    });
    return places;
  }

  // An edge enters a triangle from one with which it shares a side, and leaves it by the side whose source is on its right
  // and whose target is on its left: which one, the side of one vertex decides. Crossings are counted while they are found, so
  // that no more are stored than there may be.
  template <class Side>
  Error_code trace_edges(const Triangulation& of, const Triangulation& in, const std::vector<Index>& places,
                         const Side& side, Traces& result, Run_control& control, const Execution& execution) const
  {
    if(control.is_stopped())
      return ERROR_STOPPED;
    if(std::count(places.begin(), places.end(), Triangulation::none) > 0)
      return ERROR_NO_1_TO_1_MAPPING;
    if(std::size_t(m_n_first) + m_n_second > m_max_vertices)
      return ERROR_TOO_LARGE_OVERLAY;
    const std::size_t max_crossings = m_max_vertices - m_n_first - m_n_second;
    std::atomic<std::size_t> n_crossings{0};
    constexpr std::size_t block_size = 256; // edges, of which those of hubs may have thousands of crossings each
    const Triangle_sides edges(of.triangles()), sides(in.triangles());
    for(std::size_t e = 0; e < edges.size(); ++e)
      if(edges.is_edge(e))
        result.edges.push_back(static_cast<Index>(e));
    const std::size_t n = result.edges.size();
    struct Block
    {
      std::vector<std::size_t> counts, crossed;
      std::vector<Index> triangles;
    };
    std::vector<Block> blocks((n + block_size - 1) / block_size);
    const auto trace = [&](std::size_t begin, std::size_t end) {
      Block& block = blocks[begin / block_size];
      for(std::size_t k = begin; k < end && n_crossings <= max_crossings; ++k)
      {
        const std::size_t e = result.edges[k];
        const Point_3 &p = of.points()[edges.source(e)], &q = of.points()[edges.target(e)];
        const Index last = places[edges.target(e)];
        Index current = places[edges.source(e)];
        const std::size_t old_size = block.crossed.size();
        block.triangles.push_back(current);
        const auto is_left = [&](Index v) { return side(p, q, in.points()[v]) == POSITIVE; };
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
          current = static_cast<Index>(entry / 3);
          block.triangles.push_back(current);
          // The next side starts on the right and ends at the apex, the one after it ends on the left.
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

  // Numbers the crossings in the order along the edges of the first triangulation, and finds the numbers of those along
  // the edges of the second one. Two arcs of less than half a circle cross once at most. Returns false if the traces
  // differ, or the control ends it.
  bool match(const Traces& first, const Traces& second, std::vector<Index>& crossings_of_second, Run_control& control)
  {
    if(first.crossed.size() != second.crossed.size())
      return false;
    using Crossing = std::array<std::size_t, 3>; // the edges that cross, and the number of the crossing
    const auto places = [](const Traces& traces, std::size_t which) {
      std::vector<Crossing> result;
      result.reserve(traces.crossed.size());
      for(std::size_t k = 0; k < traces.edges.size(); ++k)
        while(result.size() < traces.ends[k])
        {
          const std::size_t number = result.size();
          Crossing& place = result.emplace_back();
          place[which] = traces.edges[k];
          place[1 - which] = traces.crossed[number];
          place[2] = number;
        }
      return result;
    };
    std::vector<Crossing> of_first = places(first, 0), of_second = places(second, 1);
    m_crossings.clear();
    for(const Crossing& place : of_first)
      m_crossings.push_back({place[0], place[1]});
    std::sort(of_first.begin(), of_first.end());
    if(!control.go_further(0, 0.))
      return false;
    std::sort(of_second.begin(), of_second.end());
    crossings_of_second.resize(of_second.size());
    for(std::size_t k = 0; k < of_first.size(); ++k)
    {
      if(of_first[k][0] != of_second[k][0] || of_first[k][1] != of_second[k][1])
        return false;
      crossings_of_second[of_second[k][2]] = static_cast<Index>(of_first[k][2]);
    }
    return control.go_further(0, 0.);
  }

  bool make_cells(const Triangulation& first, const Triangulation& second, const Traces& traces_of_first,
                  const Traces& traces_of_second, const std::vector<Index>& crossings_of_second, Run_control& control,
                  const Execution& execution)
  {
    std::vector<Part> parts;
    const std::size_t n_edges = traces_of_first.edges.size() + traces_of_second.edges.size();
    parts.reserve(2 * (n_edges + 2 * m_crossings.size()));
    const auto add_parts = [&](const Triangulation& of, const Traces& traces, std::size_t which) {
      const Triangle_sides edges(of.triangles());
      const Index first_vertex = which == 0 ? 0 : m_n_first, first_crossing = m_n_first + m_n_second;
      std::size_t k = 0; // of the crossings
      for(std::size_t j = 0; j < traces.edges.size(); ++j)
      {
        const std::size_t e = traces.edges[j];
        Index source = first_vertex + edges.source(e);
        for(bool is_last = false; !is_last;)
        {
          is_last = k == traces.ends[j];
          Index target = first_vertex + edges.target(e);
          if(!is_last)
            target = first_crossing + (which == 0 ? static_cast<Index>(k) : crossings_of_second[k]);
          std::array<Index, 2> parents;
          parents[1 - which] = traces.triangles[k + j];
          parents[which] = edges.triangle(e);
          parts.push_back({parents, source, target});
          parents[which] = edges.opposite_triangle(e);
          parts.push_back({parents, target, source});
          source = target;
          k += !is_last;
        }
      }
    };
    add_parts(first, traces_of_first, 0);
    add_parts(second, traces_of_second, 1);
    if(!control.go_further(0, 0.))
      return false;

    // Buckets for the triangles of the first triangulation, sorted by those of the second
    const std::size_t n = first.triangles().size();
    std::vector<std::size_t> begins(n + 1, 0);
    for(const Part& part : parts)
      ++begins[part.parents[0] + 1];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<std::size_t> ends = begins;
    std::vector<Part> sorted(parts.size());
    for(const Part& part : parts)
      sorted[ends[part.parents[0]]++] = part;
    constexpr std::size_t block_size = 256; // of parallel work: enough that handing it out costs nothing
    const auto sort = [&](std::size_t begin, std::size_t end) {
      for(std::size_t t = begin; t < end; ++t)
        std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begins[t]),
                  sorted.begin() + static_cast<std::ptrdiff_t>(begins[t + 1]), [](const Part& a, const Part& b) {
                    return a.parents[1] != b.parents[1] ? a.parents[1] < b.parents[1] : a.source < b.source;
                  });
    };
    if(!for_each_block_until_stopped(control, execution, n, block_size, sort))
      return false;
    m_cells.clear();
    m_corners.clear();
    m_corners.reserve(sorted.size());
    Patience patience(control);
    for(std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end)
    {
      if(patience.has_ended())
        return false;
      while(end < sorted.size() && sorted[end].parents == sorted[begin].parents)
        ++end;
      if(!add_cell(&sorted[begin], end - begin))
        return false;
    }
    return number_of_vertices() + m_cells.size() == parts.size() / 2 + 2;
  }

  // Chains the parts around a cell.
  bool add_cell(const Part* parts, std::size_t n)
  {
    Index corner = parts[0].source;
    for(std::size_t k = 0; k < n; ++k)
    {
      m_corners.push_back(corner);
      const Part* const next = std::find_if(parts, parts + n, [&](const Part& part) { return part.source == corner; });
      if(next == parts + n || (k + 1 < n && next->target == parts[0].source))
        return false;
      corner = next->target;
    }
    m_cells.push_back({parts[0].parents, m_corners.size()});
    return n >= 3 && corner == parts[0].source;
  }

  std::size_t m_max_vertices;
  Index m_n_first = 0, m_n_second = 0;
  std::vector<Index> m_places_of_first, m_places_of_second;
  std::vector<Crossing> m_crossings;
  std::vector<Cell> m_cells;
  std::vector<Index> m_corners;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_SPHERE_OVERLAY_H
