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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_LANEWISE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_LANEWISE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Whether a policy says by a nested type `Is_lanewise` that it works on any number type that stands for one number per
// lane, and can be called with these arguments, which a class that is derived from such a policy may have hidden.
template <class Void, class Policy, class... Arguments>
struct Is_lanewise_if_valid : std::false_type
{};

template <class Policy, class... Arguments>
struct Is_lanewise_if_valid<std::void_t<typename Policy::Is_lanewise>, Policy, Arguments...>
  : std::bool_constant<std::is_convertible<typename Policy::Is_lanewise, Tag_true>::value &&
                       std::is_invocable<const Policy&, Arguments...>::value>
{};

template <class Policy, class... Arguments>
using Is_lanewise = Is_lanewise_if_valid<void, Policy, Arguments...>;

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_LANEWISE_H
