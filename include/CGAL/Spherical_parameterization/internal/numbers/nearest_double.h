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

// A double as a rational number. Without GMP, CGAL makes it of a numerator and a denominator that are doubles, which there are not
// for small numbers, and what it makes of floats is rounded to integers.
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

// The largest double that is not larger than x >= 0: doubles are in the order of their bits.
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

// A rational number, rounded to the nearest double, of two as near to the even one. CGAL::to_double() rounds towards zero or to
// nearest, or errs by more, and has 0 or NaN where numerator and denominator are both beyond the range of doubles: that depends on
// the library that computes with such numbers.
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
