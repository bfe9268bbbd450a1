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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_MESH_PAIR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_MESH_PAIR_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/run/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

// The meshes and maps of a call for two surfaces: what is read here is all that is done with them.
template <class TriangleMesh1, class VertexSphereMap1, class TriangleMesh2, class VertexSphereMap2>
struct Mesh_pair
{
  Mesh_on_sphere<TriangleMesh1, VertexSphereMap1> first;
  Mesh_on_sphere<TriangleMesh2, VertexSphereMap2> second;

  template <class NamedParameters1, class NamedParameters2>
  Error_code read(const TriangleMesh1& tmesh1, const VertexSphereMap1& map1, const NamedParameters1& np1,
                  const TriangleMesh2& tmesh2, const VertexSphereMap2& map2, const NamedParameters2& np2,
                  const Execution& execution)
  {
    if(const Error_code error = first.read_with_points(tmesh1, map1, vertex_point_map_of(tmesh1, np1), execution))
      return error;
    return second.read_with_points(tmesh2, map2, vertex_point_map_of(tmesh2, np2), execution);
  }
};

// Takes over the arrays of a mesh that has been read.
template <class Arrays>
Surface_on_sphere surface_of(Arrays& arrays)
{
  return {std::move(arrays.points), std::move(arrays.images), std::move(arrays.triangles)};
}

// The largest number of vertices of a common refinement, if it is given.
template <class NamedParameters>
std::optional<std::size_t> maximum_number_of(const NamedParameters& np)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::maximum_number_t>::value)
    return std::nullopt;
  else
    return static_cast<std::size_t>(parameters::get_parameter(np, internal_np::maximum_number));
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_MESH_PAIR_H
