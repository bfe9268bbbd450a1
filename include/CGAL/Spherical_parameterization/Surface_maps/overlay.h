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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_OVERLAY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_OVERLAY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/overlay_surfaces.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/read_two_surfaces.h>
#include <CGAL/Spherical_parameterization/internal/run/maximum_number.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// The common refinement of two surfaces that have maps to the same sphere, as `overlay()` makes it: triangles, each of
/// which is a part of one face of the first surface and of one face of the second. It is closed: with `points` of either
/// surface, `triangles` are that surface; and what is between the two points of a vertex is a morph.
///
/// \tparam TriangleMesh1,TriangleMesh2 models of `FaceListGraph`
template <class TriangleMesh1, class TriangleMesh2>
struct Surface_overlay_3
{
  /// Type of the points
  using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;

  /// For each vertex, the corresponding points of the first surface and of the second one
  std::vector<std::array<Point_3, 2>> points;

  /// The vertices of each triangle, counterclockwise as seen from outside
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// For each triangle, the face of the first surface and that of the second one which it is a part of
  std::vector<std::pair<typename boost::graph_traits<TriangleMesh1>::face_descriptor,
                        typename boost::graph_traits<TriangleMesh2>::face_descriptor>>
      faces;
};

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// makes the common refinement of two surfaces that have maps to the same sphere. Composed, the maps are one between the
/// surfaces, and the refinement is where both are linear: its cells are the parts of the sphere that are in the image of one
/// face of each. The map is projective between the two faces of a cell; on each of the triangles that it is divided into, it
/// is taken as affine. Such refinements were introduced for morphing \cgalCite{cgal:kcp-stpo-92}, \cgalCite{cgal:a-mpssf-00}.
///
/// The connectivity is exact: the faces of the other mesh that contain the vertices, and which edges cross, are decided by
/// exact predicates on the points as they are in the maps. Ties, such as a vertex on an edge, or equal meshes, are broken as
/// if the first sphere were moved by an infinitesimal linear map, a simulation of simplicity \cgalCite{cgal:em-sstcd-90};
/// then triangles have no area, but are where they belong.
/// The result is certified: the edges of both meshes, traced through the other one, cross the same edges; the parts of edges
/// around each cell are one polygon; and Euler's formula holds. Points of crossings are rounded.
///
/// The running time is \f$ O(n \log n) \f$ for `n` faces and crossings, of which each takes some 200 bytes. Long and narrow
/// faces have many; so have vertices of high degree that coincide, \f$ d^2 / 2 \f$ for a degree of \f$ d \f$ of both. They are
/// counted first, and there is a bound.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh1,TriangleMesh2 models of `FaceListGraph`
/// \tparam VertexSphereMap1,VertexSphereMap2 models of `ReadablePropertyMap` from the vertices of the meshes to `%Point_3`
///         of a \cgal kernel; the coordinates are of type `double` or `float`
/// \tparam NamedParameters1,NamedParameters2 sequences of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh1,tmesh2 the first surface and the second one
/// \param vertex_sphere_map1,vertex_sphere_map2 the images of their vertices, at any distance from the origin
/// \param result receives the refinement
/// \param np1,np2 optional sequences of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh1`, or `tmesh2`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh1)`, or of `tmesh2`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{of `np1`: a visitor whose `go_further()` may stop the run}
///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{of `np1`: the time in seconds after which the run is stopped}
///     \cgalParamType{double}
///     \cgalParamDefault{no limit, as with any value that is not positive}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{of `np1`: the largest number of vertices of the refinement, at most 2<sup>32</sup> - 2}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{4,194,304, or 32 times the number of vertices of both meshes, whichever is more}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; the defect of the first mesh, or else of the second one, see `find_defect()`, or with its map:
///         `ERROR_NO_1_TO_1_MAPPING` if that is no bijection; `ERROR_TOO_LARGE_OVERLAY` if the refinement would have more
///         vertices than the bound; or `ERROR_STOPPED`. The result is as it was then.
///
/// \sa `CGAL::Spherical_parameterization::measure_distortion_between()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh1, class VertexSphereMap1,
          class TriangleMesh2, class VertexSphereMap2, typename CGAL_NP_TEMPLATE_PARAMETERS_1,
          typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Error_code overlay(const TriangleMesh1& tmesh1, VertexSphereMap1 vertex_sphere_map1, const TriangleMesh2& tmesh2,
                   VertexSphereMap2 vertex_sphere_map2, Surface_overlay_3<TriangleMesh1, TriangleMesh2>& result,
                   const CGAL_NP_CLASS_1& np1 = parameters::default_values(),
                   const CGAL_NP_CLASS_2& np2 = parameters::default_values())
{
  const auto run = [&](auto& first, auto& second, internal::Run_control& control,
                       const internal::Execution& execution) -> Error_code {
    using Overlay = Surface_overlay_3<TriangleMesh1, TriangleMesh2>;
    using Point_3 = typename Overlay::Point_3;
    internal::Overlay_arrays arrays;
    if(const Error_code error = internal::make_overlay(internal::surface_of(first), internal::surface_of(second),
                                                       internal::maximum_number_of(np1), arrays, control, execution))
      return error;
    Overlay overlay;
    overlay.points.reserve(arrays.points[0].size());
    for(std::size_t v = 0; v < arrays.points[0].size(); ++v)
    {
      const internal::Vector_3d &p = arrays.points[0][v], &q = arrays.points[1][v];
      overlay.points.push_back({Point_3(p[0], p[1], p[2]), Point_3(q[0], q[1], q[2])});
    }
    overlay.faces.reserve(arrays.parents.size());
    for(const auto& parents : arrays.parents)
      overlay.faces.emplace_back(first.faces_of_mesh[parents[0]], second.faces_of_mesh[parents[1]]);
    overlay.triangles = std::move(arrays.triangles);
    result = std::move(overlay);
    return OK;
  };
  return internal::with_two_surfaces<ConcurrencyTag>(tmesh1, vertex_sphere_map1, np1, tmesh2, vertex_sphere_map2, np2,
                                                     run);
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_OVERLAY_H
