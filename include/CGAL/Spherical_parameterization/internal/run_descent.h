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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_DESCENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_DESCENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/internal/levels/Descent_loop.h>
#include <CGAL/Spherical_parameterization/internal/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/run_parameterization.h>

#include <CGAL/Default.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A model of SphereRadiusPolicy_3 as the loop over sweeps sees it. Each run works on a copy, as a policy may keep a
// state.
template <class Radius, class Energy>
class Radius_policy_chooser : public Radius_chooser
{
public:
  Radius_policy_chooser(const Radius& radius, const Energy& energy)
    : m_radius(radius)
    , m_energy(energy)
  {}

  double initial_radius(double equal_area_radius) const override { return m_radius.initial_radius(equal_area_radius); }
  double next_radius(const Face_range_3& faces, double radius) override { return m_radius(m_energy, faces, radius); }
  bool next_phase() override { return internal::next_phase(m_radius); }

private:
  Radius m_radius;
  Energy m_energy;
};

// The work of the parameterizers that improve a bijection by sweeps: makes the initial map, and lowers its energy.
template <class Step, class InitialParameterizer, class Energy, class Radius, class Run>
Error_code run_descent(InitialParameterizer& initial_parameterizer, const Energy& energy, const Radius& radius,
                       const Sharpness& sharpness, const Descent_settings& settings, std::size_t max_sweeps, Run& run)
{
  const Error_code error = make_initial_map(initial_parameterizer, run);
  if(error != OK)
    return error;
  const auto descend = [&](Radius_chooser* chooser) {
    Descent_loop<Energy, Step> loop(run.mesh, energy, Step(), sharpness, chooser, settings, run.control, run.execution);
    run.radius = loop.run(run.positions, max_sweeps);
  };
  if constexpr(std::is_same<Radius, Default>::value)
    descend(nullptr);
  else
  {
    Radius_policy_chooser<Radius, Energy> chooser(radius, energy);
    descend(&chooser);
  }
  run.control.on_optimization_end();
  return OK;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_DESCENT_H
