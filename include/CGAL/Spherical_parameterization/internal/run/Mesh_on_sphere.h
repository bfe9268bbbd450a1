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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_MESH_ON_SPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_MESH_ON_SPHERE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Exact_predicates_kernel.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A mesh and its map as flat arrays, in the order of the mesh, without isolated vertices.
template <class TriangleMesh, class VertexSphereMap>
struct Mesh_on_sphere
{
  static_assert(check_mesh_and_readable_map<TriangleMesh, VertexSphereMap>());

  using Selection = Exact_predicates_kernel_of_map<VertexSphereMap>;
  using Exact_kernel = typename Selection::type;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices_of_mesh;
  std::vector<face_descriptor> faces_of_mesh;
  std::vector<typename Exact_kernel::Point_3> images;
  std::vector<Linked_triangle> triangles;
  std::vector<Vector_3d> points; // of the surface

  // Copies the mesh and checks that the map is a bijection, unless this is known.
  Error_code read(const TriangleMesh& tmesh, const VertexSphereMap& vertex_sphere_map, bool is_known_to_be_bijective,
                  const Execution& execution)
  {
    Mesh_arrays<TriangleMesh> arrays;
    if(const Error_code error = arrays.read(tmesh))
      return error;
    vertices_of_mesh = std::move(arrays.vertices_of_mesh);
    images = read_values(vertices_of_mesh, vertex_sphere_map, [](const auto& p) { return Selection::convert(p); });
    triangles = link_triangles(arrays.triangles, images.size());
    if(triangles.empty() ||
       (!is_known_to_be_bijective && !certify_bijectivity<Exact_kernel>(images, triangles, execution).is_bijective()))
      return find_error(tmesh, vertex_sphere_map);
    faces_of_mesh.assign(faces(tmesh).begin(), faces(tmesh).end());
    return OK;
  }

  // The same, and also copies the points of the surface, given by the named parameters of the call.
  template <class NamedParameters>
  Error_code read_with_points(const TriangleMesh& tmesh, const VertexSphereMap& vertex_sphere_map,
                              const NamedParameters& np, const Execution& execution)
  {
    if(const Error_code error = read(tmesh, vertex_sphere_map, false, execution))
      return error;
    points = read_points(vertices_of_mesh, vertex_point_map_of(tmesh, np));
    return are_finite(points) ? OK : ERROR_NON_FINITE_COORDINATE;
  }

  // Finds the defect of a mesh without a valid map, or of its map, by the checks of parameterize().
  static Error_code find_error(const TriangleMesh& tmesh, const VertexSphereMap& vertex_sphere_map)
  {
    Mesh_arrays<TriangleMesh> arrays;
    Surface surface;
    const Error_code error = read_surface(tmesh, vertex_sphere_map, arrays, surface);
    return error == OK ? ERROR_NO_1_TO_1_MAPPING : error;
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_MESH_ON_SPHERE_H
