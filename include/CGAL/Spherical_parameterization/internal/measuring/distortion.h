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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The edges of a triangle: edge i is opposite to corner i, and all of them have the orientation of the triangle.
using Triangle_edges = std::array<Vector_3d, 3>;

// The singular values s1 <= s2 of the linear map from one triangle to another, and the resulting distortions.
//
// Both triangles are mapped isometrically to the plane, with the longest edge of the source, and its image, on the
// x-axis. The map is then a matrix (a b; 0 c) with a, c >= 0, and
//   s2 + s1 = |(a + c, b)|    and    s2 - s1 = |(a - c, b)|,
// so that there is no cancellation if s1 and s2 are close to each other, unlike in the roots of I + 2 d and I - 2 d
// with I = s1^2 + s2^2 and d = s1 s2. If they are far apart, s1 = d / s2 avoids cancellation. The remaining relative
// error is due to the rounding of the edges, about 1e-15 longest edge / height of the source. The foot of the height is
// measured from the corner next to it, which reduces the error for a source that is thin because one of its edges is
// short.
//
// Each triangle is first scaled by a power of two, which is exact, so that coordinates up to about 1e300 and down to
// 1e-300 cause no overflow or underflow before the final values do.
struct Triangle_stretch
{
  // Whether the source is degenerate: twice its area is at most 1e-12 times the square of its longest edge, or a
  // coordinate is not finite. Then all distortions are infinite.
  bool is_degenerate = true;

  // The three measures of Face_distortion. They are infinite if the image has no area, or is not finite.
  double isometric = infinity, area = infinity, angle = infinity;

  // s1 s2 is `ratio` times 2^`ratio_exponent`, even if it is out of the range of double; 0 if the distortions are
  // infinite.
  double ratio = 0.;
  int ratio_exponent = 0;

  Triangle_stretch() = default;

  Triangle_stretch(const Triangle_edges& source, const Triangle_edges& image)
  {
    int source_exponent, image_exponent;
    const Triangle_edges from = scaled(source, source_exponent);
    const Triangle_edges to = scaled(image, image_exponent);

    const std::array<double, 3> squared = {squared_length(from[0]), squared_length(from[1]), squared_length(from[2])};
    std::size_t longest = 0, shortest = 0;
    for(std::size_t i = 1; i < 3; ++i)
    {
      longest = squared[i] > squared[longest] ? i : longest;
      shortest = squared[i] <= squared[shortest] ? i : shortest;
    }
    const Planar_triangle p(from[longest], from[shortest]);
    const Planar_triangle q(to[longest], to[shortest]);

    is_degenerate = !(p.height > min_height * p.base);
    if(is_degenerate || !(q.height > 0.))
      return;

    const double a = q.base / p.base;
    const double c = q.height / p.height;
    const double b = (q.foot - p.foot * a) / p.height;
    const double s2 = 0.5 * (hypotenuse(a + c, b) + hypotenuse(a - c, b));
    const double s1 = a * (c / s2);
    const int exponent = image_exponent - source_exponent;
    ratio = a * c;
    ratio_exponent = 2 * exponent;
    const double determinant = std::ldexp(ratio, ratio_exponent);
    isometric = (std::max)(std::ldexp(s2, exponent), std::ldexp(1. / s1, -exponent));
    area = determinant > 0. ? determinant + 1. / determinant : infinity;
    angle = s2 / s1 + s1 / s2;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double min_height = 1e-12; // of the longest edge: there, rounding errors are about 1e-3

  // A triangle in the plane whose first edge is (base, 0) and whose apex is (foot, height), seen from the corner
  // between `first`, the edge on the axis, and `second`.
  struct Planar_triangle
  {
    // Since all edges have the orientation of the triangle, one of the two starts where the other one ends. Which one
    // does not matter, because the triangle may be rotated by half a turn.
    Planar_triangle(const Vector_3d& first, const Vector_3d& second)
      : base(length(first))
      , foot(-dot(first, second) / base)
      , height(length(accurate_cross(first, second)) / base)
    {}

    double base, foot, height;
  };

  // a b - c d with a small relative error: the rounding errors of the products are compensated.
  static double difference_of_products(double a, double b, double c, double d)
  {
    const Double_double ab = exact_product(a, b), cd = exact_product(c, d);
    return (ab.high - cd.high) + (ab.low - cd.low);
  }

  static Vector_3d accurate_cross(const Vector_3d& a, const Vector_3d& b)
  {
    return {difference_of_products(a[1], b[2], a[2], b[1]), difference_of_products(a[2], b[0], a[0], b[2]),
            difference_of_products(a[0], b[1], a[1], b[0])};
  }

  // The edges divided by 2^exponent, so that the largest coordinate is in [1/2, 1); NaN if one of them is not finite.
  static Triangle_edges scaled(const Triangle_edges& edges, int& exponent)
  {
    double largest = 0.;
    bool are_finite = true;
    for(const Vector_3d& edge : edges)
    {
      are_finite = are_finite && is_finite(edge);
      for(const double x : edge)
        largest = (std::max)(largest, std::abs(x));
    }
    exponent = 0;
    double factor = std::numeric_limits<double>::quiet_NaN();
    if(are_finite)
    {
      std::frexp(largest, &exponent);
      // The largest power of two is 2^1023: subnormal coordinates stay smaller than 1/2.
      exponent = (std::max)(exponent, -1023);
      factor = std::ldexp(1., -exponent);
    }
    return {factor * edges[0], factor * edges[1], factor * edges[2]};
  }
};

// Maximum, average and standard deviation of a sequence of non-negative numbers, in one pass; all are infinite if a
// number is, or if there is none. The sums are those of Welford, because a difference of sums of squares has no correct
// digit if the numbers hardly differ.
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

