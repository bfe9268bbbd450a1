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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONIC_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONIC_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/Dirichlet_energy.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Laplacian_system.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/center_mass.h>
#include <CGAL/Spherical_parameterization/internal/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/vertex_areas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Lowers the harmonic energy of a map to the unit sphere. Where it is least, the Laplacian at every vertex is normal to
// the sphere: L u = 2 share(u) u, see Dirichlet_energy. This is solved as a fixed point: with the right-hand side from
// the last map, a linear system with the one matrix L gives the next map, up to the projection to the sphere. Each step
// leaves about a third of the error of the lowest frequency. As the right-hand side nearly vanishes where limbs are
// shrunk to a small place, limbs are solved as well as in the plane at once.
//
// The energy alone would be least for a map to one point. So after each step a Moebius transformation, which changes a
// conformal map to another one, brings the centre of the area of the surface back to the centre of the sphere.
template <class SolverTraits, class ConcurrencyTag>
class Spherical_harmonic_map
{
public:
  // `weights` are those of the edges in the order of the corners of the mesh. If `is_guarded`, steps that would turn a
  // face over are shortened.
  Spherical_harmonic_map(const Indexed_mesh& mesh, const std::vector<double>& weights, bool is_guarded)
    : m_mesh(mesh)
    , m_weights(weights)
    , m_energy(mesh.rings(), weights)
    , m_is_guarded(is_guarded)
    , m_areas(vertex_masses(mesh.rings(), mesh.points()))
    , m_shares(m_areas.size())
  {}

  // Lowers the energy of `positions`; returns false if the linear system cannot be solved.
  template <class RunControl>
  bool run(std::vector<Vector_3d>& positions, std::size_t most_iterations, RunControl& control)
  {
    Parameterization_report& report = control.report();
    double energy = m_energy(positions, m_shares);
    report.initial_energy = m_lowest_energy = energy;
    report.stop_reason = ITERATION_LIMIT;
    if(!m_system.factor(m_mesh.rings(), m_weights, [](std::uint32_t v) { return v == 0; }))
      return false;
    std::vector<Vector_3d> target, candidate(positions.size());
    for(std::size_t i = 0; i < most_iterations; ++i)
    {
      if(!find_target(positions, target))
        return false;
      const double last_energy = energy;
      double t = 1.;
      bool is_found = false;
      for(int halving = 0; halving < most_halvings && !is_found; ++halving, t *= 0.5)
        is_found = move(positions, target, t, energy, candidate);
      if(!is_found)
      {
        report.stop_reason = OBSTRUCTED;
        break;
      }
      positions.swap(candidate);
      ++report.number_of_average_iterations;
      control.visitor().after_iteration(i + 1, energy, 1.);
      if(!control.go_further(i + 1, energy))
        break;
      if(std::abs(energy - last_energy) < tolerance * energy)
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
  static constexpr double tolerance = 1e-9;    // of the energy; positions may go on turning around the centre together
  static constexpr double largest_rise = 1e-4; // above the lowest energy so far: the transformation may cost a little
  static constexpr int most_halvings = 8;

  // The next map in space. What is missing for the sum of the right-hand sides to vanish is taken in proportion to the
  // shares, so that limbs do not feel it.
  bool find_target(const std::vector<Vector_3d>& positions, std::vector<Vector_3d>& target)
  {
    const Vector_3d excess = center_of_mass(positions, m_shares);
    target.resize(positions.size());
    for(std::size_t v = 0; v < target.size(); ++v)
      target[v] = (2. * m_shares[v]) * (positions[v] - excess);
    if(!m_system.solve(target))
      return false;
    const Vector_3d center = center_of_mass(target, m_areas);
    for(Vector_3d& x : target)
      x = x - center;
    return true;
  }

  // Goes the part t of the way; returns whether the map there is acceptable, and if so, sets the energy.
  bool move(const std::vector<Vector_3d>& positions, const std::vector<Vector_3d>& target, double t, double& energy,
            std::vector<Vector_3d>& candidate)
  {
    const auto is_admissible = [&](const std::vector<Vector_3d>& p) {
      return !m_is_guarded || are_safely_positive(m_mesh.rings(), p);
    };
    for(std::size_t v = 0; v < positions.size(); ++v)
      candidate[v] = normalized(t < 1. ? (1. - t) * positions[v] + t * target[v] : target[v]);
    if(!is_admissible(candidate))
      return false;
    center_mass(candidate, m_areas, is_admissible);
    const double candidate_energy = m_energy(candidate, m_shares);
    if(!(candidate_energy < (1. + largest_rise) * m_lowest_energy))
      return false;
    energy = candidate_energy;
    m_lowest_energy = (std::min)(m_lowest_energy, energy);
    return true;
  }

  const Indexed_mesh& m_mesh;
  const std::vector<double>& m_weights;
  Dirichlet_energy<ConcurrencyTag> m_energy;
  bool m_is_guarded;
  std::vector<double> m_areas;  // of the vertices
  std::vector<double> m_shares; // of the vertices in the energy of the last map
  double m_lowest_energy = 0.;
  Laplacian_system<SolverTraits> m_system;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONIC_MAP_H
