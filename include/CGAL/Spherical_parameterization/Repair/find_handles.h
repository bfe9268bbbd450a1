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
/// A handle of a surface, represented by a handle cycle. A surface with handles cannot be mapped to a sphere.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
template <class TriangleMesh>
struct Handle
{
  /// A short non-separating cycle around the handle or through it. Edges connect each vertex to the next one, and the
  /// last vertex to the first one. Cutting the surface along the cycle and filling both sides removes one handle.
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> path;
  double length = 0.; ///< the length of the cycle, in the unit of the mesh
};

namespace internal {

struct Handle_cycle
{
  std::vector<std::uint32_t> vertices; // of a cycle, in order
  double length = 0.;
};

// Finds at most `max_handles` handle cycles of a closed connected surface.
std::vector<Handle_cycle> find_handle_cycles(const Index_triangles& triangles, std::vector<Vector_3d> points,
                                             std::size_t max_handles);

} // namespace internal

/// \ingroup PkgSphericalParameterizationRepair
///
/// finds the handles of a surface, such as the tiny handles that scans and marching cubes produce.
///
/// Each handle is represented by a non-separating cycle from a tree-cotree decomposition \cgalCite{cgal:ew-gohh-05} of
/// the surface, cut along the previous cycles. Cycles that enclose a small area are preferred. Therefore cycles are
/// short and small handles tend to come first, but neither the order nor the minimum length is guaranteed.
///
/// The running time is \f$ O(n \log n) \f$ for each handle, 0.2 seconds for 100,000 vertices.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a closed surface
/// \param handles receives the handles; empty if the surface has genus 0, and on an error
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{the maximum number of handles to be found}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`, or the first error of the mesh other than handles, see `find_defect()`
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
  for(const internal::Handle_cycle& path :
      internal::find_handle_cycles(arrays.triangles, internal::read_points(arrays.vertices_of_mesh, vpm), max_handles))
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
