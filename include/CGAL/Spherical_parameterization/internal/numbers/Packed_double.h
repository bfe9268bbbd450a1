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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_PACKED_DOUBLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_PACKED_DOUBLE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

// Whether the compiler has vectors beyond the standard. A program that defines CGAL_SPHERICAL_PARAMETERIZATION_STANDARD_CXX is
// compiled as by one that has nothing of the kind.
#if defined(__GNUC__) && !defined(CGAL_SPHERICAL_PARAMETERIZATION_STANDARD_CXX)
#define CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
#endif

// Whether Eight_lanes.h has a number type of its own. Clang inlines what is called directly only, and MinGW-w64 does not align
// stacks for such numbers.
#if defined(CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS) && defined(__x86_64__) && !defined(__clang__) &&              \
    !defined(_WIN32)
#define CGAL_SPHERICAL_PARAMETERIZATION_HAS_EIGHT_LANES
#endif

// What is compiled for a better processor than the rest of the program has to be inlined into the function that is.
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
#define CGAL_SP_INLINE inline __attribute__((always_inline))
#else
#define CGAL_SP_INLINE inline
#endif

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS

// The vectors of W numbers that compilers offer beyond the standard, and what they lack.
//
// A vector is put together by its constructor from all its numbers at once, and what there is an instruction for with
// two numbers is done by halves: compilers find the best for both. Numbers that are written one after the other would
// be sent through the memory, from which a vector is not read before all of them are there.
template <int W>
struct Packed_vectors;

template <>
struct Packed_vectors<2>
{
  typedef double Doubles __attribute__((vector_size(16)));
  typedef std::int64_t Integers __attribute__((vector_size(16)));
  typedef float Floats __attribute__((vector_size(8)));

  // v[k] = f(k)
  template <class Function>
  static CGAL_SP_INLINE void generate(Doubles& v, const Function& f)
  {
    v = Doubles{f(0), f(1)};
  }

  static CGAL_SP_INLINE void take_square_roots(Doubles& v)
  {
#ifdef __SSE2__
    // The library function would have to set errno, which keeps compilers from using the instruction for two numbers.
    v = _mm_sqrt_pd(v);
#else
    v = Doubles{std::sqrt(v[0]), std::sqrt(v[1])};
#endif
  }

  static CGAL_SP_INLINE bool any_negative(const Integers& v)
  {
#ifdef __SSE2__
    return _mm_movemask_pd(Doubles(v)) != 0; // the same bits
#else
    return (v[0] | v[1]) < 0;
#endif
  }
};

template <>
struct Packed_vectors<4>
{
  using Half = Packed_vectors<2>;
  typedef double Doubles __attribute__((vector_size(32)));
  typedef std::int64_t Integers __attribute__((vector_size(32)));
  typedef float Floats __attribute__((vector_size(16)));

  template <class Function>
  static CGAL_SP_INLINE void generate(Doubles& v, const Function& f)
  {
    v = Doubles{f(0), f(1), f(2), f(3)};
  }

  static CGAL_SP_INLINE void take_square_roots(Doubles& v)
  {
    Half::Doubles low = {v[0], v[1]}, high = {v[2], v[3]};
    Half::take_square_roots(low);
    Half::take_square_roots(high);
    v = Doubles{low[0], low[1], high[0], high[1]};
  }

  static CGAL_SP_INLINE bool any_negative(const Integers& v)
  {
    return Half::any_negative(Half::Integers{v[0], v[1]} | Half::Integers{v[2], v[3]});
  }
};

// A condition for each lane of a Packed_double: all bits of a lane are set where it holds.
template <int W>
class alignas(8 * W) Packed_mask
{
public:
  using Self = Packed_mask;
  using Integers = typename Packed_vectors<W>::Integers;

  CGAL_SP_INLINE explicit Packed_mask(const Integers& lanes)
    : m_lanes(lanes)
  {}
  CGAL_SP_INLINE Packed_mask(const Packed_mask& other)
    : m_lanes(other.m_lanes)
  {}
  CGAL_SP_INLINE Packed_mask& operator=(const Packed_mask& other) { return m_lanes = other.m_lanes, *this; }

  friend CGAL_SP_INLINE bool lane(const Packed_mask& a, std::size_t k) { return a.m_lanes[k] != 0; }

  friend CGAL_SP_INLINE Self operator&&(const Self& a, const Self& b) { return Self(a.m_lanes & b.m_lanes); }
  friend CGAL_SP_INLINE Self operator||(const Self& a, const Self& b) { return Self(a.m_lanes | b.m_lanes); }
  friend CGAL_SP_INLINE Packed_mask operator!(const Packed_mask& a) { return Packed_mask(~a.m_lanes); }

  // whether the condition holds in any lane
  friend CGAL_SP_INLINE bool any(const Packed_mask& a) { return Packed_vectors<W>::any_negative(a.m_lanes); }

  CGAL_SP_INLINE const Integers& lanes() const { return m_lanes; }

private:
  Integers m_lanes;
};

