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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_INDEPENDENT_SETS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_INDEPENDENT_SETS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/sequential_vertex_coloring.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// What Boost's colouring needs to see of `Vertex_rings`: a model of VertexListGraph and AdjacencyGraph.
struct Ring_graph
{
  using vertex_descriptor = std::uint32_t;
  using vertex_iterator = boost::counting_iterator<std::uint32_t>;
  using adjacency_iterator = const std::uint32_t*;
  using vertices_size_type = std::size_t;
  using edge_descriptor = void;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  struct traversal_category : boost::vertex_list_graph_tag, boost::adjacency_graph_tag
  {};

  const Vertex_rings& rings;
};

inline std::size_t num_vertices(const Ring_graph& g)
{
  return g.rings.number_of_vertices();
}

inline std::pair<Ring_graph::vertex_iterator, Ring_graph::vertex_iterator> vertices(const Ring_graph& g)
{
  return {Ring_graph::vertex_iterator(0), Ring_graph::vertex_iterator(static_cast<std::uint32_t>(num_vertices(g)))};
}

inline std::pair<const std::uint32_t*, const std::uint32_t*> adjacent_vertices(std::uint32_t v, const Ring_graph& g)
{
  const Vertex_rings::Ring ring = g.rings.ring(v);
  return {ring.first, ring.last};
}

// The vertices of a mesh grouped by the colours of a greedy colouring: no two vertices of a set are neighbours, so all
// of a set may move at once. Within a set the vertices are in increasing order.
class Independent_sets
{
public:
  explicit Independent_sets(const Vertex_rings& rings)
  {
    const std::size_t n = rings.number_of_vertices();
    std::vector<std::size_t> colors(n);
    const std::size_t n_colors = boost::sequential_vertex_coloring(
        Ring_graph{rings}, boost::typed_identity_property_map<std::uint32_t>(),
        boost::make_iterator_property_map(colors.begin(), boost::typed_identity_property_map<std::uint32_t>()));
    m_first.assign(n_colors + 1, 0);
    for(const std::size_t color : colors)
      ++m_first[color + 1];
    for(std::size_t color = 0; color < n_colors; ++color)
      m_first[color + 1] += m_first[color];
    m_vertices.resize(n);
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    for(std::size_t v = 0; v < n; ++v)
      m_vertices[next[colors[v]]++] = static_cast<std::uint32_t>(v);
  }

  std::size_t number_of_sets() const { return m_first.size() - 1; }

  // set k is vertices()[first(k)], ..., vertices()[first(k + 1) - 1]
  std::size_t first(std::size_t k) const { return m_first[k]; }
  const std::vector<std::size_t>& first() const { return m_first; }
  const std::vector<std::uint32_t>& vertices() const { return m_vertices; }

private:
  std::vector<std::size_t> m_first;
  std::vector<std::uint32_t> m_vertices;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_INDEPENDENT_SETS_H
