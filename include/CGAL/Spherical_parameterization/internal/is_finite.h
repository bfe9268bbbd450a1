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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_FINITE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_FINITE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>

#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Whether x is neither infinite nor NaN. It asks the bits, as a compiler that may assume that all numbers are finite
// (-ffinite-math-only, part of -ffast-math) replaces std::isfinite() by true.
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

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_FINITE_H
