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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_VALID_POLICY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_VALID_POLICY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

template <class Policy, class = void>
struct Has_is_valid : std::false_type
{};

template <class Policy>
struct Has_is_valid<Policy, std::void_t<decltype(std::declval<const Policy&>().is_valid())>> : std::true_type
{};

// returns whether the parameters of a policy are in their ranges; a policy that does not say is taken for valid
template <class Policy>
bool is_valid_policy(const Policy& policy)
{
  if constexpr(Has_is_valid<Policy>::value)
    return policy.is_valid();
  else
    return true;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_VALID_POLICY_H
