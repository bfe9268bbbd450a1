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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_READ_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_READ_MESH_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/surface/Indexed_mesh.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Checks the caller's mesh and copies it: the first of the two places that touch it. `vertices_of_mesh` gets the
// vertices in the order of their original numbers, the report the counts.
template <class TriangleMesh, class VertexPointMap>
Error_code read_mesh(const TriangleMesh& tmesh, const VertexPointMap& vpm, Indexed_mesh& mesh,
                     std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertices_of_mesh,
                     Parameterization_report& report)
{
  using Index = std::uint32_t;

  // Corners are counted in 32 bits, with padding between the stars; see Star_packets.
  if(num_halfedges(tmesh) >= (std::numeric_limits<Index>::max)() / 2)
    return ERROR_TOO_LARGE_MESH;
  for(const auto f : faces(tmesh))
    if(!is_triangle(halfedge(f, tmesh), tmesh))
      return ERROR_NON_TRIANGULAR_MESH;
  if(faces(tmesh).begin() == faces(tmesh).end())
    return ERROR_EMPTY_MESH;
  for(const auto h : halfedges(tmesh))
    if(is_border(h, tmesh))
      return ERROR_NON_CLOSED_MESH;

  const auto index = get(CGAL::dynamic_vertex_property_t<Index>(), tmesh);
  std::vector<Vector_3d> points;
  points.reserve(num_vertices(tmesh));
  vertices_of_mesh.reserve(num_vertices(tmesh));
  for(const auto v : vertices(tmesh))
  {
    if(halfedge(v, tmesh) == boost::graph_traits<TriangleMesh>::null_halfedge())
    {
      ++report.number_of_isolated_vertices;
      continue;
    }
    put(index, v, static_cast<Index>(points.size()));
    vertices_of_mesh.push_back(v);
    const auto& p = get(vpm, v);
    points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  std::vector<std::array<Index, 3>> triangles;
  triangles.reserve(num_faces(tmesh));
  for(const auto f : faces(tmesh))
  {
    const auto h = halfedge(f, tmesh);
    triangles.push_back(
        {get(index, source(h, tmesh)), get(index, target(h, tmesh)), get(index, target(next(h, tmesh), tmesh))});
  }
  const Error_code error = mesh.assign(std::move(points), triangles);
  report.number_of_vertices = mesh.number_of_vertices();
  report.number_of_faces = triangles.size();
  report.number_of_flat_faces = mesh.number_of_flat_faces();
  return error;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_READ_MESH_H
