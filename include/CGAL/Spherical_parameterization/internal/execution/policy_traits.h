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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_POLICY_TRAITS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_POLICY_TRAITS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <type_traits>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

template <class Void, template <class...> class Expression, class... T>
struct Is_detected : std::false_type
{};

template <template <class...> class Expression, class... T>
struct Is_detected<std::void_t<Expression<T...>>, Expression, T...> : std::true_type
{};

// Whether there is a type `Expression<T...>`, that of an expression with these types.
template <template <class...> class Expression, class... T>
constexpr bool is_detected = Is_detected<void, Expression, T...>::value;

// The optional members of models of concepts, and their defaults.

template <class Policy>
using Is_valid_result = decltype(std::declval<const Policy&>().is_valid());

// Returns whether the parameters of a policy are in their ranges; a policy without parameters is valid.
template <class Policy>
bool is_valid_policy(const Policy& policy)
{
  if constexpr(is_detected<Is_valid_result, Policy>)
    return policy.is_valid();
  else
    return true;
}

template <class Policy>
using Next_phase_result = decltype(std::declval<Policy&>().next_phase());

// Starts the next phase of a policy and returns whether there is one; most policies have a single phase.
template <class Policy>
bool next_phase(Policy& policy)
{
  if constexpr(is_detected<Next_phase_result, Policy>)
    return policy.next_phase();
  else
    return false;
}

template <class Energy, class Faces>
using Optimal_scale_result = decltype(std::declval<const Energy&>().optimal_scale(std::declval<const Faces&>()));

// Whether faces are weighted by their areas on the surface; by default, all faces have the same weight.
template <class Energy, class = void>
constexpr bool weighs_faces_by_area = false;
template <class Energy>
constexpr bool weighs_faces_by_area<Energy, std::enable_if_t<Energy::weighs_faces_by_area>> = true;

// Whether the areas of faces are increased where the surface is curved; by default, they are not.
template <class Energy, class = void>
constexpr bool follows_curvature = false;
template <class Energy>
constexpr bool follows_curvature<Energy, std::enable_if_t<Energy::follows_curvature>> = true;

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_POLICY_TRAITS_H
