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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_LEVEL_DESCENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_LEVEL_DESCENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/descent/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/descent/Energy_summary.h>
#include <CGAL/Spherical_parameterization/internal/descent/Vertex_step.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Star_kernel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <atomic>
#include <cstddef>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The number of sweeps over a level.
struct Level_sweeps
{
  std::size_t maximum = 0;
  double convergence_tolerance = 0.; // stops earlier if measurements differ by less; see the plan
  bool measures = true;              // whether faces are measured, for the radius and for convergence
};

// Extends a map through a hierarchy from the coarsest level to the finest one: on every level, the new vertices are
// inserted into their holes, all at once, and then all vertices of the level are swept.
//
// Since every vertex is swept before others are inserted next to it, insertion is robust: kernels stay as wide as the
// faces around them.
//
// A Plan determines the particulars of a map: the space, see Block_coordinate_descent, the step of a vertex, where a
// new vertex is inserted, the number of sweeps over a level and what they minimize, the radius, and what else is done on
// a level.
template <class Plan>
class Level_descent
{
public:
  Level_descent(Mesh_hierarchy& hierarchy, const std::vector<Vector_3d>& points, const Rest_limits& limits, Plan& plan,
                Run_control& control, Execution execution)
    : m_hierarchy(hierarchy)
    , m_points(points)
    , m_limits(limits)
    , m_plan(plan)
    , m_control(control)
    , m_execution(execution)
    , m_descent(plan.space(), plan.step(), execution)
    , m_kernels(execution, Star_kernel())
  {}

  // Given the positions of the vertices of the coarsest level, computes those of all others. The report then has the
  // stop reason of the finest level, if it was swept. Returns false if a kernel has become too narrow for double
  // precision. Levels of the hierarchy that have been mapped are dropped, because the finer ones need the memory. The
  // descent may end at another level, from which another descent can continue.
  bool run(std::vector<Vector_3d>& positions, std::size_t last_level = 0)
  {
    const std::size_t n_levels = m_hierarchy.number_of_levels();
    if(n_levels > 1)
      m_descent.reserve(m_hierarchy.level(1).vertices.size());
    for(std::size_t k = n_levels; k-- > last_level;)
    {
      const Mesh_hierarchy::Level& level = m_hierarchy.level(k);
      std::vector<Vector_3d> local = level.gathered(positions);
      const Level_sweeps sweeps = m_plan.start_level(m_descent.space(), level, k == last_level);
      if(!insert_vertices(level, m_hierarchy.rings(k), local))
        return false;
      const bool has_settled = sweeps.maximum > 0 && relax(level, m_hierarchy.rings(k), local, sweeps);
      if(k == 0 && sweeps.maximum > 0)
        m_control.report().stop_reason = has_settled ? CONVERGED : ITERATION_LIMIT;
      m_plan.finish_level(m_descent, m_hierarchy, k, local, m_radius);
      for(std::size_t v = 0; v < local.size(); ++v)
        positions[level.vertices[v]] = local[v];
      m_control.on_level(local.size());
      if(k > last_level)
        m_hierarchy.drop_coarsest();
    }
    return true;
  }

private:
  bool insert_vertices(const Mesh_hierarchy::Level& level, const Vertex_rings& rings, std::vector<Vector_3d>& local)
  {
    constexpr std::size_t block_size = 16; // levels are small, as in Mesh_hierarchy
    std::atomic<bool> is_complete(true);
    for_each_block(m_execution, 0, level.removed.size(), block_size, [&](std::size_t begin, std::size_t end) {
      Star_kernel& kernel = m_kernels.local();
      for(std::size_t k = begin; k < end; ++k)
      {
        const Mesh_hierarchy::Removed_vertex& removed = level.removed[k];
        const Ring_hole hole = {local, rings.ring(removed.vertex), removed.target};
        Vector_3d& position = local[removed.vertex];
        if(!m_plan.find_insertion_point(hole, removed, position) && !kernel.find_point(hole, position))
          is_complete = false;
      }
    });
    return is_complete;
  }

  // Sweeps over a level, and returns whether it has converged. A run that is stopped sweeps it once, because vertices
  // must be inserted into swept levels.
  bool relax(const Mesh_hierarchy::Level& level, const Vertex_rings& rings, std::vector<Vector_3d>& local,
             const Level_sweeps& sweeps)
  {
    constexpr std::size_t sweeps_per_measurement = 5; // measuring takes a fifth of the time of a sweep
    const std::vector<Vector_3d> points = level.gathered(m_points);
    std::vector<double> densities;
    Independent_sets sets;
    const auto find_densities = [&] {
      if(!m_limits.is_uniform)
        densities = vertex_densities(rings, points, level.areas);
    };
    run_both(
        m_execution, [&] { sets = Independent_sets(rings); }, find_densities); // each is sequential
    m_descent.assign(rings, sets, points, densities, m_limits);
    sets = Independent_sets();
    double last_average = 0.;
    for(std::size_t i = 0; i < sweeps.maximum; ++i)
    {
      if(sweeps.measures && i % sweeps_per_measurement == 0)
      {
        const Energy_summary summary = m_descent.measure(local, m_radius, Face_objective());
        m_plan.choose_radius(m_descent, m_radius);
        if(i > 0 && m_plan.has_settled(m_descent.space(), summary, last_average, sweeps.convergence_tolerance))
          return true;
        last_average = summary.average();
      }
      if(!m_control.go_further(0, last_average) && i > 0)
        break;
      m_plan.start_sweep(m_descent.space(), i, i + 1 == sweeps.maximum);
      m_descent.sweep(local, m_radius, m_plan.objective(i));
      ++m_control.report().number_of_level_iterations;
    }
    return false;
  }

  Mesh_hierarchy& m_hierarchy;
  const std::vector<Vector_3d>& m_points;
  Rest_limits m_limits;
  Plan& m_plan;
  Run_control& m_control;
  Execution m_execution;
  Block_coordinate_descent<typename Plan::Space, Newton_step> m_descent; // on the current level
  Per_thread<Star_kernel> m_kernels;
  double m_radius = 1.; // of the sphere on which the energies are evaluated
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_LEVEL_DESCENT_H
