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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_MAP_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_MAP_SURFACE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_map_report.h>
#include <CGAL/Spherical_parameterization/Surface_map_settings.h>
#include <CGAL/Spherical_parameterization/internal/align/Surface_alignment.h>
#include <CGAL/Spherical_parameterization/internal/surface/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/find_surface_map.h>
#include <CGAL/Spherical_parameterization/internal/write_map.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file map_surface.h

namespace CGAL {
namespace Spherical_parameterization {

namespace internal {

// The numbers of the landmarks in the arrays, or none if one is no vertex of a face, or a vertex has two of them.
template <class Arrays1, class Arrays2, class Landmarks>
std::optional<std::vector<std::array<std::uint32_t, 2>>> landmark_numbers(const Arrays1& arrays1,
                                                                          const Arrays2& arrays2,
                                                                          const Landmarks& landmarks)
{
  const auto numbers_of = [&](const auto& vertices, const auto& landmark_of) {
    using Entry = std::pair<typename std::decay_t<decltype(vertices)>::value_type, std::uint32_t>;
    std::vector<Entry> entries;
    for(std::uint32_t v = 0; v < vertices.size(); ++v)
      entries.emplace_back(vertices[v], v);
    std::sort(entries.begin(), entries.end());
    std::vector<std::uint32_t> result;
    std::vector<char> is_used(vertices.size(), 0);
    for(const auto& landmark : landmarks)
    {
      const auto entry = std::lower_bound(entries.begin(), entries.end(), Entry(landmark_of(landmark), 0));
      if(entry == entries.end() || entry->first != landmark_of(landmark) || is_used[entry->second])
        return std::vector<std::uint32_t>();
      is_used[entry->second] = 1;
      result.push_back(entry->second);
    }
    return result;
  };
  std::vector<std::array<std::uint32_t, 2>> result;
  if(landmarks.empty())
    return result;
  const auto first = numbers_of(arrays1.vertices_of_mesh, [](const auto& l) { return l.first; });
  const auto second = numbers_of(arrays2.vertices_of_mesh, [](const auto& l) { return l.second; });
  if(first.empty() || second.empty())
    return std::nullopt;
  for(std::size_t k = 0; k < first.size(); ++k)
    result.push_back({first[k], second[k]});
  return result;
}

} // namespace internal

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// maps a surface one-to-one onto another one, with low distortion in both directions, by means of their maps to the sphere.
/// What it finds is a direction for each vertex of the first surface. As a map to the sphere of the second one, the
/// directions are as certified as any map of this package, and so is the map between the surfaces that they make: from a
/// face of the first one to the sphere, and from there by the inverse of the second map. What lies in a direction is found
/// with `Sphere_locator_3`; `remesh_through_sphere()` gives the second surface with the connectivity of the first one,
/// `transfer()` carries properties over, and `overlay()` is the common refinement.
///
/// The spheres are turned against each other by landmarks, or else by features, see `align_spheres()`, and bent until these
/// agree, if the surfaces are different poses or bodies. From there, the symmetric Dirichlet energy of the map, integrated
/// over both surfaces, is lowered by the steps that `Bijective_low_distortion_parameterizer_3` makes, level by level of a
/// hierarchy, together with terms for soft landmarks and for features. What a face sees of the second surface is the metric
/// that this gives to its sphere. If the spheres agree as they are, the result is the rotation itself, unless the descent
/// has lowered the energy of the common refinement.
///
/// The running time is nearly linear in the size of the meshes: for 26,000 vertices each, some 2.5 seconds on two threads.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
///         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh1 a model of `FaceListGraph` with an internal vertex point property map
/// \tparam VertexSphereMap1 a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh1>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as value
///         type; its coordinates are of type `double` or `float`
/// \tparam TriangleMesh2 a model of `FaceListGraph` with an internal vertex point property map
/// \tparam VertexSphereMap2 the same for it
/// \tparam VertexDirectionMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh1>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as value
///         type
///
/// \param tmesh1 the first surface
/// \param vertex_sphere_map1 the images of its vertices, at any distance from the origin
/// \param tmesh2 the second surface
/// \param vertex_sphere_map2 the images of its vertices, at any distance from the origin
/// \param vertex_direction_map receives for each vertex of the first surface its direction on the sphere of the second
///        one, a point at distance 1 of the origin. It may be `vertex_sphere_map1`.
/// \param settings landmarks and features, if any
/// \param report receives what has been found, if it is not null
///
/// \return `OK`: the map is certified, whether all landmarks are met or not; what is wrong with the first mesh, or else the
///         second one, see `find_defect()`, or with its map: `ERROR_NO_1_TO_1_MAPPING` if that is no bijection;
///         `ERROR_NON_FINITE_COORDINATE` if a point is not finite; `ERROR_INVALID_LANDMARK` if a vertex has two landmarks,
///         or a landmark is no vertex of a face; `ERROR_WRONG_PARAMETER` if the weight of landmarks is not positive, that of
///         features negative, or one of their values not finite; or `ERROR_INSUFFICIENT_PRECISION` if doubles, or the numbers
///         of the map, cannot hold the result. Nothing is written then.
///
/// \sa `CGAL::Spherical_parameterization::measure_distortion_between()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh1, class VertexSphereMap1,
          class TriangleMesh2, class VertexSphereMap2, class VertexDirectionMap>
[[nodiscard]] Error_code map_surface(const TriangleMesh1& tmesh1, VertexSphereMap1 vertex_sphere_map1,
                                     const TriangleMesh2& tmesh2, VertexSphereMap2 vertex_sphere_map2,
                                     VertexDirectionMap vertex_direction_map,
                                     const Surface_map_settings<TriangleMesh1, TriangleMesh2>& settings = {},
                                     Surface_map_report* report = nullptr)
{
  using Arrays1 = internal::Mesh_on_sphere<TriangleMesh1, VertexSphereMap1>;
  using Arrays2 = internal::Mesh_on_sphere<TriangleMesh2, VertexSphereMap2>;
  using K = typename Arrays1::Exact_kernel;
  static_assert(std::is_same<typename K::FT, double>::value && std::is_same<K, typename Arrays2::Exact_kernel>::value,
                "The coordinates of both maps to the sphere have to be of type double or float.");
  const internal::Execution execution = internal::execution_of<ConcurrencyTag>();

  // What the caller has, as flat arrays.
  if((settings.landmark_weight && !internal::is_positive_and_finite(*settings.landmark_weight)) ||
     !(settings.feature_weight >= 0. && internal::is_finite(settings.feature_weight)))
    return ERROR_WRONG_PARAMETER;
  Arrays1 arrays1;
  Arrays2 arrays2;
  if(const Error_code error =
         internal::read_surfaces(tmesh1, vertex_sphere_map1, arrays1, tmesh2, vertex_sphere_map2, arrays2, execution))
    return error;
  internal::Surface_map_hints hints;
  hints.landmark_weight = settings.landmark_weight.value_or(0.);
  hints.feature_weight = settings.feature_weight;
  hints.go_further = settings.go_further;
  if(auto landmarks = internal::landmark_numbers(arrays1, arrays2, settings.landmarks))
    hints.landmarks = std::move(*landmarks);
  else
    return ERROR_INVALID_LANDMARK;
  const auto read_feature = [](const auto& vertices, const auto& feature, auto& channels) {
    channels.emplace_back();
    for(const auto v : vertices)
      channels.back().push_back(feature(v));
  };
  for(const auto& [feature1, feature2] : settings.features)
  {
    read_feature(arrays1.vertices_of_mesh, feature1, hints.features[0]);
    read_feature(arrays2.vertices_of_mesh, feature2, hints.features[1]);
  }
  for(const auto& channels : hints.features)
    if(!internal::Surface_alignment::are_finite(channels))
      return ERROR_WRONG_PARAMETER;
  internal::Indexed_mesh mesh;
  {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for(const internal::Linked_triangle& t : arrays1.triangles)
      triangles.push_back(t.vertices);
    if(const Error_code error = mesh.assign(arrays1.points, triangles))
      return error;
  }
  internal::Located_surface<K> first, second;
  first.set_points(std::move(arrays1.points));
  first.sphere.assign(std::move(arrays1.images), std::move(arrays1.triangles));
  second.set_points(std::move(arrays2.points));
  second.sphere.assign(std::move(arrays2.images), std::move(arrays2.triangles));
  internal::run_both(
      execution, [&] { first.sphere.make_grid(); }, [&] { second.sphere.make_grid(); });

  const auto found = internal::find_surface_map(mesh, first, second, hints, execution);
  if(!found)
    return ERROR_INSUFFICIENT_PRECISION;
  if(const Error_code error = internal::write_map(mesh, arrays1.vertices_of_mesh, found->positions, 1.,
                                                  internal::Guarantee::ONE_TO_ONE, vertex_direction_map, execution))
    return error;
  if(report)
    *report = found->report;
  return OK;
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_MAP_SURFACE_H
