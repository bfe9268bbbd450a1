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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_HIERARCHICAL_EMBEDDING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_HIERARCHICAL_EMBEDDING_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Optimal_radius_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/internal/levels/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/levels/Independent_sets.h>
#include <CGAL/Spherical_parameterization/internal/levels/Measured_faces.h>
#include <CGAL/Spherical_parameterization/internal/levels/Sharpness_rule.h>
#include <CGAL/Spherical_parameterization/internal/levels/Star_energy.h>
#include <CGAL/Spherical_parameterization/internal/levels/Vertex_step.h>
#include <CGAL/Spherical_parameterization/internal/levels/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/levels/Star_kernel.h>
#include <CGAL/Spherical_parameterization/internal/surface/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/surface/face_weights.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/run/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Maps a hierarchy to the unit sphere from the coarsest level up: the tetrahedron is made regular; on every level, the
// vertices that are new are put into the kernels of their holes, all at once, and then all vertices of the level are
// swept.
//
// That every vertex has been swept before others are inserted next to it is what makes the insertion robust: kernels
// stay as wide as the faces around them.
template <class Energy>
class Hierarchical_embedding
{
public:
  Hierarchical_embedding(Mesh_hierarchy& hierarchy, const std::vector<Vector_3d>& points,
                         const Face_energy<Energy>& energy, const Sharpness& sharpness, std::size_t sweeps_per_level,
                         const Rest_limits& limits, Run_control& control, Execution execution)
    : m_hierarchy(hierarchy)
    , m_points(points)
    , m_energy(energy)
    , m_sharpness_rule(sharpness)
    , m_sweeps_per_level(sweeps_per_level)
    , m_limits(limits)
    , m_control(control)
    , m_execution(execution)
    , m_descent(energy, Newton_step::on_coarse_levels(), execution)
    , m_kernels(execution, Star_kernel())
  {}

  // Computes the positions of all vertices of the finest level, which itself is only swept if `sweeps_finest_level`;
  // the report then says why that has ended.
  // Returns false if a kernel has become too narrow for doubles. The levels of the hierarchy that have been mapped are
  // dropped, as the finer ones need the memory.
  bool run(std::vector<Vector_3d>& positions, bool sweeps_finest_level)
  {
    positions.resize(m_points.size());
    if(m_hierarchy.number_of_levels() > 1)
      m_descent.reserve(m_hierarchy.level(1).vertices.size());
    const std::size_t coarsest = m_hierarchy.number_of_levels() - 1;
    place_tetrahedron(m_hierarchy.level(coarsest), m_hierarchy.rings(coarsest), positions);
    for(std::size_t k = coarsest + 1; k-- > 0;)
    {
      const Mesh_hierarchy::Level& level = m_hierarchy.level(k);
      std::vector<Vector_3d> local = level.gathered(positions);
      if(!insert_vertices(level, m_hierarchy.rings(k), local))
        return false;
      if(k > 0)
        relax(level, m_hierarchy.rings(k), local, needs_all_sweeps(local.size()));
      else if(sweeps_finest_level)
      {
        m_descent.set_step(Newton_step());
        m_control.report().stop_reason = relax(level, m_hierarchy.rings(k), local, true) ? CONVERGED : ITERATION_LIMIT;
      }
      for(std::size_t v = 0; v < local.size(); ++v)
        positions[level.vertices[v]] = local[v];
      m_control.on_level(local.size());
      m_hierarchy.drop_coarsest();
    }
    return true;
  }

private:
  static constexpr std::size_t block_size = 16;

  static void place_tetrahedron(const Mesh_hierarchy::Level& level, const Vertex_rings& rings,
                                std::vector<Vector_3d>& positions)
  {
    const double a = 1. / std::sqrt(3.);
    const Vertex_rings::Ring ring = rings.ring(0);
    positions[level.vertices[0]] = {a, a, a};
    positions[level.vertices[ring[0]]] = {a, -a, -a};
    positions[level.vertices[ring[1]]] = {-a, a, -a};
    positions[level.vertices[ring[2]]] = {-a, -a, a};
  }

