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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_READ_TWO_SURFACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_READ_TWO_SURFACES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/run/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/run/Visitor_control.h>
#include <CGAL/Spherical_parameterization/internal/run/check_run.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Checks the types of a function of two surfaces that computes in double precision, unless it accepts all types that
// Exact_predicates_kernel accepts.
template <bool takes_exact_numbers, class TriangleMesh1, class VertexSphereMap1, class TriangleMesh2,
          class VertexSphereMap2>
constexpr bool check_pair()
{
  if constexpr(check_mesh_and_readable_map<TriangleMesh1, VertexSphereMap1>() &&
               check_mesh_and_readable_map<TriangleMesh2, VertexSphereMap2>())
  {
    using K1 = typename Exact_predicates_kernel_of_map<VertexSphereMap1>::type;
    using K2 = typename Exact_predicates_kernel_of_map<VertexSphereMap2>::type;
    constexpr bool are_numbers =
        takes_exact_numbers || (std::is_same<typename K1::FT, double>::value && std::is_same<K1, K2>::value);
    static_assert(are_numbers, "The coordinates of both maps to the sphere have to be of type double or float.");
    return are_numbers;
  }
  return false;
}

// Checks a call of a function of two surfaces, reads both as Mesh_on_sphere, and returns f(first, second, control, execution).
template <class ConcurrencyTag, bool takes_exact_numbers = false, class TriangleMesh1, class VertexSphereMap1,
          class NamedParameters1, class TriangleMesh2, class VertexSphereMap2, class NamedParameters2, class Function>
Error_code with_two_surfaces(const TriangleMesh1& tmesh1, const VertexSphereMap1& map1, const NamedParameters1& np1,
                             const TriangleMesh2& tmesh2, const VertexSphereMap2& map2, const NamedParameters2& np2,
                             const Function& f)
{
  if constexpr(check_pair<takes_exact_numbers, TriangleMesh1, VertexSphereMap1, TriangleMesh2, VertexSphereMap2>() &&
               check_run_parameters<TriangleMesh1, NamedParameters1>() &&
               check_vertex_point_map<TriangleMesh2, NamedParameters2>())
  {
    Visitor_control<NamedParameters1> control(np1);
    const Execution execution = execution_of<ConcurrencyTag>();
    Mesh_on_sphere<TriangleMesh1, VertexSphereMap1> first;
    Mesh_on_sphere<TriangleMesh2, VertexSphereMap2> second;
    if(const Error_code error = first.read_with_points(tmesh1, map1, np1, execution))
      return error;
    if(const Error_code error = second.read_with_points(tmesh2, map2, np2, execution))
      return error;
    return f(first, second, static_cast<Run_control&>(control), execution);
  }
  else
    return ERROR_WRONG_PARAMETER;
}

// Moves the arrays out of a mesh that has been read.
template <class Arrays>
Surface_on_sphere surface_of(Arrays& arrays)
{
  return {std::move(arrays.points), std::move(arrays.images), std::move(arrays.triangles)};
}

// Reads features, each a pair of functions of a vertex, for the first (0) or the second (1) surface. Returns false if a value is not
// finite.
template <std::size_t surface, class Features, class Vertices>
bool read_features(const Features& features, const Vertices& vertices, std::vector<std::vector<double>>& channels)
{
  for(const auto& feature : features)
  {
    channels.emplace_back();
    for(const auto v : vertices)
    {
      channels.back().push_back(std::get<surface>(feature)(v));
      if(!is_finite(channels.back().back()))
        return false;
    }
  }
  return true;
}

// Reads the indices of the landmarks on one of the surfaces. Returns false if a landmark is not among its vertices, or occurs twice.
template <std::size_t surface, class Landmarks, class Vertex>
bool read_landmarks(const Landmarks& landmarks, const std::vector<Vertex>& vertices,
                    std::vector<std::array<std::uint32_t, 2>>& numbers)
{
  std::map<Vertex, std::size_t> indices; // the indices of the landmarks
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

// Reads the mask of excluded vertices. Returns false if all vertices are excluded.
template <class Function, class Vertices>
bool read_mask(const Function& counts, const Vertices& vertices, std::vector<char>& mask)
{
  if(!counts)
    return true;
  for(const auto v : vertices)
    mask.push_back(!counts(v));
  return std::find(mask.begin(), mask.end(), 0) != mask.end();
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_READ_TWO_SURFACES_H
