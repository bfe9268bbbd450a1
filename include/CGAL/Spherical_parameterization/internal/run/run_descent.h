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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_DESCENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_DESCENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/internal/descent/Descent_settings.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/surface/Run.h>

#include <CGAL/Default.h>

#include <cstddef>
#include <type_traits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The step types of a vertex, see Vertex_step.h.
class Newton_step;
class Gradient_step;

// Adapts a model of SphereRadiusPolicy_3 to the loop over sweeps. Each run works on a copy, since a policy may have
// mutable state.
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

// Computes the initial map, by the hierarchy unless that fails, and calls the visitor. If `shares` are given, they are
// the prescribed areas of the vertices, instead of the areas on the surface.
template <class Energy>
void embed_surface(const Energy& energy, const Level_settings& settings, Run& run,
                   const std::vector<double>& shares = {});

// Minimizes the objective by sweeps, starting from a bijection. The map of the last resort, above 1.7 million vertices,
// may have faces that rounding errors of the sweeps could invert; then there are no sweeps. If `shares` are given,
// faces keep their shapes on the surface but get these areas.
template <class Step, class Energy>
void descend(const Energy& energy, Radius_chooser* radius, const Sharpness& sharpness, const Descent_settings& settings,
             std::size_t max_sweeps, Run& run, const std::vector<double>& shares = {});

// The same with a radius policy, or without one; calls the visitor at the end.
template <class Step, class Energy, class Radius>
void run_descent(const Energy& energy, const Radius& radius, const Sharpness& sharpness,
                 const Descent_settings& settings, std::size_t max_sweeps, Run& run)
{
  if constexpr(std::is_same<Radius, Default>::value)
    descend<Step>(energy, nullptr, sharpness, settings, max_sweeps, run);
  else
  {
    Radius_policy_chooser<Radius, Energy> chooser(radius, energy);
    descend<Step>(energy, &chooser, sharpness, settings, max_sweeps, run);
  }
  run.control.on_optimization_end();
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#if defined(CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY) || defined(CGAL_SPHERICAL_PARAMETERIZATION_OWN_ENERGIES)
#include <CGAL/Spherical_parameterization/internal/run/run_descent_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_DESCENT_H
