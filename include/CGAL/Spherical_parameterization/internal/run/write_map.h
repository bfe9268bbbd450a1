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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_WRITE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_WRITE_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Exact_predicates_kernel.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Kernel_traits.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The guarantee of a method for its maps: they are bijective, or there is none, and a map with inverted faces is
// written and reported.
enum class Guarantee
{
  ONE_TO_ONE,
  NONE
};

// Whether the images of the vertices of a mesh define a bijection.
template <class Point_3>
bool are_bijective(const Index_triangles& triangles, const std::vector<Point_3>& images, const Execution& execution)
{
  using Kernel = typename Kernel_traits<Point_3>::Kernel;
  if constexpr(Exact_predicates_kernel<Kernel>::has_doubles)
  {
    std::vector<Vector_3d> points;
    points.reserve(images.size());
    for(const Point_3& p : images)
      points.push_back({static_cast<double>(p.x()), static_cast<double>(p.y()), static_cast<double>(p.z())});
    return are_bijective(triangles, points, execution);
  }
  else
    return certify_bijectivity<Kernel>(images, triangles, execution).is_bijective();
}

// Whether two points with floating-point coordinates are equal, for any compile flags: with -ffast-math, NaN may equal
// every number, and subnormal numbers may equal 0.
template <class Point_3>
bool have_same_bits(const Point_3& p, const Point_3& q)
{
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  const FT a[3] = {p.x(), p.y(), p.z()}, b[3] = {q.x(), q.y(), q.z()};
  return std::memcmp(a, b, sizeof(a)) == 0;
}

// Whether the map holds the points that were written, or others that are a bijection as well, for example in single
// precision. Exact numbers are always certified again, because lazy numbers that are not finite must not be compared.
template <class VertexDescriptor, class VertexSphereMap, class Point_3>
bool is_bijective_as_written(const std::vector<VertexDescriptor>& vertices, const Index_triangles& triangles,
                             VertexSphereMap map, const std::vector<Point_3>& points, Execution execution)
{
  if constexpr(std::is_floating_point<typename Kernel_traits<Point_3>::Kernel::FT>::value)
  {
    const auto is_unchanged = [&](const Point_3& p, const auto v) { return have_same_bits<Point_3>(get(map, v), p); };
    if(std::equal(points.begin(), points.end(), vertices.begin(), is_unchanged))
      return true;
  }
  const auto images = read_values(vertices, map, [](const Point_3& p) { return p; });
  return are_bijective(triangles, images, execution);
}

// Scales the positions from the unit sphere to the sphere of radius `radius`, certifies the points in the caller's
// point type, and only then writes them. A map that is not bijective is written only if the method guarantees nothing.
// A readable map is read and checked again after writing.
template <class VertexDescriptor, class VertexSphereMap>
Error_code write_map(const std::vector<VertexDescriptor>& vertices, const Index_triangles& triangles,
                     const std::vector<Vector_3d>& positions, double radius, Guarantee guarantee, VertexSphereMap map,
                     Execution execution)
{
  using Point_3 = typename boost::property_traits<VertexSphereMap>::value_type;
  using Category = typename boost::property_traits<VertexSphereMap>::category;
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;

  if(!is_positive_and_finite(radius))
    return ERROR_INSUFFICIENT_PRECISION;
  if constexpr(std::is_floating_point<FT>::value)
    if(radius > static_cast<double>((std::numeric_limits<FT>::max)()))
      return ERROR_INSUFFICIENT_PRECISION;
  std::vector<Point_3> points;
  points.reserve(positions.size());
  for(const Vector_3d& u : positions)
  {
    if(!is_finite(u))
      return ERROR_INSUFFICIENT_PRECISION;
    points.emplace_back(static_cast<FT>(radius * u[0]), static_cast<FT>(radius * u[1]), static_cast<FT>(radius * u[2]));
  }
  bool is_bijective = are_bijective(triangles, points, execution);
  if(!is_bijective && guarantee == Guarantee::ONE_TO_ONE)
    return ERROR_INSUFFICIENT_PRECISION;

  for(std::size_t v = 0; v < points.size(); ++v)
    put(map, vertices[v], points[v]);
  if constexpr(std::is_convertible<Category, boost::readable_property_map_tag>::value)
    if(is_bijective)
      is_bijective = is_bijective_as_written(vertices, triangles, map, points, execution);
  if(is_bijective)
    return OK;
  return guarantee == Guarantee::ONE_TO_ONE ? ERROR_INSUFFICIENT_PRECISION : ERROR_NO_1_TO_1_MAPPING;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_WRITE_MAP_H