  double maximum() const { return m_size > 0 ? m_maximum : std::numeric_limits<double>::infinity(); }
  double average() const { return is_finite(maximum()) ? m_average : maximum(); }
  double deviation() const
  {
    return is_finite(maximum()) ? std::sqrt(m_squares / static_cast<double>(m_size)) : maximum();
  }

private:
  std::size_t m_size = 0;
  double m_maximum = 0.;
  double m_average = 0.;
  double m_squares = 0.; // sum of the squared differences from the average
};

// p - q, computed in the number type of the coordinates if that is exact.
template <class Point_3>
Vector_3d difference(const Point_3& p, const Point_3& q)
{
  using FT = std::decay_t<decltype(p.x())>;
  // Differences of floats are exact in double precision, or have a smaller error than in single precision.
  using Number = std::conditional_t<std::is_arithmetic<FT>::value, double, FT>;
  const auto difference_of = [](const FT& x, const FT& y) { return CGAL::to_double(Number(x) - Number(y)); };
  return {difference_of(p.x(), q.x()), difference_of(p.y(), q.y()), difference_of(p.z(), q.z())};
}

template <class Point_3>
Triangle_edges triangle_edges(const Point_3& p0, const Point_3& p1, const Point_3& p2)
{
  return {difference(p2, p1), difference(p0, p2), difference(p1, p0)};
}

template <class Point_3>
constexpr bool has_floating_point_coordinates =
    std::is_floating_point<std::decay_t<decltype(std::declval<const Point_3&>().x())>>::value;

// The distortion of a face by a map, see Triangle_stretch.
struct Measured_face : Triangle_stretch
{
  bool is_inverted;
};

// Measures all faces, in parallel unless numbers are exact: copies of exact numbers may share mutable state.
// `Selection` is Exact_predicates_kernel_of_map of the property map of the images.
template <class Selection, class Surface_point_3, class Image_point_3>
std::vector<Measured_face> distortion_of_faces(const std::vector<Surface_point_3>& points,
                                               const std::vector<Image_point_3>& images,
                                               const Index_triangles& triangles, Execution execution)
{
  constexpr std::size_t block_size = 256; // of parallel work: large enough to make the overhead negligible
  constexpr bool may_be_parallel =
      has_floating_point_coordinates<Surface_point_3> && has_floating_point_coordinates<Image_point_3>;
  const Orientation_about_origin_3<typename Selection::type> orientation;
  std::vector<Measured_face> result(triangles.size());
  for_each_in_blocks(may_be_parallel ? execution : Execution(), 0, result.size(), block_size, [&](std::size_t k) {
    const auto [a, b, c] = triangles[k];
    const Image_point_3 &u = images[a], &v = images[b], &w = images[c];
    const Triangle_stretch stretch(triangle_edges(points[a], points[b], points[c]), triangle_edges(u, v, w));
    const Sign sign = orientation(Selection::convert(u), Selection::convert(v), Selection::convert(w));
    result[k] = {stretch, sign != POSITIVE};
  });
  return result;
}

// A write-only map that discards the values of faces, for measure_distortion() without a property map for them.
struct No_face_map
{
  template <class Face, class Distortion>
  friend void put(const No_face_map&, const Face&, const Distortion&)
  {}
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_H
