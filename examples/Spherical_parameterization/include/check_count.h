// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_CHECK_COUNT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_CHECK_COUNT_H

#include "Program_error.h"

#include <cstddef>
#include <string>

namespace Program {

/// checks that `size` bytes suffice for so many things of at least `smallest_size` bytes each, so that a damaged number
/// makes no reader ask for more memory than the file can fill.
///
/// \throws Program_error if they do not
inline void check_count(std::size_t count, const std::string& things, std::size_t size, std::size_t smallest_size)
{
  if(count > size / smallest_size)
    throw Program_error("the file is too short for " + std::to_string(count) + " " + things +
                        ": it is truncated, or the number is wrong");
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_CHECK_COUNT_H
