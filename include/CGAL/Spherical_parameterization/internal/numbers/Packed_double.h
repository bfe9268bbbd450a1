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

// What is compiled for a better processor than the rest of the program has to be inlined into the function that is.
#ifdef __GNUC__
#define CGAL_SP_INLINE inline __attribute__((always_inline))
#else
#define CGAL_SP_INLINE inline
#endif

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

#ifdef __GNUC__ // and all compilers that have its vectors

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

  // exp(a) from -708 to 709, with a relative error of some 1e-16 (1e-11 where doubles are not rounded to nearest); what
  // is smaller, or no number, gets the value at the lower end, what is larger that at the upper one.
  friend CGAL_SP_INLINE Packed_double exponential(const Packed_double& a)
  {
    const Packed_double lowest(-708.), highest(709.);
    const Packed_double x = select(a > lowest, minimum(a, highest), lowest);

    // x = k log(2) + r with |r| <= log(2) / 2, if k is rounded to nearest: next to this shift, doubles are integers, so
    // that the last bits of the sum are k. The sign, which is not set, is masked for compilers that may reorder sums
    // (-ffast-math): they would take the shift out again without any rounding.
    const Packed_double shift(6755399441055744.); // 3 * 2^51
    const Packed_double shifted = x * Packed_double(1.4426950408889634074) + shift;
    const Integers bits = Integers(shifted.m_lanes), exponent = bits << 52;
    const Packed_double k = Packed_double(Doubles(bits & 0x7fffffffffffffff)) - shift;
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

    return Packed_double(Doubles(Integers(power.m_lanes) + exponent)); // times 2^k
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

#endif // __GNUC__

// The same for a single number, but for the ends of the exponential.

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
CGAL_SP_INLINE double exponential(double a)
{
  return std::exp(a);
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

// Stands for a number type in the call of a generic function.
template <class FT_>
struct Number_type
{
  using FT = FT_;
};

#ifdef __GNUC__
using Two_lanes = Packed_double<2>;
using Four_lanes = Packed_double<4>;

#ifdef __x86_64__
template <class Function>
__attribute__((target("avx2"), flatten)) void run_in_four_lanes(const Function& f)
{
  f(Number_type<Four_lanes>());
}
#endif

template <class Function>
__attribute__((flatten)) void run_in_two_lanes(const Function& f)
{
  f(Number_type<Two_lanes>());
}
#else
using Two_lanes = double;
using Four_lanes = double;
#endif

// Calls f(Number_type<FT>()) with the packed number type that this processor works on best, compiled for it, whatever
// the rest of the program is compiled for. As nothing about a lane depends on the others, all of them give the same.
template <class Function>
void run_in_lanes(const Function& f)
{
#ifndef __GNUC__
  f(Number_type<double>());
#else
#ifdef __x86_64__
  if(__builtin_cpu_supports("avx2"))
    return run_in_four_lanes(f);
#endif
  run_in_two_lanes(f);
#endif
}

#undef CGAL_SP_INLINE

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_PACKED_DOUBLE_H
