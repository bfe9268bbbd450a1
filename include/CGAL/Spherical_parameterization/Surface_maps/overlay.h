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
/// The class `Surface_overlay_3` contains the common refinement of two surfaces with maps to the same sphere, computed by
/// `overlay()`. Each triangle is a part of one face of the first surface and of one face of the second surface.
///
/// The refinement is closed: `triangles` with the `points` of either surface describe that surface. Interpolation between the
/// two points of each vertex yields a morph.
///
/// \tparam TriangleMesh1,TriangleMesh2 models of `FaceListGraph`
template <class TriangleMesh1, class TriangleMesh2>
struct Surface_overlay_3
{
  /// Type of the points
  using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;

  /// For each vertex, the corresponding points of the first and the second surface
  std::vector<std::array<Point_3, 2>> points;

  /// The vertices of each triangle, counterclockwise as seen from outside
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// For each triangle, the faces of the first and the second surface that contain it
  std::vector<std::pair<typename boost::graph_traits<TriangleMesh1>::face_descriptor,
                        typename boost::graph_traits<TriangleMesh2>::face_descriptor>>
      faces;
};

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// computes the common refinement of two surfaces that have maps to the same sphere.
///
/// Composed, the maps are a map between the surfaces. The cells of the refinement are the parts of the sphere that lie in the
/// image of one face of each surface. The map is projective between the two faces of a cell. Cells are triangulated, and the
/// map is approximated by an affine one in each triangle. Such refinements were introduced for morphing
/// \cgalCite{cgal:kcp-stpo-92}, \cgalCite{cgal:a-mpssf-00}.
///
/// <b>Guarantee.</b> The connectivity is exact: exact predicates on the points in the maps determine the faces of the other
/// mesh that contain vertices, and the edges that cross. Ties, such as a vertex on an edge or equal meshes, are resolved by
/// simulation of simplicity \cgalCite{cgal:em-sstcd-90}, as if an infinitesimal linear map were applied to the first sphere.
/// The resulting triangles have no area, but their position is correct. The result is certified: tracing the edges of each
/// mesh through the other one yields the same crossings, the parts of edges around each cell form one polygon, and Euler's
/// formula holds. The points of crossings are rounded.
///
/// <b>Complexity.</b> The running time is \f$ O(n \log n) \f$ for \f$ n \f$ faces and crossings. Each crossing takes about 200
/// bytes. Long and narrow faces have many crossings. Two vertices of degree \f$ d \f$ that coincide have \f$ d^2 / 2 \f$
/// crossings. Crossings are counted before the refinement is built, and their number is limited by `maximum_number`.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh1,TriangleMesh2 models of `FaceListGraph`
/// \tparam VertexSphereMap1,VertexSphereMap2 models of `ReadablePropertyMap` from the vertices of the meshes to `%Point_3`
///         of a \cgal kernel; the coordinates are of type `double` or `float`
/// \tparam NamedParameters1,NamedParameters2 sequences of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh1,tmesh2 the first and the second surface
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
///     \cgalParamDescription{of `np1`: a visitor whose function `go_further()` may stop the run}
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
///     \cgalParamDefault{the maximum of 4,194,304 and 32 times the number of vertices of both meshes}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; the defect of the first mesh, or of the second one if the first one has none, see `find_defect()`, or the
///         defect of its map: `ERROR_NO_1_TO_1_MAPPING` if it is not bijective; `ERROR_TOO_LARGE_OVERLAY` if the refinement
///         would have more vertices than the bound; or `ERROR_STOPPED`. The result is not changed if an error is returned.
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
