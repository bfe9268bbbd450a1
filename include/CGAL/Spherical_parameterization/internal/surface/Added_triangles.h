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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_ADDED_TRIANGLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_ADDED_TRIANGLES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The vertices and faces that have been added to a mesh, in the order of the triangles that they were made of.
template <class TriangleMesh>
struct Added_triangles
{
  using Traits = boost::graph_traits<TriangleMesh>;

  std::vector<typename Traits::vertex_descriptor> vertices;
  std::vector<typename Traits::face_descriptor> faces;

  // Adds a closed mesh with n vertices. The first vertex of a triangle is source(halfedge(f, tmesh), tmesh).
  Added_triangles(const std::vector<Linked_triangle>& triangles, std::size_t n, TriangleMesh& tmesh)
  {
    const std::size_t n_halfedges = 3 * triangles.size();
    reserve(tmesh, static_cast<typename Traits::vertices_size_type>(num_vertices(tmesh) + n),
            static_cast<typename Traits::edges_size_type>(num_edges(tmesh) + n_halfedges / 2),
            static_cast<typename Traits::faces_size_type>(num_faces(tmesh) + triangles.size()));
    vertices.reserve(n);
    for(std::size_t v = 0; v < n; ++v)
      vertices.push_back(add_vertex(tmesh));

    // The halfedge i of a triangle is the one that is opposite to its vertex i.
    std::vector<typename Traits::halfedge_descriptor> halfedges(n_halfedges);
    for(std::uint32_t t = 0; t < triangles.size(); ++t)
      for(std::size_t i = 0; i < 3; ++i)
        if(const std::uint32_t s = triangles[t].neighbors[i]; t < s)
        {
          const auto h = halfedge(add_edge(tmesh), tmesh);
          halfedges[3 * t + i] = h;
          halfedges[3 * s + triangles[s].side_of(t)] = opposite(h, tmesh);
        }

    faces.reserve(triangles.size());
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
  }
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_ADDED_TRIANGLES_H
