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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_READ_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_READ_MESH_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A caller's mesh as flat arrays: its vertices, without isolated ones, and its faces as triples of vertex indices, both
// in the order of the mesh. The functions below read values of the vertices.
template <class TriangleMesh>
struct Mesh_arrays
{
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices_of_mesh;
  Index_triangles triangles;
  std::size_t number_of_isolated_vertices = 0;

  // Reads a mesh of triangles. A border is accepted only on request.
  Error_code read(const TriangleMesh& tmesh, bool may_have_border = false)
  {
    // Corners are counted by 32-bit indices, with padding between the stars; see Star_packets.
    if(num_halfedges(tmesh) >= (std::numeric_limits<std::uint32_t>::max)() / 2)
      return ERROR_TOO_LARGE_MESH;
    for(const auto f : faces(tmesh))
      if(!is_triangle(halfedge(f, tmesh), tmesh))
        return ERROR_NON_TRIANGULAR_MESH;
    if(faces(tmesh).begin() == faces(tmesh).end())
      return ERROR_EMPTY_MESH;
    if(!may_have_border)
      for(const auto h : halfedges(tmesh))
        if(is_border(h, tmesh))
          return ERROR_NON_CLOSED_MESH;

    const auto index = get(CGAL::dynamic_vertex_property_t<std::uint32_t>(), tmesh);
    vertices_of_mesh.reserve(num_vertices(tmesh));
    for(const auto v : vertices(tmesh))
      if(halfedge(v, tmesh) == boost::graph_traits<TriangleMesh>::null_halfedge())
        ++number_of_isolated_vertices;
      else
      {
        put(index, v, static_cast<std::uint32_t>(vertices_of_mesh.size()));
        vertices_of_mesh.push_back(v);
      }
    triangles.reserve(num_faces(tmesh));
    for(const auto f : faces(tmesh))
    {
      const auto h = halfedge(f, tmesh);
      triangles.push_back(
          {get(index, source(h, tmesh)), get(index, target(h, tmesh)), get(index, target(next(h, tmesh), tmesh))});
    }
    return OK;
  }
};

// Values of vertices, computed as f(value) from the values of a property map.
template <class Vertices, class Map, class Function>
auto read_values(const Vertices& vertices, const Map& map, const Function& f)
{
  std::vector<std::decay_t<decltype(f(get(map, vertices[0])))>> result;
  result.reserve(vertices.size());
  for(const auto v : vertices)
    result.push_back(f(get(map, v)));
  return result;
}

// The same for points, rounded.
template <class Vertices, class VertexPointMap>
std::vector<Vector_3d> read_points(const Vertices& vertices, const VertexPointMap& vpm)
{
  return read_values(vertices, vpm, [](const auto& p) { return rounded(p); });
}

inline bool are_finite(const std::vector<Vector_3d>& points)
{
  return std::all_of(points.begin(), points.end(), [](const Vector_3d& p) { return is_finite(p); });
}

// The property map of the points of a mesh: the named parameter `vertex_point_map`, or else the internal map of the
// mesh, which is writable if the mesh is.
template <class TriangleMesh, class NamedParameters>
auto vertex_point_map_of(TriangleMesh& tmesh, const NamedParameters& np)
{
  const auto given = parameters::get_parameter(np, internal_np::vertex_point);
  if constexpr(std::is_const<TriangleMesh>::value)
    return parameters::choose_parameter(given, get_const_property_map(vertex_point, tmesh));
  else
    return parameters::choose_parameter(given, get_property_map(vertex_point, tmesh));
}

// Reads a mesh and its points as the surface for a method.
template <class TriangleMesh, class VertexPointMap>
Error_code read_surface(const TriangleMesh& tmesh, const VertexPointMap& vpm, Mesh_arrays<TriangleMesh>& arrays,
                        Surface& surface)
{
  if(const Error_code error = arrays.read(tmesh))
    return error;
  std::vector<Vector_3d> points = read_points(arrays.vertices_of_mesh, vpm);
  if(!are_finite(points))
    return ERROR_NON_FINITE_COORDINATE;
  return surface.assign(std::move(points), link_triangles(arrays.triangles, arrays.vertices_of_mesh.size()));
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_READ_MESH_H
