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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTANCE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTANCE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_distance.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_3.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

/// \file measure_distance.h

namespace CGAL {
namespace Spherical_parameterization {

namespace internal {

// The corners of the faces of a mesh.
template <class TriangleMesh, class VertexPointMap>
std::vector<std::array<Vector_3d, 3>> corners_of_faces(const TriangleMesh& tmesh, const VertexPointMap& vpm)
{
  std::vector<std::array<Vector_3d, 3>> result;
  result.reserve(num_faces(tmesh));
  for(const auto f : faces(tmesh))
  {
    result.emplace_back();
    auto h = halfedge(f, tmesh);
    for(Vector_3d& corner : result.back())
    {
      const auto& p = get(vpm, source(h, tmesh));
      corner = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
      h = next(h, tmesh);
    }
  }
  return result;
}

// The largest absolute value of the coordinates, or infinity if one of them is not finite.
inline double largest_coordinate(const std::vector<std::array<Vector_3d, 3>>& corners)
{
  double result = 0.;
  for(const std::array<Vector_3d, 3>& triangle : corners)
    for(const Vector_3d& p : triangle)
    {
      if(!is_finite(p))
        return std::numeric_limits<double>::infinity();
      result = (std::max)({result, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    }
  return result;
}

// The triangles of a surface, but for those without an area, whose places are in their neighbours. Its unit is 2 to the
// power of `exponent`, in which all coordinates are below 1: the fourth power of a length must neither overflow nor
// underflow, as the predicates of the tree throw for NaN, and end the process for infinity.
class Triangle_set
{
public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point_3 = Kernel::Point_3;

  Triangle_set(const std::vector<std::array<Vector_3d, 3>>& corners, int exponent)
  {
    constexpr double min_squared_area = 1e-200;
    const auto point = [&](const Vector_3d& p) {
      return Point_3(std::scalbn(p[0], -exponent), std::scalbn(p[1], -exponent), std::scalbn(p[2], -exponent));
    };
    for(const std::array<Vector_3d, 3>& t : corners)
    {
      const Kernel::Triangle_3 triangle(point(t[0]), point(t[1]), point(t[2]));
      if(triangle.squared_area() > min_squared_area && !triangle.is_degenerate())
        m_triangles.push_back(triangle);
    }
    double area = 0.;
    for(const Kernel::Triangle_3& triangle : m_triangles)
    {
      m_box += triangle.bbox();
      area += std::sqrt(triangle.squared_area());
      m_areas.push_back(area);
    }
    m_tree.insert(m_triangles.begin(), m_triangles.end());
    m_tree.build(); // before several threads ask it
    m_tree.accelerate_distance_queries();
  }
  Triangle_set(const Triangle_set&) = delete; // the tree refers to the triangles

  double diagonal() const
  {
    return m_triangles.empty() ? 0.
                               : std::sqrt(CGAL::squared_distance(Point_3(m_box.xmin(), m_box.ymin(), m_box.zmin()),
                                                                  Point_3(m_box.xmax(), m_box.ymax(), m_box.zmax())));
  }

  // The place with the number k of n that are spread evenly: triangle by triangle at equal steps of the area, and in a
  // triangle by the additive recurrence of the plastic number, which has low discrepancy.
  Point_3 sample(std::size_t k, std::size_t n) const
  {
    const double area = (static_cast<double>(k) + 0.5) / static_cast<double>(n) * m_areas.back();
    const auto i = std::lower_bound(m_areas.begin(), m_areas.end() - 1, area) - m_areas.begin();
    const Kernel::Triangle_3& t = m_triangles[static_cast<std::size_t>(i)];
    constexpr double plastic_number = 1.32471795724474602596;
    double u = std::fmod(static_cast<double>(k + 1) / plastic_number, 1.);
    double v = std::fmod(static_cast<double>(k + 1) / (plastic_number * plastic_number), 1.);
    if(u + v > 1.)
    {
      u = 1. - u;
      v = 1. - v;
    }
    return t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
  }

  Surface_distance::One_way distance_to(const Triangle_set& other, std::size_t n, const Execution& execution) const
  {
    if(m_triangles.empty() || other.m_triangles.empty() || n == 0)
      return {};
    constexpr std::size_t block_size = 256;
    std::vector<double> distances(n);
    for_each_block(execution, 0, n, block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
        distances[k] = other.m_tree.squared_distance(sample(k, n));
    });
    double sum = 0., max = 0.;
    for(const double d : distances)
    {
      sum += d;
      max = (std::max)(max, d);
    }
    return {std::sqrt(sum / static_cast<double>(n)), std::sqrt(max)};
  }

private:
  using Iterator = std::vector<Kernel::Triangle_3>::const_iterator;
  using Primitive = AABB_triangle_primitive<Kernel, Iterator>;

  std::vector<Kernel::Triangle_3> m_triangles;
  std::vector<double> m_areas; // of the triangles up to each
  Bbox_3 m_box;
  AABB_tree<AABB_traits<Kernel, Primitive>> m_tree;
};

} // namespace internal

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// measures how far two surfaces are apart, such as a surface and its remesh: from places of each, spread evenly over its
/// area, to the nearest places of the other one. The places are always the same for the same meshes. Faces without an area
/// are left out, and those that are less than 1e-100 times the square of the largest coordinate. Coordinates of any
/// magnitude are treated alike.
///
/// The running time is \f$ O((n + k) \log n) \f$ for `n` faces and `k` places, as a rule.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
///         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh1 a model of `FaceListGraph`
/// \tparam TriangleMesh2 a model of `FaceListGraph`
/// \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
/// \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh1 a triangle mesh
/// \param tmesh2 another one
/// \param number_of_samples the number of places of each
/// \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
/// \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh1` (`tmesh2`)}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh1)` (`tmesh2`)}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the distances both ways; 0 if one of the meshes has no face with an area, or if there are no samples; not a
///         number if a coordinate is infinite or not a number
///
/// \sa `CGAL::Spherical_parameterization::remesh_through_sphere()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh1, class TriangleMesh2,
          typename CGAL_NP_TEMPLATE_PARAMETERS_1, typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Surface_distance measure_distance(const TriangleMesh1& tmesh1, const TriangleMesh2& tmesh2,
                                  std::size_t number_of_samples = 30000,
                                  const CGAL_NP_CLASS_1& np1 = parameters::default_values(),
                                  const CGAL_NP_CLASS_2& np2 = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto corners1 =
      internal::corners_of_faces(tmesh1, choose_parameter(get_parameter(np1, internal_np::vertex_point),
                                                          get_const_property_map(vertex_point, tmesh1)));
  const auto corners2 =
      internal::corners_of_faces(tmesh2, choose_parameter(get_parameter(np2, internal_np::vertex_point),
                                                          get_const_property_map(vertex_point, tmesh2)));
  const double size = (std::max)(internal::largest_coordinate(corners1), internal::largest_coordinate(corners2));
  if(!internal::is_finite(size))
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {{nan, nan}, {nan, nan}, nan};
  }
  int exponent = 0;
  std::frexp(size, &exponent);
  const internal::Triangle_set first(corners1, exponent), second(corners2, exponent);
  const internal::Execution execution = internal::execution_of<ConcurrencyTag>();
  const auto distance = [&](const internal::Triangle_set& from, const internal::Triangle_set& to) {
    const Surface_distance::One_way d = from.distance_to(to, number_of_samples, execution);
    return Surface_distance::One_way{std::scalbn(d.root_mean_square, exponent), std::scalbn(d.maximum, exponent)};
  };
  return {distance(first, second), distance(second, first), std::scalbn(first.diagonal(), exponent)};
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTANCE_H
