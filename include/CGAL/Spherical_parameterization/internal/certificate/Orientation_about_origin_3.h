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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_ORIENTATION_ABOUT_ORIGIN_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_ORIENTATION_ABOUT_ORIGIN_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/enum.h>

#include <cmath>

// If the compiler may change the values of floating-point expressions, or assume that all numbers are finite, the
// filter below proves nothing.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) ||                                  \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#define CGAL_SPHERICAL_PARAMETERIZATION_NO_IEEE_ARITHMETIC
#endif

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The exact sign of det(a, b, c), with finite coordinates, by integer arithmetic: about a microsecond for points whose
// coordinates are of similar size. It depends neither on the rounding mode nor on compiler options for floating-point
// arithmetic, nor on whether the processor flushes subnormal numbers to zero.
Sign exact_determinant_sign(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c);

// The exact sign of det(a, b, c): POSITIVE if the triangle abc is counterclockwise as seen from outside a sphere around
// the origin. A triangle with a coordinate that is not finite has no orientation: ZERO.
//
// Coordinates of type double are decided by a floating-point filter and, if it fails, by integer arithmetic: the result
// is correct with any compiler options. For any other `K`, a kernel with exact predicates, its predicates decide.
template <class K, class FT = typename K::FT>
class Orientation_about_origin_3; // for exact numbers: in Exact_predicates_kernel.h

// The filter evaluates det(a, b - a, c - a), which is the same number, and whose rounding errors decrease with the size
// of the triangle. So it succeeds also for the small triangles of a fine mesh on a sphere, whose determinants are below
// the error bound of a filter on det(a, b, c); it fails only for needles.
//
// Proof of correctness. Let e = 2^-52, an upper bound of the relative error of an operation in any rounding mode, let d
// be the exact determinant and p the exact sum of the absolute values of its six products. Ignoring underflow, each
// product in the computed determinant D has at most seven factors (1 + x) with |x| <= e: two differences, two
// multiplications, the difference of the cross product and two additions; fewer if the compiler contracts a
// multiplication and an addition. The same holds for the computed P of p, whose terms are all positive. Thus
//   |D - d| <= ((1 + e)^7 - 1) p    and    p <= P / (1 - e)^7,    hence    |D - d| <= 7 (1 + 15 e) e P < 8 e P.
// Underflow, even if the processor replaces subnormal operands and results by 0, changes each operand and each result
// by less than 2^-1022. Let m be the sum of 1 and the absolute values of a, b - a and c - a. The factors of products
// are at most m and m^2, so underflow, in fewer than 2^7 operations, adds less than 2^-1014 m^2 to D and P, which is
// far below 2^-1000 m^2 even with all rounding errors. Nothing overflows, in any rounding mode, because m is bounded;
// and coordinates that are not finite do not satisfy this bound.
template <class K>
class Orientation_about_origin_3<K, double>
{
  using Point_3 = typename K::Point_3;

public:
  Sign operator()(const Point_3& a, const Point_3& b, const Point_3& c) const
  {
    return orientation(coordinates(a), coordinates(b), coordinates(c));
  }

private:
  static const Vector_3d& coordinates(const Vector_3d& p) { return p; }
  template <class Point>
  static Vector_3d coordinates(const Point& p)
  {
    return {p.x(), p.y(), p.z()};
  }

  static Sign orientation(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c)
  {
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_NO_IEEE_ARITHMETIC
    const Sign sign = filtered(a, b, c);
    if(sign != ZERO)
      return sign;
#endif
    return is_finite(a) && is_finite(b) && is_finite(c) ? exact_determinant_sign(a, b, c) : ZERO;
  }

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_NO_IEEE_ARITHMETIC
  // The sign, or ZERO if it is not certain.
  static Sign filtered(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c)
  {
#ifdef __clang__
#pragma clang fp reassociate(off) // Clang defines no macro for -fassociative-math alone.
#endif
    const double px = b[0] - a[0], py = b[1] - a[1], pz = b[2] - a[2];
    const double qx = c[0] - a[0], qy = c[1] - a[1], qz = c[2] - a[2];
    const double pyqz = py * qz, pzqy = pz * qy;
    const double pzqx = pz * qx, pxqz = px * qz;
    const double pxqy = px * qy, pyqx = py * qx;
    const double ax = std::abs(a[0]), ay = std::abs(a[1]), az = std::abs(a[2]);
    const double determinant = a[0] * (pyqz - pzqy) + a[1] * (pzqx - pxqz) + a[2] * (pxqy - pyqx);
    const double permanent = ax * (std::abs(pyqz) + std::abs(pzqy)) + ay * (std::abs(pzqx) + std::abs(pxqz)) +
                             az * (std::abs(pxqy) + std::abs(pyqx));
    const double m = (ax + ay + az) + (std::abs(px) + std::abs(py) + std::abs(pz)) +
                     (std::abs(qx) + std::abs(qy) + std::abs(qz)) + 1.;
    if(!(m < 0x1p300))
      return ZERO;
    const double error = 0x1p-49 * permanent + 0x1p-1000 * m * m;
    return determinant > error ? POSITIVE : determinant < -error ? NEGATIVE : ZERO;
  }
#endif
};

// The point type of the package; Orientation_about_origin_3 decides as for points of a kernel with double coordinates.
struct Double_points
{
  using FT = double;
  using Point_3 = Vector_3d;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_ORIENTATION_ABOUT_ORIGIN_3_H
