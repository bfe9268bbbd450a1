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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Exact_predicates_kernel.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/measuring/distortion.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The distortion of a face of a mesh by a map to the sphere. The map sends the face to a flat triangle by a linear map
/// with singular values \f$ s_1 \leq s_2 \f$. Each of the measures is invariant under inversion, that is, stretching a
/// length, an area or a ratio of lengths by a factor is as bad as shrinking it by the same factor.
///
/// \sa `CGAL::Spherical_parameterization::measure_distortion()`
struct Face_distortion
{
  /// \f$ \max(s_2, 1 / s_1) \f$: the largest factor by which a length is stretched or shrunk. At least 1, and 1 for an
  /// isometry.
  double isometric;

  /// \f$ s_1 s_2 + 1 / (s_1 s_2) \f$: how the area changes. At least 2, and 2 if it stays the same.
  double area;

  /// \f$ s_1 / s_2 + s_2 / s_1 \f$: how the angles change. At least 2, and 2 for a similarity.
  double angle;

  /// whether the image is not positively oriented about the origin, by an exact predicate on the points in the map.
  bool is_inverted;
};

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The statistics of one measure of distortion over the faces of a mesh, each face counting the same whatever its area.
///
/// All three numbers are infinite if the distortion of a face is, or if all faces are degenerate.
///
/// \sa `CGAL::Spherical_parameterization::Distortion_summary`
struct Distortion_statistics
{
  double maximum = 0.;   ///< the largest value
  double average = 0.;   ///< the arithmetic mean
  double deviation = 0.; ///< the standard deviation, the square root of the mean squared difference from the average
};

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The distortion of a map from a mesh to the sphere, summed up over its faces.
///
/// \sa `CGAL::Spherical_parameterization::measure_distortion()`
struct Distortion_summary
{
  Distortion_statistics isometric; ///< statistics of `Face_distortion::isometric`
  Distortion_statistics area;      ///< statistics of `Face_distortion::area`
  Distortion_statistics angle;     ///< statistics of `Face_distortion::angle`

  /// the radius of the sphere: the average distance of the images from the origin.
  double radius = 0.;

  /// the radius of the sphere at which the average of `Face_distortion::area` is least: eq. 11 of \cgalCite{cgal:whfl-bspld-16}, which
  /// compares maps at this radius. Faces whose distortion is infinite do not count; 0 if there are no others.
  double balanced_radius = 0.;

  /// all faces of the mesh.
  std::size_t number_of_faces = 0;

  /// faces whose image is not positively oriented about the origin; degenerate faces may be among them.
  std::size_t number_of_inverted_faces = 0;

  /// faces that are so thin that they have no distortion; they are left out of the statistics.
  std::size_t number_of_degenerate_faces = 0;
};

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// measures how much a map to the sphere distorts the faces of a mesh, each one and all together.
///
/// A face is mapped linearly to the flat triangle of its vertices' images, at the radius that the map has; its
/// distortions are those of `Face_distortion`, equations 12 to 14 of \cgalCite{cgal:whfl-bspld-16}.
///
/// - A face of the mesh whose area, taken twice, is at most 1e-12 times the square of its longest edge is degenerate.
///   It has no distortion that would mean something: its values in `face_distortion_map` are infinite, and it is
///   counted and left out of the statistics.
/// - A face whose image has no area has infinite distortion, and so have the statistics then.
/// - An inverted face, one whose image is not positively oriented about the origin, is counted, by an exact predicate.
///   Its distortions are those of the mirrored face, and part of the statistics.
///
/// The values have a relative error of about 1e-15 times the longest edge of the face over its height if the
/// coordinates are of type `double` or `float`; others count as `CGAL::to_double()` rounds their differences.
/// Coordinates of any magnitude are treated alike. The running time is linear in the number of faces, and so is the
/// additional memory. The property maps are read and written by the calling thread alone; coordinates of an exact
/// number type are measured by it as well.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a
///         \cgal kernel; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam FaceDistortionMap a model of `WritablePropertyMap` from the faces of `TriangleMesh` to `Face_distortion`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a triangle mesh, closed or not
/// \param vertex_sphere_map the images of the vertices, points around the origin
/// \param distortion receives the statistics over the faces, the radius and the numbers of special faces
/// \param face_distortion_map receives the distortion of each face
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; or `ERROR_EMPTY_MESH`, `ERROR_NON_TRIANGULAR_MESH` or `ERROR_TOO_LARGE_MESH`, and `distortion` and
///         `face_distortion_map` are as they were
///
/// \sa `CGAL::Spherical_parameterization::is_bijective()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          class FaceDistortionMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code measure_distortion(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                              Distortion_summary& distortion, FaceDistortionMap face_distortion_map,
                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  if constexpr(internal::check_mesh_and_readable_map<TriangleMesh, VertexSphereMap>())
  {
    internal::Mesh_arrays<TriangleMesh> mesh;
    if(const Error_code error = mesh.read(tmesh, true))
      return error;
    const auto as_it_is = [](const auto& p) { return p; };
    const auto points =
        internal::read_values(mesh.vertices_of_mesh, internal::vertex_point_map_of(tmesh, np), as_it_is);
    const auto images = internal::read_values(mesh.vertices_of_mesh, vertex_sphere_map, as_it_is);
    const auto measured = internal::distortion_of_faces<internal::Exact_predicates_kernel_of_map<VertexSphereMap>>(
        points, images, mesh.triangles, internal::execution_of<ConcurrencyTag>());

    internal::Statistics_accumulator isometric, area, angle, radius;
    for(const auto& p : images)
      radius.add(internal::hypotenuse(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
    Distortion_summary summary;
    summary.radius = radius.average();
    summary.number_of_faces = measured.size();
    double ratios = 0., inverse_ratios = 0.; // of areas, in the unit of the first one
    int exponent = 0;
    auto face = measured.begin();
    for(const auto f : faces(tmesh))
    {
      const internal::Measured_face& values = *face++;
      summary.number_of_inverted_faces += values.is_inverted;
      summary.number_of_degenerate_faces += values.is_degenerate;
      if(!values.is_degenerate)
      {
        isometric.add(values.isometric);
        area.add(values.area);
        angle.add(values.angle);
      }
      if(internal::is_finite(values.isometric))
      {
        exponent = ratios == 0. ? values.ratio_exponent : exponent;
        const double ratio = std::ldexp(values.ratio, values.ratio_exponent - exponent);
        ratios += ratio;
        inverse_ratios += 1. / ratio;
      }
      put(face_distortion_map, f, Face_distortion{values.isometric, values.area, values.angle, values.is_inverted});
    }
    if(ratios > 0.)
      summary.balanced_radius =
          std::ldexp(summary.radius * std::sqrt(std::sqrt(inverse_ratios / ratios)), -exponent / 2);
    const auto statistics = [](const internal::Statistics_accumulator& of) {
      return Distortion_statistics{of.maximum(), of.average(), of.deviation()};
    };
    summary.isometric = statistics(isometric);
    summary.area = statistics(area);
    summary.angle = statistics(angle);
    distortion = summary;
    return OK;
  }
  else
    return ERROR_WRONG_PARAMETER;
}

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// measures how much a map to the sphere distorts the faces of a mesh, all together, as the function above.
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code measure_distortion(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                              Distortion_summary& distortion, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Spherical_parameterization::measure_distortion<ConcurrencyTag>(tmesh, vertex_sphere_map, distortion,
                                                                        internal::No_face_map(), np);
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H
