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

#include <CGAL/Spherical_parameterization/internal/numbers/Eight_lanes.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>

#include <cstddef>
#include <optional>
#include <tuple>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Passes a number type to a generic function.
template <class FT_>
struct Number_type
{
  using FT = FT_;
};

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_EIGHT_LANES
// This processor has a fused multiply-add instruction; see begin_arithmetic.h.
template <class Function>
__attribute__((target("avx512f,avx512dq"), optimize("fp-contract=off", "no-tree-vectorize"), flatten)) //
void run_in_eight_lanes(const Function& f)
{
  f(Number_type<Eight_lanes>());
}
#endif

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

// Calls f(Number_type<FT>()) with the packed number type that is fastest on this processor, with no more than
// `max_lanes` numbers. The call is compiled for the processor, independently of the rest of the program. Since lanes
// are independent of each other, all number types give the same results.
template <std::size_t max_lanes = 8, class Function>
void run_in_lanes(const Function& f)
{
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
  f(Number_type<double>());
#else
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_EIGHT_LANES
  if constexpr(max_lanes >= 8)
    if(__builtin_cpu_supports("avx512dq"))
      return run_in_eight_lanes(f);
#endif
#ifdef __x86_64__
  if(__builtin_cpu_supports("avx2"))
    return run_in_four_lanes(f);
#endif
  run_in_two_lanes(f);
#endif
}

// The data that a thread keeps between calls of such a function: a T<FT> for each number type, created at its first
// use, since that is only possible on a processor that supports it.
template <template <class> class T>
class In_lanes
{
public:
  // `arguments` are those of the constructor.
  template <class FT, class... Arguments>
  T<FT>& get(const Arguments&... arguments)
  {
    std::optional<T<FT>>& result = std::get<std::optional<T<FT>>>(m_all);
    if(!result)
      result.emplace(arguments...);
    return *result;
  }

private:
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS
  std::tuple<std::optional<T<double>>> m_all;
#elif !defined(CGAL_SPHERICAL_PARAMETERIZATION_HAS_EIGHT_LANES)
  std::tuple<std::optional<T<double>>, std::optional<T<Two_lanes>>, std::optional<T<Four_lanes>>> m_all;
#else
  std::tuple<std::optional<T<double>>, std::optional<T<Two_lanes>>, std::optional<T<Four_lanes>>,
             std::optional<T<Eight_lanes>>>
      m_all;
#endif
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_RUN_IN_LANES_H
