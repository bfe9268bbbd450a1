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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_LOOP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_LOOP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/internal/descent/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/descent/Descent_settings.h>
#include <CGAL/Spherical_parameterization/internal/descent/Energy_summary.h>
#include <CGAL/Spherical_parameterization/internal/descent/Objective.h>
#include <CGAL/Spherical_parameterization/internal/descent/Round_sphere.h>
#include <CGAL/Spherical_parameterization/internal/descent/Smooth_step.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

struct Descent_state
{
  double radius = 1., value = 0.; // of the objective
  Energy_summary summary;
};

// Whether the run has converged: in the objective, the average energy and the radius. Changes are compared with the
// possible gain, if no map has an energy below `isometric_energy`. The paper's criterion concerns only the sum, whose
// relative change is that of exp(s value).
inline bool has_converged(const Descent_state& now, const Descent_state& last, const Descent_settings& settings,
                          double sharpness, double isometric_energy)
{
  const auto is_settled = [](double value, double last_value, double tolerance) {
    return std::abs(value - last_value) <= tolerance * last_value;
  };
  const double energy_tolerance = settings.energy_tolerance;
  if(!is_settled(now.radius, last.radius, settings.radius_tolerance))
    return false;
  const Energy_summary &all = now.summary, &last_all = last.summary;
  if(!settings.is_accelerated && sharpness > 0.)
    return std::abs(exponential(sharpness * (now.value - last.value)) - 1.) <= energy_tolerance;
  if(!settings.is_accelerated)
    return is_settled(all.average(), last_all.average(), energy_tolerance);
  return all.has_settled(now.value, last.value, energy_tolerance, isometric_energy) &&
         all.has_settled(all.average(), last_all.average(), energy_tolerance, isometric_energy);
}

// The method BLD, starting from a bijection: sweeps over all vertices, each with a radius and a sharpness for the
// current map, until convergence.
template <class Energy, class Step>
class Descent_loop
{
public:
  using Space = Round_sphere<Energy, Step>;

  // The descent has been given the mesh; it and the control must outlive this object. The unit is the radius of the
  // sphere with the area of the surface, from which the loop starts.
  Descent_loop(Block_coordinate_descent<Space, Step>& descent, const Length_unit& unit, const Sharpness& sharpness,
               Radius_chooser* radius, const Descent_settings& settings, Run_control& control, Execution execution)
    : m_unit(unit)
    , m_number_of_vertices(descent.number_of_vertices())
    , m_descent(descent)
    , m_smooth_step(descent.space(), m_number_of_vertices, !radius)
    , m_execution(execution)
    , m_isometric_energy(descent.space().energy()(2., 1.))
    , m_objective(sharpness, !radius)
    , m_radius_chooser(radius)
    , m_settings(settings)
    , m_control(control)
  {}

  // Minimizes the objective over the positions on the unit sphere in at most `max_sweeps` sweeps, and returns the
  // radius by flat areas.
  double run(std::vector<Vector_3d>& positions, std::size_t max_sweeps)
  {
    minimize(positions, max_sweeps);
    choose_final_radius(positions);
    finish(positions);
    return m_state.radius;
  }

  // The same, without what only the result of a run needs. The radius is that of the last sweep.
  void minimize(std::vector<Vector_3d>& positions, std::size_t max_sweeps)
  {
    Parameterization_report& report = m_control.report();
    start(positions);
    report.stop_reason = ITERATION_LIMIT;
    bool has_phases = true; // whether the radius policy may have further phases
    const std::size_t window =
        m_settings.is_accelerated
            ? (std::min)(Smooth_step_schedule::min_interval + size_of_small_meshes / m_number_of_vertices, max_window)
            : 1;
    Descent_state last;
    for(std::size_t i = 0; i < max_sweeps; ++i)
    {
      if(i % window == 0)
        last = m_state;
      const bool was_final = i > 0 && m_objective.is_final();

      choose_objective(i);
      choose_radius(i, positions);
      if(makes_smooth_step(i))
        step_smoothly(i, positions);
      if(m_settings.is_accelerated)
        m_descent.sweep_with_focus(positions, scaled_radius(), m_objective.of_faces(),
                                   m_state.summary.maximum_energy());
      else
        m_descent.sweep(positions, scaled_radius(), m_objective.of_faces());
      measure(positions);

      m_control.after_iteration(i + 1, m_state.value, m_state.radius);
      if(!m_control.go_further(i + 1, m_state.value))
        break;
      const bool may_end =
          was_final && (i + 1) % window == 0 && (!m_settings.is_accelerated || m_smooth_steps.may_end(i + 1 - window));
      if(may_end && has_converged(m_state, last, m_settings, m_objective.of_faces().sharpness, m_isometric_energy))
      {
        if(m_objective.set_final_sharpness())
        {
          sum_up();
          continue;
        }
        has_phases = m_radius_chooser && m_radius_chooser->next_phase();
        if(!has_phases)
        {
          report.stop_reason = CONVERGED;
          break;
        }
      }
    }
    if(has_phases)
      skip_phases();
    if(m_control.is_stopped())
      report.stop_reason = m_control.stop_reason();
  }

