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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_LOOP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_LOOP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/internal/descent/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/descent/Independent_sets.h>
#include <CGAL/Spherical_parameterization/internal/descent/Measured_faces.h>
#include <CGAL/Spherical_parameterization/internal/descent/Sharpness_rule.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/run/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/simd/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The radius policy of a run, see SphereRadiusPolicy_3, asked once per sweep. Radii are in the caller's unit of length.
class Radius_chooser
{
public:
  virtual ~Radius_chooser() = default;
  virtual double initial_radius(double equal_area_radius) const = 0;
  virtual double next_radius(const Face_range_3& faces, double radius) = 0;
  virtual bool next_phase() = 0;
};

// When the loop ends, and whether it goes beyond what the paper describes.
struct Descent_settings
{
  // A sweep that changes the energy by at most this much, relative, and the radius likewise, has converged.
  double energy_tolerance = 4e-5, radius_tolerance = 1e-3;
  // If so, extra sweeps go over the worst faces alone, the radius makes half steps, and convergence asks for more than
  // that the sum of eq. 6 or 7 has settled.
  bool is_accelerated = true;
};

// The method BLD once there is a bijection: sweeps over all vertices, each with the radius and the sharpness that suit
// the map at hand, until nothing changes any more.
template <class Energy, class Step>
class Descent_loop
{
public:
  Descent_loop(const Indexed_mesh& mesh, const Energy& energy, const Step& step, const Sharpness& sharpness,
               Radius_chooser& radius, const Descent_settings& settings, Run_control& control, Execution execution);
  ~Descent_loop();

  // Lowers the energy of the positions on the unit sphere in at most `max_sweeps` sweeps, and returns the radius.
  double run(std::vector<Vector_3d>& positions, std::size_t max_sweeps);

private:
  // The vertices around faces above this share of the largest energy are swept some times more, as they settle slowest,
  // and the largest distortion is theirs: as often as takes the time of a sweep over all vertices, if that is not too
  // seldom to be worth it.
  static constexpr double focus_energy = 0.6;
  static constexpr std::size_t min_focus_sweeps = 5;
  static constexpr std::size_t max_focus_sweeps = 10;
  // If it is, they are too many, and stay so for a while: these sweeps do without.
  static constexpr std::size_t sweeps_without_focus = 4;

  struct State
  {
    double radius = 1., sharpness = 0.;
    Energy_summary summary;
  };

  void start(const std::vector<Vector_3d>& positions)
  {
    m_state.radius = m_radius_chooser.initial_radius(m_mesh.equal_area_radius());
    if(!is_positive_and_finite(m_state.radius))
      m_state.radius = m_mesh.equal_area_radius();
    measure(positions);
    m_control.report().initial_energy = m_state.summary.average();
  }

  // Half the way by default: over-relaxed vertices answer a full step with more than their share, and the two never
  // settle.
  void choose_radius(bool is_full_step)
  {
    const double aim = m_radius_chooser.next_radius(m_descent.faces(), m_state.radius);
    if(is_positive_and_finite(aim))
      m_state.radius =
          is_full_step || !m_settings.is_accelerated ? aim : m_state.radius * std::sqrt(aim / m_state.radius);
  }

  void choose_sharpness(std::size_t i)
  {
    m_state.sharpness = m_sharpness_rule.next(i, m_state.summary.average(), m_state.summary.maximum_energy());
    Parameterization_report& report = m_control.report();
    report.sharpness = m_state.sharpness;
    ++(m_state.sharpness > 0. ? report.number_of_sharp_iterations : report.number_of_average_iterations);
  }

  // Moves all vertices, then, if few faces are much worse than the others, those around them some times more. One
  // thread looks for these faces, while the others have begun with the sweep.
  void sweep(std::vector<Vector_3d>& positions, std::size_t i)
  {
    const auto sweep_all = [&] { m_descent.sweep(positions, scaled_radius(), m_state.sharpness); };
    if(!m_settings.is_accelerated || !(m_state.sharpness > 0.) || i < m_next_focus)
    {
      sweep_all();
      return;
    }
    std::size_t focus = 0; // its number of vertices
    m_descent.reserve_focus(m_max_focus);
    run_both(m_execution, sweep_all, [&] {
      focus = m_descent.focus_on_faces_above(focus_energy * m_state.summary.maximum_energy(), m_max_focus);
    });
    if(focus > m_max_focus)
      m_next_focus = i + 1 + sweeps_without_focus;
    else if(focus > 0)
    {
      const std::size_t n_sweeps = (std::min)(m_mesh.number_of_vertices() / focus, max_focus_sweeps);
      for(std::size_t k = 0; k < n_sweeps; ++k)
        m_descent.sweep_focus(positions, scaled_radius(), m_state.sharpness);
    }
  }

