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

#include <CGAL/Spherical_parameterization/Distortion_statistics.h>
#include <CGAL/Spherical_parameterization/Distortion_summary.h>
#include <CGAL/Spherical_parameterization/Face_distortion.h>
#include <CGAL/Spherical_parameterization/internal/Exact_predicates_kernel.h>
#include <CGAL/Spherical_parameterization/internal/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/Statistics_accumulator.h>
#include <CGAL/Spherical_parameterization/internal/Triangle_stretch.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

/// \file measure_distortion.h

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// p - q, computed in the number type of the coordinates if that is exact
template <class Point_3>
Vector_3d difference(const Point_3& p, const Point_3& q)
{
  if constexpr(std::is_arithmetic<std::decay_t<decltype(p.x())>>::value)
  {
    // Differences of float are exact, or more so, in double precision.
    return {static_cast<double>(p.x()) - static_cast<double>(q.x()),
            static_cast<double>(p.y()) - static_cast<double>(q.y()),
            static_cast<double>(p.z()) - static_cast<double>(q.z())};
  }
  else
  {
    return {CGAL::to_double(p.x() - q.x()), CGAL::to_double(p.y() - q.y()), CGAL::to_double(p.z() - q.z())};
  }
}

template <class Point_3>
Triangle_edges triangle_edges(const Point_3& p0, const Point_3& p1, const Point_3& p2)
{
  return {difference(p2, p1), difference(p0, p2), difference(p1, p0)};
}

// where the overload without a face map leaves the values of the faces
struct No_face_distortion_map
{
  template <class Face>
  friend void put(const No_face_distortion_map&, const Face&, const Face_distortion&)
  {}
};

