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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_NEAREST_DOUBLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_NEAREST_DOUBLE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstdint>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A double as a rational number. Without GMP, CGAL makes it from a numerator and a denominator of type double, which do
// not exist for small numbers, and its conversion of floats rounds to integers.
inline Exact_rational exact_rational(double x)
{
  constexpr double smallest = 1e-200, scale = 0x1p600;
  return std::abs(x) < smallest && x != 0. ? Exact_rational(x * scale) / Exact_rational(scale) : Exact_rational(x);
}

template <class Number>
double nearest_double(const Number& x)
{
  return CGAL::to_double(x);
}

// The largest double that is not larger than x >= 0: non-negative doubles are ordered like their bits.
inline double largest_double_below(const Exact_rational& x)
{
  std::uint64_t low = 0, high = bits_of(HUGE_VAL);
  while(high - low > 1)
  {
    const std::uint64_t middle = low + (high - low) / 2;
    (CGAL::compare(exact_rational(double_of_bits(middle)), x) == LARGER ? high : low) = middle;
  }
  return double_of_bits(low);
}

// Rounds a rational number to the nearest double, ties to even. CGAL::to_double() rounds towards zero or to nearest, or
// has a larger error, and returns 0 or NaN if numerator and denominator are both beyond the range of double, depending
// on the number library.
inline double nearest_double(const Exact_rational& x)
{
  if(CGAL::sign(x) == NEGATIVE)
    return -nearest_double(Exact_rational(-x));
  const auto is_above = [&](double y) { return CGAL::compare(exact_rational(y), x) == LARGER; };
  const auto next_of = [](double y) { return std::nextafter(y, HUGE_VAL); };
  double low = CGAL::to_double(x);
  if(std::isfinite(low) && low > 0. && is_above(low))
    low = std::nextafter(low, 0.);
  if(!(low >= 0.) || !std::isfinite(next_of(low)) || is_above(low) || !is_above(next_of(low)))
    low = largest_double_below(x);
  const double high = next_of(low);
  if(!std::isfinite(high))
    return low;
  const Comparison_result side = CGAL::compare(x - exact_rational(low), exact_rational(high) - x);
  return side == SMALLER || (side == EQUAL && bits_of(low) % 2 == 0) ? low : high;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_NEAREST_DOUBLE_H
