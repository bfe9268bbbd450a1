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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

// Whether the compiler has vector extensions. Programs that define CGAL_SPHERICAL_PARAMETERIZATION_STANDARD_CXX are
// compiled as without them.
#if defined(__GNUC__) && !defined(CGAL_SPHERICAL_PARAMETERIZATION_STANDARD_CXX)
#define CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
#endif

// Whether Eight_lanes.h has its own number type. Clang inlines only direct calls, and MinGW-w64 does not align stacks
// for such numbers.
#if defined(CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS) && defined(__x86_64__) && !defined(__clang__) &&              \
    !defined(_WIN32)
#define CGAL_SPHERICAL_PARAMETERIZATION_HAS_EIGHT_LANES
#endif

// Code that is compiled for a better processor than the rest of the program must be inlined into its caller.
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
#define CGAL_SP_INLINE inline __attribute__((always_inline))
#else
#define CGAL_SP_INLINE inline
#endif

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS

// The vectors of W numbers in compiler extensions, and the operations that these lack.
//
// A vector is constructed from all its numbers at once, and operations with an instruction for two numbers are done by
// halves: compilers optimize both well. Numbers that are written one after the other would pass through memory, where
// the load of the vector waits for all of them.
template <int W>
struct Packed_vectors;

template <>
struct Packed_vectors<2>
{
  typedef double Doubles __attribute__((vector_size(16)));
  typedef std::int64_t Integers __attribute__((vector_size(16)));
  typedef float Floats __attribute__((vector_size(8)));

  // v[k] = f(k).
  template <class Function>
  static CGAL_SP_INLINE void generate(Doubles& v, const Function& f)
  {
    v = Doubles{f(0), f(1)};
  }

  // columns[k][l] = rows[l][k], for four numbers of a row.
  static CGAL_SP_INLINE void load_columns(const float* const* rows, Doubles* columns)
  {
    for(int k = 0; k < 4; ++k)
      columns[k] = Doubles{rows[0][k], rows[1][k]};
  }

