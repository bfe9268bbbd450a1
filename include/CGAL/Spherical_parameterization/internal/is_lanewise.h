// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
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

// Whether a policy works on any number type that stands for one number per lane: it says so by a nested type
// `Is_lanewise`.
template <class Policy, class = void>
struct Is_lanewise : std::false_type
{};

template <class Policy>
struct Is_lanewise<Policy, std::void_t<typename Policy::Is_lanewise>>
  : std::is_convertible<typename Policy::Is_lanewise, Tag_true>
{};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_LANEWISE_H
