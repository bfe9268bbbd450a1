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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_READ_NUMBER_OF_ITERATIONS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_READ_NUMBER_OF_ITERATIONS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Sets `number` to the named parameter `number_of_iterations` if it is given; returns false if that is negative.
template <class NamedParameters>
bool read_number_of_iterations(const NamedParameters& np, std::size_t& number)
{
  const auto given =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::number_of_iterations), number);
  if constexpr(std::is_signed<std::decay_t<decltype(given)>>::value)
    if(given < 0)
      return false;
  number = static_cast<std::size_t>(given);
  return true;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_READ_NUMBER_OF_ITERATIONS_H
