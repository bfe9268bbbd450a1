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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_HIERARCHICAL_EMBEDDING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_HIERARCHICAL_EMBEDDING_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/internal/descent/Descent_loop.h>
#include <CGAL/Spherical_parameterization/internal/descent/Descent_settings.h>
#include <CGAL/Spherical_parameterization/internal/descent/Energy_summary.h>
#include <CGAL/Spherical_parameterization/internal/descent/Level_descent.h>
#include <CGAL/Spherical_parameterization/internal/descent/Objective.h>
#include <CGAL/Spherical_parameterization/internal/descent/Round_sphere.h>
#include <CGAL/Spherical_parameterization/internal/descent/Vertex_step.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Star_kernel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The control of a descent over a level, whose sweeps are sweeps over a level in the report of the run.
class Level_control : public Run_control
{
public:
  explicit Level_control(Run_control& run)
    : m_run(run)
  {}

  void after_iteration(std::size_t, double, double) override { ++m_run.report().number_of_level_iterations; }

private:
  bool visitor_goes_further(std::size_t, double energy) override { return m_run.go_further(0, energy); }

  Run_control& m_run;
};

// The plan for mapping a hierarchy to the unit sphere, see Level_descent: the coarsest level is a regular tetrahedron,
// new vertices are inserted into the kernels of their holes, and sweeps minimize the average energy (eq. 6) at the
// optimal radius: on a coarse level, a face may represent a whole extremity, and weighting the worst faces would
// misplace the extremities.
//
// With a sharpness, a descent minimizes the objective of that sharpness on the finest level with at most a quarter of the
// vertices, a sixteenth, and so on, unless it is small. The descent over the mesh then needs two thirds of the sweeps.
template <class Energy>
class Hierarchical_embedding
{
public:
  using Space = Round_sphere<Energy, Newton_step>;

  // The control must outlive this object.
  Hierarchical_embedding(const Face_energy<Energy>& energy, const Level_settings& settings, const Rest_limits& limits,
                         Run_control& control, const Execution& execution)
    : m_energy(energy)
    , m_settings(settings)
    , m_limits(limits)
    , m_control(control)
    , m_execution(execution)
  {
    if(settings.sharpness)
      m_settings.sharpness = Objective::initial_sharpness(*settings.sharpness);
    constexpr Descent_settings sufficient = {2e-3, 4e-3}; // the descent over the mesh goes on
    double &energy_tolerance = m_settings.descent.energy_tolerance,
           &radius_tolerance = m_settings.descent.radius_tolerance;
    energy_tolerance = (std::max)(energy_tolerance, sufficient.energy_tolerance);
    radius_tolerance = (std::max)(radius_tolerance, sufficient.radius_tolerance);
  }

  Space space() const { return Space(m_energy); }
  Newton_step step() const { return Newton_step(over_relaxation); }

  // Small levels, which determine the large features, are swept until they converge, at little cost. If all faces are
  // to have the same size, after other attempts have failed, the number of sweeps is decisive.
  Level_sweeps start_level(Space&, const Mesh_hierarchy::Level& level, bool is_finest)
  {
    if(is_finest && !m_settings.sweeps_finest_level)
      return {};
    if(level.vertices.size() < size_of_small_meshes && !m_limits.is_uniform)
      return {(std::max)(max_sweeps_to_converge, m_settings.sweeps_per_level), convergence_tolerance};
    if(m_has_descended)
      return {sweeps_after_descent, -1., false}; // the radius is that of the descent
    return {m_settings.sweeps_per_level, -1.};
  }

  // New vertices are inserted into the kernel.
  bool find_insertion_point(const Ring_hole&, const Mesh_hierarchy::Removed_vertex&, Vector_3d&) const { return false; }

  // After a descent, the first sweep decreases the energies around new vertices, where steps for a soft maximum would be
  // short, and the second one decreases the objective.
  Face_objective objective(std::size_t sweep) const
  {
    return m_has_descended && sweep > 0 ? m_objective : Face_objective();
  }

  // Minimizes the objective on some levels, which have been swept. The radius becomes that of the minimum.
  void finish_level(Block_coordinate_descent<Space, Newton_step>& descent, const Mesh_hierarchy& hierarchy,
                    std::size_t k, std::vector<Vector_3d>& positions, double& radius)
  {
    if(!m_settings.sharpness || !is_to_descend(hierarchy, k) || m_control.is_stopped())
      return;
    Level_control control(m_control);
    descent.set_step(Newton_step());
    Descent_loop<Energy, Newton_step> loop(descent, Length_unit(), *m_settings.sharpness, nullptr, m_settings.descent,
                                           control, m_execution);
    loop.minimize(positions, default_number_of_sweeps(positions.size()));
    descent.set_step(step());
    radius = loop.scaled_radius();
    m_objective = loop.objective();
    m_has_descended = true;
  }

  // The radius of minimum energy, regardless of the policy for the mesh itself.
  template <class Descent>
  void choose_radius(const Descent& descent, double& radius) const
  {
    constexpr int max_steps = 20;       // which change it by a factor of up to 400
    constexpr double short_step = 1e-3; // sweeps change the radius anyway
    for(int k = 0; k < max_steps; ++k)
    {
      const double step = descent.radius_step(radius, Face_objective()), next = radius * exponential(step);
      if(!is_positive_and_finite(next)) // for example if no radius is optimal
        return;
      radius = next;
      if(!(std::abs(step) > short_step))
        return;
    }
  }

