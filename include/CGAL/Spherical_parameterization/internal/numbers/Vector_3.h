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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_VECTOR_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_VECTOR_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Three numbers without a kernel: all computations between reading the mesh and writing the map use arrays of these.
template <class FT>
using Vector_3 = std::array<FT, 3>;
using Vector_3d = Vector_3<double>;

template <class FT>
Vector_3<FT> operator-(const Vector_3<FT>& a, const Vector_3<FT>& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class FT>
Vector_3<FT> operator+(const Vector_3<FT>& a, const Vector_3<FT>& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <class FT>
Vector_3<FT> operator*(const FT& s, const Vector_3<FT>& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}

template <class FT>
FT dot(const Vector_3<FT>& a, const Vector_3<FT>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class FT>
Vector_3<FT> cross(const Vector_3<FT>& a, const Vector_3<FT>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Of ranges of equal size.
template <class Range1, class Range2>
double inner_product(const Range1& a, const Range2& b)
{
  double sum = 0.;
  for(std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

template <class FT>
FT squared_length(const Vector_3<FT>& a)
{
  return dot(a, a);
}

template <class FT = double>
FT length(const Vector_3<FT>& a)
{
  return square_root(dot(a, a));
}

template <class FT = double>
Vector_3<FT> normalized(const Vector_3<FT>& a)
{
  return (1. / length(a)) * a;
}

inline Vector_3d normalized_or_zero(const Vector_3d& a)
{
  return length(a) > 0. ? normalized(a) : a;
}

// Whether x is neither infinite nor NaN. It tests the bits, because compilers that may assume that all numbers are
// finite (-ffinite-math-only, part of -ffast-math) replace std::isfinite() by true.
inline bool is_finite(double x)
{
  std::uint64_t bits;
  static_assert(sizeof(bits) == sizeof(x), "A double has 64 bits.");
  std::memcpy(&bits, &x, sizeof(bits));
  constexpr std::uint64_t exponent = 0x7FF0000000000000u;
  return (bits & exponent) != exponent;
}

inline bool is_finite(const Vector_3d& p)
{
  return is_finite(p[0]) && is_finite(p[1]) && is_finite(p[2]);
}

inline bool is_positive_and_finite(double x)
{
  return x > 0. && is_finite(x);
}

// An orthonormal frame (t1, t2, n) at the point n of the unit sphere. Points near n are represented by their offsets
// from n in this frame: differences of nearby coordinates are exact, so even small triangles keep their relative
// precision.
template <class FT>
class Basic_tangent_frame
{
public:
  explicit Basic_tangent_frame(const Vector_3<FT>& n)
    : m_n(n)
  {
    // The two axes are smooth functions of n except at the plane n.z = 0, where the sign keeps the denominator away
    // from 0.
    const FT sign = select(n[2] < 0., FT(-1.), FT(1.));
    const FT a = -1. / (sign + n[2]);
    const FT b = n[0] * n[1] * a;
    m_t1 = {1. + sign * n[0] * n[0] * a, sign * b, -sign * n[0]};
    m_t2 = {b, sign + n[1] * n[1] * a, -n[1]};
  }

  // The offset of `p` from the origin of the frame, in the coordinates of the frame.
  Vector_3<FT> offset_of(const Vector_3<FT>& p) const { return coordinates_of(p - m_n); }

  // A vector in the coordinates of the frame.
  Vector_3<FT> coordinates_of(const Vector_3<FT>& v) const { return {dot(v, m_t1), dot(v, m_t2), dot(v, m_n)}; }

  // The tangential vector with the given coordinates.
  Vector_3<FT> vector_of(const FT& x, const FT& y) const { return x * m_t1 + y * m_t2; }

  // The point of the sphere whose offset has the tangential coordinates `x` and `y`, x^2 + y^2 < 1.
  Vector_3<FT> point_at(const FT& x, const FT& y) const
  {
    const Vector_3<FT> p = m_n + (x * m_t1 + y * m_t2 + height_at(x, y) * m_n);
    // The length is that of n, 1 up to a few roundings, so one step of Newton's method normalizes it.
    return (1.5 - 0.5 * squared_length(p)) * p;
  }

  // The offset of that point along n: sqrt(1 - x^2 - y^2) - 1 without cancellation.
  static FT height_at(const FT& x, const FT& y)
  {
    const FT t = x * x + y * y;
    return -t / (1. + square_root(1. - t));
  }

private:
  Vector_3<FT> m_n, m_t1, m_t2;
};

using Tangent_frame = Basic_tangent_frame<double>;

template <class Point_3>
Vector_3d rounded(const Point_3& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

// The direction of a point as a rounded unit vector. Powers of two avoid overflow and underflow of squares, and do not
// change the result if there is none.
inline Vector_3d direction_of(const Vector_3d& x)
{
  int exponent;
  std::frexp((std::max)({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])}), &exponent);
  return normalized(Vector_3d{std::ldexp(x[0], -exponent), std::ldexp(x[1], -exponent), std::ldexp(x[2], -exponent)});
}

template <class Point_3>
Vector_3d direction_of(const Point_3& p)
{
  return direction_of(rounded(p));
}

// Points, scaled together by a power of two, which is exact, so that no product of their coordinates overflows or
// underflows.
inline std::array<Vector_3d, 3> scaled_together(std::array<Vector_3d, 3> points)
{
  double size = 0.;
  for(const Vector_3d& p : points)
    size = (std::max)({size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  int exponent;
  std::frexp(size, &exponent);
  for(Vector_3d& p : points)
    for(double& x : p)
      x = std::ldexp(x, -exponent);
  return points;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_VECTOR_3_H