  // The current objective, and the radius in the unit of the mesh.
  const Face_objective& objective() const { return m_objective.of_faces(); }

  // It is restricted to a range where its powers are finite.
  double scaled_radius() const { return (std::min)((std::max)(m_unit.scaled_radius(m_state.radius), 1e-50), 1e50); }

private:
  static constexpr std::size_t max_window = 100; // without it, the window would be 502 sweeps for a tetrahedron
  static constexpr int max_halvings =
      5; // of steps of the radius and of smooth steps, each of which sums up all faces: down to 1/16

  void start(const std::vector<Vector_3d>& positions)
  {
    m_state.radius = m_unit.equal_area_radius();
    if(m_radius_chooser)
    {
      const double radius = m_radius_chooser->initial_radius(m_state.radius);
      if(is_positive_and_finite(radius))
        m_state.radius = radius;
    }
    measure(positions);
    m_control.report().initial_energy = m_state.summary.average();
  }

  void choose_objective(std::size_t i)
  {
    if(m_objective.start_sweep(i, m_state.summary))
      sum_up();
    minimize_over_level();
    Parameterization_report& report = m_control.report();
    report.sharpness = m_objective.of_faces().sharpness;
    ++(report.sharpness > 0. ? report.number_of_sharp_iterations : report.number_of_average_iterations);
  }

  // Newton steps of the level until one is short; that one is undone if it increases the objective.
  void minimize_over_level()
  {
    constexpr int max_steps = 2000;     // more than the number of powers of two in the range of double
    constexpr double short_step = 0.01; // Newton's method doubles the digits; the next step is negligible
    for(int k = 0; k < max_steps; ++k)
    {
      const Objective last = m_objective;
      const Energy_summary last_summary = m_state.summary;
      const double step = m_objective.improve_level(m_state.summary);
      if(!(step > 0.))
        return;
      sum_up();
      if(step > short_step)
        continue;
      if(m_objective.value(m_state.summary) > last.value(last_summary))
      {
        m_objective = last;
        m_state.summary = last_summary;
      }
      return;
    }
  }

  // A smooth step moves the radius as well.
  void choose_radius(std::size_t i, const std::vector<Vector_3d>& positions)
  {
    if(m_radius_chooser)
      follow_policy(i == 0, positions);
    else if(!makes_smooth_step(i))
      minimize_over_radius();
  }

  // Half steps by default: over-relaxed vertices overreact to a full step, and the two would not converge.
  void follow_policy(bool is_full_step, const std::vector<Vector_3d>& positions)
  {
    const double aim = m_radius_chooser->next_radius(
        m_descent.faces(positions, scaled_radius(), m_objective.of_faces()), m_state.radius);
    if(is_positive_and_finite(aim))
      m_state.radius =
          is_full_step || !m_settings.is_accelerated ? aim : m_state.radius * std::sqrt(aim / m_state.radius);
  }

  // At the end of the range of double, coordinates must stay finite.
  void set_radius(double radius)
  {
    if(is_positive_and_finite(radius) && is_positive_and_finite(4. * radius))
      m_state.radius = radius;
  }

  // A Newton step in the logarithm of the radius, or a fraction of it that does not increase the objective.
  void minimize_over_radius()
  {
    const double radius = m_state.radius, value = m_objective.value(m_state.summary);
    double step = m_descent.radius_step(scaled_radius(), m_objective.of_faces());
    for(int k = 0; k < max_halvings && step != 0.; ++k, step *= 0.5)
    {
      set_radius(radius * exponential(step));
      sum_up();
      if(m_objective.value(m_state.summary) <= value)
        return;
    }
    m_state.radius = radius;
    sum_up();
  }