  bool insert_vertices(const Mesh_hierarchy::Level& level, const Vertex_rings& rings, std::vector<Vector_3d>& local)
  {
    std::atomic<bool> is_complete(true);
    for_each_block(m_execution, 0, level.removed.size(), block_size, [&](std::size_t begin, std::size_t end) {
      Star_kernel& kernel = m_kernels.local();
      for(std::size_t k = begin; k < end; ++k)
      {
        const Mesh_hierarchy::Removed_vertex& removed = level.removed[k];
        if(!kernel.find_point(Ring_hole{local, rings.ring(removed.vertex), removed.target}, local[removed.vertex]))
          is_complete = false;
      }
    });
    return is_complete;
  }

  // A level that has hardly more vertices than the last one that was swept in full is only swept until its new vertices
  // have settled.
  bool needs_all_sweeps(std::size_t n_vertices)
  {
    const bool result = n_vertices < min_brief_level || 2 * n_vertices >= 3 * m_size_of_last_full_level;
    if(result)
      m_size_of_last_full_level = n_vertices;
    return result;
  }

  // Sweeps over a level, and returns whether it has settled. A run that is stopped sweeps it once, as vertices are to
  // be inserted into what has been swept.
  bool relax(const Mesh_hierarchy::Level& level, const Vertex_rings& rings, std::vector<Vector_3d>& local, bool is_full)
  {
    const std::vector<Vector_3d> points = level.gathered(m_points);
    std::vector<double> densities;
    std::unique_ptr<const Independent_sets> sets; // g++ takes an optional for uninitialized, where there is one thread
    const auto find_densities = [&] {
      if(!m_limits.is_uniform)
        densities = vertex_densities(rings, points, level.areas);
    };
    run_both(
        m_execution, [&] { sets = std::make_unique<const Independent_sets>(rings); },
        find_densities); // each is sequential
    m_descent.assign(rings, *sets, points, densities, m_limits);
    sets.reset();
    const std::size_t n_sweeps = is_full ? number_of_sweeps(local.size()) : (m_sweeps_per_level + 3) / 4;
    double sharpness = 0., last_average = 0.;
    for(std::size_t i = 0; i < n_sweeps && (i == 0 || !m_control.is_stopped()); ++i)
    {
      if(i % sweeps_per_measurement == 0)
      {
        const Energy_summary summary = m_descent.measure(local, m_radius, Face_objective()).all();
        choose_radius();
        if(ends_when_settled(local.size()) && i > 0 &&
           std::abs(summary.average() - last_average) <= settled_change * summary.scale_of_changes(last_average))
          return true;
        last_average = summary.average();
        sharpness = sharpness_on_level(local.size(), i, summary);
        if(!m_control.go_further(0, summary.average()) && i > 0)
          break;
      }
      m_descent.sweep(local, m_radius, Face_objective(sharpness));
      ++m_control.report().number_of_level_iterations;
      m_control.check_clock();
    }
    return false;
  }

  // The radius of the lowest energy, whatever the policy of the mesh itself.
  void choose_radius()
  {
    const double radius = m_energy.is_guarded() ? Optimal_radius_3()(m_energy, m_descent.faces(), m_radius)
                                                : Optimal_radius_3()(m_energy.energy(), m_descent.faces(), m_radius);
    if(is_positive_and_finite(radius))
      m_radius = radius;
  }

  // The sharpness of a sweep over a level, which may be the mesh itself.
  double sharpness_on_level(std::size_t n_vertices, std::size_t sweep, const Energy_summary& summary)
  {
    if(n_vertices == m_points.size())
      return m_sharpness_rule.next(sweep, summary.average(), summary.maximum_energy());
    if(n_vertices < min_sharp_level)
      return 0.;
    if(n_vertices < min_nearly_finest_level || 2 * n_vertices < m_points.size())
      return m_sharpness_rule.on_coarse_level(summary.maximum_energy());
    return m_sharpness_rule.next(0, summary.average(), summary.maximum_energy());
  }

  // Coarse levels are swept more often: there the large features find their places, at little cost. On the coarsest
  // they get the time that they need, which may be short; see relax().
  std::size_t number_of_sweeps(std::size_t n_vertices) const
  {
    if(ends_when_settled(n_vertices))
      return max_sweeps_to_settle * m_sweeps_per_level;
    const double factor = std::sqrt(2000. / static_cast<double>(n_vertices));
    return static_cast<std::size_t>(static_cast<double>(m_sweeps_per_level) * (std::min)((std::max)(factor, 1.), 3.));
  }