  void measure(const std::vector<Vector_3d>& positions)
  {
    m_state.summary = m_descent.measure(positions, scaled_radius(), m_state.sharpness);
  }

  // Whether a sweep has changed nothing that matters. As the sharpness may move with the map, the accelerated descent
  // compares energies that do so little or not at all, and all have to settle; the paper's rule is about the sum alone,
  // whose relative change is that of exp(s objective()).
  bool has_converged(const State& last) const
  {
    const double tolerance = m_settings.energy_tolerance;
    const Energy_summary &now = m_state.summary, &before = last.summary;
    if(!is_settled(m_state.radius, last.radius, m_settings.radius_tolerance))
      return false;
    if(!m_settings.is_accelerated && m_state.sharpness > 0.)
      return std::abs(std::expm1(m_state.sharpness * (now.objective() - before.objective()))) <= tolerance;
    if(!m_settings.is_accelerated)
      return is_settled(now.average(), before.average(), tolerance);
    const auto is_settled_energy = [&](double value, double last_value, double energy_tolerance) {
      return std::abs(value - last_value) <= energy_tolerance * now.scale_of_changes(last_value);
    };
    return is_settled_energy(now.objective(), before.objective(), tolerance) &&
           is_settled_energy(now.average(), before.average(), tolerance) &&
           is_settled_energy(now.maximum_energy(), before.maximum_energy(), 10. * tolerance);
  }

  void finish(const std::vector<Vector_3d>& positions)
  {
    m_state.sharpness = 0.;
    measure(positions);
    Parameterization_report& report = m_control.report();
    report.average_energy = m_state.summary.average();
    report.largest_energy = m_state.summary.maximum_energy();
    report.seconds_for_optimization = m_control.lap();
  }

  static bool is_settled(double value, double last_value, double tolerance)
  {
    return std::abs(value - last_value) <= tolerance * last_value;
  }

  // the radius in the unit of the mesh, kept where its powers are finite
  double scaled_radius() const { return (std::min)((std::max)(m_mesh.scaled_radius(m_state.radius), 1e-50), 1e50); }

  const Indexed_mesh& m_mesh;
  Block_coordinate_descent<Energy, Step> m_descent;
  Sharpness_rule m_sharpness_rule;
  Radius_chooser& m_radius_chooser;
  Descent_settings m_settings;
  Run_control& m_control;
  Execution m_execution;
  std::size_t m_max_focus;      // vertices
  std::size_t m_next_focus = 0; // the first sweep that may have one
  State m_state;
};

// Defined out of the class and so not inline: `extern template class Descent_loop<...>` spares a program that maps in
// several files the time to compile it in each.

template <class Energy, class Step>
Descent_loop<Energy, Step>::Descent_loop(const Indexed_mesh& mesh, const Energy& energy, const Step& step,
                                         const Sharpness& sharpness, Radius_chooser& radius,
                                         const Descent_settings& settings, Run_control& control, Execution execution)
  : m_mesh(mesh)
  , m_descent(Face_energy<Energy>(energy), step, execution)
  , m_sharpness_rule(sharpness)
  , m_radius_chooser(radius)
  , m_settings(settings)
  , m_control(control)
  , m_execution(execution)
  , m_max_focus(mesh.number_of_vertices() / min_focus_sweeps)
{
  m_descent.assign(mesh.rings(), Independent_sets(mesh.rings()), mesh.points(), std::vector<double>(), Rest_limits());
}

template <class Energy, class Step>
Descent_loop<Energy, Step>::~Descent_loop() = default;

template <class Energy, class Step>
double Descent_loop<Energy, Step>::run(std::vector<Vector_3d>& positions, std::size_t max_sweeps)
{
  Parameterization_report& report = m_control.report();
  start(positions);
  report.stop_reason = ITERATION_LIMIT;
  bool has_phases = true; // whether the radius policy may have further ones
  for(std::size_t i = 0; i < max_sweeps; ++i)
  {
    const State last = m_state;
    const bool was_final = i > 0 && m_sharpness_rule.is_final();

    choose_radius(i == 0);
    choose_sharpness(i);
    sweep(positions, i);
    measure(positions);

    const double energy = m_state.summary.objective();
    m_control.after_iteration(i + 1, energy, m_state.radius);
    if(!m_control.go_further(i + 1, energy))
      break;
    if(was_final && has_converged(last))
    {
      has_phases = m_radius_chooser.next_phase();
      if(!has_phases)
      {
        report.stop_reason = CONVERGED;
        break;
      }
    }
  }
  if(m_control.is_stopped())
    report.stop_reason = m_control.stop_reason();
  while(has_phases) // a run that was ended early gets the last radius as well
    has_phases = m_radius_chooser.next_phase();
  choose_radius(true);
  finish(positions);
  return m_state.radius;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_LOOP_H
