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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_RINGS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_RINGS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The connectivity of a closed triangle mesh: for each vertex its neighbors in counterclockwise order, as compressed
// sparse rows. The faces of vertex v are (v, ring[j], ring[j + 1]), where ring[0] follows the last neighbor.
class Vertex_rings
{
public:
  struct Ring
  {
    const std::uint32_t* first;
    const std::uint32_t* last;

    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
    std::uint32_t operator[](std::size_t j) const { return first[j]; }

    // The same around the closed ring, for j below twice its size.
    std::uint32_t around(std::size_t j) const { return first[j < size() ? j : j - size()]; }

    std::size_t position_of(std::uint32_t v) const
    {
      return static_cast<std::size_t>(std::find(first, last, v) - first);
    }
  };

  std::size_t number_of_vertices() const { return m_offsets.size() - 1; }
  std::size_t number_of_corners() const { return m_neighbors.size(); }
  std::size_t number_of_faces() const { return m_neighbors.size() / 3; }

  std::size_t offset(std::size_t v) const { return m_offsets[v]; }
  std::size_t degree(std::size_t v) const { return m_offsets[v + 1] - m_offsets[v]; }

  Ring ring(std::size_t v) const { return {m_neighbors.data() + m_offsets[v], m_neighbors.data() + m_offsets[v + 1]}; }

  // Calls f(v, p, q) for every face once, in a fixed order; v is its vertex of smallest index.
  template <class Function>
  void for_each_face(Function f) const
  {
    for(std::uint32_t v = 0; v < number_of_vertices(); ++v)
    {
      const Ring neighbors = ring(v);
      for(std::size_t j = 0; j < neighbors.size(); ++j)
      {
        const std::uint32_t p = neighbors[j], q = neighbors.around(j + 1);
        if(v < p && v < q)
          f(v, p, q);
      }
    }
  }

  // Construction: the rings of the vertices 0, 1, 2, ... one after the other.
  void reserve(std::size_t n_vertices, std::size_t n_corners)
  {
    m_offsets.reserve(n_vertices + 1);
    m_neighbors.reserve(n_corners);
  }
  void push_neighbor(std::uint32_t v) { m_neighbors.push_back(v); }
  void end_ring() { m_offsets.push_back(static_cast<std::uint32_t>(m_neighbors.size())); }

  // Construction in any order: the ring of v occupies the corners offsets[v] to offsets[v + 1] and is written to them.
  void assign(std::vector<std::uint32_t> offsets)
  {
    m_offsets = std::move(offsets);
    m_neighbors.resize(m_offsets.back());
  }
  std::uint32_t* ring_to_fill(std::size_t v) { return m_neighbors.data() + m_offsets[v]; }

private:
  std::vector<std::uint32_t> m_offsets = {0};
  std::vector<std::uint32_t> m_neighbors;
};

// Creates the rings of the n vertices. Fails if a vertex has no triangle or is adjacent to another one by two edges, if
// its triangles form more than one fan, or if they leave a gap.
inline bool build_rings(const std::vector<Linked_triangle>& linked, std::size_t n, Vertex_rings& rings)
{
  constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  std::vector<std::uint32_t> first(n, none), degrees(n, 0); // a triangle of each vertex, and their number
  for(std::uint32_t t = 0; t < linked.size(); ++t)
    for(const std::uint32_t v : linked[t].vertices)
    {
      first[v] = degrees[v] == 0 ? t : first[v];
      ++degrees[v];
    }
  rings.reserve(n, 3 * linked.size());
  for(std::uint32_t v = 0; v < n; ++v)
  {
    std::uint32_t t = first[v];
    if(t == none)
      return false;
    for(std::uint32_t k = 0; k < degrees[v]; ++k)
    {
      if(k > 0 && t == first[v])
        return false;
      const std::size_t i = linked[t].corner_of(v), next = i < 2 ? i + 1 : 0;
      rings.push_neighbor(linked[t][next]);
      t = linked[t].neighbors[next];
    }
    if(t != first[v])
      return false;
    rings.end_ring();
  }
  return true;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_RINGS_H
