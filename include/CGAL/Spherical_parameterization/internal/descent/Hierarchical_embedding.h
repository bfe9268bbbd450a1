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

#include <CGAL/Spherical_parameterization/Optimal_radius_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
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
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// How a hierarchy is mapped to the unit sphere: a tetrahedron is made regular, new vertices go into the kernels of their
// holes, and on every level the energy is lowered at its best radius; see Level_descent.
template <class Energy>
class Hierarchical_embedding
{
public:
  using Space = Round_sphere<Energy, Newton_step>;

  // The finest of the levels has `n_vertices`. It is only swept if `sweeps_finest_level`.
  Hierarchical_embedding(std::size_t n_vertices, const Face_energy<Energy>& energy, const Sharpness& sharpness,
                         std::size_t sweeps_per_level, bool sweeps_finest_level, bool is_uniform)
    : m_n_vertices(n_vertices)
    , m_energy(energy)
    , m_sharpness_rule(sharpness)
    , m_sweeps_per_level(sweeps_per_level)
    , m_sweeps_finest_level(sweeps_finest_level)
    , m_is_uniform(is_uniform)
  {}

  Space space() const { return Space(m_energy); }

  Level_sweeps start_level(Space&, const Mesh_hierarchy::Level& level, bool is_finest)
  {
    if(is_finest && !m_sweeps_finest_level)
      return {};
    const std::size_t n = level.vertices.size();
    const bool is_full = is_finest || needs_all_sweeps(n);
    const std::size_t n_brief_sweeps = (m_sweeps_per_level + 3) / (is_left_to_descent(n) ? 8 : 4);
    return {is_full ? number_of_sweeps(n) : n_brief_sweeps, ends_when_settled(n) ? settled_change : -1.,
            is_finest ? Newton_step() : Newton_step::on_coarse_levels()};
  }

  // The kernel is the place.
  bool find_place(const Ring_hole&, const Mesh_hierarchy::Removed_vertex&, Vector_3d&) const { return false; }

  // The radius of the lowest energy, whatever the policy of the mesh itself, and the sharpness of the level.
  Face_objective choose_objective(std::size_t n_vertices, std::size_t sweep, const Energy_summary& summary,
                                  const Face_range_3& faces, double& radius)
  {
    const double best = m_energy.is_guarded() ? Optimal_radius_3()(m_energy, faces, radius)
                                              : Optimal_radius_3()(m_energy.energy(), faces, radius);
    if(is_positive_and_finite(best))
      radius = best;
    return Face_objective(sharpness_on_level(n_vertices, sweep, summary));
  }

  void start_sweep(Space&, std::size_t, bool) const {}
  bool may_end(const Space&) const { return true; }

private:
  // A level that has hardly more vertices than the last one that was swept in full is only swept until its new vertices
  // have settled.
  bool needs_all_sweeps(std::size_t n_vertices)
  {
    const std::size_t doubled_ratio = is_left_to_descent(n_vertices) ? 6 : 3;
    const bool result = n_vertices < min_brief_level || 2 * n_vertices >= doubled_ratio * m_size_of_last_full_level;
    if(result)
      m_size_of_last_full_level = n_vertices;
    return result;
  }

  // Large levels are swept less if a descent over the mesh follows: its smooth steps do what sweeps over them would.
  bool is_left_to_descent(std::size_t n_vertices) const
  {
    return !m_sweeps_finest_level && n_vertices >= min_left_level;
  }

  // The sharpness of a sweep over a level, which may be the mesh itself.
  double sharpness_on_level(std::size_t n_vertices, std::size_t sweep, const Energy_summary& summary)
  {
    if(n_vertices == m_n_vertices)
      return m_sharpness_rule.next(sweep, summary.average(), summary.maximum_energy());
    if(n_vertices < min_sharp_level)
      return 0.;
    if(n_vertices < min_nearly_finest_level || 2 * n_vertices < m_n_vertices)
      return m_sharpness_rule.on_coarse_level(summary.maximum_energy());
    return m_sharpness_rule.next(0, summary.average(), summary.maximum_energy());
  }

