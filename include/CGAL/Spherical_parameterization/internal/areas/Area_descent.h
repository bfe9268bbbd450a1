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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_DESCENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_DESCENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Conformal_energy_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/areas/Area_shares.h>
#include <CGAL/Spherical_parameterization/internal/areas/Area_step.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Moves the vertices, from a bijection close enough for Newton's method, until their cells have the prescribed areas;
// see Area_step. All intermediate maps are bijections. The weight of the areas increases from step to step: first the
// large differences decrease where the energy resists least, and in the end only the areas matter. If the areas cannot
// be realized, the differences become as small as possible. Returns the number of steps.
template <class Energy>
std::size_t minimize_area_deviation(const Surface& surface, const Area_shares& shares, const Energy& energy,
                                    double tolerance, std::vector<Vector_3d>& positions, Run_control& control)
{
#ifdef CGAL_EIGEN3_ENABLED
  // With the first weight, deviations of a third matter as much as the energy of typical maps. With the last one, the
  // effect of the energy on the areas is below 1e-4 on most surfaces. It increases further if the map has converged and
  // this is not sufficient.
  constexpr double first_penalty = 10., last_penalty = 1e6, max_penalty = 1e9, growth = 10.;
  constexpr std::size_t max_attempts = 200;
  constexpr int max_halvings = 6;
  constexpr double first_damping = 1., min_damping = 1e-6, max_damping = 1e12;
  constexpr double min_fall = 1e-4; // of the objective in a step, relative; a smaller decrease is convergence
  constexpr double sufficient_decrease = 1e-4; // of the decrease predicted by the slope

  Parameterization_report& report = control.report();
  if(!control.check_clock())
  {
    report.stop_reason = control.stop_reason();
    return 0;
  }
  Area_step<Energy> step(surface.rings(), surface.points(), shares.of_faces, shares.of_vertices, energy);
  std::vector<Vector_3d> moved;
  double penalty = first_penalty, damping = first_damping;
  double value = step.objective(positions, penalty);
  const std::size_t first_iteration = report.number_of_iterations();
  std::size_t n_steps = 0;
  const auto goes_on = [&] { return control.go_further(first_iteration + n_steps, value); };
  const auto descend = [&]() -> Stop_reason {
    for(std::size_t k = 0; k < max_attempts; ++k)
    {
      if(relative_deviation(step.ratios()) <= tolerance)
        return CONVERGED;
      if(control.is_stopped() || !control.check_clock())
        return control.stop_reason();
      double t = 1., next = value;
      bool is_found = false;
      if(step.find(positions, penalty, damping, goes_on))
        for(int halving = 0; halving < max_halvings && !is_found; ++halving)
        {
          t = std::ldexp(1., -halving);
          step.move(positions, t, moved);
          if(!are_safely_positive(surface.rings(), moved))
            continue;
          next = step.objective(moved, penalty);
          is_found = next < value + sufficient_decrease * t * step.slope();
        }
      if(!is_found)
      {
        value = step.objective(positions, penalty); // so that the ratios belong to these positions again
        damping *= 16.;
        if(damping > max_damping)
          return OBSTRUCTED;
        continue;
      }
      positions.swap(moved);
      damping = (std::max)(t == 1. ? damping / 8. : t < 0.5 ? damping * (2. / t) : damping, min_damping);
      const double fall = (value - next) / value;
      value = next;
      ++n_steps;
      control.after_iteration(first_iteration + n_steps, value, surface.equal_area_radius());
      if(!control.go_further(first_iteration + n_steps, value))
        return control.stop_reason();
      const bool has_settled = penalty >= last_penalty && fall < min_fall;
      if(has_settled && penalty >= max_penalty)
        return CONVERGED;
      if(has_settled || (penalty < last_penalty && (t >= 0.5 || fall < 0.01)))
      {
        penalty *= growth;
        value = step.objective(positions, penalty);
      }
    }
    return ITERATION_LIMIT;
  };
  report.stop_reason = descend();
  report.number_of_average_iterations += n_steps;
  report.seconds_for_optimization += control.lap();
  return n_steps;
#else
  static_assert(sizeof(Energy) == 0, "Areas as wanted take Eigen: link the target CGAL::Eigen3_support.");
  return 0;
#endif
}

#if defined(CGAL_SPHERICAL_PARAMETERIZATION_USE_LIBRARY) && defined(CGAL_EIGEN3_ENABLED)
// The library contains the instances for the energies of the package.
#define CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(EXTERN, Energy)                                                   \
  EXTERN template std::size_t minimize_area_deviation(const Surface&, const Area_shares&, const Energy&, double,       \
                                                      std::vector<Vector_3d>&, Run_control&);
CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(extern, Symmetric_Dirichlet_energy_3)
CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(extern, Isometric_energy_3)
CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(extern, Conformal_energy_3)
CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(extern, Stretch_energy_3)
#endif

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_DESCENT_H
