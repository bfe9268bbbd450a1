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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_OBJECTIVE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_OBJECTIVE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/internal/descent/Energy_summary.h>
#include <CGAL/Spherical_parameterization/internal/descent/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The state of a schedule during a run: its current sharpness. For a relative sharpness, the level determines the
// sharpness; a relative sharpness of 0 is a schedule that stays at 0.
class Sharpness_rule
{
public:
  explicit Sharpness_rule(const Sharpness& sharpness)
    : m_rule(sharpness)
    , m_current(sharpness.m_number_of_average_sweeps == 0 ? sharpness.m_first : 0.)
  {}

  // The sharpness of the next sweep over the mesh. `sweep` counts from 0.
  double next(std::size_t sweep, double average_energy, double max_energy)
  {
    if(sweep > 0 && m_current < m_rule.m_last)
    {
      if(m_current == 0.)
      {
        const bool is_over = m_rule.m_number_of_average_sweeps == Sharpness::adaptive
                                 ? average_energy > (1. - min_decrease_of_average) * m_average_energy
                                 : sweep >= m_rule.m_number_of_average_sweeps;
        if(is_over)
          m_current = m_rule.m_first;
      }
      else if(max_energy > (1. - m_rule.m_min_fall) * m_max_energy &&
              average_energy > (1. - m_rule.m_min_fall) * m_average_energy)
        m_current = (std::min)(growth * m_current, m_rule.m_last);
    }
    m_average_energy = average_energy;
    m_max_energy = max_energy;
    return m_current;
  }

  bool is_relative() const { return m_rule.m_is_relative; }
  double dial() const { return m_rule.m_is_relative ? m_rule.m_first : 0.; }

  // Whether the sharpness has reached its final value.
  bool is_final() const { return m_current == m_rule.m_last; }

private:
  static constexpr double min_decrease_of_average = 1e-3; // as documented in Sharpness
  static constexpr double growth = 1.25;                  // from 0.1 to 10, the paper's range, in 21 steps

  Sharpness m_rule;
  double m_current;
  double m_average_energy = 0., m_max_energy = 0.; // before the last sweep
};

// The objective of a run. For a relative sharpness beta it is one function of the map, the radius and a level R,
// through the energies E of the n faces:
//
//   Phi = (1 - a) mean E + a S,   S = (1 - 1/b) R + (R/b) mean exp(b (E/R - 1)),   a = beta / (beta + 40), b = beta + 1.
//
// Its minimum over R makes S a soft maximum: homogeneous and convex in the energies, equal to them if all are the same,
// and closer to the largest for larger b. Since Phi is jointly convex in the energies and R, steps of the map, the
// radius and the level all decrease the same function, although the sharpness s = b/R of the sweeps changes.
//
// For a schedule, the objective is that of eq. 6 or 7 of the paper, with an s that changes from sweep to sweep.
class Objective
{
public:
  // `has_radius` is true if the radius is a variable of the objective, and the map should be isometric.
  Objective(const Sharpness& sharpness, bool has_radius)
    : m_rule(sharpness)
  {
    m_faces.area_correction = has_radius ? 1. / 9. : 0.;
    if(m_rule.dial() > 0.)
      set_relative_sharpness((std::min)(m_rule.dial(), max_initial_sharpness));
  }

  const Face_objective& of_faces() const { return m_faces; }

  // The sharpness of the first phase, which is also that of coarse levels; none for a schedule.
  static std::optional<Sharpness> initial_sharpness(const Sharpness& sharpness)
  {
    const Sharpness_rule rule(sharpness);
    if(!rule.is_relative())
      return std::nullopt;
    return Sharpness::relative((std::min)(rule.dial(), max_initial_sharpness));
  }

  // Sets a relative sharpness above that of Sharpness::balanced() to its final value, and returns whether this was
  // necessary. Starting from the map that has converged for the smaller value usually gives a lower largest energy.
  bool set_final_sharpness()
  {
    if(!m_faces.has_level() || m_b == m_rule.dial() + 1.)
      return false;
    set_relative_sharpness(m_rule.dial());
    if(!m_faces.is_average())
      set_level(m_faces.level);
    return true;
  }

  // Determines the objective of the next sweep for the current map. Returns whether it has changed, so that the map
  // must be summed up again.
  bool start_sweep(std::size_t sweep, const Energy_summary& summary)
  {
    const double last_sharpness = m_faces.sharpness;
    if(!m_faces.has_level())
      m_faces.sharpness = m_rule.next(sweep, summary.average(), summary.maximum_energy());
    else if(m_faces.is_average() && summary.maximum_energy() > 0.)
      set_level(summary.maximum_energy());
    return m_faces.sharpness != last_sharpness;
  }

  // Moves the level towards the minimum of Phi for the current map, and returns the relative change.
  //
  // dS/dR = 0 is equivalent to mean[(b x - 1) exp(b (x - 1))] = b - 1 with x = E/R. The left side is increasing and
  // convex in 1/R. This makes a Newton step in 1/R that at most doubles or halves R: for the logarithm of both sides,
  // which is nearly linear where exponents are large, or for the sides themselves, where the left one may be negative.
  double improve_level(const Energy_summary& summary)
  {
    if(!m_faces.has_level() || m_faces.is_average())
      return 0.;
    const double s = m_faces.sharpness, level = m_faces.level, slope = s * summary.weighted_mean() - 1.;
    const double exponent = s * (summary.exponential_mean() - level);
    const double curvature = s * s * summary.weighted_mean_square();
    if(!is_finite(curvature)) // squares of energies beyond the range of double
      return 0.;
    const double excess = slope > 0. && m_b >= 2. ? slope * (exponent + logarithm(slope / (m_b - 1.)))
                                                  : slope - (m_b - 1.) / exponential(exponent);
    const double step = (std::min)((std::max)(excess / curvature, -1.), 0.5);
    set_level(level / (1. - step));
    return std::abs(m_faces.level - level) / level;
  }

  // Moves the level, to no less than half of its value.
  void move_level(double step)
  {
    if(m_faces.has_level() && !m_faces.is_average())
      set_level((std::max)(m_faces.level + step, 0.5 * m_faces.level));
  }

  // Phi, or the mean of eq. 6 or 7 in the unit of the energy.
  double value(const Energy_summary& summary) const
  {
    if(!m_faces.has_level() || m_faces.is_average())
      return summary.exponential_mean();
    const double s = m_faces.sharpness, level = m_faces.level;
    const double soft_maximum = (1. - 1. / m_b) * level + exponential(s * (summary.exponential_mean() - level)) / s;
    return (1. - m_faces.share) * summary.average() + m_faces.share * soft_maximum;
  }

  bool is_final() const { return m_rule.is_final(); }

private:
  static constexpr double max_initial_sharpness = 20.;

  void set_relative_sharpness(double beta)
  {
    m_b = beta + 1.;
    m_faces.share = beta / (beta + 40.); // 1/2 for Sharpness::lowest_worst()
  }

  void set_level(double level)
  {
    m_faces.level = level;
    m_faces.sharpness = m_b / level;
  }

  Sharpness_rule m_rule;
  double m_b = 1.;
  Face_objective m_faces;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_OBJECTIVE_H
