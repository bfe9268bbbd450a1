// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_SHARPNESS_POLICY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_SHARPNESS_POLICY_H

#include "Copy_constructible.h"

#include <cstddef>

namespace archetypes {

// SharpnessPolicy_3 without the optional member
class Sharpness_policy : public Copy_constructible
{
public:
  using Copy_constructible::Copy_constructible;

  double operator()(std::size_t /* sweep */, double /* average_energy */, double largest_energy)
  {
    return 10. / largest_energy;
  }

  double on_coarse_level(double largest_energy) const { return 3. / largest_energy; }

  bool is_final() const { return true; }
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_SHARPNESS_POLICY_H
