// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_REQUIRE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_REQUIRE_H

#include <cstdio>
#include <cstdlib>

// Ends the program if the condition does not hold: to a fuzzer, that is a crash to be reported.
inline void require(bool condition, const char* message)
{
  if(condition)
    return;
  std::fprintf(stderr, "A requirement does not hold: %s\n", message);
  std::abort();
}

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_REQUIRE_H