  // A run that ends early also gets the radius of the last phase, if the policy reaches it.
  void skip_phases()
  {
    constexpr int max_phases = 1000; // a caller's policy may have no last one
    const bool is_stopped = m_control.is_stopped();
    for(int k = 0; k < max_phases && m_radius_chooser && m_radius_chooser->next_phase(); ++k)
      if(!is_stopped && !m_control.check_clock())
        return;
  }

  // The radius of the final map, by flat areas instead of determinants, which are smaller on coarse meshes.
  void choose_final_radius(const std::vector<Vector_3d>& positions)
  {
    constexpr int max_steps = 100;     // a few are usual, tens where the curvature is negative
    constexpr double min_step = 1e-13; // rounding error
    if(m_radius_chooser)
    {
      follow_policy(true, positions);
      return;
    }
    m_descent.measure(positions, scaled_radius(), m_objective.of_faces(), true);
    for(int k = 0; k < max_steps; ++k)
    {
      const double step = m_descent.radius_step(scaled_radius(), m_objective.of_faces());
      set_radius(m_state.radius * exponential(step));
      if(!(std::abs(step) > min_step))
        return;
    }
  }

  bool makes_smooth_step(std::size_t sweep) const { return m_settings.is_accelerated && m_smooth_steps.is_due(sweep); }

  void step_smoothly(std::size_t sweep, std::vector<Vector_3d>& positions)
  {
    const double value = m_objective.value(m_state.summary);
    make_smooth_step(positions);
    m_smooth_steps.has_made(sweep, value, m_objective.value(m_state.summary));
  }

  // A step of all vertices at once and of the level, see Smooth_step, or a fraction of it that decreases the objective.
  void make_smooth_step(std::vector<Vector_3d>& positions)
  {
    if(!m_smooth_step.find(m_descent.measured_faces(), m_descent.stars(), positions, scaled_radius(),
                           m_objective.of_faces(), m_execution))
      return;
    const double value = m_objective.value(m_state.summary), radius = m_state.radius;
    const Objective objective = m_objective;
    double t = 1.;
    for(int k = 0; k < max_halvings; ++k, t *= 0.5)
    {
      m_smooth_step.move(positions, t, m_moved, m_execution);
      if(!m_descent.are_safely_positive(m_moved))
        continue;
      m_objective = objective;
      m_objective.move_level(m_smooth_step.level_step(t));
      set_radius(radius * m_smooth_step.radius_factor(t));
      measure(m_moved);
      if(m_state.value < value)
      {
        positions.swap(m_moved);
        return;
      }
    }
    m_objective = objective;
    m_state.radius = radius;
    measure(positions);
  }

  void measure(const std::vector<Vector_3d>& positions)
  {
    m_state.summary = m_descent.measure(positions, scaled_radius(), m_objective.of_faces());
    m_state.value = m_objective.value(m_state.summary);
  }

  // Sums up the last measured map for another objective or radius.
  void sum_up() { m_state.summary = m_descent.summary(scaled_radius(), m_objective.of_faces()); }

  // The energies in the report are those at the returned radius, by the area measure of the descent.
  void finish(const std::vector<Vector_3d>& positions)
  {
    Face_objective objective;
    objective.area_correction = m_objective.of_faces().area_correction;
    m_state.summary = m_descent.measure(positions, scaled_radius(), objective);
    Parameterization_report& report = m_control.report();
    report.average_energy = m_state.summary.average();
    report.largest_energy = m_state.summary.maximum_energy();
    if(!is_finite(report.average_energy))
    {
      report.stop_reason = NON_FINITE_ENERGY;
      report.average_energy = report.largest_energy = std::numeric_limits<double>::quiet_NaN();
    }
    report.seconds_for_optimization = m_control.lap();
  }

  Length_unit m_unit; // the caller's unit is that of radii
  std::size_t m_number_of_vertices;
  Block_coordinate_descent<Space, Step>& m_descent;
  Smooth_step<Space> m_smooth_step;
  Execution m_execution;
  std::vector<Vector_3d> m_moved;
  Smooth_step_schedule m_smooth_steps;
  double m_isometric_energy; // no map has less, for most energies
  Objective m_objective;
  Radius_chooser* m_radius_chooser;
  Descent_settings m_settings;
  Run_control& m_control;
  Descent_state m_state;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_LOOP_H
