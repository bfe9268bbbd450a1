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
/// The class `Sphere_domain_3` is a triangulation of the sphere, by which a surface is sampled: directions, and triangles
/// that cover the sphere once. There are regular ones, and `make_sphere_domain()` makes one of any mesh that has a map to the
/// sphere.
///
/// The regular ones are solids whose edges are divided into `n`, from 1 to `max_subdivision`; for any other `n`, they are
/// empty. Those of the octahedron and the icosahedron are divided into arcs of the same angle, and their triangles
/// accordingly; the squares of the cube are divided by planes through its axes that are the same angle apart. So the
/// samples are almost evenly spaced: the areas of triangles differ by a factor of at most 1.8 (octahedron), 1.7 (cube)
/// and 1.2 (icosahedron). The vertices of the solid come first, those on its edges next, and those in its faces last.
///
/// \sa `CGAL::Spherical_parameterization::remesh_through_sphere()`
class Sphere_domain_3
{
public:
  /// Type of the directions
  using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;
  /// The numbers of the vertices of a triangle, counterclockwise as seen from outside
  using Triangle = std::array<std::uint32_t, 3>;

  /// The largest number that edges can be divided into: 5000
  static constexpr std::uint32_t max_subdivision = 5000; // of which an icosahedron has 250 million vertices

  /// makes an empty domain.
  Sphere_domain_3() = default;

  /// returns an octahedron whose edges are divided into `n`: \f$ 4 n^2 + 2 \f$ directions of length 1. The vertices of
  /// the octahedron are on the axes.
  static Sphere_domain_3 octahedron(std::uint32_t n) { return regular(8, n); }

  /// returns a cube whose edges are divided into `n`: \f$ 6 n^2 + 2 \f$ directions of length 1. The faces of the cube are
  /// orthogonal to the axes, and each of their squares consists of two triangles.
  static Sphere_domain_3 cube(std::uint32_t n) { return regular(6, n); }

  /// returns an icosahedron whose edges are divided into `n`: \f$ 10 n^2 + 2 \f$ directions of length 1. Two vertices of
  /// the icosahedron are on the z-axis, and one is in the plane of the x-axis and the z-axis.
  static Sphere_domain_3 icosahedron(std::uint32_t n) { return regular(20, n); }

  /// returns whether there is nothing to sample by.
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
/// makes a domain of a mesh and its map to the sphere; vertices without faces are left out. Coordinates of an exact number type
/// are rounded.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a \cgal kernel
///
/// \param tmesh the mesh
/// \param vertex_sphere_map the directions of the vertices: points around the origin, at any distance from it
/// \param domain receives the domain
///
/// \return `OK`; what is wrong with the mesh, see `find_defect()`, or with its map: `ERROR_NO_1_TO_1_MAPPING` if that is no
///         bijection. The domain is as it was then.
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
