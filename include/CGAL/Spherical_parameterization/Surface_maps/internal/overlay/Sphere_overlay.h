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

#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/Edge_traces.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/Perturbed_orientation.h>

#include <limits>
#include <numeric>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The common refinement of two triangulations of the sphere. It is exact; ties are resolved as if the points of the first one were
// perturbed, see Perturbed_orientation. The vertices are those of the first triangulation, those of the second one, and the crossings of
// their edges, in the order along the edges of the first one.
class Sphere_overlay
{
public:
  using Index = std::uint32_t;

  // The intersection of a triangle of the first triangulation with a triangle of the second one: a convex polygon.
  struct Cell
  {
    std::array<Index, 2> parents;
    std::size_t end; // the end of its corners, which are counterclockwise
  };

  using Crossing = std::array<std::size_t, 2>; // an edge of each triangulation

  // The maximum number of vertices; each takes about 200 bytes, and has an index of type std::uint32_t.
  explicit Sphere_overlay(std::size_t max_vertices = (std::numeric_limits<std::size_t>::max)())
    : m_max_vertices((std::min)(max_vertices, std::size_t((std::numeric_limits<Index>::max)() - 1)))
  {}

  // The default bound. The refinement of surfaces without needles has 4 to 6 times as many vertices as the surfaces; two coinciding
  // vertices of degree d add d^2 / 2.
  static std::size_t default_max_vertices(const Sphere_mesh& first, const Sphere_mesh& second)
  {
    constexpr std::size_t always_allowed = std::size_t(1) << 22, factor = 32;
    return (std::max)(always_allowed, factor * (first.points().size() + second.points().size()));
  }

  // Returns ERROR_NO_1_TO_1_MAPPING if the certificate fails, which requires that both traces find the same crossings, every cell is one
  // polygon, and V - E + F = 2; ERROR_TOO_LARGE_OVERLAY if there are too many vertices, before most memory is allocated; ERROR_STOPPED if
  // the control has stopped the run. The triangulations must be bijective.
  template <class Orientation = Perturbed_orientation>
  Error_code assign(const Sphere_mesh& first, const Sphere_mesh& second, Run_control& control,
                    const Execution& execution)
  {
    m_n_first = static_cast<Index>(first.points().size());
    m_n_second = static_cast<Index>(second.points().size());
    const Orientation of_first(true), of_second(false); // for the edges of the first and of the second triangulation
    m_triangles_of_first = locate_vertices(first, second, of_second, control);
    m_triangles_of_second = locate_vertices(second, first, of_first, control);
    Edge_traces traces_of_first, traces_of_second;
    if(const Error_code error = trace_edges(first, second, m_triangles_of_first, of_first, m_max_vertices,
                                            traces_of_first, control, execution))
      return error;
    if(const Error_code error = trace_edges(second, first, m_triangles_of_second, of_second, m_max_vertices,
                                            traces_of_second, control, execution))
      return error;
    std::vector<Index> crossings_of_second; // in the order along the edges of the second triangulation
    const bool is_certified =
        match(traces_of_first, traces_of_second, crossings_of_second, control) &&
        make_cells(first, second, traces_of_first, traces_of_second, crossings_of_second, control, execution);
    return control.is_stopped() ? ERROR_STOPPED : is_certified ? OK : ERROR_NO_1_TO_1_MAPPING;
  }

  std::size_t number_of_vertices() const { return std::size_t(m_n_first) + m_n_second + m_crossings.size(); }

  // The triangles of the other triangulation that contain the vertices.
  const std::vector<Index>& triangles_of_first() const { return m_triangles_of_first; }
  const std::vector<Index>& triangles_of_second() const { return m_triangles_of_second; }

  const std::vector<Crossing>& crossings() const { return m_crossings; }
  const std::vector<Cell>& cells() const { return m_cells; }

  // The corners of all cells.
  const std::vector<Index>& corners() const { return m_corners; }

private:
  // A part of an edge, as a directed side of the cell on its left.
  struct Part
  {
    std::array<Index, 2> parents;
    Index source, target;
  };

  // Assigns indices to the crossings in the order along the edges of the first triangulation, and finds their indices along the edges of
  // the second one. Two arcs of less than half a circle cross at most once. Returns false if the traces differ, or the control stops the
  // run.
  bool match(const Edge_traces& first, const Edge_traces& second, std::vector<Index>& crossings_of_second,
             Run_control& control)
  {
    if(first.crossed.size() != second.crossed.size())
      return false;
    using Numbered = std::array<std::size_t, 3>; // the edges that cross, and the index of the crossing
    const auto numbered = [](const Edge_traces& traces, std::size_t which) {
      std::vector<Numbered> result;
      result.reserve(traces.crossed.size());
      for(std::size_t k = 0; k < traces.edges.size(); ++k)
        while(result.size() < traces.ends[k])
        {
          const std::size_t number = result.size(), e = traces.edges[k], f = traces.crossed[number];
          result.push_back(which == 0 ? Numbered{e, f, number} : Numbered{f, e, number});
        }
      return result;
    };
    std::vector<Numbered> of_first = numbered(first, 0), of_second = numbered(second, 1);
    m_crossings.clear();
    for(const Numbered& crossing : of_first)
      m_crossings.push_back({crossing[0], crossing[1]});
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

  bool make_cells(const Sphere_mesh& first, const Sphere_mesh& second, const Edge_traces& traces_of_first,
                  const Edge_traces& traces_of_second, const std::vector<Index>& crossings_of_second,
                  Run_control& control, const Execution& execution)
  {
    std::vector<Part> parts;
    const std::size_t n_edges = traces_of_first.edges.size() + traces_of_second.edges.size();
    parts.reserve(2 * (n_edges + 2 * m_crossings.size()));
    const auto add_parts = [&](const Sphere_mesh& of, const Edge_traces& traces, std::size_t which) {
      const Triangle_sides edges(of.triangles());
      const Index first_vertex = which == 0 ? 0 : m_n_first, first_crossing = m_n_first + m_n_second;
      std::size_t k = 0; // the index of the crossing
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

    // Buckets for the triangles of the first triangulation, sorted by those of the second one.
    const std::size_t n = first.triangles().size();
    std::vector<std::size_t> begins(n + 1, 0);
    for(const Part& part : parts)
      ++begins[part.parents[0] + 1];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<std::size_t> ends = begins;
    std::vector<Part> sorted(parts.size());
    for(const Part& part : parts)
      sorted[ends[part.parents[0]]++] = part;
    constexpr std::size_t block_size = 256; // large enough that the overhead of parallel execution is negligible
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

  // Chains the parts around a cell. Returns false if they do not form one polygon.
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
  std::vector<Index> m_triangles_of_first, m_triangles_of_second;
  std::vector<Crossing> m_crossings;
  std::vector<Cell> m_cells;
  std::vector<Index> m_corners;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_SPHERE_OVERLAY_H