// One number per lane for several stars that are worked on at once, as a number type: whatever is written for one star
// with `double` works for several with this. All operations are those of IEEE arithmetic in each lane, so the result of
// a star depends neither on its lane nor on how many lanes there are. What a condition decides for a double is done by
// masks and select().
//
// The alignment is written out because compilers take that of a vector which the target has no registers for to be
// smaller. The copy constructors are written out so that no compiler passes an object in registers: which ones there
// are differs between functions that are compiled for different processors.
template <int W>
class alignas(8 * W) Packed_double
{
public:
  using Self = Packed_double;
  using Mask = Packed_mask<W>;
  static constexpr std::size_t width = W;

  Packed_double() = default;
  CGAL_SP_INLINE Packed_double(double value)
  {
    Vectors::generate(m_lanes, [&](std::size_t) { return value; });
  }
  CGAL_SP_INLINE Packed_double(const Packed_double& other)
    : m_lanes(other.m_lanes)
  {}
  CGAL_SP_INLINE Packed_double& operator=(const Packed_double& other) { return m_lanes = other.m_lanes, *this; }

  // the values values[0], ..., values[width - 1]
  static CGAL_SP_INLINE Packed_double load(const double* values)
  {
    Packed_double result;
    std::memcpy(&result.m_lanes, values, sizeof(Doubles));
    return result;
  }

  // the same of floats
  static CGAL_SP_INLINE Packed_double load(const float* values)
  {
    Floats floats;
    std::memcpy(&floats, values, sizeof(Floats));
    return generate([&](std::size_t k) { return static_cast<double>(floats[k]); });
  }

  static CGAL_SP_INLINE void store(const Self& a, double* values) { std::memcpy(values, &a.m_lanes, sizeof(Doubles)); }

  // the value of lane k is f(k)
  template <class Function>
  static CGAL_SP_INLINE Packed_double generate(const Function& f)
  {
    Packed_double result;
    Vectors::generate(result.m_lanes, f);
    return result;
  }

  friend CGAL_SP_INLINE double lane(const Packed_double& a, std::size_t k) { return a.m_lanes[k]; }

  friend CGAL_SP_INLINE Self operator+(const Self& a, const Self& b) { return Self(a.m_lanes + b.m_lanes); }
  friend CGAL_SP_INLINE Self operator-(const Self& a, const Self& b) { return Self(a.m_lanes - b.m_lanes); }
  friend CGAL_SP_INLINE Self operator*(const Self& a, const Self& b) { return Self(a.m_lanes * b.m_lanes); }
  friend CGAL_SP_INLINE Self operator/(const Self& a, const Self& b) { return Self(a.m_lanes / b.m_lanes); }
  CGAL_SP_INLINE Packed_double operator-() const { return Packed_double(-m_lanes); }
  CGAL_SP_INLINE Packed_double& operator+=(const Packed_double& other) { return m_lanes += other.m_lanes, *this; }
  CGAL_SP_INLINE Packed_double& operator*=(const Packed_double& other) { return m_lanes *= other.m_lanes, *this; }

  friend CGAL_SP_INLINE Mask operator<(const Self& a, const Self& b) { return Mask(Integers(a.m_lanes < b.m_lanes)); }
  friend CGAL_SP_INLINE Mask operator>(const Self& a, const Self& b) { return b < a; }

  friend CGAL_SP_INLINE Packed_double select(const Mask& condition, const Packed_double& a, const Packed_double& b)
  {
    return Packed_double(condition.lanes() ? a.m_lanes : b.m_lanes);
  }
  friend CGAL_SP_INLINE Self maximum(const Self& a, const Self& b) { return select(a < b, b, a); }
  friend CGAL_SP_INLINE Self minimum(const Self& a, const Self& b) { return select(b < a, b, a); }
  friend CGAL_SP_INLINE Packed_double absolute(const Packed_double& a) { return select(a < Packed_double(0.), -a, a); }

  friend CGAL_SP_INLINE Packed_double square_root(const Packed_double& a)
  {
    Packed_double result = a;
    Vectors::take_square_roots(result.m_lanes);
    return result;
  }

  // what clamped_exponential() needs of the bits
  friend CGAL_SP_INLINE Packed_double without_fraction(const Packed_double& shifted)
  {
    return Packed_double(Doubles(Integers(shifted.m_lanes) & 0x7fffffffffffff00));
  }
  friend CGAL_SP_INLINE Packed_double times_power_of_two(const Packed_double& a, const Packed_double& shifted)
  {
    return Packed_double(Doubles(Integers(a.m_lanes) + (Integers(shifted.m_lanes) << 44)));
  }

private:
  using Vectors = Packed_vectors<W>;
  using Doubles = typename Vectors::Doubles;
  using Integers = typename Vectors::Integers;
  using Floats = typename Vectors::Floats;

  CGAL_SP_INLINE explicit Packed_double(const Doubles& lanes)
    : m_lanes(lanes)
  {}

