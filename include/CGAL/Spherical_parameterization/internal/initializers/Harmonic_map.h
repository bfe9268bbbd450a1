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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_HARMONIC_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_HARMONIC_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Laplacian_system.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Stereographic_embedding.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Run.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <CGAL/number_type_basic.h>

#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The discrete harmonic energy of a map u to the unit sphere, the sum of w |u_v - u_w|^2 / 2 over the edges, in units
// of the area of the sphere. With cotangent weights, it is 1 for a conformal map and larger for every other map, up to
// the discretization error. The weights are in the order of the corners of `rings`.
//
// Since |u_v - u_w|^2 = 2 u_v (u_v - u_w) on the sphere, the contribution of a vertex, half the sum over its edges,
// equals half the normal component of the Laplacian there; `shares` receives it, in the unit of the weights.
inline double dirichlet_energy(const Vertex_rings& rings, const std::vector<double>& weights,
                               const std::vector<Vector_3d>& u, std::vector<double>& shares, Execution execution)
{
  for_each_in_blocks(execution, 0, u.size(), usual_block_size, [&](std::size_t v) {
    const Vertex_rings::Ring ring = rings.ring(v);
    double sum = 0.;
    for(std::size_t j = 0; j < ring.size(); ++j)
      sum += weights[rings.offset(v) + j] * squared_length(u[ring[j]] - u[v]);
    shares[v] = 0.25 * sum;
  });
  return 0.25 / CGAL_PI * std::accumulate(shares.begin(), shares.end(), 0.);
}

// Minimizes the harmonic energy of a map to the unit sphere. At a minimum, the Laplacian at every vertex is normal to
// the sphere: L u = 2 share(u) u, see dirichlet_energy(). This is solved as a fixed point: with the right-hand side of
// the previous map, a linear system with the constant matrix L gives the next map, up to the projection to the sphere.
// Each step reduces the error of the lowest frequency to about a third. The right-hand side nearly vanishes where
// extremities are shrunk to a small region, so extremities converge in one step, as in the plane.
//
// The energy alone would be minimal for a map to one point. Therefore, after each step, a Moebius transformation, which
// preserves conformality, moves the center of the surface's area back to the center of the sphere.
class Harmonic_map
{
public:
  // If `has_to_be_bijective`, the weights of edges are made positive, and steps that would invert a face are shortened;
  // otherwise, the weights are the unmodified cotangents.
  Harmonic_map(const Surface& mesh, bool has_to_be_bijective, Execution execution)
    : m_mesh(mesh)
    , m_has_to_be_bijective(has_to_be_bijective)
    , m_execution(execution)
    , m_weights(cotangent_weights(mesh.rings(), mesh.points(),
                                  has_to_be_bijective ? min_positive_weight : std::numeric_limits<double>::lowest()))
    , m_masses(vertex_masses(mesh.rings(), mesh.points()))
    , m_shares(m_masses.size())
  {}

  // Required by lower_energy().
  static constexpr double tolerance = 1e-9;    // of the energy; all positions may keep rotating around the center
  static constexpr double max_increase = 1e-4; // above the lowest energy; the transformation may increase it
  static constexpr int max_halvings = 8;       // down to 1/128 of the distance to the solution

  const std::vector<double>& weights() const { return m_weights; }
  double energy_of(const std::vector<Vector_3d>& positions)
  {
    return dirichlet_energy(m_mesh.rings(), m_weights, positions, m_shares, m_execution);
  }
  double radius() const { return 1.; }

  // The next map in space. The right-hand sides are corrected so that their sum vanishes, in proportion to the
  // contributions of the vertices, so that extremities are not affected.
  template <class System>
  bool find_step(const std::vector<Vector_3d>& positions, System& system)
  {
    const Vector_3d excess = center_of_mass(positions, m_shares);
    m_target.resize(positions.size());
    for(std::size_t v = 0; v < m_target.size(); ++v)
      m_target[v] = (2. * m_shares[v]) * (positions[v] - excess);
    if(!system.solve(m_target))
      return false;
    const Vector_3d center = center_of_mass(m_target, m_masses);
    for(Vector_3d& x : m_target)
      x = x - center;
    return true;
  }

  bool move(const std::vector<Vector_3d>& positions, double t, std::vector<Vector_3d>& candidate) const
  {
    const auto is_allowed = [&](const std::vector<Vector_3d>& p) {
      return !m_has_to_be_bijective || are_safely_positive(m_mesh.rings(), p);
    };
    for(std::size_t v = 0; v < positions.size(); ++v)
      candidate[v] = normalized(t < 1. ? (1. - t) * positions[v] + t * m_target[v] : m_target[v]);
    if(!is_allowed(candidate))
      return false;
    center_mass(candidate, m_masses, is_allowed);
    return true;
  }

private:
  const Surface& m_mesh;
  bool m_has_to_be_bijective;
  Execution m_execution;
  std::vector<double> m_weights;   // of the edges
  std::vector<double> m_masses;    // of the vertices
  std::vector<double> m_shares;    // of the vertices in the energy of the last map
  std::vector<Vector_3d> m_target; // of the step
};

// Maps a mesh to the unit sphere with minimum harmonic energy, starting from the map through the plane.
template <class SolverTraits>
Error_code map_harmonically(Run& run, bool has_to_be_bijective, std::size_t max_rounds)
{
  if(const Error_code error = embed_stereographically<SolverTraits>(run, has_to_be_bijective))
    return error;
  return lower_energy<SolverTraits>(Harmonic_map(run.surface, has_to_be_bijective, run.execution), max_rounds, run);
}

#if defined(CGAL_SPHERICAL_PARAMETERIZATION_USE_LIBRARY) && defined(CGAL_EIGEN3_ENABLED)
extern template Error_code map_harmonically<Default>(Run&, bool, std::size_t);
#endif

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_HARMONIC_MAP_H