  // Coarse levels are swept more often: there the large features find their places, at little cost. On the coarsest
  // they get the time that they need, which may be short; see Level_descent.
  std::size_t number_of_sweeps(std::size_t n_vertices) const
  {
    if(ends_when_settled(n_vertices))
      return max_sweeps_to_settle * m_sweeps_per_level;
    const double factor = std::sqrt(2000. / static_cast<double>(n_vertices));
    return static_cast<std::size_t>(static_cast<double>(m_sweeps_per_level) * (std::min)((std::max)(factor, 1.), 3.));
  }

  // Where all faces are to be alike, after other attempts have failed, more sweeps are what makes the difference.
  bool ends_when_settled(std::size_t n_vertices) const { return n_vertices < min_brief_level && !m_is_uniform; }

  // Levels with fewer vertices follow the average energy (eq. 6), whatever the sharpness. Where a face stands for a
  // whole extremity, to fight the worst one throws the extremities into disorder, from which the finer levels do not recover.
  static constexpr std::size_t min_sharp_level = 300;

  // Levels with at least so many vertices, and half of those of the mesh, follow the worst faces as the mesh itself
  // will: they leave to it what is near to where it ends. On smaller levels the average pays for it.
  static constexpr std::size_t min_nearly_finest_level = 2500;

  // Levels with fewer vertices are all swept until the extremities have found their places: until the average energy changes
  // by no more than this, see Energy_summary::has_settled(), from one measurement to the next, or so many times as often as
  // others. The share is as small as it is for the sake of conformal maps, whose areas go on changing at
  // hardly any gain of energy.
  static constexpr std::size_t min_brief_level = 500;
  static constexpr std::size_t min_left_level = 2000;
  static constexpr double settled_change = 1e-5;
  static constexpr std::size_t max_sweeps_to_settle = 10;

  std::size_t m_n_vertices;
  Face_energy<Energy> m_energy;
  Sharpness_rule m_sharpness_rule;
  std::size_t m_sweeps_per_level;
  bool m_sweeps_finest_level, m_is_uniform;
  std::size_t m_size_of_last_full_level = 0;
};

inline void place_tetrahedron(const Mesh_hierarchy& hierarchy, std::vector<Vector_3d>& positions)
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

// Maps a mesh to the unit sphere through a hierarchy. It may happen that faces get so small that doubles cannot hold
// the map: because the energy lets them, as a conformal one does on long extremities, or because the surface itself has no
// room for them, as where many vertices share one place. Then it is tried again with a growing guard against the former
// and growing limits of the latter, and in the end without regard to the surface, each face having the same room, with
// more and more sweeps. Returns whether there is a map. The finest level is only swept if `sweeps_finest_level`, as the
// levels are.
template <class Energy>
bool embed_hierarchically(const Surface& mesh, const Energy& energy, const Sharpness& sharpness,
                          std::size_t sweeps_per_level, bool sweeps_finest_level, std::vector<Vector_3d>& positions,
                          Run_control& control, Execution execution, const std::vector<double>& shares = {})
{
  Parameterization_report& report = control.report();
  const auto embed = [&](double guard, const Sharpness& level_sharpness, const Rest_limits& limits,
                         std::size_t sweeps_factor) {
    // An attempt uses the hierarchy up, and a second one is rare.
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
    Hierarchical_embedding<Energy> plan(mesh.number_of_vertices(), Face_energy<Energy>(energy, guard), level_sharpness,
                                        sweeps_factor * sweeps_per_level, sweeps_finest_level, limits.is_uniform);
    positions.resize(mesh.number_of_vertices());
    place_tetrahedron(hierarchy, positions);
    return Level_descent(hierarchy, mesh.points(), limits, plan, control, execution).run(positions);
  };

  bool is_embedded = embed(0., sharpness, Rest_limits(), 1);
  for(const double guard : {1e-10, 1e-8, 1e-6, 1e-4, 1e-2})
    is_embedded =
        is_embedded || embed(guard, Sharpness::lowest_average(), {std::sqrt(std::sqrt(guard)), 0.1 * guard, false}, 1);
  Rest_limits without_shape;
  without_shape.is_uniform = true;
  for(const std::size_t sweeps_factor : {std::size_t(1), std::size_t(4), std::size_t(16)})
    is_embedded = is_embedded || embed(1., Sharpness::lowest_average(), without_shape, sweeps_factor);
  report.seconds_for_embedding = control.lap();
  return is_embedded;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_HIERARCHICAL_EMBEDDING_H
