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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASELINES_HARMONIC_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASELINES_HARMONIC_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/baselines/Laplacian_system.h>
#include <CGAL/Spherical_parameterization/internal/baselines/Stereographic_embedding.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/surface/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/run/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The discrete harmonic energy of a map to the unit sphere, the sum of w |u_v - u_w|^2 / 2 over the edges, in units of
// the area of the sphere: with cotangent weights, it is 1 for a conformal map and more for every other, up to the error
// of discretisation.
class Dirichlet_energy
{
public:
  // `weights` are those of the edges in the order of the corners of `rings`; both are referred to.
  Dirichlet_energy(const Vertex_rings& rings, const std::vector<double>& weights, Execution execution)
    : m_rings(rings)
    , m_weights(weights)
    , m_execution(execution)
  {}

  // Returns the energy. As |u_v - u_w|^2 = 2 u_v (u_v - u_w) on the sphere, the share of a vertex, half the sum over
  // its edges, is also half the normal part of the Laplacian there; `shares` gets it, in the unit of the weights.
  double operator()(const std::vector<Vector_3d>& u, std::vector<double>& shares) const
  {
    for_each_block(m_execution, 0, u.size(), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
      {
        const Vertex_rings::Ring ring = m_rings.ring(v);
        double sum = 0.;
        for(std::size_t j = 0; j < ring.size(); ++j)
          sum += m_weights[m_rings.offset(v) + j] * squared_length(u[ring[j]] - u[v]);
        shares[v] = 0.25 * sum;
      }
    });
    double sum = 0.;
    for(const double share : shares)
      sum += share;
    return 0.25 / CGAL_PI * sum;
  }

private:
  static constexpr std::size_t block_size = 1024;

  const Vertex_rings& m_rings;
  const std::vector<double>& m_weights;
  Execution m_execution;
};

// Lowers the harmonic energy of a map to the unit sphere. Where it is minimal, the Laplacian at every vertex is normal
// to the sphere: L u = 2 share(u) u, see Dirichlet_energy. This is solved as a fixed point: with the right-hand side
// from the last map, a linear system with the one matrix L gives the next map, up to the projection to the sphere. Each
// step leaves about a third of the error of the lowest frequency. As the right-hand side nearly vanishes where limbs
// are shrunk to a small place, limbs are solved as well as in the plane at once.
//
// The energy alone would be minimal for a map to one point. So after each step a Moebius transformation, which changes
// a conformal map to another one, brings the centre of the area of the surface back to the centre of the sphere.
template <class SolverTraits>
class Harmonic_map
{
public:
  // `weights` are those of the edges in the order of the corners of the mesh. If `keeps_bijective`, the map is
  // so all the way: steps that would turn a face over are shortened.
  Harmonic_map(const Indexed_mesh& mesh, const std::vector<double>& weights, bool keeps_bijective, Execution execution)
    : m_mesh(mesh)
    , m_weights(weights)
    , m_energy(mesh.rings(), weights, execution)
    , m_keeps_bijective(keeps_bijective)
    , m_masses(vertex_masses(mesh.rings(), mesh.points()))
    , m_shares(m_masses.size())
  {}

  // Lowers the energy of `positions`; returns false if the linear system cannot be solved.
  bool run(std::vector<Vector_3d>& positions, std::size_t max_iterations, Run_control& control)
  {
    Parameterization_report& report = control.report();
    double energy = m_energy(positions, m_shares);
    report.initial_energy = m_lowest_energy = energy;
    report.stop_reason = ITERATION_LIMIT;
    if(!m_system.factor(m_mesh.rings(), m_weights, [](std::uint32_t v) { return v == 0; }))
      return false;
    std::vector<Vector_3d> target, candidate(positions.size());
    for(std::size_t i = 0; i < max_iterations; ++i)
    {
      if(!find_target(positions, target))
        return false;
      const double last_energy = energy;
      double t = 1.;
      bool is_found = false;
      for(int halving = 0; halving < max_halvings && !is_found; ++halving, t *= 0.5)
        is_found = move(positions, target, t, energy, candidate);
      if(!is_found)
      {
        report.stop_reason = OBSTRUCTED;
        break;
      }
      positions.swap(candidate);
      ++report.number_of_average_iterations;
      control.after_iteration(i + 1, energy, 1.);
      if(!control.go_further(i + 1, energy))
        break;
      if(std::abs(energy - last_energy) < tolerance * energy)
      {
        report.stop_reason = CONVERGED;
        break;
      }
    }
    report.average_energy = energy;
    return true;
  }

private:
  static constexpr double tolerance = 1e-9; // of the energy; positions may go on turning around the centre together
  static constexpr double max_rise = 1e-4;  // above the lowest energy so far: the transformation may cost a little
  static constexpr int max_halvings = 8;

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
    const Vector_3d center = center_of_mass(target, m_masses);
    for(Vector_3d& x : target)
      x = x - center;
    return true;
  }

  // Goes the part t of the way; returns whether the map there is acceptable, and if so, sets the energy.
  bool move(const std::vector<Vector_3d>& positions, const std::vector<Vector_3d>& target, double t, double& energy,
            std::vector<Vector_3d>& candidate)
  {
    const auto is_admissible = [&](const std::vector<Vector_3d>& p) {
      return !m_keeps_bijective || are_safely_positive(m_mesh.rings(), p);
    };
    for(std::size_t v = 0; v < positions.size(); ++v)
      candidate[v] = normalized(t < 1. ? (1. - t) * positions[v] + t * target[v] : target[v]);
    if(!is_admissible(candidate))
      return false;
    center_mass(candidate, m_masses, is_admissible);
    const double candidate_energy = m_energy(candidate, m_shares);
    if(!(candidate_energy < (1. + max_rise) * m_lowest_energy))
      return false;
    energy = candidate_energy;
    m_lowest_energy = (std::min)(m_lowest_energy, energy);
    return true;
  }

  const Indexed_mesh& m_mesh;
  const std::vector<double>& m_weights;
  Dirichlet_energy m_energy;
  bool m_keeps_bijective;
  std::vector<double> m_masses; // of the vertices
  std::vector<double> m_shares; // of the vertices in the energy of the last map
  double m_lowest_energy = 0.;
  Laplacian_system<SolverTraits> m_system;
};

// Maps a mesh to the unit sphere with the minimum harmonic energy, starting through the plane. If the map has to be
// bijective, it is so all the way, and the weights of the edges are positive; if not, the weights are the cotangents
// as they are.
template <class SolverTraits>
Error_code map_harmonically(const Indexed_mesh& mesh, bool keeps_bijective, std::size_t max_iterations,
                            std::vector<Vector_3d>& positions, Run_control& control, Execution execution)
{
  control.on_initialization_begin(mesh.number_of_vertices());
  Stereographic_embedding<SolverTraits> embedding(mesh);
  if(!embedding.solve())
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  if(!embedding.project_bijectively(positions))
  {
    if(keeps_bijective)
      return ERROR_INSUFFICIENT_PRECISION;
    embedding.project(positions);
  }
  control.report().seconds_for_embedding = control.lap();
  control.on_initialization_end();

  const std::vector<double> weights = cotangent_weights(
      mesh.rings(), mesh.points(), keeps_bijective ? min_positive_weight : std::numeric_limits<double>::lowest());
  Harmonic_map<SolverTraits> map(mesh, weights, keeps_bijective, execution);
  if(!map.run(positions, max_iterations, control))
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  control.report().seconds_for_optimization = control.lap();
  control.on_optimization_end();
  return OK;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASELINES_HARMONIC_MAP_H