  // Where all faces are to be alike, after other attempts have failed, more sweeps are what makes the difference.
  bool ends_when_settled(std::size_t n_vertices) const { return n_vertices < min_brief_level && !m_limits.is_uniform; }

  static constexpr std::size_t sweeps_per_measurement = 5;

  // Levels with fewer vertices follow the average energy (eq. 6), whatever the sharpness. Where a face stands for a
  // whole limb, to fight the worst one throws the limbs into disorder, from which the finer levels do not recover.
  static constexpr std::size_t min_sharp_level = 300;

  // Levels with at least so many vertices, and half of those of the mesh, follow the worst faces as the mesh itself
  // will: they leave to it what is near to where it ends. On smaller levels the average pays for it, a percent in
  // places.
  static constexpr std::size_t min_nearly_finest_level = 2500;

  // Levels with fewer vertices are all swept until the limbs have found their places: until the average energy changes
  // by no more than this share of Energy_summary::scale_of_changes() from one measurement to the next, or so many times
  // as often as others. The share is as small as it is for the sake of conformal maps, whose areas go on changing at
  // hardly any gain of energy.
  static constexpr std::size_t min_brief_level = 500;
  static constexpr double settled_change = 1e-5;
  static constexpr std::size_t max_sweeps_to_settle = 10;

  Mesh_hierarchy& m_hierarchy;
  const std::vector<Vector_3d>& m_points;
  Face_energy<Energy> m_energy;
  Sharpness_rule m_sharpness_rule;
  std::size_t m_sweeps_per_level;
  Rest_limits m_limits;
  Run_control& m_control;
  Execution m_execution;
  Block_coordinate_descent<Energy, Newton_step> m_descent; // on the level at hand
  Per_thread<Star_kernel> m_kernels;
  std::size_t m_size_of_last_full_level = 0;
  double m_radius = 1.; // of the sphere that the energies are taken on
};

// Maps a mesh to the unit sphere through a hierarchy. It may happen that faces get so small that doubles cannot hold
// the map: because the energy lets them, as a conformal one does on long limbs, or because the surface itself has no
// room for them, as where many vertices share one place. Then it is tried again with a growing guard against the former
// and growing limits of the latter, and in the end without regard to the surface, each face having the same room, with
// more and more sweeps. Returns whether there is a map. The finest level is only swept if `sweeps_finest_level`, as the
// levels are.
template <class Energy>
bool embed_hierarchically(const Indexed_mesh& mesh, const Energy& energy, const Sharpness& sharpness,
                          std::size_t sweeps_per_level, bool sweeps_finest_level, std::vector<Vector_3d>& positions,
                          Run_control& control, Execution execution)
{
  Parameterization_report& report = control.report();
  const auto embed = [&](double guard, const Sharpness& level_sharpness, const Rest_limits& limits,
                         std::size_t sweeps_factor) {
    // An attempt uses the hierarchy up, and a second one is rare.
    Mesh_hierarchy hierarchy =
        Mesh_hierarchy::build(mesh.rings(), mesh.points(),
                              Follows_curvature<Energy>::value ? curvature_masses(mesh.rings(), mesh.points())
                                                               : vertex_areas(mesh.rings(), mesh.points()),
                              execution);
    control.check_clock();
    if(++report.number_of_attempts == 1)
    {
      report.number_of_levels = hierarchy.number_of_levels();
      report.seconds_for_hierarchy = control.lap();
    }
    return Hierarchical_embedding<Energy>(hierarchy, mesh.points(), Face_energy<Energy>(energy, guard), level_sharpness,
                                          sweeps_factor * sweeps_per_level, limits, control, execution)
        .run(positions, sweeps_finest_level);
  };

  bool is_embedded = embed(0., sharpness, Rest_limits(), 1);
  for(const double guard : {1e-10, 1e-8, 1e-6, 1e-4, 1e-2})
    is_embedded =
        is_embedded || embed(guard, Sharpness::lowest_average(), {std::pow(guard, 0.25), 0.1 * guard, false}, 1);
  Rest_limits without_shape;
  without_shape.is_uniform = true;
  for(const std::size_t sweeps_factor : {std::size_t(1), std::size_t(4), std::size_t(16)})
    is_embedded = is_embedded || embed(1., Sharpness::lowest_average(), without_shape, sweeps_factor);
  report.seconds_for_embedding = control.lap();
  return is_embedded;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_HIERARCHICAL_EMBEDDING_H
