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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_EIGHT_LANES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_EIGHT_LANES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_EIGHT_LANES
#include <immintrin.h>
#endif

#include <array>
#include <cstddef>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_EIGHT_LANES

// Eight lanes by AVX-512, because compilers scalarize the comparisons of a generic vector. These functions may only be
// called on a processor with AVX-512. They are inlined into code that is compiled for it, see run_in_lanes(), after the
// functions that call them, which are not compiled for it.
#define CGAL_SP_EIGHT_LANES inline __attribute__((target("avx512f,avx512dq")))

template <>
class Packed_mask<8>
{
public:
  using Self = Packed_mask;

  CGAL_SP_EIGHT_LANES explicit Packed_mask(__mmask8 lanes)
    : m_lanes(lanes)
  {}
  CGAL_SP_EIGHT_LANES Packed_mask(const Packed_mask& other)
    : m_lanes(other.m_lanes)
  {}
  CGAL_SP_EIGHT_LANES Packed_mask& operator=(const Packed_mask& other) { return m_lanes = other.m_lanes, *this; }

  friend CGAL_SP_EIGHT_LANES bool lane(const Packed_mask& a, std::size_t k) { return (a.m_lanes >> k & 1) != 0; }

  friend CGAL_SP_EIGHT_LANES Self operator&&(const Self& a, const Self& b) { return of(a.m_lanes & b.m_lanes); }
  friend CGAL_SP_EIGHT_LANES Self operator||(const Self& a, const Self& b) { return of(a.m_lanes | b.m_lanes); }
  friend CGAL_SP_EIGHT_LANES Self operator!(const Self& a) { return of(~a.m_lanes); }

  friend CGAL_SP_EIGHT_LANES bool any(const Packed_mask& a) { return a.m_lanes != 0; }

  CGAL_SP_EIGHT_LANES __mmask8 lanes() const { return m_lanes; }

private:
  static CGAL_SP_EIGHT_LANES Packed_mask of(int lanes) { return Packed_mask(static_cast<__mmask8>(lanes)); }

  __mmask8 m_lanes;
};

template <>
class alignas(64) Packed_double<8>
{
public:
  using Self = Packed_double;
  using Mask = Packed_mask<8>;
  static constexpr std::size_t width = 8;

  Packed_double() = default;
  CGAL_SP_EIGHT_LANES Packed_double(double value)
    : m_lanes(_mm512_set1_pd(value))
  {}
  CGAL_SP_EIGHT_LANES Packed_double(const Packed_double& other)
    : m_lanes(other.m_lanes)
  {}
  CGAL_SP_EIGHT_LANES Packed_double& operator=(const Packed_double& other) { return m_lanes = other.m_lanes, *this; }

  static CGAL_SP_EIGHT_LANES Self load(const double* values) { return Self(_mm512_loadu_pd(values)); }
  static CGAL_SP_EIGHT_LANES Self load(const float* values) { return of(_mm256_loadu_ps(values)); }
  static CGAL_SP_EIGHT_LANES std::array<Self, 4> load_columns(const std::array<const float*, 8>& rows)
  {
    const __m256 a = two_rows(rows[0], rows[4]), b = two_rows(rows[1], rows[5]), c = two_rows(rows[2], rows[6]),
                 d = two_rows(rows[3], rows[7]);
    const __m256 ab0 = _mm256_unpacklo_ps(a, b), ab2 = _mm256_unpackhi_ps(a, b), cd0 = _mm256_unpacklo_ps(c, d),
                 cd2 = _mm256_unpackhi_ps(c, d);
    return {of(_mm256_shuffle_ps(ab0, cd0, 0x44)), of(_mm256_shuffle_ps(ab0, cd0, 0xee)),
            of(_mm256_shuffle_ps(ab2, cd2, 0x44)), of(_mm256_shuffle_ps(ab2, cd2, 0xee))};
  }
  static CGAL_SP_EIGHT_LANES void store(const Self& a, double* values) { _mm512_storeu_pd(values, a.m_lanes); }

  template <class Function>
  static CGAL_SP_EIGHT_LANES Packed_double generate(const Function& f)
  {
    return Self(_mm512_setr_pd(f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7)));
  }

  friend CGAL_SP_EIGHT_LANES double lane(const Packed_double& a, std::size_t k) { return a.m_lanes[k]; }

  friend CGAL_SP_EIGHT_LANES Self operator+(const Self& a, const Self& b) { return Self(a.m_lanes + b.m_lanes); }
  friend CGAL_SP_EIGHT_LANES Self operator-(const Self& a, const Self& b) { return Self(a.m_lanes - b.m_lanes); }
  friend CGAL_SP_EIGHT_LANES Self operator*(const Self& a, const Self& b) { return Self(a.m_lanes * b.m_lanes); }
  friend CGAL_SP_EIGHT_LANES Self operator/(const Self& a, const Self& b) { return Self(a.m_lanes / b.m_lanes); }
  CGAL_SP_EIGHT_LANES Self operator-() const { return Self(-m_lanes); }
  CGAL_SP_EIGHT_LANES Self& operator+=(const Self& other) { return m_lanes += other.m_lanes, *this; }
  CGAL_SP_EIGHT_LANES Self& operator*=(const Self& other) { return m_lanes *= other.m_lanes, *this; }

  friend CGAL_SP_EIGHT_LANES Mask operator<(const Self& a, const Self& b)
  {
    return Mask(_mm512_cmp_pd_mask(a.m_lanes, b.m_lanes, _CMP_LT_OS));
  }
  friend CGAL_SP_EIGHT_LANES Mask operator>(const Self& a, const Self& b) { return b < a; }

  friend CGAL_SP_EIGHT_LANES Self select(const Mask& condition, const Self& a, const Self& b)
  {
    return Self(_mm512_mask_blend_pd(condition.lanes(), b.m_lanes, a.m_lanes));
  }
  friend CGAL_SP_EIGHT_LANES Self maximum(const Self& a, const Self& b) { return select(a < b, b, a); }
  friend CGAL_SP_EIGHT_LANES Self minimum(const Self& a, const Self& b) { return select(b < a, b, a); }
  friend CGAL_SP_EIGHT_LANES Self absolute(const Self& a) { return select(a < Self(0.), -a, a); }
  friend CGAL_SP_EIGHT_LANES Self square_root(const Self& a) { return Self(_mm512_maskz_sqrt_pd(all, a.m_lanes)); }

  friend CGAL_SP_EIGHT_LANES Self without_fraction(const Self& shifted)
  {
    return Self(__m512d(__m512i(shifted.m_lanes) & 0x7fffffffffffff00));
  }
  friend CGAL_SP_EIGHT_LANES Self times_power_of_two(const Self& a, const Self& shifted)
  {
    return Self(__m512d(__m512i(a.m_lanes) + (__m512i(shifted.m_lanes) << 44)));
  }

private:
  static constexpr __mmask8 all = 0xff; // unmasked, they read uninitialized values: g++ 12 warns

  static CGAL_SP_EIGHT_LANES Self of(const __m256& floats) { return Self(_mm512_maskz_cvtps_pd(all, floats)); }
  static CGAL_SP_EIGHT_LANES __m256 two_rows(const float* low, const float* high)
  {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1);
  }

  CGAL_SP_EIGHT_LANES explicit Packed_double(const __m512d& lanes)
    : m_lanes(lanes)
  {}

  __m512d m_lanes;
};

#undef CGAL_SP_EIGHT_LANES

using Eight_lanes = Packed_double<8>;

#else

using Eight_lanes = Four_lanes;

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HAS_EIGHT_LANES

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_EIGHT_LANES_H
