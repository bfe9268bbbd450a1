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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_MAXIMUM_NUMBER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_MAXIMUM_NUMBER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <optional>

namespace CGAL::Spherical_parameterization::internal {

// The named parameter maximum_number, if it is given.
template <class NamedParameters>
std::optional<std::size_t> maximum_number_of(const NamedParameters& np)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::maximum_number_t>::value)
    return std::nullopt;
  else
    return static_cast<std::size_t>(parameters::get_parameter(np, internal_np::maximum_number));
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_MAXIMUM_NUMBER_H
