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

#include <cstdint>

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

// The vectors of W numbers that compilers offer beyond the standard.
template <int W>
struct Packed_vectors;

template <>
struct Packed_vectors<2>
{
  typedef double Doubles __attribute__((vector_size(16)));
  typedef std::int64_t Integers __attribute__((vector_size(16)));
  typedef std::int32_t Short_integers __attribute__((vector_size(8)));
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE void fill(Doubles& v, double x) { v = Doubles{x, x}; }
};

template <>
struct Packed_vectors<4>
{
  typedef double Doubles __attribute__((vector_size(32)));
  typedef std::int64_t Integers __attribute__((vector_size(32)));
  typedef std::int32_t Short_integers __attribute__((vector_size(16)));
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE void fill(Doubles& v, double x) { v = Doubles{x, x, x, x}; }
};

template <>
struct Packed_vectors<8>
{
  typedef double Doubles __attribute__((vector_size(64)));
  typedef std::int64_t Integers __attribute__((vector_size(64)));
  typedef std::int32_t Short_integers __attribute__((vector_size(32)));
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE void fill(Doubles& v, double x) { v = Doubles{x, x, x, x, x, x, x, x}; }
};

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PACKED_VECTORS_H
