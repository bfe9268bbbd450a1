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
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Mesh_pair.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_map_settings.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/find_surface_map.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/run/check_run.h>
#include <CGAL/Spherical_parameterization/internal/run/write_map.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Reads the numbers of the landmarks on one of the surfaces among its vertices. Returns false if one is not among them, or
// there twice.
template <std::size_t surface, class Landmarks, class Vertex>
bool read_landmarks(const Landmarks& landmarks, const std::vector<Vertex>& vertices,
                    std::vector<std::array<std::uint32_t, 2>>& numbers)
{
  std::map<Vertex, std::size_t> indices; // of the landmarks
  for(std::size_t k = 0; k < landmarks.size(); ++k)
    indices.emplace(std::get<surface>(landmarks[k]), k);
  numbers.resize(landmarks.size());
  std::size_t n_found = 0;
  for(std::uint32_t v = 0; v < vertices.size(); ++v)
    if(const auto found = indices.find(vertices[v]); found != indices.end())
    {
      numbers[found->second][surface] = v;
      ++n_found;
    }
  return n_found == landmarks.size();
}

// Reads where a surface does not count. Returns false if it does nowhere.
template <class Function, class Vertices>
bool read_mask(const Function& counts, const Vertices& vertices, std::vector<char>& mask)
{
  if(!counts)
    return true;
  for(const auto v : vertices)
    mask.push_back(!counts(v));
  return std::find(mask.begin(), mask.end(), 0) != mask.end();
}

// A run between surfaces, from the caller's meshes and maps to the caller's map: reads, finds the map, certifies and writes.
template <class ConcurrencyTag, class TriangleMesh1, class VertexSphereMap1, class TriangleMesh2,
          class VertexSphereMap2, class Landmarks, class Features, class Masks, class VertexDirectionMap,
          class NamedParameters1, class NamedParameters2>
Error_code run_surface_map(const TriangleMesh1& tmesh1, VertexSphereMap1 vertex_sphere_map1,
                           const TriangleMesh2& tmesh2, VertexSphereMap2 vertex_sphere_map2, const Landmarks& landmarks,
                           const Features& features, const Masks& masks, Surface_map_settings settings,
                           VertexDirectionMap vertex_direction_map, Surface_map_report& report,
                           const NamedParameters1& np1, const NamedParameters2& np2)
{
  if constexpr(check_two_spheres<TriangleMesh1, VertexSphereMap1, TriangleMesh2, VertexSphereMap2>() &&
               check_run_parameters<TriangleMesh1, NamedParameters1>() &&
               check_vertex_point_map<TriangleMesh2, NamedParameters2>())
  {
    Visitor_control<NamedParameters1> control(np1);
    const Execution execution = execution_of<ConcurrencyTag>();
    if(!settings.are_valid(features.size()))
      return ERROR_WRONG_PARAMETER;
    Mesh_pair<TriangleMesh1, VertexSphereMap1, TriangleMesh2, VertexSphereMap2> meshes;
    if(const Error_code error =
           meshes.read(tmesh1, vertex_sphere_map1, np1, tmesh2, vertex_sphere_map2, np2, execution))
      return error;
    const auto &vertices1 = meshes.first.vertices_of_mesh, &vertices2 = meshes.second.vertices_of_mesh;
    if(!read_landmarks<0>(landmarks, vertices1, settings.landmarks) ||
       !read_landmarks<1>(landmarks, vertices2, settings.landmarks))
      return ERROR_INVALID_LANDMARK;
    if(!read_features<0>(features, vertices1, settings.features[0]) ||
       !read_features<1>(features, vertices2, settings.features[1]) ||
       !read_mask(masks.first, vertices1, settings.masks[0]) || !read_mask(masks.second, vertices2, settings.masks[1]))
      return ERROR_WRONG_PARAMETER;
    Index_triangles triangles;
    for(const Linked_triangle& t : meshes.first.triangles)
      triangles.push_back(t.vertices);
    std::vector<Vector_3d> directions;
    if(const Error_code error = find_surface_map(surface_of(meshes.first), surface_of(meshes.second),
                                                 std::move(settings), directions, report, control, execution))
      return error;
    return write_map(vertices1, triangles, directions, 1., Guarantee::ONE_TO_ONE, vertex_direction_map, execution);
  }
  else
    return ERROR_WRONG_PARAMETER;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_RUN_SURFACE_MAP_H
