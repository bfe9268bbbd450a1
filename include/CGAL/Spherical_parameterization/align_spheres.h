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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ALIGN_SPHERES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ALIGN_SPHERES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Sphere_alignment_3.h>
#include <CGAL/Spherical_parameterization/internal/align/Rotation_search.h>
#include <CGAL/Spherical_parameterization/internal/align/Sphere_grid.h>
#include <CGAL/Spherical_parameterization/internal/align/Surface_alignment.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// \file align_spheres.h

namespace CGAL {
namespace Spherical_parameterization {

namespace internal {

inline Sphere_alignment_3::Rotation_3 as_transformation(const Rotation_matrix& r)
{
  return {r[0][0], r[0][1], r[0][2], r[1][0], r[1][1], r[1][2], r[2][0], r[2][1], r[2][2]};
}

// Reads a mesh, its map and features of its vertices, and samples them at the directions of a grid.
template <class TriangleMesh, class VertexSphereMap, class... FeatureMap>
Error_code read_samples(const Sphere_grid& grid, const TriangleMesh& tmesh, const VertexSphereMap& vertex_sphere_map,
                        const Execution& execution, Surface_alignment::Samples& samples, const FeatureMap&... maps)
{
  using Arrays = Mesh_on_sphere<TriangleMesh, VertexSphereMap>;
  Arrays arrays;
  if(const Error_code error = arrays.read(tmesh, vertex_sphere_map, false, execution))
    return error;
  if(const Error_code error = arrays.read_points(get(vertex_point, tmesh)))
    return error;
  std::vector<Surface_alignment::Channel> features;
  [[maybe_unused]] const auto read = [&](const auto& map) {
    features.emplace_back();
    for(const auto v : arrays.vertices_of_mesh)
      features.back().push_back(CGAL::to_double(get(map, v)));
  };
  (read(maps), ...);
  if(!Surface_alignment::are_finite(features))
    return ERROR_WRONG_PARAMETER;
  Sphere_triangulation<typename Arrays::Exact_kernel> images;
  images.assign(std::move(arrays.images), std::move(arrays.triangles));
  images.make_grid();
  samples = Surface_alignment::samples_of(grid, images, arrays.points, features, execution);
  return OK;
}

} // namespace internal

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// finds the rotations that bring the sphere of one surface onto that of another one such that the surfaces agree best, among
/// all rotations and without a start. What is compared are features of the surfaces that do not depend on how they lie in
/// space, and little on their pose: how much the maps change areas; the average geodesic distance of a place from all others;
/// and the mean curvature, with its sign, at two scales, which tells front from back where a half turn would exchange both
/// sides of a body. Instead, the caller may give any features.
///
/// Both surfaces are sampled at the same 4002 directions. Only the order of the values of a feature counts, so that scales
/// and outliers do not matter. The score of a rotation is the correlation of all features, evenly over the sphere. 12,000
/// rotations are tried, and the best ones refined to about 0.2 degrees.
///
/// It is meant for surfaces that are nearly isometric, such as poses of a body, with maps made in the same way. Between
/// bodies of other proportions it is likely to fail: look at the margin, and give landmarks or features.
///
/// Rotations never exchange a surface and its mirror image. To align with that, mirror one of the meshes: change the sign
/// of one coordinate, of its points and of its map, and the orientation of its faces.
///
/// The running time is linear in the size of the meshes; for less than 100,000 vertices, it is that of the comparison.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
///         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh1 a model of `FaceListGraph` with an internal vertex point property map
/// \tparam VertexSphereMap1 a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh1>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as value
///         type; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam TriangleMesh2 a model of `FaceListGraph` with an internal vertex point property map
/// \tparam VertexSphereMap2 the same for it
/// \tparam FeatureMap1 a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh1>::%vertex_descriptor` as key type and a number type as value type
/// \tparam FeatureMap2 the same for the second mesh
///
/// \param tmesh1 the first surface
/// \param vertex_sphere_map1 the images of its vertices, at any distance from the origin
/// \param tmesh2 the second surface
/// \param vertex_sphere_map2 the images of its vertices, at any distance from the origin
/// \param result receives the rotations of the first sphere
/// \param features for each feature that is to be compared, the map of the first mesh and that of the second one; if there
///        are none, those of the package are
///
/// \return `OK`; what is wrong with the first mesh, or else the second one, see `find_defect()`, or with its map:
///         `ERROR_NO_1_TO_1_MAPPING` if that is no bijection; `ERROR_NON_FINITE_COORDINATE` if a point is not finite; or
///         `ERROR_WRONG_PARAMETER` if the value of a feature is not. The result is as it was then.
///
/// \sa `CGAL::Spherical_parameterization::fit_rotation()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh1, class VertexSphereMap1,
          class TriangleMesh2, class VertexSphereMap2, class... FeatureMap1, class... FeatureMap2>
[[nodiscard]] Error_code align_spheres(const TriangleMesh1& tmesh1, VertexSphereMap1 vertex_sphere_map1,
                                       const TriangleMesh2& tmesh2, VertexSphereMap2 vertex_sphere_map2,
                                       Sphere_alignment_3& result,
                                       const std::pair<FeatureMap1, FeatureMap2>&... features)
{
  const internal::Execution execution = internal::execution_of<ConcurrencyTag>();
  const internal::Sphere_grid grid;
  internal::Surface_alignment::Samples first, second;
  if(const Error_code error =
         internal::read_samples(grid, tmesh1, vertex_sphere_map1, execution, first, features.first...))
    return error;
  if(const Error_code error =
         internal::read_samples(grid, tmesh2, vertex_sphere_map2, execution, second, features.second...))
    return error;
  const internal::Surface_alignment alignment(grid, std::move(first), std::move(second), execution);
  constexpr std::size_t n_candidates = 4;
  result.candidates.clear();
  for(const internal::Scored_rotation& candidate : alignment.best_rotations(n_candidates))
    result.candidates.push_back({internal::as_transformation(candidate.rotation), candidate.score});
  return OK;
}

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// finds the rotation that brings the sphere of one surface onto that of another one such that landmarks come as near as
/// possible to theirs: the sum of the squared distances between their directions is least. It is never a reflection.
///
/// The running time is linear in the number of landmarks.
///
/// \tparam VertexSphereMap1 a model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type
/// \tparam VertexSphereMap2 the same for the second surface
/// \tparam Landmarks a range of `std::pair` of a vertex of the first surface and one of the second surface, the keys of
///         the maps
///
/// \param vertex_sphere_map1 the images of the vertices of the first surface, at any distance from the origin
/// \param vertex_sphere_map2 the images of the vertices of the second surface, at any distance from the origin
/// \param landmarks pairs of vertices that correspond
/// \param rotation receives the rotation of the first sphere
///
/// \return `OK`; `ERROR_INVALID_DIRECTION` if an image is zero or not finite; or `ERROR_UNDETERMINED_ROTATION` if several
///         rotations are equally good: with fewer than two landmarks, or if all lie in one direction and its opposite. The
///         rotation is as it was then.
///
/// \sa `CGAL::Spherical_parameterization::align_spheres()`
template <class VertexSphereMap1, class VertexSphereMap2, class Landmarks>
[[nodiscard]] Error_code fit_rotation(VertexSphereMap1 vertex_sphere_map1, VertexSphereMap2 vertex_sphere_map2,
                                      const Landmarks& landmarks, Sphere_alignment_3::Rotation_3& rotation)
{
  std::vector<std::pair<internal::Vector_3d, internal::Vector_3d>> directions;
  for(const auto& [v, w] : landmarks)
  {
    const auto direction = [](const auto& p) {
      return internal::direction_of({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    };
    const auto p = direction(get(vertex_sphere_map1, v)), q = direction(get(vertex_sphere_map2, w));
    if(!p || !q)
      return ERROR_INVALID_DIRECTION;
    directions.emplace_back(*p, *q);
  }
  const std::optional<internal::Rotation_matrix> matrix = internal::fitting_rotation(directions);
  if(!matrix)
    return ERROR_UNDETERMINED_ROTATION;
  rotation = internal::as_transformation(*matrix);
  return OK;
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ALIGN_SPHERES_H
