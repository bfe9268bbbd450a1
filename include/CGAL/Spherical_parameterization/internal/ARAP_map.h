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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ARAP_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ARAP_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/ARAP_energy.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Laplacian_system.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/cotangent_weights.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Lowers the as-rigid-as-possible energy of a map to the sphere by local and global steps: rotations and radius are
// fitted, then all vertices are moved by the solution of a linear system with the Laplacian, which is factored once.
// Forces and movements are restricted to the tangents of the sphere, and a step that would raise the energy is
// shortened, so the energy always falls.
template <class SolverTraits, class ConcurrencyTag>
class ARAP_map
{
public:
  explicit ARAP_map(const Indexed_mesh& mesh)
    : m_mesh(mesh)
    , m_energy(mesh.rings(), mesh.points())
  {}

  // Lowers the energy of `positions` and sets the radius, in the caller's unit of length; returns false if the linear
  // system cannot be solved.
  template <class RunControl>
  bool run(std::vector<Vector_3d>& positions, double& radius, std::size_t most_iterations, RunControl& control)
  {
    Parameterization_report& report = control.report();
    const std::vector<double> weights =
        cotangent_weights(m_mesh.rings(), m_mesh.points(), std::numeric_limits<double>::lowest());
    Laplacian_system<SolverTraits> system;
    if(!system.factor(m_mesh.rings(), weights, [](std::uint32_t v) { return v == 0; }))
      return false;
    double energy = m_energy.fit(positions), scaled_radius = m_energy.radius();
    radius = scaled_radius * m_mesh.equal_area_radius();
    report.initial_energy = energy;
    report.stop_reason = ITERATION_LIMIT;
    std::vector<Vector_3d> step(positions.size()), candidate(positions.size());
    for(std::size_t i = 0; i < most_iterations; ++i)
    {
      m_energy.forces(positions, step);
      make_tangential(positions, step);
      if(!system.solve(step))
        return false;
      make_tangential(positions, step);
      double t = 1. / scaled_radius, next_energy = 0.;
      bool is_found = false;
      for(int halving = 0; halving < most_halvings && !is_found; ++halving, t *= 0.5)
      {
        for(std::size_t v = 0; v < positions.size(); ++v)
          candidate[v] = normalized(positions[v] + t * step[v]);
        next_energy = m_energy.fit(candidate);
        is_found = next_energy < energy;
      }
      if(!is_found)
      {
        report.stop_reason = next_energy - energy <= tolerance * energy ? CONVERGED : OBSTRUCTED;
        break;
      }
      const bool has_converged = energy - next_energy < tolerance * energy;
      positions.swap(candidate);
      energy = next_energy;
      scaled_radius = m_energy.radius();
      radius = scaled_radius * m_mesh.equal_area_radius();
      ++report.number_of_average_iterations;
      control.visitor().after_iteration(i + 1, energy, radius);
      if(!control.go_further(i + 1, energy))
        break;
      if(has_converged)
      {
        report.stop_reason = CONVERGED;
        break;
      }
    }
    if(control.stop_reason() != NOT_RUN)
      report.stop_reason = control.stop_reason();
    report.average_energy = energy;
    return true;
  }

private:
  static constexpr double tolerance = 1e-6; // of the energy
  static constexpr int most_halvings = 12;

  static void make_tangential(const std::vector<Vector_3d>& positions, std::vector<Vector_3d>& vectors)
  {
    for(std::size_t v = 0; v < positions.size(); ++v)
      vectors[v] = vectors[v] - dot(vectors[v], positions[v]) * positions[v];
  }

  const Indexed_mesh& m_mesh;
  ARAP_energy<ConcurrencyTag> m_energy;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ARAP_MAP_H
