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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TANGENT_FRAME_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TANGENT_FRAME_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// An orthonormal frame (t1, t2, n) at the point n of the unit sphere. Points near n are handled by their offsets from n
// in this frame: differences of nearby coordinates are exact, so a triangle keeps its relative precision however small
// it is.
template <class FT>
class Basic_tangent_frame
{
public:
  explicit Basic_tangent_frame(const Vector_3<FT>& n)
    : m_n(n)
  {
    // The two axes as smooth functions of n but for the plane n.z = 0, where the sign keeps the denominator away from
    // 0.
    const FT sign = select(n[2] < 0., FT(-1.), FT(1.));
    const FT a = -1. / (sign + n[2]);
    const FT b = n[0] * n[1] * a;
    m_t1 = {1. + sign * n[0] * n[0] * a, sign * b, -sign * n[0]};
    m_t2 = {b, sign + n[1] * n[1] * a, -n[1]};
  }

  // the offset of `p` from the origin of the frame, in the coordinates of the frame
  Vector_3<FT> offset_of(const Vector_3<FT>& p) const { return coordinates_of(p - m_n); }

  // a vector in the coordinates of the frame
  Vector_3<FT> coordinates_of(const Vector_3<FT>& v) const { return {dot(v, m_t1), dot(v, m_t2), dot(v, m_n)}; }

  // the tangential vector with the given coordinates
  Vector_3<FT> vector_of(const FT& x, const FT& y) const { return x * m_t1 + y * m_t2; }

  // the point of the sphere whose offset has the tangential coordinates `x` and `y`, x^2 + y^2 < 1
  Vector_3<FT> point_at(const FT& x, const FT& y) const
  {
    const FT z = height_at(x, y);
    const Vector_3<FT> p = {m_n[0] + (x * m_t1[0] + y * m_t2[0] + z * m_n[0]),
                            m_n[1] + (x * m_t1[1] + y * m_t2[1] + z * m_n[1]),
                            m_n[2] + (x * m_t1[2] + y * m_t2[2] + z * m_n[2])};
    // The length is that of n, 1 up to some roundings, so that one step of Newton's method normalizes it.
    return (1.5 - 0.5 * squared_length(p)) * p;
  }

  // the offset along n of that point: sqrt(1 - x^2 - y^2) - 1 without its cancellation
  static FT height_at(const FT& x, const FT& y)
  {
    const FT t = x * x + y * y;
    return -t / (1. + square_root(1. - t));
  }

private:
  Vector_3<FT> m_n, m_t1, m_t2;
};

using Tangent_frame = Basic_tangent_frame<double>;

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TANGENT_FRAME_H
