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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_DIRECTION_OF_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_DIRECTION_OF_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

template <class Point_3>
Vector_3d rounded(const Point_3& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

// The direction of a point, at distance 1 from the origin, rounded. Powers of two keep squares from overflow and underflow,
// and change no bit of what needs none.
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

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_DIRECTION_OF_H
