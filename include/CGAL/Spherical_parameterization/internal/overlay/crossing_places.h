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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_OVERLAY_CROSSING_PLACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_OVERLAY_CROSSING_PLACES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Spherical_parameterization::internal {

template <class Point_3>
Vector_3d coordinates_of(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

inline Vector_3d point_on_edge(const Vector_3d& p, const Vector_3d& q, double place)
{
  return (1. - place) * p + place * q;
}

// Where on the edge from p to q the ray of r is, from 0 to 1, if it is in its plane, or next to it.
inline double place_on_edge(const Vector_3d& p, const Vector_3d& q, const Vector_3d& r)
{
  const Vector_3d n = cross(p, q);
  const double to_p = dot(cross(p, r), n), to_q = dot(cross(r, q), n); // (1 - t) p + t q crosses with t n and (1 - t) n
  const double place = to_p / (to_p + to_q);
  return place > 0. ? (std::min)(place, 1.) : 0.;
}

// Scales an edge by a power of two, which is exact, so that products of its coordinates neither overflow nor underflow.
inline void scale_to_unit(Vector_3d& p, Vector_3d& q)
{
  double max = 0.;
  for(std::size_t k = 0; k < 3; ++k)
    max = (std::max)({max, std::abs(p[k]), std::abs(q[k])});
  const int exponent = std::ilogb(max);
  for(std::size_t k = 0; k < 3; ++k)
  {
    p[k] = std::scalbn(p[k], -exponent);
    q[k] = std::scalbn(q[k], -exponent);
  }
}

// Where two edges cross, from 0 to 1 on each: the numbers s and t for which (1 - s) a1 + s a2 and (1 - t) b1 + t b2 have one
// direction. Edges that are next to each other over a length have no one place, but one that they share.
inline std::array<double, 2> crossing_places(Vector_3d a1, Vector_3d a2, Vector_3d b1, Vector_3d b2)
{
  scale_to_unit(a1, a2);
  scale_to_unit(b1, b2);
  const Vector_3d n = cross(b1, b2);
  const double d1 = std::abs(dot(n, a1)), d2 = std::abs(dot(n, a2)); // on two sides, but for ties and rounding
  const double s = d1 + d2 > 0. ? d1 / (d1 + d2) : 0.5;
  const double t = place_on_edge(b1, b2, point_on_edge(a1, a2, s));
  return {place_on_edge(a1, a2, point_on_edge(b1, b2, t)), t};
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_OVERLAY_CROSSING_PLACES_H
