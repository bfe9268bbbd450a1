// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ORIENTATION_ABOUT_ORIGIN_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ORIENTATION_ABOUT_ORIGIN_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Origin.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The exact sign of det(a, b, c): POSITIVE if the triangle abc turns counterclockwise as seen from outside of a sphere
// around the origin. A triangle with a coordinate that is not finite has no orientation: ZERO.
//
// `K` is a kernel with exact predicates. For coordinates of type double a floating-point filter stands in front of the
// predicate of the kernel. It evaluates det(a, b - a, c - a), which is the same number, and whose rounding errors
// shrink with the triangle: the small triangles of a fine mesh on a sphere, whose determinants fall below what a filter
// on det(a, b, c) can tell from 0, pass as well; only needles do not.
//
// Why the filter is right. Let e = 2^-52, an upper bound of the relative error of an operation in any rounding mode,
// let d be the exact determinant and p the exact sum of the absolute values of its six products. Ignoring underflow,
// each product in the computed determinant D carries at most seven factors (1 + x) with |x| <= e: two differences, two
// multiplications, the difference of the cross product and two additions. The same holds for the computed P of p, whose
// terms are all positive. Thus
//   |D - d| <= ((1 + e)^7 - 1) p    and    p <= P / (1 - e)^7,    hence    |D - d| <= 7 (1 + 15 e) e P < 8 e P.
// Underflow only happens in multiplications (sums and differences are exact where they are subnormal). It adds less
// than 2^-1021 to each of the six products of the cross product's components, and to each of the three products that
// follow. With |a| = |a_x| + |a_y| + |a_z|, the determinant changes by less than 2^-1016 (|a| + 1), and so does P,
// which counts 2^-49 of that: together less than 2^-1000 (|a| + 1). An overflow makes P or |a| infinite or not a
// number, and so does a coordinate that is not finite; no comparison below is true then.
template <class K>
class Orientation_about_origin_3
{
  using Point_3 = typename K::Point_3;

public:
  Sign operator()(const Point_3& a, const Point_3& b, const Point_3& c) const
  {
    if constexpr(std::is_same<typename K::FT, double>::value)
    {
      const double px = b.x() - a.x(), py = b.y() - a.y(), pz = b.z() - a.z();
      const double qx = c.x() - a.x(), qy = c.y() - a.y(), qz = c.z() - a.z();
      const double pyqz = py * qz, pzqy = pz * qy;
      const double pzqx = pz * qx, pxqz = px * qz;
      const double pxqy = px * qy, pyqx = py * qx;
      const double ax = std::abs(a.x()), ay = std::abs(a.y()), az = std::abs(a.z());
      const double determinant = a.x() * (pyqz - pzqy) + a.y() * (pzqx - pxqz) + a.z() * (pxqy - pyqx);
      const double permanent = ax * (std::abs(pyqz) + std::abs(pzqy)) + ay * (std::abs(pzqx) + std::abs(pxqz)) +
                               az * (std::abs(pxqy) + std::abs(pyqx));
      const double error = 0x1p-49 * permanent + 0x1p-1000 * (ax + ay + az + 1.);
      if(determinant > error)
      {
        return POSITIVE;
      }
      if(determinant < -error)
      {
        return NEGATIVE;
      }
    }

    if(!is_finite(a) || !is_finite(b) || !is_finite(c))
    {
      return ZERO;
    }
    return m_orientation(m_origin, a, b, c);
  }

private:
  // An exact number cannot be infinite, but a lazy one that was made from an infinite double or from NaN must not be
  // evaluated. Its interval tells. A finite number beyond the range of doubles has one finite end.
  static bool is_finite(const typename K::FT& x)
  {
    const std::pair<double, double> interval = CGAL::to_interval(x);
    return interval.first < std::numeric_limits<double>::infinity() &&
           interval.second > -std::numeric_limits<double>::infinity();
  }

  static bool is_finite(const Point_3& p) { return is_finite(p.x()) && is_finite(p.y()) && is_finite(p.z()); }

  typename K::Orientation_3 m_orientation = K().orientation_3_object();
  Point_3 m_origin{ORIGIN};
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ORIENTATION_ABOUT_ORIGIN_3_H
