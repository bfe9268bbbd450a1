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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_STATE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_STATE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/descent/Descent_settings.h>
#include <CGAL/Spherical_parameterization/internal/descent/Energy_summary.h>

#include <cmath>
#include <cstddef>

namespace CGAL::Spherical_parameterization::internal {

struct Descent_state
{
  double radius = 1., value = 0.; // of the objective
  Mesh_summary summary;
};

// Whether nothing that matters has changed: the objective, the average and the radius, and, less exactly, the largest
// energy, which is a matter of few faces. Changes are compared with what could still be gained, if no map has less than
// `isometric_energy`. The paper's rule is about the sum alone, whose relative change is that of exp(s value).
inline bool has_converged(const Descent_state& now, const Descent_state& last, const Descent_settings& settings,
                          double sharpness, double isometric_energy)
{
  const auto is_settled = [](double value, double last_value, double tolerance) {
    return std::abs(value - last_value) <= tolerance * last_value;
  };
  const double energy_tolerance = settings.energy_tolerance;
  if(!is_settled(now.radius, last.radius, settings.radius_tolerance))
    return false;
  const Energy_summary all = now.summary.all(), last_all = last.summary.all();
  if(!settings.is_accelerated && sharpness > 0.)
    return std::abs(std::expm1(sharpness * (now.value - last.value))) <= energy_tolerance;
  if(!settings.is_accelerated)
    return is_settled(all.average(), last_all.average(), energy_tolerance);
  const auto has_settled = [&](double value, double last_value, double factor) {
    return all.has_settled(value, last_value, factor * energy_tolerance, isometric_energy);
  };
  return has_settled(now.value, last.value, 1.) && has_settled(all.average(), last_all.average(), 1.) &&
         has_settled(all.maximum_energy(), last_all.maximum_energy(), 20.);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_STATE_H
