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

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

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

  // The sharpness of a coarse level: a fifth of the dial, 3 at most, as sharp coarse levels make the end worse.
  double on_coarse_level(double max_energy) const { return relative((std::min)(0.2 * dial(), 3.), max_energy); }

  double dial() const { return m_rule.m_is_relative ? m_rule.m_first : 0.; }

  // Whether the sharpness has reached its last value. That of a dial follows the map only, and settles with it.
  bool is_final() const { return m_rule.m_is_relative || m_current == m_rule.m_last; }

private:
  static constexpr double min_fall_of_average = 1e-3; // as Sharpness documents it
  static constexpr double growth = 1.25;              // from 0.1 to 10, the paper's range, in 21 steps

  // An energy may be 0 at its minimum, and a map may reach it.
  static double relative(double beta, double max_energy) { return max_energy > 0. ? beta / max_energy : 0.; }

  Sharpness m_rule;
  double m_current;
  double m_average_energy = 0., m_max_energy = 0.; // before the last sweep
};

// What a run lowers. For a dial beta it is one function of the map, the radius and a level R, through the energies E of
// the n faces:
//
//   Phi = (1 - a) mean E + a S,   S = (1 - 1/b) R + (R/b) mean exp(b (E/R - 1)),   a = beta / (beta + 40), b = beta + 1.
//
// Its minimum over R makes S a soft maximum: homogeneous and convex in the energies, equal to them where all are the
// same, and nearer to the largest the larger b is. As Phi is jointly convex in the energies and R, steps of the map, the
// radius and the level all lower one function, though the sharpness s = b/R of the sweeps changes.
//
// The group of the slivers, see sliver_vertices(), would own R, and with it how much all other faces count. It has a
// soft maximum with a level of its own, which is added to that of the others; each has the sum over its faces, divided
// by n. That level is not lowered below that of the others: slivers that are no worse count as they do.
//
// For a schedule it is what eq. 6 or 7 of the paper says, with an s that changes from sweep to sweep.
class Objective
{
public:
  // `has_radius` says whether the radius is one of the variables, and the map is to be isometric.
  Objective(const Sharpness& sharpness, bool has_radius)
    : m_rule(sharpness)
    , m_b(m_rule.dial() + 1.)
  {
    m_faces.area_correction = has_radius ? 1. / 9. : 0.;
    if(m_rule.dial() > 0.)
      m_faces.share = m_rule.dial() / (m_rule.dial() + 40.); // half for Sharpness::lowest_worst()
  }

  const Face_objective& of_faces() const { return m_faces; }

  // The slivers are measured on the sphere of this radius, whatever that of the other faces is; 0: on the same.
  void set_sliver_radius(double radius) { m_faces.sliver_radius = radius; }

  // Chooses what the next sweep lowers, given the map at hand. Returns whether that has changed, so that the map is to be
  // summed up anew.
  bool start_sweep(std::size_t sweep, const Mesh_summary& summary)
  {
    const Energy_summary all = summary.all();
    const double last_sharpness = m_faces.ordinary.sharpness;
    if(!m_faces.has_levels())
      m_faces.ordinary.sharpness = m_faces.of_slivers.sharpness =
          m_rule.next(sweep, all.average(), all.maximum_energy());
    else if(m_faces.is_average() && all.maximum_energy() > 0.)
      m_faces.ordinary = m_faces.of_slivers = at_level(all.maximum_energy());
    return m_faces.ordinary.sharpness != last_sharpness;
  }

  // Moves the levels towards the minimum of Phi for the map at hand, and returns how far, relative.
  double improve_levels(const Mesh_summary& summary)
  {
    if(!m_faces.has_levels() || m_faces.is_average())
      return 0.;
    const double size = summary.all().size(), step = improve_level(m_faces.ordinary, summary.ordinary, size, 0.);
    return (std::max)(step, improve_level(m_faces.of_slivers, summary.slivers, size, m_faces.ordinary.level));
  }

  // Moves the level of all faces but the slivers, to no less than half of what it is.
  void move_level(double step)
  {
    if(m_faces.has_levels() && !m_faces.is_average())
      m_faces.ordinary = at_level((std::max)(m_faces.ordinary.level + step, 0.5 * m_faces.ordinary.level));
  }

  // Phi, or the mean of eq. 6 or 7 in the unit of the energy
  double value(const Mesh_summary& summary) const
  {
    const Energy_summary all = summary.all();
    if(!m_faces.has_levels() || m_faces.is_average())
      return all.exponential_mean();
    const double soft_maximum = soft_maximum_of(m_faces.ordinary, summary.ordinary, all.size()) +
                                soft_maximum_of(m_faces.of_slivers, summary.slivers, all.size());
    return (1. - m_faces.share) * all.average() + m_faces.share * soft_maximum;
  }

  bool is_final() const { return m_rule.is_final(); }

private:
  using Exponential = Face_objective::Exponential;

  Exponential at_level(double level) const { return {m_b / level, level}; }

  // dS/dR = 0 says that mean[(b x - 1) exp(b (x - 1))] = b - 1 with x = E/R. The left side is increasing and convex in
  // 1/R, where this makes a Newton step, at most one that doubles or halves R: for the logarithm of both sides, which is
  // nearly linear where exponents are large, or for the sides themselves, where the left one may be negative.
  double improve_level(Exponential& e, const Energy_summary& summary, double size, double min_level) const
  {
    if(summary.is_empty())
      return 0.;
    const double s = e.sharpness, slope = s * summary.weighted_mean() - 1.;
    const double exponent = s * (summary.exponential_mean() - e.level), share = summary.size() / size;
    const double curvature = s * s * summary.weighted_mean_square();
    if(!is_finite(curvature)) // squares of energies beyond what a double holds
      return 0.;
    const double excess = slope > 0. && m_b >= 2. ? slope * (exponent + logarithm(share * slope / (m_b - 1.)))
                                                  : slope - (m_b - 1.) / (share * exponential(exponent));
    const double step = (std::min)((std::max)(excess / curvature, -1.), 0.5);
    const double level = (std::max)(e.level / (1. - step), (std::min)(e.level, min_level));
    const double change = std::abs(level - e.level) / e.level;
    e = at_level(level);
    return change;
  }

  // S of a group among `size` faces
  double soft_maximum_of(const Exponential& e, const Energy_summary& summary, double size) const
  {
    if(summary.is_empty())
      return 0.;
    const double mean = summary.size() / size * exponential(e.sharpness * (summary.exponential_mean() - e.level));
    return (1. - 1. / m_b) * e.level + mean / e.sharpness;
  }

  Sharpness_rule m_rule;
  double m_b;
  Face_objective m_faces;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_OBJECTIVE_H
