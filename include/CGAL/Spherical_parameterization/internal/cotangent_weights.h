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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COTANGENT_WEIGHTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COTANGENT_WEIGHTS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The least weight of an edge where all have to be positive: an edge opposite to two right angles has 0.
constexpr double least_positive_weight = 0.01;

// The cotangent weight of every edge, half the sum of the cotangents of the two angles opposite to it, in the order of
// the corners of `rings`: that of the edge (v, ring[j]) at rings.offset(v) + j. No weight is below `least_weight`.
//
// The two copies of a weight are equal bit by bit.
inline std::vector<double> cotangent_weights(const Vertex_rings& rings, const std::vector<Vector_3d>& points,
                                             double least_weight)
{
  std::vector<double> weights(rings.number_of_corners());
  const auto opposite_cotangent = [&](std::uint32_t v, std::uint32_t p, std::uint32_t q) {
    const Rest_triangle rest = Rest_triangle::from_points(points[v], points[p], points[q]);
    return rest.opposite_2 / rest.inverse_area;
  };
  for(std::uint32_t v = 0; v < rings.number_of_vertices(); ++v)
  {
    const Vertex_rings::Ring ring = rings.ring(v);
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      const std::uint32_t w = ring[j];
      if(w < v)
        continue;
      const std::uint32_t left = ring.around(j + 1), right = ring.around(j + ring.size() - 1);
      const double weight = 0.5 * (opposite_cotangent(v, w, left) + opposite_cotangent(w, v, right));
      const Vertex_rings::Ring other = rings.ring(w);
      const auto back = static_cast<std::size_t>(std::find(other.begin(), other.end(), v) - other.begin());
      weights[rings.offset(v) + j] = weights[rings.offset(w) + back] = (std::max)(weight, least_weight);
    }
  }
  return weights;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COTANGENT_WEIGHTS_H
