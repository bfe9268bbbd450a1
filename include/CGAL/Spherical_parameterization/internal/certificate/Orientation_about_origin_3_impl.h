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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_ORIENTATION_ABOUT_ORIGIN_3_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_ORIENTATION_ABOUT_ORIGIN_3_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/enum.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// An arbitrary-precision integer; those for determinants of coordinates of similar size are stored without allocation.
using Determinant_integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<512>>;

// A positive multiple of `p`, whose coordinates are finite, with integer coordinates. They are extracted from the bits,
// without floating-point operations.
inline std::array<Determinant_integer, 3> integer_multiple(const Vector_3d& p)
{
  std::array<std::int64_t, 3> mantissas;
  std::array<int, 3> exponents;
  constexpr int largest_exponent = 0x7FF;
  int smallest = largest_exponent; // of the coordinates that are not 0
  for(std::size_t i = 0; i < 3; ++i)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &p[i], sizeof(bits));
    std::uint64_t mantissa = bits & 0xFFFFFFFFFFFFFu;
    exponents[i] = static_cast<int>((bits >> 52) & 0x7FFu);
    if(exponents[i] > 0)
      mantissa |= std::uint64_t(1) << 52;
    else
      exponents[i] = 1; // subnormal
    mantissas[i] = static_cast<std::int64_t>(mantissa);
    if(bits >> 63)
      mantissas[i] = -mantissas[i];
    if(mantissas[i] != 0)
      smallest = (std::min)(smallest, exponents[i]);
  }
  std::array<Determinant_integer, 3> result;
  for(std::size_t i = 0; i < 3; ++i)
    if(mantissas[i] != 0)
    {
      result[i] = mantissas[i];
      result[i] <<= static_cast<unsigned int>(exponents[i] - smallest);
    }
  return result;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Sign exact_determinant_sign(const Vector_3d& a, const Vector_3d& b,
                                                                   const Vector_3d& c)
{
  const std::array<Determinant_integer, 3> p = integer_multiple(a), q = integer_multiple(b), r = integer_multiple(c);
  const Determinant_integer determinant =
      p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  return determinant.sign() > 0 ? POSITIVE : determinant.sign() < 0 ? NEGATIVE : ZERO;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_ORIENTATION_ABOUT_ORIGIN_3_IMPL_H
