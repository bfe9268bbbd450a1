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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_MEASURE_DISTANCE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_MEASURE_DISTANCE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/Visitor_control.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The class `Surface_distance` contains the distances between two surfaces measured by `measure_distance()`, in the unit of
/// their coordinates.
struct Surface_distance
{
  /// The distances from points of one surface to the nearest points of the other one
  struct One_way
  {
    double root_mean_square = 0.; ///< The root mean square
    double maximum = 0.;          ///< The maximum
  };

  One_way from_first;   ///< The distances from the first surface to the second one
  One_way from_second;  ///< The distances from the second surface to the first one
  double diagonal = 0.; ///< The length of the diagonal of the bounding box of the first surface

  /// returns the peak signal-to-noise ratio in decibels: \f$ 20 \log_{10} \f$ of the diagonal divided by the larger root mean
  /// square. It is infinite if both root mean squares are 0.
  double psnr() const
  {
    const double larger = (std::max)(from_first.root_mean_square, from_second.root_mean_square);
    constexpr double decibels = 8.685889638065037; // 20 divided by the natural logarithm of 10
    return larger > 0. ? decibels * internal::logarithm(diagonal / larger) : std::numeric_limits<double>::infinity();
  }
};

namespace internal {

// Appends the corners of the faces of a mesh, which may have a boundary.
template <class TriangleMesh, class VertexPointMap>
Error_code append_corners(const TriangleMesh& tmesh, const VertexPointMap& vpm, std::vector<Vector_3d>& corners)
{
  Mesh_arrays<TriangleMesh> mesh;
  if(const Error_code error = mesh.read(tmesh, true))
    return error;
  const std::vector<Vector_3d> points = read_points(mesh.vertices_of_mesh, vpm);
  if(!are_finite(points))
    return ERROR_NON_FINITE_COORDINATE;
  corners.reserve(corners.size() + 3 * mesh.triangles.size());
  for(const auto& triangle : mesh.triangles)
    for(const std::uint32_t v : triangle)
      corners.push_back(points[v]);
  return OK;
}

// Measures the distance between the triangles with the first `n_first` corners and the other ones, with this many samples on
// each surface.
Error_code measure_distance(std::vector<Vector_3d> corners, std::size_t n_first,
                            const std::array<std::size_t, 2>& n_samples, Surface_distance& distance,
                            Run_control& control, const Execution& execution);

} // namespace internal

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// measures the distance between two surfaces, such as a surface and its remesh: from sample points that are evenly distributed
/// over the area of each surface to the nearest points of the other one.
///
/// The sample points depend only on the meshes. If a surface has no area, each face has the same number of sample points. The
/// surfaces need not be closed. Coordinates of any magnitude are supported.
///
/// <b>Complexity.</b> The running time is usually \f$ O((n + k) \log n) \f$ for \f$ n \f$ faces and \f$ k \f$ sample points.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh1,TriangleMesh2 models of `FaceListGraph`
/// \tparam NamedParameters1,NamedParameters2 sequences of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh1,tmesh2 triangle meshes
/// \param distance receives the distances
/// \param np1,np2 optional sequences of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh1`, or `tmesh2`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh1)`, or of `tmesh2`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_points_on_faces}
///     \cgalParamDescription{the number of sample points on `tmesh1`, or `tmesh2`}
///     \cgalParamType{an integer}
///     \cgalParamDefault{`30000`}
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
/// \cgalNamedParamsEnd
///
/// \return `OK`; `ERROR_NON_TRIANGULAR_MESH`; `ERROR_EMPTY_MESH`; `ERROR_TOO_LARGE_MESH`; `ERROR_NON_FINITE_COORDINATE`;
///         `ERROR_WRONG_PARAMETER` if a number of sample points is less than 1; or `ERROR_STOPPED`. `distance` is not changed if
///         an error is returned.
///
/// \sa `CGAL::Spherical_parameterization::remesh_through_sphere()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh1, class TriangleMesh2,
          typename CGAL_NP_TEMPLATE_PARAMETERS_1, typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Error_code measure_distance(const TriangleMesh1& tmesh1, const TriangleMesh2& tmesh2, Surface_distance& distance,
                            const CGAL_NP_CLASS_1& np1 = parameters::default_values(),
                            const CGAL_NP_CLASS_2& np2 = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto n1 = choose_parameter(get_parameter(np1, internal_np::number_of_points_on_faces), 30000);
  const auto n2 = choose_parameter(get_parameter(np2, internal_np::number_of_points_on_faces), 30000);
  if(n1 < 1 || n2 < 1)
    return ERROR_WRONG_PARAMETER;
  internal::Visitor_control<CGAL_NP_CLASS_1> control(np1);
  std::vector<internal::Vector_3d> corners;
  if(const Error_code error = internal::append_corners(tmesh1, internal::vertex_point_map_of(tmesh1, np1), corners))
    return error;
  const std::size_t n_first = corners.size();
  if(const Error_code error = internal::append_corners(tmesh2, internal::vertex_point_map_of(tmesh2, np2), corners))
    return error;
  return internal::measure_distance(std::move(corners), n_first,
                                    {static_cast<std::size_t>(n1), static_cast<std::size_t>(n2)}, distance, control,
                                    internal::execution_of<ConcurrencyTag>());
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Sampling/internal/sampling_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_MEASURE_DISTANCE_H
