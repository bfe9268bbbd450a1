// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VECTOR_3D_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VECTOR_3D_H

#include <CGAL/license/Spherical_parameterization.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Three doubles without a kernel: everything between reading the mesh and writing the map works on arrays of these.
using Vector_3d = std::array<double, 3>;

inline Vector_3d operator-(const Vector_3d& a, const Vector_3d& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Vector_3d operator+(const Vector_3d& a, const Vector_3d& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Vector_3d operator*(double s, const Vector_3d& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}

inline double dot(const Vector_3d& a, const Vector_3d& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector_3d cross(const Vector_3d& a, const Vector_3d& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double squared_length(const Vector_3d& a)
{
  return dot(a, a);
}

inline double length(const Vector_3d& a)
{
  return std::sqrt(dot(a, a));
}

inline Vector_3d normalized(const Vector_3d& a)
{
  return (1. / length(a)) * a;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VECTOR_3D_H
