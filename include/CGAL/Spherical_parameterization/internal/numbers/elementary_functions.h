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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_ELEMENTARY_FUNCTIONS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_ELEMENTARY_FUNCTIONS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

// Replacements of functions of the standard library that are not correctly rounded and so differ between systems. These
// give the same bits on every machine with IEEE doubles, with any compiler that does not contract products and sums.
// They consist of + - * /, the square root, and operations on the bits of numbers. Where rounding matters, a number is
// a sum of two. Zeros, infinities, NaN and out-of-range arguments give the results of the standard library.
//
// Coefficients of polynomials interpolate, in 60 digits, at the zeros of a Chebyshev polynomial, and are rounded. The
// test test_numbers measures and bounds the largest error of each function in units of the last place (ulp).

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// high + low, where `low` is at most a few units in the last place of `high`.
struct Double_double
{
  double high, low;
};

// a + b, exactly (Knuth)
inline Double_double exact_sum(double a, double b)
{
  const double sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// The same for |a| >= |b| or a = 0 (Dekker).
inline Double_double exact_sum_of_ordered(double a, double b)
{
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// The first 26 bits of a number: products of these are exact. Unlike in Veltkamp's product, there is no overflow.
inline double upper_half(double a)
{
  return double_of_bits(bits_of(a) & 0xfffffffff8000000);
}

// a b, up to 2^-105 of it (Dekker); it must not overflow, and from 2^-960 on it does not underflow.
inline Double_double exact_product(double a, double b)
{
  const double product = a * b, a1 = upper_half(a), a2 = a - a1, b1 = upper_half(b), b2 = b - b1;
  return {product, ((a1 * b1 - product) + (a1 * b2 + a2 * b1)) + a2 * b2};
}

// a / b, up to about 2^-100 of it.
inline Double_double quotient(const Double_double& a, const Double_double& b)
{
  const double inverse = 1. / b.high, q = a.high * inverse;
  const Double_double product = exact_product(q, b.high);
  return {q, (((a.high - product.high) - product.low) + (a.low - q * b.low)) * inverse};
}

// c0 + c1 x + c2 x^2 + ..., two terms at a time, which takes half the time of one term after the other.
inline double polynomial(double, double, double c0)
{
  return c0;
}
template <class... Coefficients>
double polynomial(double x, double square, double c0, double c1, Coefficients... others)
{
  if constexpr(sizeof...(others) == 0)
    return c0 + x * c1;
  else
    return (c0 + x * c1) + square * polynomial(x, square, others...);
}

// exp(a); error: 1 ulp; bitwise equal to clamped_exponential() in its range.
inline double exponential(double a)
{
  double shifted;
  if(a >= -708. && a <= 709.)
  {
    const double power = exponential_of_rest(a, shifted);
    return times_power_of_two(power, shifted);
  }
  if(a > 710.)
    return std::numeric_limits<double>::infinity();
  if(a < -746.)
    return 0.;
  if(!(std::abs(a) <= 746.))
    return a; // not a number
  const double power = exponential_of_rest(a, shifted);
  return std::ldexp(power, static_cast<int>(shifted - integer_shift));
}

// log(a); error: 0.95 ulp
inline double logarithm(double a)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if(!(a > 0.))
    return a == 0. ? -infinity : std::numeric_limits<double>::quiet_NaN();
  if(!(a < infinity))
    return a;
  constexpr double smallest_normal = (std::numeric_limits<double>::min)();
  const bool is_denormal = a < smallest_normal;
  const std::uint64_t bits = bits_of(is_denormal ? a * 18014398509481984. : a); // 2^54

  // a = 2^k m with m from sqrt(1/2) to sqrt(2)
  const std::uint64_t root_of_half = 0x3fe6a09e667f3bcd, exponent_of_one = 1023;
  const std::uint64_t steps = (bits - root_of_half + (exponent_of_one << 52)) >> 52; // k + 1023
  const double m = double_of_bits(bits - ((steps - exponent_of_one) << 52));
  const double k = static_cast<double>(static_cast<int>(steps) - 1023 - (is_denormal ? 54 : 0));

  // With f = m - 1 and s = f / (2 + f), log(m) = 2 artanh(s) = f - s (f - s^2 p(s^2)). The product of k and the first
  // part of log(2) is exact.
  const double f = m - 1., s = f / (2. + f), z = s * s;
  const double series =
      polynomial(z, z * z, 6.66666666666666963e-01, 3.99999999998994993e-01, 2.85714286259782624e-01,
                 2.22222111343416240e-01, 1.81828891582999030e-01, 1.53317205023765585e-01, 1.46164632589580096e-01);
  const Double_double sum = exact_sum_of_ordered(k * 0x1.62e42fefa38p-1, f);
  return sum.high + ((sum.low + k * 0x1.ef35793c7673p-45) - s * (f - z * series));
}

// An angle as `quarters` quarter turns and a rest of at most an eighth of a turn, up to rounding error.
struct Reduced_angle
{
  explicit Reduced_angle(double angle)
  {
    constexpr double max_angle = 2e5; // k has 17 bits, and the first two parts of pi / 2 have 36 of them
    if(!(std::abs(angle) <= max_angle))
      angle = std::fmod(angle, 6.283185307179586); // exact, except for this constant
    const double k_rounded = angle * 0.6366197723675814 + (angle < 0. ? -0.5 : 0.5);
    const std::int64_t n = std::abs(k_rounded) <= 2. * max_angle ? static_cast<std::int64_t>(k_rounded) : 0; // no NaN
    const double k = static_cast<double>(n);
    const Double_double first = exact_sum(angle - k * 0x1.921fb5444p+0, -(k * 0x1.68c234c4cp-39));
    rest = exact_sum(first.high, -(k * 0x1.98a2e03707345p-77));
    rest.low += first.low;
    quarters = static_cast<unsigned>(n & 3);
  }

  double sine_of_rest() const
  {
    const double r = rest.high, z = r * r;
    const double series = polynomial(z, z * z, -1.66666666666666657e-01, 8.33333333333333148e-03,
                                     -1.98412698412650626e-04, 2.75573192193373122e-06, -2.50521062318028370e-08,
                                     1.60585315167977585e-10, -7.58669109419795817e-13);
    return r + (rest.low * (1. - 0.5 * z) + r * z * series);
  }

  double cosine_of_rest() const
  {
    const double r = rest.high;
    const Double_double square = exact_product(r, r);
    const double z = square.high, z2 = z * z;
    const double series = polynomial(z, z2, 4.16666666666666644e-02, -1.38888888888873976e-03, 2.48015872987645609e-05,
                                     -2.75573172711451445e-07, 2.08761461465586099e-09, -1.13826236474746042e-11);
    const Double_double sum = exact_sum_of_ordered(1., -0.5 * z);
    return sum.high + ((sum.low - (0.5 * square.low + r * rest.low)) + z2 * series);
  }

  Double_double rest;
  unsigned quarters;
};

// sin(a) and cos(a); error: 0.9 ulp for |a| <= 2e5. Beyond, the effect of half a unit in the last place of `a` is
// added.
inline double sine(double a)
{
  if(std::abs(a) < 1e-8)
    return a; // with the sign of a zero
  const Reduced_angle angle(a);
  const double result = angle.quarters & 1 ? angle.cosine_of_rest() : angle.sine_of_rest();
  return angle.quarters & 2 ? -result : result;
}

inline double cosine(double a)
{
  const Reduced_angle angle(a);
  const double result = angle.quarters & 1 ? angle.sine_of_rest() : angle.cosine_of_rest();
  return (angle.quarters + 1) & 2 ? -result : result;
}

// The angle from 0 to pi of the point (x, y) with y >= 0, which is not the origin, from the x-axis. Both coordinates
// must be in a range in which products and quotients neither overflow nor underflow.
inline double angle_of(double y, double x)
{
  const double width = std::abs(x);
  const bool is_steep = y > width;
  const double a = is_steep ? width : y, b = is_steep ? y : width;

  // With t = (a - c b) / (b + c a), atan(a / b) = atan(c) + atan(t). For c = 0, 1/2 or 1, |t| is at most 0.2361.
  constexpr std::array<Double_double, 3> angles = {
      {{0., 0.}, {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56}, {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};
  const std::size_t i =
      static_cast<std::size_t>(a > 0.2360679774997897 * b) + static_cast<std::size_t>(a > 0.7207592200561265 * b);
  const double c = 0.5 * static_cast<double>(i);
  const Double_double t = quotient(exact_sum(a, -(c * b)), exact_sum_of_ordered(b, c * a));
  const double z = t.high * t.high;
  const double series =
      polynomial(z, z * z, -3.33333333333333315e-01, 1.99999999999995598e-01, -1.42857142855029873e-01,
                 1.11111110721091991e-01, -9.09090547784978664e-02, 7.69211915159042636e-02, -6.66086015367258200e-02,
                 5.77717253891118915e-02, -4.21237455541517841e-02);
  const Double_double angle = exact_sum_of_ordered(angles[i].high, t.high);
  const double low = angle.low + (angles[i].low + (t.low + t.high * z * series));

  // From the nearest axis.
  const double quarters = is_steep ? 1. : (x < 0. ? 2. : 0.);
  const double sign = is_steep == (x < 0.) ? 1. : -1.;
  const Double_double sum = exact_sum_of_ordered(quarters * 0x1.921fb54442d18p+0, sign * angle.high);
  return sum.high + (sum.low + (quarters * 0x1.1a62633145c07p-54 + sign * low));
}

// atan2(y, x); error: 0.6 ulp
inline double arc_tangent(double y, double x)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double height = std::abs(y), width = std::abs(x);
  double a = height, b = x, size = height < width ? width : height;
  if(!(height <= infinity && width <= infinity))
    return x + y; // not a number
  if(size == infinity)
  {
    a = height == infinity ? 1. : 0.;
    b = std::copysign(width == infinity ? 1. : 0., x);
  }
  else if(size == 0.)
    b = std::copysign(1., x);
  else if(x > 0. && height < x * 8e-19) // 2^-60
    return y / x;
  else if(size > 1e250 || size < 1e-250)
  {
    const double scale = size > 1. ? 0x1p-600 : 0x1p600;
    a *= scale;
    b *= scale;
  }
  return std::copysign(angle_of(a, b), y);
}

// sqrt(x^2 + y^2 + z^2); error: 0.6 ulp, or 0.8 for denormal numbers
inline double hypotenuse(double x, double y, double z = 0.)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double a = std::abs(x), b = std::abs(y), c = std::abs(z), size = (std::max)((std::max)(a, b), c);
  if(a == infinity || b == infinity || c == infinity)
    return infinity;
  // A power of two, 2^600 or its inverse, if squares would be too large or too small.
  const double scale = size > 1e135 ? 0x1p-600 : (size < 1e-135 ? 0x1p600 : 1.);
  const double u = scale * x, v = scale * y, w = scale * z;
  const Double_double uu = exact_product(u, u), vv = exact_product(v, v), ww = exact_product(w, w);
  const Double_double uv = exact_sum(uu.high, vv.high), all = exact_sum(uv.high, ww.high);
  const double low = all.low + (uv.low + ((uu.low + vv.low) + ww.low));
  const double root = std::sqrt(all.high);
  if(!(root > 0.))
    return root; // zero, or not a number
  const Double_double square = exact_product(root, root);
  return (root + (((all.high - square.high) - square.low) + low) / (2. * root)) / scale;
}

// cbrt(a); error: 0.6 ulp, exact for cubes
inline double cube_root(double a)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double size = std::abs(a);
  if(!(size > 0. && size < infinity))
    return a;
  // |a| = 2^(3 k) m with m from 1 to 8
  int exponent;
  const double fraction = std::frexp(size, &exponent);
  const int k = (exponent + 2999) / 3 - 1000;
  const double m = std::ldexp(fraction, exponent - 3 * k);
  // Interpolated with an error of one percent, improved by Halley's method to all digits but the last, and by Newton's
  // method with the exact m - r^3.
  double r = 0.71673464 + m * (0.32883645 + m * (-0.034026054 + m * 0.0016274953));
  for(int step = 0; step < 2; ++step)
  {
    const double cube = r * r * r;
    r *= (cube + 2. * m) / (2. * cube + m);
  }
  const Double_double square = exact_product(r, r), cube = exact_product(square.high, r);
  r += ((m - cube.high) - (cube.low + square.low * r)) / (3. * square.high);
  return std::copysign(std::ldexp(r, k), a);
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_ELEMENTARY_FUNCTIONS_H
