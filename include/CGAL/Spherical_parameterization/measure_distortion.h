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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Distortion_summary.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/measuring/Triangle_stretch.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file measure_distortion.h

namespace CGAL {
namespace Spherical_parameterization {

#ifndef DOXYGEN_RUNNING
namespace internal {

// Maximum, average and standard deviation of a sequence of numbers >= 0, in one pass. The sums are those of Welford,
// because a difference of the sums of squares has no correct digit left where the numbers hardly differ.
class Statistics_accumulator
{
public:
  void add(double x)
  {
    m_maximum = (std::max)(m_maximum, x);
    ++m_size;
    const double difference = x - m_average;
    m_average += difference / static_cast<double>(m_size);
    m_squares += difference * (x - m_average);
  }

  double average() const { return !is_finite(m_maximum) ? m_maximum : m_average; }

  Distortion_statistics statistics() const
  {
    if(m_size == 0 || !is_finite(m_maximum))
      return {m_maximum, m_maximum, m_maximum};
    return {m_maximum, m_average, std::sqrt(m_squares / static_cast<double>(m_size))};
  }

private:
  std::size_t m_size = 0;
  double m_maximum = 0.;
  double m_average = 0.;
  double m_squares = 0.; // sum of the squared differences from the average
};

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
    return {CGAL::to_double(p.x() - q.x()), CGAL::to_double(p.y() - q.y()), CGAL::to_double(p.z() - q.z())};
}

template <class Point_3>
Triangle_edges triangle_edges(const Point_3& p0, const Point_3& p1, const Point_3& p2)
{
  return {difference(p2, p1), difference(p0, p2), difference(p1, p0)};
}

template <class Point_3>
struct Has_floating_point_coordinates
  : std::is_floating_point<std::decay_t<decltype(std::declval<const Point_3&>().x())>>
{};

// Measures all faces, in the order of faces(tmesh). The mesh and its property maps are read by this thread, and only
// then are the faces measured in parallel; copies of an exact number may share mutable state, so those are not.
template <class TriangleMesh, class VertexPointMap, class VertexSphereMap>
std::vector<Face_distortion> distortions_of_faces(const TriangleMesh& tmesh, VertexPointMap vertex_point_map,
                                                  VertexSphereMap vertex_sphere_map, std::vector<char>& is_degenerate,
                                                  Execution execution)
{
  using Surface_point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  using Image_point_3 = typename boost::property_traits<VertexSphereMap>::value_type;
  using Selection = Exact_predicates_kernel_of_map<VertexSphereMap>;

  std::vector<Surface_point_3> surface_points;
  std::vector<Image_point_3> images;
  surface_points.reserve(num_vertices(tmesh));
  images.reserve(num_vertices(tmesh));
  const auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tmesh);
  for(const auto v : vertices(tmesh))
    if(halfedge(v, tmesh) != boost::graph_traits<TriangleMesh>::null_halfedge())
    {
      put(index, v, images.size());
      surface_points.push_back(get(vertex_point_map, v));
      images.push_back(get(vertex_sphere_map, v));
    }
  std::vector<std::array<std::size_t, 3>> triangles;
  triangles.reserve(num_faces(tmesh));
  for(const auto f : faces(tmesh))
  {
    const auto h = halfedge(f, tmesh);
    triangles.push_back(
        {get(index, source(h, tmesh)), get(index, target(h, tmesh)), get(index, target(next(h, tmesh), tmesh))});
  }

  constexpr std::size_t block_size = 256;
  constexpr bool may_be_parallel =
      Has_floating_point_coordinates<Surface_point_3>::value && Has_floating_point_coordinates<Image_point_3>::value;
  const Orientation_about_origin_3<typename Selection::type> orientation;
  std::vector<Face_distortion> result(triangles.size());
  is_degenerate.resize(triangles.size());
  for_each_block(may_be_parallel ? execution : Execution(), 0, triangles.size(), block_size,
                 [&](std::size_t begin, std::size_t end) {
                   for(std::size_t k = begin; k < end; ++k)
                   {
                     const auto [a, b, c] = triangles[k];
                     const Image_point_3 &u = images[a], &v = images[b], &w = images[c];
                     const Triangle_stretch stretch(
                         triangle_edges(surface_points[a], surface_points[b], surface_points[c]),
                         triangle_edges(u, v, w));
                     const bool is_inverted =
                         orientation(Selection::convert(u), Selection::convert(v), Selection::convert(w)) != POSITIVE;
                     result[k] = {stretch.isometric(), stretch.area(), stretch.angle(), is_inverted};
                     is_degenerate[k] = stretch.is_degenerate();
                   }
                 });
  return result;
}

} // namespace internal
#endif

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
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
///         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
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
/// \param face_distortion_map receives the distortion of each face
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
/// \return the statistics over the faces, the radius and the numbers of special faces; if a face is no triangle,
///         nothing but the member `error`, and `face_distortion_map` is as it was
///
/// \sa `CGAL::Spherical_parameterization::is_bijective()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          class FaceDistortionMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Distortion_summary measure_distortion(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                      FaceDistortionMap face_distortion_map,
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  if constexpr(internal::check_mesh_and_readable_map<TriangleMesh, VertexSphereMap>())
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;

    Distortion_summary summary;
    if(!CGAL::is_triangle_mesh(tmesh))
    {
      summary.error = ERROR_NON_TRIANGULAR_MESH;
      return summary;
    }
    internal::Statistics_accumulator isometric, area, angle, radius;
    for(const auto v : vertices(tmesh))
      if(halfedge(v, tmesh) != boost::graph_traits<TriangleMesh>::null_halfedge())
      {
        const auto& p = get(vertex_sphere_map, v);
        radius.add(std::hypot(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
      }
    summary.radius = radius.average();

    std::vector<char> is_degenerate;
    const std::vector<Face_distortion> distortions = internal::distortions_of_faces(
        tmesh,
        choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh)),
        vertex_sphere_map, is_degenerate, internal::execution_of<ConcurrencyTag>());
    summary.number_of_faces = distortions.size();
    std::size_t k = 0;
    for(const auto f : faces(tmesh))
    {
      const Face_distortion& distortion = distortions[k];
      summary.number_of_inverted_faces += distortion.is_inverted;
      if(is_degenerate[k++])
        ++summary.number_of_degenerate_faces;
      else
      {
        isometric.add(distortion.isometric);
        area.add(distortion.area);
        angle.add(distortion.angle);
      }
      put(face_distortion_map, f, distortion);
    }
    summary.isometric = isometric.statistics();
    summary.area = area.statistics();
    summary.angle = angle.statistics();
    return summary;
  }
  else
    return Distortion_summary();
}

#ifndef DOXYGEN_RUNNING
namespace internal {

// where the overload without a face map leaves the values of the faces
struct No_face_distortion_map
{
  template <class Face>
  friend void put(const No_face_distortion_map&, const Face&, const Face_distortion&)
  {}
};

} // namespace internal
#endif

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// measures how much a map to the sphere distorts the faces of a mesh, all together.
///
/// Measures and parameters are those of the first function of this name.
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Distortion_summary measure_distortion(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Spherical_parameterization::measure_distortion<ConcurrencyTag>(tmesh, vertex_sphere_map,
                                                                        internal::No_face_distortion_map(), np);
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H