  Doubles m_lanes;
};

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS

// The same for a single number.

template <class T>
CGAL_SP_INLINE T lane(T a, std::size_t)
{
  return a;
}
CGAL_SP_INLINE bool any(bool condition)
{
  return condition;
}
CGAL_SP_INLINE double select(bool condition, double a, double b)
{
  return condition ? a : b;
}
CGAL_SP_INLINE double maximum(double a, double b)
{
  return a < b ? b : a;
}
CGAL_SP_INLINE double minimum(double a, double b)
{
  return b < a ? b : a;
}
CGAL_SP_INLINE double absolute(double a)
{
  return std::abs(a);
}
CGAL_SP_INLINE double square_root(double a)
{
  return std::sqrt(a);
}
CGAL_SP_INLINE std::uint64_t bits_of(double a)
{
  std::uint64_t result;
  std::memcpy(&result, &a, sizeof(double));
  return result;
}
CGAL_SP_INLINE double double_of_bits(std::uint64_t bits)
{
  double result;
  std::memcpy(&result, &bits, sizeof(double));
  return result;
}
CGAL_SP_INLINE double without_fraction(double shifted)
{
  return double_of_bits(bits_of(shifted) & 0x7fffffffffffff00);
}
CGAL_SP_INLINE double times_power_of_two(double a, double shifted)
{
  return double_of_bits(bits_of(a) + (bits_of(shifted) << 44));
}

// Next to this number, 3 * 2^43, doubles have eight bits behind the point: those before them are the integer k, if the
// number k + exponential_shift is looked at.
constexpr double exponential_shift = 26388279066624.;

// exp(x) = 2^k power with 3/4 <= power < 3/2, but for a thousandth, where `shifted` becomes k + exponential_shift. So 1 + r
// below is rounded less than it would be from sqrt(1/2) to sqrt(2), and the sum it is made of as well.
template <class FT>
CGAL_SP_INLINE FT exponential_of_rest(const FT& x, FT& shifted)
{
  // x = k log(2) + r, with k rounded down where x / log(2) is 0.584 above it, the nearest of these steps to log2(3/2). The
  // sign, which is not set, is masked, too: compilers that may reorder sums (-ffast-math) could not take the shift out again
  // without any rounding.
  shifted = without_fraction(x * FT(1.4426950408889634074) + FT(exponential_shift + 0.4140625));
  const FT k = shifted - FT(exponential_shift);
  const FT r = (x - k * FT(6.93147180369123816490e-01)) - k * FT(1.90821492927058770002e-10);

  // exp(r) = 1 + r + r^2 q(r), where the largest error, 4.2e-18 of it, is the least that a polynomial q of this degree can
  // have (by Remez' algorithm). The coefficients are written out, as a quotient of two numbers is not evaluated by compilers
  // that have to respect the rounding mode, but whenever it is needed.
  const FT r2 = r * r, r4 = r2 * r2;
  const FT q0 = (FT(4.99999999999999889e-01) + r * FT(1.66666666666677399e-01)) +
                r2 * (FT(4.16666666666841712e-02) + r * FT(8.33333333242222522e-03));
  const FT q1 = (FT(1.38888888857992081e-03) + r * FT(1.98412724721398775e-04)) +
                r2 * (FT(2.48015754038370876e-05) + r * FT(2.75541345723716236e-06));
  const FT q2 = FT(2.75906785373925631e-07) + r * FT(2.64542900341025883e-08);
  return FT(1.) + (r + r2 * (q0 + r4 * (q1 + r4 * q2)));
}

// exp(a) from -708 to 709, with an error below 1 ulp (and a relative one of 1e-11 where doubles are not rounded to
// nearest); what is smaller, or no number, gets the value at the lower end, what is larger that at the upper one. Every
// number type gives the same bits. See exponential() for all doubles.
template <class FT>
CGAL_SP_INLINE FT clamped_exponential(const FT& a)
{
  const FT lowest(-708.), highest(709.);
  FT shifted;
  const FT power = exponential_of_rest(FT(select(a > lowest, minimum(a, highest), lowest)), shifted);
  return times_power_of_two(power, shifted);
}

// How to make a number, be it a single one or a packed one, whose static members do it.
template <class FT>
struct Lanes : FT
{};

template <>
struct Lanes<double>
{
  static constexpr std::size_t width = 1;
  static CGAL_SP_INLINE double load(const double* values) { return *values; }
  static CGAL_SP_INLINE double load(const float* values) { return *values; }
  static CGAL_SP_INLINE void store(double a, double* values) { *values = a; }
  template <class Function>
  static CGAL_SP_INLINE double generate(const Function& f)
  {
    return f(std::size_t(0));
  }
};

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
using Two_lanes = Packed_double<2>;
using Four_lanes = Packed_double<4>;
#else
using Two_lanes = double;
using Four_lanes = double;
#endif

#undef CGAL_SP_INLINE

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_PACKED_DOUBLE_H
