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
    Vectors::generate(result.m_lanes, f);
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
    Packed_double result = a;
    Vectors::take_square_roots(result.m_lanes);
    return result;
  }

  // exp(a) from -708 to 709, with a relative error of some 1e-16 (1e-11 where doubles are not rounded to nearest); what
  // is smaller, or no number, gets the value at the lower end, what is larger that at the upper one.
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_double exponential(const Packed_double& a)
  {
    const Packed_double lowest(-708.), highest(709.);
    const Packed_double x = select(a > lowest, smaller(a, highest), lowest);

    // x = k log(2) + r with |r| <= log(2) / 2, if k is rounded to nearest: next to this shift, doubles are integers, so
    // that the last bits of the sum are k. The sign, which is not set, is masked for compilers that may reorder sums
    // (-ffast-math): they would take the shift out again without any rounding.
    const Packed_double shift(6755399441055744.); // 3 * 2^51
    const Packed_double shifted = x * Packed_double(1.4426950408889634074) + shift;
    Integers bits;
    std::memcpy(&bits, &shifted.m_lanes, sizeof(bits));
    const Integers exponent = bits << 52;
    bits &= 0x7fffffffffffffff;
    Packed_double k;
    std::memcpy(&k.m_lanes, &bits, sizeof(bits));
    k = k - shift;
    const Packed_double r =
        (x - k * Packed_double(6.93147180369123816490e-01)) - k * Packed_double(1.90821492927058770002e-10);

    // exp(r) = 1 + r + r^2 q(r), where q interpolates at the zeros of a Chebyshev polynomial, to 2e-17. The
    // coefficients are written out, as a quotient of two numbers is not evaluated by compilers that have to respect the
    // rounding mode, but whenever it is needed.
    const Packed_double r2 = r * r, r4 = r2 * r2;
    const Packed_double q0 = (Packed_double(5.00000000000000111e-01) + r * Packed_double(1.66666666666666685e-01)) +
                             r2 * (Packed_double(4.16666666666241289e-02) + r * Packed_double(8.33333333333006153e-03));
    const Packed_double q1 = (Packed_double(1.38888889172137167e-03) + r * Packed_double(1.98412698630536177e-04)) +
                             r2 * (Packed_double(2.48015212959543761e-05) + r * Packed_double(2.75572684599970641e-06));
    const Packed_double q2 = Packed_double(2.76200884454097462e-07) + r * Packed_double(2.51003854955103203e-08);
    const Packed_double power = Packed_double(1.) + (r + r2 * (q0 + r4 * (q1 + r4 * q2)));

    // times 2^k
    std::memcpy(&bits, &power.m_lanes, sizeof(bits));
    bits += exponent;
    Packed_double result;
    std::memcpy(&result.m_lanes, &bits, sizeof(bits));
    return result;
  }

private:
  using Vectors = Packed_vectors<W>;
  using Doubles = typename Vectors::Doubles;
  using Integers = typename Vectors::Integers;

  CGAL_SPHERICAL_PARAMETERIZATION_INLINE explicit Packed_double(const Doubles& lanes)
    : m_lanes(lanes)
  {}

  Doubles m_lanes;
};

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS

// The same for a single number, but for the ends of the exponential.

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
