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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPRODUCIBILITY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPRODUCIBILITY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <limits>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// names the results of this version of the package: versions of equal names give the same bits for the same input and settings,
/// wherever `is_reproducible()`. It is the digest of a table of results that the tests compare on all platforms.
constexpr const char* results_version = "85f91c79";

/// \ingroup PkgSphericalParameterizationMethods
///
/// returns whether the package, as it is compiled here, has the results of every other machine, to the last bit: whether each
/// floating-point operation is rounded by itself, to the nearest number of 64 bits, as IEEE 754 has it. This is tried out. The page
/// \ref PkgSphericalParameterizationReproducibility says what is promised, and where this is
/// `false`, as with `-ffast-math`: maps are made and certified all the same.
///
/// It takes a few nanoseconds.
inline bool is_reproducible()
{
  // volatile, so that the operations are those that the compiler has made of them, when the program runs
  const volatile double one = 1., two_to_minus_60 = 0x1p-60, half_epsilon = 0x1p-53, more_than_half = 0x1.8p-53;
  const volatile double factor = 1. + 0x1p-30, rounded_square = 1. + 0x1p-29,
                        smallest = (std::numeric_limits<double>::min)();
  const double x = factor, a = one, b = two_to_minus_60, s = smallest;
  const bool is_rounded_by_itself = x * x - rounded_square == 0.; // not with the difference
  const bool is_in_order_and_of_64_bits = (a + b) - a == 0.;
  const bool is_to_nearest = a + half_epsilon == one && a + more_than_half > one && -a - half_epsilon == -one;
  const bool has_subnormals = s * 0.5 > 0.;
  return is_rounded_by_itself && is_in_order_and_of_64_bits && is_to_nearest && has_subnormals;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPRODUCIBILITY_H
