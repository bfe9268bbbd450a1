// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_ERROR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_ERROR_H

#include <stdexcept>

namespace Program {

/// What the user has to be told before the program ends with exit status 1.
class Program_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_ERROR_H
