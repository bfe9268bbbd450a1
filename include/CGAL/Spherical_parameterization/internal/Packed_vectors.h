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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PACKED_VECTORS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PACKED_VECTORS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

// What is compiled for a better processor than the rest of the program has to be inlined into the function that is.
#if defined(__GNUC__)
#define CGAL_SPHERICAL_PARAMETERIZATION_INLINE inline __attribute__((always_inline))
#define CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
#else
#define CGAL_SPHERICAL_PARAMETERIZATION_INLINE inline
#endif

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

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

  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE void fill(Doubles& v, double x) { v = Doubles{x, x}; }

  // v[k] = f(k)
  template <class Function>
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE void generate(Doubles& v, const Function& f)
  {
    v = Doubles{f(0), f(1)};
  }

  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE void take_square_roots(Doubles& v)
  {
#ifdef __SSE2__
    // The library function would have to set errno, which keeps compilers from using the instruction for two numbers.
    v = _mm_sqrt_pd(v);
#else
    v = Doubles{std::sqrt(v[0]), std::sqrt(v[1])};
#endif
  }

  // whether any number is negative
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE bool any_negative(const Integers& v)
  {
#ifdef __SSE2__
    Doubles bits;
    std::memcpy(&bits, &v, sizeof(bits));
    return _mm_movemask_pd(bits) != 0;
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

  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE void fill(Doubles& v, double x) { v = Doubles{x, x, x, x}; }

  template <class Function>
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE void generate(Doubles& v, const Function& f)
  {
    v = Doubles{f(0), f(1), f(2), f(3)};
  }

  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE void take_square_roots(Doubles& v)
  {
    Half::Doubles low = {v[0], v[1]}, high = {v[2], v[3]};
    Half::take_square_roots(low);
    Half::take_square_roots(high);
    v = Doubles{low[0], low[1], high[0], high[1]};
  }

  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE bool any_negative(const Integers& v)
  {
    return Half::any_negative(Half::Integers{v[0], v[1]} | Half::Integers{v[2], v[3]});
  }
};

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PACKED_VECTORS_H
