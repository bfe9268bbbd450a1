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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_BARYCENTRIC_COORDINATES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_BARYCENTRIC_COORDINATES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/nearest_double.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

inline Vector_3d absolute(const Vector_3d& a)
{
  return {std::abs(a[0]), std::abs(a[1]), std::abs(a[2])};
}

// det(q, b, c) = det(q, b, c - b) up to a relative error of 2^-22, or a value that is not positive. The rounding errors
// decrease with the size of the triangle: their effect is that of a change of q by a few units in the last place. The
// computed determinant has an error below 2^-49 times the sum of the absolute values of its six products, as proved at
// Orientation_about_origin_3; the bounds leave room for underflow.
inline double accurate_determinant(const Vector_3d& q, const Vector_3d& b, const Vector_3d& c)
{
  const Vector_3d d = c - b;
  const Vector_3d u = absolute(q), v = absolute(b), w = absolute(d);
  const double determinant = dot(q, cross(b, d));
  const double permanent =
      u[0] * (v[1] * w[2] + v[2] * w[1]) + u[1] * (v[2] * w[0] + v[0] * w[2]) + u[2] * (v[0] * w[1] + v[1] * w[0]);
  const double size = (u[0] + u[1] + u[2]) + (v[0] + v[1] + v[2]) + (w[0] + w[1] + w[2]);
  return size < 1e60 && permanent > 1e-200 && determinant > 0x1p-26 * permanent ? determinant : -1.;
}

// The barycentric coordinates, in a triangle `t`, of the intersection point of the ray from the origin in the direction
// q: q is a multiple of this combination of the corners, so they are det(q, b, c), det(q, c, a) and det(q, a, b)
// divided by their sum. It is known which of them are positive and which are 0; their signs agree with this, and zeros
// are exact.
template <class FT>
std::array<FT, 3> barycentric_coordinates(const std::array<Vector_3<FT>, 3>& t, const Vector_3<FT>& q,
                                          const std::array<bool, 3>& is_positive)
{
  std::array<FT, 3> w = {FT(0), FT(0), FT(0)};
  for(std::size_t i = 0; i < 3; ++i)
    if(is_positive[i])
    {
      const Vector_3<FT>&b = t[(i + 1) % 3], &c = t[(i + 2) % 3];
      if constexpr(std::is_same<FT, double>::value)
      {
        w[i] = accurate_determinant(q, b, c);
        if(w[i] > 0.)
          continue;
        const auto exact = [](const Vector_3d& p) {
          return Vector_3<Exact_rational>{exact_rational(p[0]), exact_rational(p[1]), exact_rational(p[2])};
        };
        const auto result =
            barycentric_coordinates<Exact_rational>({exact(t[0]), exact(t[1]), exact(t[2])}, exact(q), is_positive);
        return {nearest_double(result[0]), nearest_double(result[1]), nearest_double(result[2])};
      }
      else
        w[i] = dot(q, cross(b, c));
    }
  const FT sum = w[0] + w[1] + w[2];
  return {w[0] / sum, w[1] / sum, w[2] / sum};
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_BARYCENTRIC_COORDINATES_H
