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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DIRICHLET_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DIRICHLET_ENERGY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/for_each_block.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The discrete harmonic energy of a map to the unit sphere, the sum of w |u_v - u_w|^2 / 2 over the edges, in units of the area of
// the sphere: with cotangent weights, it is 1 for a conformal map and more for every other, up to the error of
// discretisation.
template <class ConcurrencyTag>
class Dirichlet_energy
{
public:
  // `weights` are those of the edges in the order of the corners of `rings`; both are referred to.
  Dirichlet_energy(const Vertex_rings& rings, const std::vector<double>& weights)
    : m_rings(rings)
    , m_weights(weights)
  {}

  // Returns the energy. As |u_v - u_w|^2 = 2 u_v (u_v - u_w) on the sphere, the share of a vertex, half the sum over its edges,
  // is also half the normal part of the Laplacian there; `shares` gets it, in the unit of the weights.
  double operator()(const std::vector<Vector_3d>& u, std::vector<double>& shares) const
  {
    for_each_block<ConcurrencyTag>(0, u.size(), block_size, [&](std::size_t begin, std::size_t end) {
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
    return 0.25 / 3.14159265358979323846 * sum;
  }

private:
  static constexpr std::size_t block_size = 1024;

  const Vertex_rings& m_rings;
  const std::vector<double>& m_weights;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DIRICHLET_ENERGY_H
