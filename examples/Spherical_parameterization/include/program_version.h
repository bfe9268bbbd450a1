// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_VERSION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_VERSION_H

#include <CGAL/version_macros.h>

#include <string>

namespace Program {

/// returns the name of the program, its version, and that of CGAL.
inline std::string program_version()
{
  // Within CGAL, the package has no version of its own.
#ifdef SPHERICAL_PARAMETERIZATION_VERSION
  constexpr const char* version = SPHERICAL_PARAMETERIZATION_VERSION;
#else
  constexpr const char* version = "of CGAL";
#endif
  return std::string("spherical_parameterization ") + version + ", built with CGAL " + CGAL_VERSION_STR;
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_VERSION_H
