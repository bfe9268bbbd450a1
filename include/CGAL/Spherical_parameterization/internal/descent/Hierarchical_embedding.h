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
#include <CGAL/Spherical_parameterization/internal/descent/Level_descent.h>
#include <CGAL/Spherical_parameterization/internal/descent/Descent_settings.h>
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

  // The finest level is only swept if `sweeps_finest_level`.
  Hierarchical_embedding(const Face_energy<Energy>& energy, std::size_t sweeps_per_level, bool sweeps_finest_level,
                         bool is_uniform)
    : m_energy(energy)
    , m_sweeps_per_level(sweeps_per_level)
    , m_sweeps_finest_level(sweeps_finest_level)
    , m_is_uniform(is_uniform)
  {}

  Space space() const { return Space(m_energy); }
  Newton_step step() const { return Newton_step(over_relaxation); }

  // On small levels, where the large features settle, it takes as many sweeps as it takes, at little cost. If all faces
  // are to be alike, after other attempts have failed, more sweeps are what makes the difference.
  Level_sweeps start_level(Space&, const Mesh_hierarchy::Level& level, bool is_finest)
  {
    if(is_finest && !m_sweeps_finest_level)
      return {};
    if(level.vertices.size() < size_of_small_meshes && !m_is_uniform)
      return {(std::max)(max_sweeps_to_settle, m_sweeps_per_level), settled_change};
    return {m_sweeps_per_level, -1.};
  }

  // The kernel is the place.
  bool find_place(const Ring_hole&, const Mesh_hierarchy::Removed_vertex&, Vector_3d&) const { return false; }

  // The radius of the lowest energy, whatever the policy of the mesh itself.
  template <class Descent>
  void choose_radius(const Descent& descent, double& radius) const
  {
    constexpr int max_steps = 20;       // which change it by a factor of 400
    constexpr double short_step = 1e-3; // sweeps change it anyway
    for(int k = 0; k < max_steps; ++k)
    {
      const double step = descent.radius_step(radius, Face_objective()), next = radius * exponential(step);
      if(!is_positive_and_finite(next)) // as where there is no best one
        return;
      radius = next;
      if(!(std::abs(step) > short_step))
        return;
    }
  }

  void start_sweep(Space&, std::size_t, bool) const {}
  bool may_end(const Space&) const { return true; }

private:
  static constexpr double over_relaxation = 1.5; // less than on the mesh: with its 1.7, the largest energies end higher
  static constexpr std::size_t max_sweeps_to_settle = 300;
  static constexpr double settled_change = 1e-4; // of the average energy, see Energy_summary::has_settled()

  Face_energy<Energy> m_energy;
  std::size_t m_sweeps_per_level;
  bool m_sweeps_finest_level, m_is_uniform;
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
bool embed_hierarchically(const Surface& mesh, const Energy& energy, std::size_t sweeps_per_level,
                          bool sweeps_finest_level, std::vector<Vector_3d>& positions, Run_control& control,
                          Execution execution, const std::vector<double>& shares = {})
{
  Parameterization_report& report = control.report();
  const auto embed = [&](double guard, Rest_limits limits, std::size_t sweeps_factor) {
    limits.height_without_shape = limits.min_height; // a needle on a coarse level may be as long as the surface
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
    Hierarchical_embedding<Energy> plan(Face_energy<Energy>(energy, guard), sweeps_factor * sweeps_per_level,
                                        sweeps_finest_level, limits.is_uniform);
    positions.resize(mesh.number_of_vertices());
    place_tetrahedron(hierarchy, positions);
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