  void start_sweep(Space&, std::size_t, bool) const {}

  // Whether the change of the average energy is negligible compared with the possible gain or, if that is less, with the
  // energy of an isometry: where a map is far from isometric, extremities still move while the energy hardly changes.
  bool has_settled(const Space& space, const Energy_summary& summary, double last_average, double tolerance) const
  {
    const double isometric_energy = space.energy()(2., 1.);
    return summary.has_settled(summary.average(), last_average, tolerance, isometric_energy,
                               isometric_energy > 0. ? isometric_energy : last_average);
  }

private:
  // Whether a level is the finest one with at most a quarter of the vertices, a sixteenth, and so on.
  static bool is_to_descend(const Mesh_hierarchy& hierarchy, std::size_t k)
  {
    const auto size = [&](std::size_t level) { return hierarchy.level(level).vertices.size(); };
    std::size_t bound = size(0);
    while(k > 0 && bound >= size(k - 1))
      bound /= 4;
    return k > 0 && size(k) <= bound && size(k) >= size_of_small_meshes;
  }

  static constexpr double over_relaxation = 1.5;         // with the 1.7 of descents, the largest energies are higher
  static constexpr std::size_t sweeps_after_descent = 2; // see objective()
  static constexpr std::size_t max_sweeps_to_converge = 300;
  static constexpr double convergence_tolerance = 4e-3; // see has_settled()

  Face_energy<Energy> m_energy;
  Level_settings m_settings;
  Rest_limits m_limits;
  Run_control& m_control;
  Execution m_execution;
  Face_objective m_objective; // of the last descent
  bool m_has_descended = false;
};

inline void set_tetrahedron(const Mesh_hierarchy& hierarchy, std::vector<Vector_3d>& positions)
{
  const std::size_t coarsest = hierarchy.number_of_levels() - 1;
  const std::vector<std::uint32_t>& vertices = hierarchy.level(coarsest).vertices;
  const Vertex_rings::Ring ring = hierarchy.rings(coarsest).ring(0);
  const double a = 1. / std::sqrt(3.);
  positions[vertices[0]] = {a, a, a};
  positions[vertices[ring[0]]] = {a, -a, -a};
  positions[vertices[ring[1]]] = {-a, a, -a};
  positions[vertices[ring[2]]] = {-a, -a, a};
}

// Maps a mesh to the unit sphere through a hierarchy. Faces may become so small that double precision cannot represent
// the map: because the energy allows it, such as a conformal one on long extremities, or because the surface itself has
// no room for them, for example where many vertices coincide. Then the map is computed again, with an increasing guard
// against the former and increasing limits for the latter, and finally without regard to the surface, with faces of
// equal size and an increasing number of sweeps. Returns whether there is a map.
template <class Energy>
bool embed_hierarchically(const Surface& mesh, const Energy& energy, const Level_settings& settings,
                          std::vector<Vector_3d>& positions, Run_control& control, Execution execution,
                          const std::vector<double>& shares = {})
{
  Parameterization_report& report = control.report();
  const auto embed = [&](double guard, Rest_limits limits, std::size_t sweeps_factor) {
    limits.height_without_shape = limits.min_height; // a needle on a coarse level may be as long as the surface
    // An attempt consumes the hierarchy; further attempts are rare.
    Mesh_hierarchy hierarchy(mesh.rings(), mesh.points(),
                             !shares.empty()             ? shares
                             : follows_curvature<Energy> ? curvature_masses(mesh.rings(), mesh.points())
                                                         : vertex_areas(mesh.rings(), mesh.points()),
                             control, execution);
    if(++report.number_of_attempts == 1)
    {
      report.number_of_levels = hierarchy.number_of_levels();
      report.seconds_for_hierarchy = control.lap();
    }
    Level_settings attempt = settings;
    attempt.sweeps_per_level *= sweeps_factor;
    if(report.number_of_attempts > 1)
      attempt.sharpness.reset(); // room for insertions comes first
    Hierarchical_embedding<Energy> plan(Face_energy<Energy>(energy, guard), attempt, limits, control, execution);
    positions.resize(mesh.number_of_vertices());
    set_tetrahedron(hierarchy, positions);
    return Level_descent(hierarchy, mesh.points(), limits, plan, control, execution).run(positions);
  };

  bool is_embedded = embed(0., Rest_limits(), 1);
  for(const double guard : {1e-10, 1e-8, 1e-6, 1e-4, 1e-2})
    is_embedded = is_embedded || embed(guard, {std::sqrt(std::sqrt(guard)), 0.1 * guard, false}, 1);
  Rest_limits without_shape;
  without_shape.is_uniform = true;
  for(const std::size_t sweeps_factor : {std::size_t(2), std::size_t(8), std::size_t(32)})
    is_embedded = is_embedded || embed(1., without_shape, sweeps_factor);
  report.seconds_for_embedding = control.lap();
  return is_embedded;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_HIERARCHICAL_EMBEDDING_H
