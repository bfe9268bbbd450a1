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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_RUN_IN_LANES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_RUN_IN_LANES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Stands for a number type in the call of a generic function.
template <class FT_>
struct Number_type
{
  using FT = FT_;
};

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
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
#endif // CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS

// Calls f(Number_type<FT>()) with the packed number type that this processor works on best, compiled for it, whatever
// the rest of the program is compiled for. As nothing about a lane depends on the others, all of them give the same.
template <class Function>
void run_in_lanes(const Function& f)
{
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
  f(Number_type<double>());
#else
#ifdef __x86_64__
  if(__builtin_cpu_supports("avx2"))
    return run_in_four_lanes(f);
#endif
  run_in_two_lanes(f);
#endif
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_RUN_IN_LANES_H
