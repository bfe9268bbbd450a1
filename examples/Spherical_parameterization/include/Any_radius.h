// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_RADIUS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_RADIUS_H

#include <CGAL/Spherical_parameterization/Area_balancing_radius_3.h>
#include <CGAL/Spherical_parameterization/Area_preserving_radius_3.h>
#include <CGAL/Spherical_parameterization/Fixed_radius_3.h>
#include <CGAL/Spherical_parameterization/Optimal_radius_3.h>
#include <CGAL/Spherical_parameterization/Two_phase_radius_3.h>

#include <CGAL/Default.h>

#include <variant>

namespace Program {

/// A radius policy that is chosen at run time: one model of `SphereRadiusPolicy_3` for all, as `Any_sharpness` is one.
class Any_radius
{
public:
  using Two_phase_radius_3 = CGAL::Spherical_parameterization::Two_phase_radius_3<>;
  using Optimal_radius_3 = CGAL::Spherical_parameterization::Optimal_radius_3;
  using Area_balancing_radius_3 = CGAL::Spherical_parameterization::Area_balancing_radius_3;
  using Area_preserving_radius_3 = CGAL::Spherical_parameterization::Area_preserving_radius_3;
  using Fixed_radius_3 = CGAL::Spherical_parameterization::Fixed_radius_3;
  using Two_phase_optimal_radius_3 =
      CGAL::Spherical_parameterization::Two_phase_radius_3<CGAL::Default, Optimal_radius_3>;

  using Policy = std::variant<Two_phase_radius_3, Two_phase_optimal_radius_3, Optimal_radius_3, Area_balancing_radius_3,
                              Area_preserving_radius_3, Fixed_radius_3>;

  Any_radius() = default;

  Any_radius(const Policy& policy)
    : m_policy(policy)
  {}

  bool is_valid() const
  {
    return std::visit([](const auto& policy) { return policy.is_valid(); }, m_policy);
  }

  double initial_radius(double equal_area_radius) const
  {
    return std::visit([&](const auto& policy) { return policy.initial_radius(equal_area_radius); }, m_policy);
  }

  template <class Energy, class FaceRange>
  double operator()(const Energy& energy, const FaceRange& faces, double radius)
  {
    return std::visit([&](auto& policy) { return policy(energy, faces, radius); }, m_policy);
  }

  bool next_phase()
  {
    return std::visit([](auto& policy) { return start_next_phase(policy); }, m_policy);
  }

private:
  template <class Radius>
  static bool start_next_phase(Radius& /* policy */)
  {
    return false; // there is one phase only
  }

  template <class FirstRadius, class SecondRadius>
  static bool start_next_phase(CGAL::Spherical_parameterization::Two_phase_radius_3<FirstRadius, SecondRadius>& policy)
  {
    return policy.next_phase();
  }

  Policy m_policy;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_RADIUS_H
