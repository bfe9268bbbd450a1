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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_RUN_SURFACE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_RUN_SURFACE_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Surface_map_report.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_map_hints.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/find_surface_map.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/run/check_run.h>
#include <CGAL/Spherical_parameterization/internal/run/write_map.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// What the caller knows of two surfaces, in the caller's terms; see Surface_mapper_3.
template <class Landmark, class Feature, class Masks>
struct Surface_map_settings
{
  const std::vector<Landmark>& landmarks;
  std::optional<double> landmark_weight;
  const std::vector<Feature>& features;
  double feature_weight;
  const std::vector<double>& feature_weights; // of each; empty if all are the same
  bool compares_values;
  const Masks& masks; // functions, empty if all of a surface counts
  bool keeps_alignment;

  bool are_valid() const
  {
    const bool are_weights =
        std::all_of(feature_weights.begin(), feature_weights.end(), [](double w) { return w >= 0. && is_finite(w); });
    const double sum = std::accumulate(feature_weights.begin(), feature_weights.end(), 0.);
    return !(landmark_weight && !is_positive_and_finite(*landmark_weight)) && feature_weight >= 0. &&
           is_finite(feature_weight) &&
           (feature_weights.empty() ||
            (feature_weights.size() == features.size() && are_weights && is_positive_and_finite(sum)));
  }
};

// The numbers of the landmarks on one of the surfaces among its vertices: none if one is not among them, or there twice.
template <std::size_t surface, class Landmark, class Vertex>
std::vector<std::uint32_t> numbers_of_landmarks(const std::vector<Landmark>& landmarks,
                                                const std::vector<Vertex>& vertices)
{
  std::map<Vertex, std::size_t> places; // of the landmarks
  for(std::size_t k = 0; k < landmarks.size(); ++k)
    places.emplace(std::get<surface>(landmarks[k]), k);
  std::vector<std::uint32_t> result(landmarks.size());
  std::size_t n_found = 0;
  for(std::uint32_t v = 0; v < vertices.size(); ++v)
    if(const auto place = places.find(vertices[v]); place != places.end())
    {
      result[place->second] = v;
      ++n_found;
    }
  if(n_found < landmarks.size())
    result.clear();
  return result;
}

// Reads where a surface does not count. Returns false if it does nowhere.
template <class Function, class Vertices>
bool read_mask(const Function& counts, const Vertices& vertices, Mask& mask)
{
  if(!counts)
    return true;
  for(const auto v : vertices)
    mask.push_back(!counts(v));
  return std::find(mask.begin(), mask.end(), 0) != mask.end();
}

// Reads what is known of the surfaces in terms of their arrays.
template <class Settings, class Vertices1, class Vertices2>
Error_code read_hints(const Settings& settings, const Vertices1& vertices1, const Vertices2& vertices2,
                      Surface_map_hints& hints)
{
  hints.landmark_weight = settings.landmark_weight.value_or(0.);
  hints.feature_weight = settings.feature_weight;
  hints.weights = settings.feature_weights;
  hints.compares_values = settings.compares_values;
  hints.keeps_alignment = settings.keeps_alignment;
  const std::vector<std::uint32_t> first = numbers_of_landmarks<0>(settings.landmarks, vertices1),
                                   second = numbers_of_landmarks<1>(settings.landmarks, vertices2);
  if(first.size() < settings.landmarks.size() || second.size() < settings.landmarks.size())
    return ERROR_INVALID_LANDMARK;
  for(std::size_t k = 0; k < first.size(); ++k)
    hints.landmarks.push_back({first[k], second[k]});
  if(!read_features<0>(settings.features, vertices1, hints.features[0]) ||
     !read_features<1>(settings.features, vertices2, hints.features[1]) ||
     !read_mask(settings.masks.first, vertices1, hints.masks[0]) ||
     !read_mask(settings.masks.second, vertices2, hints.masks[1]))
    return ERROR_WRONG_PARAMETER;
  return OK;
}

// A run between surfaces, from the caller's meshes and maps to the caller's map: reads, finds the map, certifies and writes.
template <class ConcurrencyTag, class TriangleMesh1, class VertexSphereMap1, class TriangleMesh2,
          class VertexSphereMap2, class Settings, class VertexDirectionMap, class NamedParameters1,
          class NamedParameters2>
Error_code run_surface_map(const TriangleMesh1& tmesh1, VertexSphereMap1 vertex_sphere_map1,
                           const TriangleMesh2& tmesh2, VertexSphereMap2 vertex_sphere_map2, const Settings& settings,
                           VertexDirectionMap vertex_direction_map, Surface_map_report& report,
                           const NamedParameters1& np1, const NamedParameters2& np2)
{
  if constexpr(check_two_spheres<TriangleMesh1, VertexSphereMap1, TriangleMesh2, VertexSphereMap2>() &&
               check_run_parameters<TriangleMesh1, NamedParameters1>() &&
               check_vertex_point_map<TriangleMesh2, NamedParameters2>())
  {
    using Arrays1 = Mesh_on_sphere<TriangleMesh1, VertexSphereMap1>;
    using Arrays2 = Mesh_on_sphere<TriangleMesh2, VertexSphereMap2>;
    using K = typename Arrays1::Exact_kernel;

    Visitor_control<NamedParameters1> control(np1);
    const Execution execution = execution_of<ConcurrencyTag>();
    if(!settings.are_valid())
      return ERROR_WRONG_PARAMETER;

    Arrays1 arrays1;
    Arrays2 arrays2;
    if(const Error_code error =
           arrays1.read_with_points(tmesh1, vertex_sphere_map1, vertex_point_map_of(tmesh1, np1), execution))
      return error;
    if(const Error_code error =
           arrays2.read_with_points(tmesh2, vertex_sphere_map2, vertex_point_map_of(tmesh2, np2), execution))
      return error;
    Surface_map_hints hints;
    if(const Error_code error = read_hints(settings, arrays1.vertices_of_mesh, arrays2.vertices_of_mesh, hints))
      return error;
    Located_surface<K> first, second;
    Error_code error1 = OK, error2 = OK;
    run_both(
        execution, [&] { error1 = locate_surface(arrays1, first); }, [&] { error2 = locate_surface(arrays2, second); });
    if(error1 != OK || error2 != OK)
      return error1 != OK ? error1 : error2;
    report.seconds_for_reading = control.lap();

    const std::vector<Vector_3d> directions =
        find_surface_map(first, second, std::move(hints), report, control, execution);
    return write_map(arrays1.vertices_of_mesh, first.mesh.callers_triangles(), directions, 1., Guarantee::ONE_TO_ONE,
                     vertex_direction_map, execution);
  }
  else
    return ERROR_WRONG_PARAMETER;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_RUN_SURFACE_MAP_H
