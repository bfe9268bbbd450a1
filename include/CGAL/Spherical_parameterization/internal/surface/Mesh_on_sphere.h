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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MESH_ON_SPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MESH_ON_SPHERE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/surface/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A mesh and its map as flat arrays, in the order of the mesh; vertices without faces are left out.
template <class TriangleMesh, class VertexSphereMap>
struct Mesh_on_sphere
{
  static_assert(check_mesh_and_readable_map<TriangleMesh, VertexSphereMap>());

  using Selection = Exact_predicates_kernel_of_map<VertexSphereMap>;
  using Exact_kernel = typename Selection::type;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  std::vector<vertex_descriptor> vertices_of_mesh;
  std::vector<face_descriptor> faces_of_mesh;
  std::vector<typename Exact_kernel::Point_3> images;
  std::vector<Linked_triangle> triangles;
  std::vector<Vector_3d> points; // of the surface

  // Copies the mesh and checks that the map is a bijection, unless that is known.
  Error_code read(const TriangleMesh& tmesh, const VertexSphereMap& vertex_sphere_map, bool is_known_to_be_bijective,
                  const Execution& execution)
  {
    if(num_halfedges(tmesh) >= (std::numeric_limits<std::uint32_t>::max)() / 2 || !CGAL::is_closed(tmesh) ||
       !CGAL::is_triangle_mesh(tmesh))
      return find_error(tmesh, vertex_sphere_map);
    copy(tmesh, vertex_sphere_map);
    if(!is_known_to_be_bijective && !certify_bijectivity<Exact_kernel>(images, triangles, execution).is_bijective())
      return find_error(tmesh, vertex_sphere_map);
    return OK;
  }

  // Copies the points of the surface, once the mesh has been read.
  template <class VertexPointMap>
  Error_code read_points(const VertexPointMap& vpm)
  {
    points.reserve(vertices_of_mesh.size());
    for(const auto v : vertices_of_mesh)
    {
      const auto& p = get(vpm, v);
      points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
      if(!is_finite(points.back()))
        return ERROR_NON_FINITE_COORDINATE;
    }
    return OK;
  }

  // What is wrong with a mesh that has no map, or with its map, is told by the check that parameterize() makes.
  static Error_code find_error(const TriangleMesh& tmesh, const VertexSphereMap& vertex_sphere_map)
  {
    Indexed_mesh mesh;
    std::vector<vertex_descriptor> vertices_read;
    Parameterization_report report;
    const Error_code error = read_mesh(tmesh, vertex_sphere_map, mesh, vertices_read, report);
    return error == OK ? ERROR_NO_1_TO_1_MAPPING : error;
  }

private:
  void copy(const TriangleMesh& tmesh, const VertexSphereMap& vertex_sphere_map)
  {
    const auto vertex_index = get(CGAL::dynamic_vertex_property_t<std::uint32_t>(), tmesh);
    const auto face_index = get(CGAL::dynamic_face_property_t<std::uint32_t>(), tmesh);
    vertices_of_mesh.reserve(num_vertices(tmesh));
    images.reserve(num_vertices(tmesh));
    for(const auto v : vertices(tmesh))
      if(halfedge(v, tmesh) != boost::graph_traits<TriangleMesh>::null_halfedge())
      {
        put(vertex_index, v, static_cast<std::uint32_t>(images.size()));
        vertices_of_mesh.push_back(v);
        images.push_back(Selection::convert(get(vertex_sphere_map, v)));
      }
    faces_of_mesh.reserve(num_faces(tmesh));
    for(const auto f : faces(tmesh))
    {
      put(face_index, f, static_cast<std::uint32_t>(faces_of_mesh.size()));
      faces_of_mesh.push_back(f);
    }
    triangles.reserve(faces_of_mesh.size());
    for(const auto f : faces_of_mesh)
    {
      const auto h = halfedge(f, tmesh), next_h = next(h, tmesh), previous_h = next(next_h, tmesh);
      triangles.push_back({{get(vertex_index, source(h, tmesh)), get(vertex_index, target(h, tmesh)),
                            get(vertex_index, target(next_h, tmesh))},
                           {get(face_index, face(opposite(next_h, tmesh), tmesh)),
                            get(face_index, face(opposite(previous_h, tmesh), tmesh)),
                            get(face_index, face(opposite(h, tmesh), tmesh))}});
    }
  }
};

// Reads two surfaces with their maps; returns what is wrong with the first one, or else with the second one.
template <class TriangleMesh1, class VertexSphereMap1, class TriangleMesh2, class VertexSphereMap2>
Error_code read_surfaces(const TriangleMesh1& tmesh1, const VertexSphereMap1& vertex_sphere_map1,
                         Mesh_on_sphere<TriangleMesh1, VertexSphereMap1>& arrays1, const TriangleMesh2& tmesh2,
                         const VertexSphereMap2& vertex_sphere_map2,
                         Mesh_on_sphere<TriangleMesh2, VertexSphereMap2>& arrays2, const Execution& execution)
{
  if(const Error_code error = arrays1.read(tmesh1, vertex_sphere_map1, false, execution))
    return error;
  if(const Error_code error = arrays2.read(tmesh2, vertex_sphere_map2, false, execution))
    return error;
  if(const Error_code error = arrays1.read_points(get(vertex_point, tmesh1)))
    return error;
  return arrays2.read_points(get(vertex_point, tmesh2));
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MESH_ON_SPHERE_H
