// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_SHARPNESS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_SHARPNESS_H

#include <CGAL/Spherical_parameterization/Absolute_sharpness_3.h>
#include <CGAL/Spherical_parameterization/Relative_sharpness_3.h>

#include <cstddef>
#include <variant>

namespace Program {

/// A sharpness policy that is chosen at run time: one model of `SharpnessPolicy_3` for all, so that the parameterizer is
/// compiled once. It is asked once per sweep, so that the choice costs nothing.
class Any_sharpness
{
public:
  using Policy = std::variant<CGAL::Spherical_parameterization::Relative_sharpness_3,
                              CGAL::Spherical_parameterization::Absolute_sharpness_3>;

  Any_sharpness() = default;

  Any_sharpness(const Policy& policy)
    : m_policy(policy)
  {}

  bool is_valid() const
  {
    return std::visit([](const auto& policy) { return policy.is_valid(); }, m_policy);
  }

  double operator()(std::size_t sweep, double average_energy, double largest_energy)
  {
    return std::visit([&](auto& policy) { return policy(sweep, average_energy, largest_energy); }, m_policy);
  }

  double on_coarse_level(double largest_energy) const
  {
    return std::visit([&](const auto& policy) { return policy.on_coarse_level(largest_energy); }, m_policy);
  }

  bool is_final() const
  {
    return std::visit([](const auto& policy) { return policy.is_final(); }, m_policy);
  }

private:
  Policy m_policy;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_SHARPNESS_H
