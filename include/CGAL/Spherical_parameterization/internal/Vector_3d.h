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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VECTOR_3D_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VECTOR_3D_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Packed_double.h>

#include <array>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Three numbers without a kernel: everything between reading the mesh and writing the map works on arrays of these.
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

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VECTOR_3D_H