template <class TriangleMesh, class VertexSphereMap, class FaceDistortionMap, class NamedParameters>
Distortion_summary measure_distortion(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                      FaceDistortionMap face_distortion_map, double isometric_bound,
                                      const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  const Vertex_point_map vertex_point_map =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh));

  using Selection = Exact_predicates_kernel_of_map<VertexSphereMap>;
  const Orientation_about_origin_3<typename Selection::type> orientation;

  CGAL_precondition(CGAL::is_triangle_mesh(tmesh));

  Distortion_summary summary;
  Statistics_accumulator isometric, area, angle, radius;

  for(const auto v : vertices(tmesh))
  {
    if(halfedge(v, tmesh) != boost::graph_traits<TriangleMesh>::null_halfedge())
    {
      const auto& p = get(vertex_sphere_map, v);
      radius.add(std::hypot(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
    }
  }
  summary.radius = radius.average();

  for(const auto f : faces(tmesh))
  {
    const auto h = halfedge(f, tmesh);
    const auto v0 = source(h, tmesh), v1 = target(h, tmesh), v2 = target(next(h, tmesh), tmesh);
    const auto& u0 = get(vertex_sphere_map, v0);
    const auto& u1 = get(vertex_sphere_map, v1);
    const auto& u2 = get(vertex_sphere_map, v2);

    const Triangle_stretch stretch(
        triangle_edges(get(vertex_point_map, v0), get(vertex_point_map, v1), get(vertex_point_map, v2)),
        triangle_edges(u0, u1, u2));
    const bool is_inverted =
        orientation(Selection::convert(u0), Selection::convert(u1), Selection::convert(u2)) != POSITIVE;

    ++summary.number_of_faces;
    if(is_inverted)
    {
      ++summary.number_of_inverted_faces;
    }
    if(stretch.is_degenerate())
    {
      ++summary.number_of_degenerate_faces;
    }
    else
    {
      isometric.add(stretch.isometric());
      area.add(stretch.area());
      angle.add(stretch.angle());
      if(stretch.isometric() > isometric_bound)
      {
        ++summary.number_of_faces_above_bound;
      }
    }
    put(face_distortion_map, f, Face_distortion{stretch.isometric(), stretch.area(), stretch.angle(), is_inverted});
  }

  summary.isometric = isometric.statistics();
  summary.area = area.statistics();
  summary.angle = angle.statistics();
  return summary;
}

} // namespace internal

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// measures how much a map to the sphere distorts the faces of a mesh, each one and all together.
///
/// A face is mapped linearly to the flat triangle of its vertices' images, at the radius that the map has. With
/// \f$ s_1 \leq s_2 \f$ the singular values of this linear map, its distortions are
/// \f$ D_{iso} = \max(s_2, 1 / s_1) \f$, \f$ D_{area} = s_1 s_2 + 1 / (s_1 s_2) \f$ and
/// \f$ D_{angle} = s_1 / s_2 + s_2 / s_1 \f$ (equations 12 to 14 of \cgalCite{cgal:whfl-bspld-16}).
///
/// - A face of the mesh whose area, taken twice, is at most 1e-12 times the square of its longest edge is degenerate.
///   It has no distortion that would mean something: its values in `face_distortion_map` are infinite, and it is
///   counted and left out of the statistics and of the bound.
/// - A face whose image has no area has infinite distortion, and so have the statistics then.
/// - An inverted face, one whose image is not positively oriented about the origin, is counted, by an exact predicate.
///   Its distortions are those of the mirrored face, and part of the statistics.
///
/// The values have a relative error of about 1e-15 times the longest edge of the face over its height if the coordinates
/// are of type `double` or `float`; others count as `CGAL::to_double()` rounds their differences. Coordinates of any
/// magnitude are treated alike. The running time is linear in the number of faces.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as
///         value type; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam FaceDistortionMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `Face_distortion` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a triangle mesh, closed or not
/// \param vertex_sphere_map the images of the vertices, points around the origin
/// \param face_distortion_map receives the distortion of each face; if a property map throws, the faces up to there
///        have theirs
/// \param isometric_bound faces with \f$ D_{iso} \f$ above this number, which is sensibly at least 1, are counted
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t` must be
///                     available in `TriangleMesh`.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the statistics over the faces, the radius and the numbers of special faces
///
/// \pre `CGAL::is_triangle_mesh(tmesh)`
///
/// \sa `CGAL::Spherical_parameterization::is_bijective()`
template <class TriangleMesh, class VertexSphereMap, class FaceDistortionMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
#ifndef DOXYGEN_RUNNING
std::enable_if_t<!std::is_arithmetic<FaceDistortionMap>::value, Distortion_summary>
#else
Distortion_summary
#endif
measure_distortion(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map, FaceDistortionMap face_distortion_map,
                   double isometric_bound, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::measure_distortion(tmesh, vertex_sphere_map, face_distortion_map, isometric_bound, np);
}

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// measures how much a map to the sphere distorts the faces of a mesh, without counting faces above a bound.
///
/// The measures are those of the first function of this name.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as
///         value type; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam FaceDistortionMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `Face_distortion` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a triangle mesh, closed or not
/// \param vertex_sphere_map the images of the vertices, points around the origin
/// \param face_distortion_map receives the distortion of each face; if a property map throws, the faces up to there
///        have theirs
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t`
///                     must be available in `TriangleMesh`.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the statistics over the faces, the radius and the numbers of special faces; the number of
///         faces above the bound is 0
///
/// \pre `CGAL::is_triangle_mesh(tmesh)`
template <class TriangleMesh, class VertexSphereMap, class FaceDistortionMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
#ifndef DOXYGEN_RUNNING
std::enable_if_t<!std::is_arithmetic<FaceDistortionMap>::value, Distortion_summary>
#else
Distortion_summary
#endif
measure_distortion(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map, FaceDistortionMap face_distortion_map,
                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::measure_distortion(tmesh, vertex_sphere_map, face_distortion_map,
                                      std::numeric_limits<double>::infinity(), np);
}

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// measures how much a map to the sphere distorts the faces of a mesh, all together.
///
/// The measures are those of the first function of this name.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as
///         value type; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a triangle mesh, closed or not
/// \param vertex_sphere_map the images of the vertices, points around the origin
/// \param isometric_bound faces with \f$ D_{iso} \f$ above this number, which is sensibly at least 1, are counted
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t`
///                     must be available in `TriangleMesh`.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the statistics over the faces, the radius and the numbers of special faces
///
/// \pre `CGAL::is_triangle_mesh(tmesh)`
template <class TriangleMesh, class VertexSphereMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Distortion_summary measure_distortion(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                      double isometric_bound, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::measure_distortion(tmesh, vertex_sphere_map, internal::No_face_distortion_map(), isometric_bound,
                                      np);
}

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// measures how much a map to the sphere distorts the faces of a mesh, all together, without counting faces above a
/// bound.
///
/// The measures are those of the first function of this name.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as
///         value type; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a triangle mesh, closed or not
/// \param vertex_sphere_map the images of the vertices, points around the origin
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t`
///                     must be available in `TriangleMesh`.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the statistics over the faces, the radius and the numbers of special faces; the number of
///         faces above the bound is 0
///
/// \pre `CGAL::is_triangle_mesh(tmesh)`
template <class TriangleMesh, class VertexSphereMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Distortion_summary measure_distortion(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::measure_distortion(tmesh, vertex_sphere_map, internal::No_face_distortion_map(),
                                      std::numeric_limits<double>::infinity(), np);
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H
