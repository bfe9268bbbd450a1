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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_FIND_HANDLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_FIND_HANDLES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/run/maximum_number.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationRepair
///
/// A handle of a surface, which keeps it from being mapped to a sphere.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
template <class TriangleMesh>
struct Handle
{
  /// a short closed path around it, or through it: there is an edge from each vertex to the next one, and from the last to the
  /// first. Where the surface is cut along it, and both sides are filled, there is one handle less.
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> path;
  double length = 0.; ///< of the path, in the unit of the mesh
};

namespace internal {

struct Handle_path
{
  std::vector<std::uint32_t> vertices; // each is joined to the next one, and the last to the first
  double length = 0.;
};

// Finds paths around the handles of a closed connected surface, at most so many.
std::vector<Handle_path> find_handle_paths(const Index_triangles& triangles, std::vector<Vector_3d> points,
                                           std::size_t max_handles);

} // namespace internal

/// \ingroup PkgSphericalParameterizationRepair
///
/// finds the handles of a surface, such as tiny ones that a scan or marching cubes have left, the ones with the shortest paths first,
/// as far as that is easily found: a tree of shortest paths and a tree of faces across other edges \cgalCite{cgal:ew-gohh-05} give
/// a closed path that does not separate the surface; it is shortened by looking for it from its own middle, and the next one is
/// looked for on the surface that is cut there.
///
/// It takes time of the order of n log n for each handle: 0.2 s on 100,000 vertices.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a closed surface
/// \param handles receives the handles: none if it is a sphere
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{the largest number of handles that are looked for}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{any}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`, or what else is wrong with the mesh than handles; see `find_defect()`
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code find_handles(const TriangleMesh& tmesh, std::vector<Handle<TriangleMesh>>& handles,
                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  handles.clear();
  const std::size_t max_handles = internal::maximum_number_of(np).value_or((std::numeric_limits<std::size_t>::max)());
  internal::Mesh_arrays<TriangleMesh> arrays;
  internal::Surface surface;
  const auto vpm = internal::vertex_point_map_of(tmesh, np);
  const Error_code error = internal::read_surface(tmesh, vpm, arrays, surface);
  if(error != ERROR_NO_TOPOLOGICAL_SPHERE)
    return error;
  for(const internal::Handle_path& path :
      internal::find_handle_paths(arrays.triangles, internal::read_points(arrays.vertices_of_mesh, vpm), max_handles))
  {
    handles.emplace_back();
    for(const std::uint32_t v : path.vertices)
      handles.back().path.push_back(arrays.vertices_of_mesh[v]);
    handles.back().length = path.length;
  }
  return OK;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Repair/internal/find_handles_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_FIND_HANDLES_H