  static CGAL_SP_INLINE void take_square_roots(Doubles& v)
  {
#ifdef __SSE2__
    // The library function may set errno, which keeps compilers from using the instruction for two numbers.
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

  static CGAL_SP_INLINE void load_columns(const float* const* rows, Doubles* columns)
  {
#ifdef __SSE2__
    __m128 a = _mm_loadu_ps(rows[0]), b = _mm_loadu_ps(rows[1]), c = _mm_loadu_ps(rows[2]), d = _mm_loadu_ps(rows[3]);
    _MM_TRANSPOSE4_PS(a, b, c, d);
    const Floats all[4] = {a, b, c, d};
    for(int k = 0; k < 4; ++k)
      columns[k] = __builtin_convertvector(all[k], Doubles);
#else
    for(int k = 0; k < 4; ++k)
      columns[k] = Doubles{rows[0][k], rows[1][k], rows[2][k], rows[3][k]};
#endif
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

// A condition for each lane of a Packed_double: all bits of a lane are set if it is true.
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

  // Whether the condition is true in any lane.
  friend CGAL_SP_INLINE bool any(const Packed_mask& a) { return Packed_vectors<W>::any_negative(a.m_lanes); }

  CGAL_SP_INLINE const Integers& lanes() const { return m_lanes; }

private:
  Integers m_lanes;
};

// One number per lane for several stars that are processed at once, as a number type: code for one star with `double`
// works for several stars with this type. All operations are those of IEEE arithmetic in each lane, so the result of a
// star depends neither on its lane nor on the number of lanes. Conditions are evaluated by masks and select().
//
// The alignment is explicit because compilers assume a smaller one for vectors that do not fit the registers of the
// target. The copy constructors are explicit so that no compiler passes an object in registers, which differ between
// functions that are compiled for different processors.
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

  // The values values[0], ..., values[width - 1].
  static CGAL_SP_INLINE Packed_double load(const double* values)
  {
    Packed_double result;
    std::memcpy(&result.m_lanes, values, sizeof(Doubles));
    return result;
  }

  // The same for floats.
  static CGAL_SP_INLINE Packed_double load(const float* values)
  {
    Floats floats;
    std::memcpy(&floats, values, sizeof(Floats));
    return Packed_double(__builtin_convertvector(floats, Doubles));
  }

  // Four numbers of a row in each lane: that with index k of all rows is result k.
  static CGAL_SP_INLINE std::array<Packed_double, 4> load_columns(const std::array<const float*, width>& rows)
  {
    Doubles columns[4];
    Vectors::load_columns(rows.data(), columns);
    return {Packed_double(columns[0]), Packed_double(columns[1]), Packed_double(columns[2]), Packed_double(columns[3])};
  }

  static CGAL_SP_INLINE void store(const Self& a, double* values) { std::memcpy(values, &a.m_lanes, sizeof(Doubles)); }

  // The value of lane k is f(k).
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

  // Bit operations for clamped_exponential().
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

// Near this number, 3 * 2^43, doubles have eight fractional bits; the bits before them are the integer k of the number
// k + integer_shift.
constexpr double integer_shift = 26388279066624.;

// The largest integer that is not above x, for x from 0 to 2^42.
template <class FT>
CGAL_SP_INLINE FT rounded_down(const FT& x)
{
  // The sum is rounded to a multiple of 1/256, which may be the next integer.
  const FT nearly = without_fraction(x + FT(integer_shift)) - FT(integer_shift);
  return nearly - select(nearly > x, FT(1.), FT(0.));
}

// exp(x) = 2^k power with 3/4 <= power < 3/2, up to one thousandth; `shifted` becomes k + integer_shift. This range
// makes the rounding errors of 1 + r below, and of its summands, smaller than the range from sqrt(1/2) to sqrt(2).
template <class FT>
CGAL_SP_INLINE FT exponential_of_rest(const FT& x, FT& shifted)
{
  // x = k log(2) + r, with k rounded down so that x / log(2) is at most 0.584 above it, the closest multiple of 1/256
  // to log2(3/2). The sign bit, which is not set, is masked as well: otherwise, compilers that may reorder sums
  // (-ffast-math) could remove the shift, and with it the rounding.
  shifted = without_fraction(x * FT(1.4426950408889634074) + FT(integer_shift + 0.4140625));
  const FT k = shifted - FT(integer_shift);
  const FT r = (x - k * FT(6.93147180369123816490e-01)) - k * FT(1.90821492927058770002e-10);

  // exp(r) = 1 + r + r^2 q(r), with a maximum relative error of 4.2e-18, the minimum for a polynomial q of this degree
  // (by the Remez algorithm). The coefficients are literals, because compilers that respect the rounding mode evaluate
  // a quotient of two constants at run time.
  const FT r2 = r * r, r4 = r2 * r2;
  const FT q0 = (FT(4.99999999999999889e-01) + r * FT(1.66666666666677399e-01)) +
                r2 * (FT(4.16666666666841712e-02) + r * FT(8.33333333242222522e-03));
  const FT q1 = (FT(1.38888888857992081e-03) + r * FT(1.98412724721398775e-04)) +
                r2 * (FT(2.48015754038370876e-05) + r * FT(2.75541345723716236e-06));
  const FT q2 = FT(2.75906785373925631e-07) + r * FT(2.64542900341025883e-08);
  return FT(1.) + (r + r2 * (q0 + r4 * (q1 + r4 * q2)));
}

// exp(a) from -708 to 709, with an error below 1 ulp (and a relative error of 1e-11 if doubles are not rounded to
// nearest). Smaller values and NaN get the result at the lower end, larger ones that at the upper end. Every number
// type gives the same bits. See exponential() for all doubles.
template <class FT>
CGAL_SP_INLINE FT clamped_exponential(const FT& a)
{
  const FT lowest(-708.), highest(709.);
  FT shifted;
  const FT power = exponential_of_rest(FT(select(a > lowest, minimum(a, highest), lowest)), shifted);
  return times_power_of_two(power, shifted);
}

// Static functions that create single or packed numbers.
template <class FT>
struct Lanes : FT
{};

template <>
struct Lanes<double>
{
  static constexpr std::size_t width = 1;
  static CGAL_SP_INLINE double load(const double* values) { return *values; }
  static CGAL_SP_INLINE double load(const float* values) { return *values; }
  static CGAL_SP_INLINE std::array<double, 4> load_columns(const std::array<const float*, 1>& rows)
  {
    return {rows[0][0], rows[0][1], rows[0][2], rows[0][3]};
  }
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

// Four numbers for sums with the same order of summation as with vector extensions.
class Four_lanes
{
public:
  static constexpr std::size_t width = 4;

  Four_lanes(double value = 0.) { m_lanes.fill(value); }

  template <class T>
  static Four_lanes load(const T* values)
  {
    Four_lanes result;
    std::copy_n(values, width, result.m_lanes.begin());
    return result;
  }
  static void store(const Four_lanes& a, double* values) { std::copy_n(a.m_lanes.begin(), width, values); }
  friend double lane(const Four_lanes& a, std::size_t k) { return a.m_lanes[k]; }

  Four_lanes& operator+=(const Four_lanes& other) { return change(other, std::plus<double>()); }
  friend Four_lanes operator+(Four_lanes a, const Four_lanes& b) { return a += b; }
  friend Four_lanes operator-(Four_lanes a, const Four_lanes& b) { return a.change(b, std::minus<double>()); }
  friend Four_lanes operator*(Four_lanes a, const Four_lanes& b) { return a.change(b, std::multiplies<double>()); }

private:
  template <class Operation>
  Four_lanes& change(const Four_lanes& other, const Operation& operation)
  {
    for(std::size_t k = 0; k < width; ++k)
      m_lanes[k] = operation(m_lanes[k], other.m_lanes[k]);
    return *this;
  }

  std::array<double, width> m_lanes;
};
#endif

// The sum of all lanes, in this order on all machines.
CGAL_SP_INLINE double sum_of_lanes(const Four_lanes& a)
{
  return (lane(a, 0) + lane(a, 1)) + (lane(a, 2) + lane(a, 3));
}

#undef CGAL_SP_INLINE

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_PACKED_DOUBLE_H
