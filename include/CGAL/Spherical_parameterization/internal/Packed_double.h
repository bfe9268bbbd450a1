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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PACKED_DOUBLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PACKED_DOUBLE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Packed_mask.h>
#include <CGAL/Spherical_parameterization/internal/Packed_vectors.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

template <int W>
class Packed_double;

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS

// One number per lane for several stars that are worked on at once, as a number type: whatever is written for one star
// with `double` works for several with this. All operations are those of IEEE arithmetic in each lane, so the result of
// a star depends neither on its lane nor on how many lanes there are. What a condition decides for a double is done by
// masks and select().
//
// The alignment is written out because compilers take that of a vector which the target has no registers for to be
// smaller. The copy constructors are written out so that no compiler passes an object in registers: which ones there are differs
// between functions that are compiled for different processors.
template <int W>
class alignas(8 * W) Packed_double
{
public:
  using Mask = Packed_mask<W>;
  static constexpr std::size_t width = W;

  Packed_double() = default;
  CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double(double value) { Vectors::fill(m_lanes, value); }
  CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double(const Packed_double& other)
    : m_lanes(other.m_lanes)
  {}
  CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double& operator=(const Packed_double& other)
  {
    m_lanes = other.m_lanes;
    return *this;
  }

  // the values values[0], ..., values[width - 1]
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double load(const double* values)
  {
    Packed_double result;
    std::memcpy(&result.m_lanes, values, sizeof(Doubles));
    return result;
  }

  CGAL_SPHERICAL_PARAMETERIZATION_INLINE void store(double* values) const
  {
    std::memcpy(values, &m_lanes, sizeof(Doubles));
  }

  // the value of lane k is f(k)
  template <class Function>
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double generate(const Function& f)
  {
    Packed_double result;
    for(std::size_t k = 0; k < W; ++k)
      result.m_lanes[k] = f(k);
    return result;
  }

  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE double lane(const Packed_double& a, std::size_t k)
  {
    return a.m_lanes[k];
  }

  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double operator+(const Packed_double& a, const Packed_double& b)
  {
    return Packed_double(a.m_lanes + b.m_lanes);
  }
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double operator-(const Packed_double& a, const Packed_double& b)
  {
    return Packed_double(a.m_lanes - b.m_lanes);
  }
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double operator*(const Packed_double& a, const Packed_double& b)
  {
    return Packed_double(a.m_lanes * b.m_lanes);
  }
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double operator/(const Packed_double& a, const Packed_double& b)
  {
    return Packed_double(a.m_lanes / b.m_lanes);
  }
  CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double operator-() const { return Packed_double(-m_lanes); }
  CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double& operator+=(const Packed_double& other)
  {
    m_lanes += other.m_lanes;
    return *this;
  }
  CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double& operator*=(const Packed_double& other)
  {
    m_lanes *= other.m_lanes;
    return *this;
  }

  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Mask operator<(const Packed_double& a, const Packed_double& b)
  {
    return Mask(Integers(a.m_lanes < b.m_lanes));
  }
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Mask operator>(const Packed_double& a, const Packed_double& b)
  {
    return b < a;
  }

  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double select(const Mask& condition, const Packed_double& a,
                                                                     const Packed_double& b)
  {
    return Packed_double(condition.lanes() ? a.m_lanes : b.m_lanes);
  }
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double larger(const Packed_double& a, const Packed_double& b)
  {
    return select(a < b, b, a);
  }
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double smaller(const Packed_double& a, const Packed_double& b)
  {
    return select(b < a, b, a);
  }
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double absolute(const Packed_double& a)
  {
    return select(a < Packed_double(0.), -a, a);
  }

  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double square_root(const Packed_double& a)
  {
    Packed_double result;
#ifdef __SSE2__
    // The library function would have to set errno, which keeps compilers from using the instruction for several lanes.
    double values[sizeof(Doubles) / sizeof(double)];
    std::memcpy(values, &a.m_lanes, sizeof(values));
    for(std::size_t k = 0; k < W; k += 2)
      _mm_storeu_pd(values + k, _mm_sqrt_pd(_mm_loadu_pd(values + k)));
    std::memcpy(&result.m_lanes, values, sizeof(values));
#else
    for(std::size_t k = 0; k < W; ++k)
      result.m_lanes[k] = std::sqrt(a.m_lanes[k]);
#endif
    return result;
  }

  // exp(a) with a relative error of some 1e-16 as long as it is a normal number. What is smaller than these becomes the
  // smallest of them, what is larger infinite.
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double exponential(const Packed_double& a)
  {
    // a = k log(2) + r with |r| <= log(2) / 2; the sum of the powers of r, and 2^k as bits of the exponent.
    const Packed_double lowest(-708.), highest(709.);
    const Packed_double x = select(a > lowest, smaller(a, highest), lowest);
    const Packed_double half = select(x < Packed_double(0.), Packed_double(-0.5), Packed_double(0.5));
    const Packed_double scaled = x * Packed_double(1.4426950408889634074) + half;
    const Short_integers k = __builtin_convertvector(scaled.m_lanes, Short_integers);
    const Packed_double multiple(__builtin_convertvector(k, Doubles));
    const Packed_double r = (x - multiple * Packed_double(6.93147180369123816490e-01)) -
                            multiple * Packed_double(1.90821492927058770002e-10);
    const Packed_double r2 = r * r, r4 = r2 * r2;
    const Packed_double p0 = (r + Packed_double(1.)) + r2 * (r * Packed_double(1. / 6.) + Packed_double(0.5));
    const Packed_double p1 = (r * Packed_double(1. / 120.) + Packed_double(1. / 24.)) +
                             r2 * (r * Packed_double(1. / 5040.) + Packed_double(1. / 720.));
    const Packed_double p2 = (r * Packed_double(1. / 362880.) + Packed_double(1. / 40320.)) +
                             r2 * (r * Packed_double(1. / 39916800.) + Packed_double(1. / 3628800.));
    const Packed_double sum = p0 + r4 * (p1 + r4 * (p2 + r4 * Packed_double(1. / 479001600.)));
    const Integers exponent = __builtin_convertvector(k, Integers) << 52;
    Integers bits;
    std::memcpy(&bits, &sum.m_lanes, sizeof(bits));
    bits += exponent;
    Packed_double result;
    std::memcpy(&result.m_lanes, &bits, sizeof(bits));
    return select(a > highest, Packed_double(std::numeric_limits<double>::infinity()), result);
  }

private:
  using Vectors = Packed_vectors<W>;
  using Doubles = typename Vectors::Doubles;
  using Integers = typename Vectors::Integers;
  using Short_integers = typename Vectors::Short_integers;

  CGAL_SPHERICAL_PARAMETERIZATION_INLINE explicit Packed_double(const Doubles& lanes)
    : m_lanes(lanes)
  {}

  Doubles m_lanes;
};

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS

// The same for a single number.

CGAL_SPHERICAL_PARAMETERIZATION_INLINE double lane(double a, std::size_t)
{
  return a;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE double select(bool condition, double a, double b)
{
  return condition ? a : b;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE double larger(double a, double b)
{
  return a < b ? b : a;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE double smaller(double a, double b)
{
  return b < a ? b : a;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE double absolute(double a)
{
  return std::abs(a);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE double square_root(double a)
{
  return std::sqrt(a);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE double exponential(double a)
{
  return std::exp(a);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PACKED_DOUBLE_H
