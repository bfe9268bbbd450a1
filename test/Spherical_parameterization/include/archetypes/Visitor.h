// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VISITOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VISITOR_H

#include "Copy_constructible.h"

#include <cstddef>

namespace archetypes {

// SphericalParameterizationVisitor
class Visitor : public Copy_constructible
{
public:
  using Copy_constructible::Copy_constructible;

  void on_initialization_begin(std::size_t) {}
  void on_level(std::size_t) {}
  void on_initialization_end() {}
  void after_iteration(std::size_t, double, double) {}
  bool go_further(std::size_t, double) { return true; }
  void on_optimization_end() {}
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VISITOR_H
