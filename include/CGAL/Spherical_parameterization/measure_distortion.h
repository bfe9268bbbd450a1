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
/// The class `Face_distortion` holds the distortions of a face by a map to the sphere. The map sends the face to a flat
/// triangle by a linear map with singular values \f$ s_1 \leq s_2 \f$. Each measure is invariant under inversion:
/// stretching a length, an area or a ratio of lengths by a factor counts the same as shrinking it by this factor.
///
/// \sa `CGAL::Spherical_parameterization::measure_distortion()`
struct Face_distortion
{
  /// \f$ \max(s_2, 1 / s_1) \f$: the largest factor by which a length is stretched or shrunk; at least 1, and 1 for an
  /// isometry.
  double isometric;

  /// \f$ s_1 s_2 + 1 / (s_1 s_2) \f$: the change of the area; at least 2, and 2 if the area is preserved.
  double area;

  /// \f$ s_1 / s_2 + s_2 / s_1 \f$: the change of the angles; at least 2, and 2 for a similarity.
  double angle;

  /// whether the image is not positively oriented about the origin, by an exact predicate on the points in the map.
  bool is_inverted;
};

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The class `Distortion_statistics` holds the statistics of one measure of distortion over the faces of a mesh. All
/// faces have the same weight, whatever their area.
///
/// All three values are infinite if the distortion of a face is infinite, or if all faces are degenerate.
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
/// The class `Distortion_summary` holds the distortion of a map from a mesh to the sphere, summarized over the faces.
///
/// \sa `CGAL::Spherical_parameterization::measure_distortion()`
struct Distortion_summary
{
  Distortion_statistics isometric; ///< statistics of `Face_distortion::isometric`
  Distortion_statistics area;      ///< statistics of `Face_distortion::area`
  Distortion_statistics angle;     ///< statistics of `Face_distortion::angle`

  /// the radius of the sphere: the average distance of the images from the origin.
  double radius = 0.;

  /// the radius that minimizes the average of `Face_distortion::area`, eq. 11 of \cgalCite{cgal:whfl-bspld-16}; the
  /// paper compares maps at this radius. Faces with infinite distortion do not count; 0 if there are no others.
  double balanced_radius = 0.;

  /// number of all faces of the mesh.
  std::size_t number_of_faces = 0;

  /// number of faces whose image is not positively oriented about the origin, including degenerate ones.
  std::size_t number_of_inverted_faces = 0;

  /// number of faces that are too thin to have a meaningful distortion; the statistics exclude them.
  std::size_t number_of_degenerate_faces = 0;
};

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// measures the distortion of a map to the sphere, for each face of a mesh and in total.
///
/// A face is mapped linearly to the flat triangle of its vertices' images, at the radius of the map. Its distortions
/// are those of `Face_distortion`, equations 12 to 14 of \cgalCite{cgal:whfl-bspld-16}.
///
/// - A face of the mesh is degenerate if twice its area is at most 1e-12 times the square of its longest edge. Its
///   values in `face_distortion_map` are infinite, and it is counted but excluded from the statistics.
/// - A face whose image has no area has infinite distortion, and then so do the statistics.
/// - An inverted face is a face whose image is not positively oriented about the origin. An exact predicate decides
///   this, and inverted faces are counted. Their distortions are those of the mirrored face and are included in the
///   statistics.
///
/// If the coordinates are of type `double` or `float`, the values have a relative error of about 1e-15 times the
/// longest edge of the face divided by its height. For other number types, `CGAL::to_double()` rounds the differences
/// of the coordinates. Accuracy does not depend on the magnitude of the coordinates.
///
/// The running time and the additional memory are linear in the number of faces. Only the calling thread reads and
/// writes the property maps, and only it evaluates coordinates of an exact number type.
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
/// \param distortion receives the statistics over the faces, the radius and the numbers of inverted and degenerate
///        faces
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
///         `face_distortion_map` are left unchanged
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
    double ratios = 0., inverse_ratios = 0.; // of areas, in units of the first ratio
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
/// measures the distortion of a map to the sphere in total, like the function above.
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
