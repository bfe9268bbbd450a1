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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_ADD_TRIANGLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_ADD_TRIANGLES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <CGAL/Kernel_traits.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Adds a closed mesh with n vertices to a mesh, and calls write(vertices, faces) with the added elements, in the order
// of the triangles and their vertices. The first vertex of a triangle is source(halfedge(f, tmesh), tmesh). If an
// exception is thrown, also by write(), all added elements are removed again.
template <class TriangleMesh, class Write>
void add_triangles(const std::vector<Linked_triangle>& triangles, std::size_t n, TriangleMesh& tmesh,
                   const Write& write)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  std::vector<typename Traits::vertex_descriptor> vertices;
  std::vector<typename Traits::face_descriptor> faces;
  vertices.reserve(n);
  faces.reserve(triangles.size());
  // Halfedge i of a triangle is the one opposite to its vertex i.
  std::vector<typename Traits::halfedge_descriptor> halfedges(3 * triangles.size(), Traits::null_halfedge());
  reserve(tmesh, static_cast<typename Traits::vertices_size_type>(num_vertices(tmesh) + n),
          static_cast<typename Traits::edges_size_type>(num_edges(tmesh) + halfedges.size() / 2),
          static_cast<typename Traits::faces_size_type>(num_faces(tmesh) + triangles.size()));
  try
  {
    for(std::size_t v = 0; v < n; ++v)
      vertices.push_back(add_vertex(tmesh));
    for(std::uint32_t t = 0; t < triangles.size(); ++t)
      for(std::size_t i = 0; i < 3; ++i)
        if(const std::uint32_t s = triangles[t].neighbors[i]; t < s)
        {
          const auto h = halfedge(add_edge(tmesh), tmesh);
          halfedges[3 * t + i] = h;
          halfedges[3 * s + triangles[s].side_of(t)] = opposite(h, tmesh);
        }
    for(std::size_t t = 0; t < triangles.size(); ++t)
    {
      const auto f = add_face(tmesh);
      faces.push_back(f);
      for(std::size_t i = 0; i < 3; ++i)
      {
        const auto h = halfedges[3 * t + i];
        const auto v = vertices[triangles[t][(i + 2) % 3]];
        set_target(h, v, tmesh);
        set_halfedge(v, h, tmesh);
        set_next(h, halfedges[3 * t + (i + 1) % 3], tmesh);
        set_face(h, f, tmesh);
      }
      set_halfedge(f, halfedges[3 * t + 2], tmesh);
    }
    write(vertices, faces);
  }
  catch(...)
  {
    for(const auto f : faces)
      remove_face(f, tmesh);
    for(std::size_t k = 0; k < halfedges.size(); ++k)
      if(k / 3 < triangles[k / 3].neighbors[k % 3] && halfedges[k] != Traits::null_halfedge())
        remove_edge(edge(halfedges[k], tmesh), tmesh);
    for(const auto v : vertices)
      remove_vertex(v, tmesh);
    throw;
  }
}

// Writes value_of(k), three numbers, for each of the vertices to a map of points or vectors.
template <class VertexMap, class Vertices, class Values>
void write_vectors(const VertexMap& map, const Vertices& vertices, const Values& value_of)
{
  using Value = typename boost::property_traits<VertexMap>::value_type;
  using FT = typename Kernel_traits<Value>::Kernel::FT;
  for(std::size_t k = 0; k < vertices.size(); ++k)
  {
    const auto value = value_of(k);
    put(map, vertices[k], Value(static_cast<FT>(value[0]), static_cast<FT>(value[1]), static_cast<FT>(value[2])));
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_ADD_TRIANGLES_H
