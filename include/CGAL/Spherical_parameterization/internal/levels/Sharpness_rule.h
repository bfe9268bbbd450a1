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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_SHARPNESS_RULE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_SHARPNESS_RULE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Sharpness.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A Sharpness in use: what it has chosen so far during a run, and chooses next.
class Sharpness_rule
{
public:
  explicit Sharpness_rule(const Sharpness& sharpness)
    : m_rule(sharpness)
    , m_current(sharpness.m_number_of_average_sweeps == 0 ? sharpness.m_first : 0.)
  {}

  // The sharpness of the next sweep over the mesh, or over a level that is nearly as fine. `sweep` counts from 0.
  double next(std::size_t sweep, double average_energy, double max_energy)
  {
    if(m_rule.m_is_relative)
      return relative(m_rule.m_first, max_energy);
    if(sweep > 0 && m_current < m_rule.m_last)
    {
      if(m_current == 0.)
      {
        const bool is_over = m_rule.m_number_of_average_sweeps == Sharpness::adaptive
                                 ? average_energy > (1. - min_fall_of_average) * m_average_energy
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

  // The sharpness of the next sweep over a coarse level.
  double on_coarse_level(double max_energy) const { return relative((std::min)(0.2 * dial(), 3.), max_energy); }

  double dial() const { return m_rule.m_is_relative ? m_rule.m_first : 0.; }

  // Whether the sharpness has reached its last value. That of a dial follows the map only, and settles with it.
  bool is_final() const { return m_rule.m_is_relative || m_current == m_rule.m_last; }

private:
  static constexpr double min_fall_of_average = 1e-3;
  static constexpr double growth = 1.25;

  // An energy may be 0 at its minimum, and a map may reach it.
  static double relative(double beta, double max_energy) { return max_energy > 0. ? beta / max_energy : 0.; }

  Sharpness m_rule;
  double m_current;
  double m_average_energy = 0., m_max_energy = 0.; // before the last sweep
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_SHARPNESS_RULE_H
