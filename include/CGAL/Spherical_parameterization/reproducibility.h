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
/// The version of the results of the package. Two versions of the package with the same value give bitwise identical
/// results for the same input and settings, wherever `is_reproducible()` returns `true`. The value is a hash of a table
/// of results that the tests compare on all platforms.
constexpr const char* results_version = "96a4027b";

/// \ingroup PkgSphericalParameterizationMethods
///
/// returns whether the package, as compiled, gives bitwise the same results as on every other machine.
///
/// This requires that each floating-point operation is rounded individually to the nearest double precision number, as
/// specified by IEEE 754. The function tests this by computation, in a few nanoseconds. The page
/// \ref PkgSphericalParameterizationReproducibility states what is guaranteed, and where the result is `false`, as with
/// `-ffast-math`. Maps are computed and certified in either case.
inline bool is_reproducible()
{
  // volatile, so that the operations are those of the compiled code at run time
  const volatile double one = 1., two_to_minus_60 = 0x1p-60, half_epsilon = 0x1p-53, more_than_half = 0x1.8p-53;
  const volatile double factor = 1. + 0x1p-30, rounded_square = 1. + 0x1p-29,
                        smallest = (std::numeric_limits<double>::min)();
  const double x = factor, a = one, b = two_to_minus_60, s = smallest;
  const bool is_rounded_by_itself = x * x - rounded_square == 0.; // before the subtraction, not together with it
  const bool is_in_order_and_of_64_bits = (a + b) - a == 0.;
  const bool is_to_nearest = a + half_epsilon == one && a + more_than_half > one && -a - half_epsilon == -one;
  const bool has_subnormals = s * 0.5 > 0.;
  return is_rounded_by_itself && is_in_order_and_of_64_bits && is_to_nearest && has_subnormals;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPRODUCIBILITY_H
