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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_IN_LANES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_IN_LANES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Packed_double.h>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Stands for a number type in the call of a generic function.
template <class FT_>
struct Number_type
{
  using FT = FT_;
};

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
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
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
#ifdef __x86_64__
  if(__builtin_cpu_supports("avx2"))
  {
    run_in_four_lanes(f);
    return;
  }
#endif
  run_in_two_lanes(f);
#else
  f(Number_type<double>());
#endif
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_IN_LANES_H
