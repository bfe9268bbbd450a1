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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TRANSFER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TRANSFER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/sampling/Property_carrier.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <type_traits>
#include <utility>

/// \file transfer.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSampling
///
/// carries properties from one mesh to another one that has a map to the same sphere: two surfaces, a surface and a mesh of
/// the sphere, or the other way round.
///
/// - A vertex of the target gets the interpolated value of the place of the source that has its direction; see
///   `Sphere_locator_3`. Where the target is coarser, that would leave out most values of the source: if all vertices
///   that would be interpolated are inside the star of the vertex, it gets the average of all vertices that are,
///   weighted with the area around them on the surface and with their barycentric coordinate for the vertex. (This is
///   the rule of the adaptive barycentric resampling that is usual for cortical surfaces.)
/// - A face of the target gets the value of the face of the source that has the direction of its centre, which is the sum
///   of its vertices' directions. If the centre of that face is in the face of the target as well, it gets the average
///   of all faces whose centres are, weighted with their areas.
/// - A mesh gets from itself what it has, to the bit, and so does each vertex of the target whose direction is that of a
///   vertex of the source, unless it gets an average.
///
/// Values of these types are interpolated and averaged: floating-point numbers, `%Point_2`, `%Vector_2`, `%Point_3` and
/// `%Vector_3` of a \cgal kernel, `CGAL::IO::Color`, and `std::array` and `std::vector` of any of them; a vector is taken to
/// go on with 0. All other ones, such as `int`, `bool`, enumerations and strings, are labels, of which the one with the
/// largest sum of weights is carried over: the types have an operator `==`.
///
/// The running time is linear in the size of the meshes, but for what `Sphere_locator_3` says; they are copied once for all
/// properties. Maps are read and written by the calling thread alone.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
///         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam SourceMesh a model of `FaceListGraph` with an internal vertex point property map
/// \tparam SourceSphereMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<SourceMesh>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as value
///         type; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam TargetMesh a model of `FaceListGraph`
/// \tparam TargetSphereMap the same for the target; its coordinates are of type `double` or `float` if those of the source
///         are, or else of the same type
/// \tparam SourceMap a model of `ReadablePropertyMap` whose key type is the vertex descriptor or the face descriptor of
///         the source
/// \tparam TargetMap a model of `WritablePropertyMap` whose key type is the vertex descriptor or the face descriptor of
///         the target, accordingly, and whose value type is that of the `SourceMap` or one that this can be converted to
///
/// \param source the mesh that has the properties
/// \param source_sphere the images of its vertices, at any distance from the origin
/// \param target the mesh that gets them
/// \param target_sphere the images of its vertices, at any distance from the origin
/// \param properties for each property, the map of the source and the map of the target
///
/// \return `OK`; or what is wrong with the source, or else the target, see `find_defect()`, or with its map to the sphere:
///         `ERROR_NO_1_TO_1_MAPPING` if that is no bijection. Nothing is written then.
///
/// \sa `CGAL::Spherical_parameterization::remesh_through_sphere()`
template <class ConcurrencyTag = Parallel_if_available_tag, class SourceMesh, class SourceSphereMap, class TargetMesh,
          class TargetSphereMap, class... SourceMap, class... TargetMap>
[[nodiscard]] Error_code transfer(const SourceMesh& source, SourceSphereMap source_sphere, const TargetMesh& target,
                                  TargetSphereMap target_sphere, const std::pair<SourceMap, TargetMap>&... properties)
{
  return internal::carry_properties<ConcurrencyTag>(source, source_sphere, target, target_sphere, [&](auto& carrier) {
    (carrier.carry(properties.first, properties.second), ...);
  });
}

/// \ingroup PkgSphericalParameterizationSampling
///
/// carries all properties of the vertices and faces of a `Surface_mesh`: those whose values are numbers of any type,
/// `bool`, `std::string`, `CGAL::IO::Color`, `%Point_2`, `%Vector_2`, `%Point_3` or `%Vector_3` of the kernel of the
/// mesh's points, `std::array<double, 2>`, `std::array<double, 3>` or `std::vector<double>`. The target gets properties
/// of the same names, in the place of those that it has if they are of the same type. The points of the meshes stay as
/// they are, and so do `source_sphere` and `target_sphere` if they are property maps of the meshes.
///
/// \tparam SourcePoint `%Point_3` of a \cgal kernel
/// \tparam TargetPoint `%Point_3` of a \cgal kernel
template <class ConcurrencyTag = Parallel_if_available_tag, class SourcePoint, class SourceSphereMap, class TargetPoint,
          class TargetSphereMap>
[[nodiscard]] Error_code transfer(const Surface_mesh<SourcePoint>& source, SourceSphereMap source_sphere,
                                  Surface_mesh<TargetPoint>& target, TargetSphereMap target_sphere)
{
  return internal::carry_properties<ConcurrencyTag>(source, source_sphere, target, target_sphere, [&](auto& carrier) {
    internal::carry_all_properties(carrier, source, source_sphere, target, target_sphere);
  });
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TRANSFER_H
