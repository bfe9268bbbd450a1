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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_SPHERE_DOMAIN_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_SPHERE_DOMAIN_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/run/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

class Sphere_domain_3;
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap>
Error_code make_sphere_domain(const TriangleMesh&, VertexSphereMap, Sphere_domain_3&);

/// \ingroup PkgSphericalParameterizationSampling
///
/// The class `Sphere_domain_3` is a triangulation of the sphere that serves as a sampling pattern: directions, and triangles that
/// cover the sphere once. The class provides regular domains. `make_sphere_domain()` creates a domain from a mesh and its map
/// to the sphere.
///
/// Regular domains are solids whose edges are divided into `n` parts, with `n` from 1 to `max_subdivision`; for any other `n`,
/// the domain is empty. The edges of the octahedron and the icosahedron are divided into arcs of equal angle, and their
/// triangles accordingly. The squares of the cube are divided by planes through its axes at equal angles. The samples are almost
/// evenly spaced: areas of triangles differ by a factor of at most 1.8 (octahedron), 1.7 (cube) and 1.2 (icosahedron). The
/// vertices of the solid come first, followed by those on its edges and those in its faces.
///
/// \sa `CGAL::Spherical_parameterization::remesh_through_sphere()`
class Sphere_domain_3
{
public:
  /// Type of the directions
  using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;
  /// The indices of the vertices of a triangle, counterclockwise as seen from outside
  using Triangle = std::array<std::uint32_t, 3>;

  /// The maximum number of parts of an edge: 5000
  static constexpr std::uint32_t max_subdivision = 5000; // An icosahedron then has 250 million vertices.

  /// constructs an empty domain.
  Sphere_domain_3() = default;

  /// returns an octahedron whose edges are divided into `n` parts: \f$ 4 n^2 + 2 \f$ directions of length 1. The vertices of
  /// the octahedron are on the axes.
  static Sphere_domain_3 octahedron(std::uint32_t n) { return regular(8, n); }

  /// returns a cube whose edges are divided into `n` parts: \f$ 6 n^2 + 2 \f$ directions of length 1. The faces of the cube are
  /// orthogonal to the axes, and each of their squares consists of two triangles.
  static Sphere_domain_3 cube(std::uint32_t n) { return regular(6, n); }

  /// returns an icosahedron whose edges are divided into `n` parts: \f$ 10 n^2 + 2 \f$ directions of length 1. Two vertices of
  /// the icosahedron are on the z-axis, and one is in the plane of the x-axis and the z-axis.
  static Sphere_domain_3 icosahedron(std::uint32_t n) { return regular(20, n); }

  /// returns whether the domain has no triangles.
  bool is_empty() const { return m_triangles.empty(); }

  /// returns the directions.
  const std::vector<Point_3>& directions() const { return m_directions; }

  /// returns the triangles.
  const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
  template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap>
  friend Error_code make_sphere_domain(const TriangleMesh&, VertexSphereMap, Sphere_domain_3&);

  static Sphere_domain_3 regular(std::size_t n_faces, std::uint32_t n);

  std::vector<Point_3> m_directions;
  std::vector<Triangle> m_triangles;
};

/// \ingroup PkgSphericalParameterizationSampling
///
/// creates a domain from a mesh and its map to the sphere. Isolated vertices are ignored. Coordinates of an exact number type are
/// rounded to double precision.
///
/// <b>Complexity.</b> The running time is linear in the size of the mesh.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a \cgal kernel
///
/// \param tmesh the mesh
/// \param vertex_sphere_map the directions of the vertices: points at any distance from the origin
/// \param domain receives the domain
///
/// \return `OK`; a defect of the mesh, see `find_defect()`, or of its map: `ERROR_NO_1_TO_1_MAPPING` if it is not bijective. The
///         domain is not changed if an error is returned.
///
/// \sa `CGAL::Spherical_parameterization::remesh_through_sphere()`
template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap>
Error_code make_sphere_domain(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map, Sphere_domain_3& domain)
{
  internal::Mesh_on_sphere<TriangleMesh, VertexSphereMap> mesh;
  if(const Error_code error = mesh.read(tmesh, vertex_sphere_map, false, internal::execution_of<ConcurrencyTag>()))
    return error;
  Sphere_domain_3 result;
  result.m_directions.reserve(mesh.images.size());
  for(const internal::Vector_3d& p : internal::read_points(mesh.vertices_of_mesh, vertex_sphere_map))
    result.m_directions.emplace_back(p[0], p[1], p[2]);
  result.m_triangles.reserve(mesh.triangles.size());
  for(const internal::Linked_triangle& t : mesh.triangles)
    result.m_triangles.push_back(t.vertices);
  domain = std::move(result);
  return OK;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Sampling/internal/sampling_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_SPHERE_DOMAIN_3_H
