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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_IS_BIJECTIVE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_IS_BIJECTIVE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Exact_predicates_kernel.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/tags.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// returns whether a map from the vertices of a mesh to points around the origin is a bijection between the mesh and
/// the sphere.
///
/// Each face is mapped linearly to the triangle of its vertices' images, and this triangle is projected to the sphere
/// along the rays from the origin. Only the directions of the images matter; the images need not be on a sphere.
///
/// The answer is exact for the points in the map, with any kernel. It is based on a theorem: if every face (a, b, c) of
/// a closed mesh is positively oriented about the origin, det(a, b, c) > 0, then the map covers all points of the
/// sphere equally often, except for branch points. This number is the degree of the map. If it is one, the map is a
/// homeomorphism. Positive orientations alone are not sufficient, because the faces around a vertex may wind around its
/// image twice. Therefore, the degree is computed as well, as the number of faces that contain a generic direction.
///
/// By the theorem, the result is `false` for a mesh that is not a topological sphere, for example one with several
/// connected components or with handles. It is also `false` for a mesh that is empty, has a border, or has a face that
/// is not a triangle, and if a coordinate is infinite or not a number. Vertices without faces are ignored. The mesh
/// must have fewer than 2^31 halfedges.
///
/// The running time and the additional memory are linear in the number of faces. Only the calling thread reads the
/// property map, and only it evaluates coordinates of an exact number type.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a
///         \cgal kernel; its coordinates are of type `double` or `float`, or of an exact number type
///
/// \param tmesh a triangle mesh
/// \param vertex_sphere_map the images of the vertices
///
/// \return `true` if and only if the map is a bijection
///
/// \sa `CGAL::Spherical_parameterization::measure_distortion()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap>
bool is_bijective(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map)
{
  if constexpr(internal::check_mesh_and_readable_map<TriangleMesh, VertexSphereMap>())
  {
    using Selection = internal::Exact_predicates_kernel_of_map<VertexSphereMap>;
    using Exact_kernel = typename Selection::type;

    internal::Mesh_arrays<TriangleMesh> mesh;
    if(mesh.read(tmesh) != OK)
      return false;
    const auto images = internal::read_values(mesh.vertices_of_mesh, vertex_sphere_map,
                                              [](const auto& p) { return Selection::convert(p); });
    return internal::certify_bijectivity<Exact_kernel>(images, mesh.triangles, internal::execution_of<ConcurrencyTag>())
        .is_bijective();
  }
  else
    return false;
}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_IS_BIJECTIVE_H
