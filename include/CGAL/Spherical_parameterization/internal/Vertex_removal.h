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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERTEX_REMOVAL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERTEX_REMOVAL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The best way to remove one vertex from a mesh: by collapsing it into one of its neighbours, its target. The cost adds
// up how far the target lies from the planes of the faces at the vertex (the quadric error of these faces) and a small
// share of the length of the edge, so that flat parts are thinned out evenly; thin new faces and targets of high degree
// make it dearer.
class Vertex_removal
{
public:
  Vertex_removal() = default;

  // Finds the best target of vertex v. Only targets that keep the mesh a simplicial complex are considered (the link
  // condition). Whether two vertices of high degree are neighbours is looked up only if `is_exact`; otherwise they are
  // taken for neighbours, so that the time for a vertex is bounded.
  static Vertex_removal best(const Vertex_rings& rings, const std::vector<Vector_3d>& points, std::uint32_t v,
                             bool is_exact)
  {
    Vertex_removal result;
    const Vertex_rings::Ring ring = rings.ring(v);
    const std::uint32_t d = static_cast<std::uint32_t>(ring.size());
    if(d > highest_degree)
      return result;

    std::array<Vector_3d, highest_degree> e, normal; // edges from v; normals of its faces, twice the area long
    std::array<double, highest_degree> area;
    double total_area = 0.;
    for(std::uint32_t j = 0; j < d; ++j)
      e[j] = points[ring[j]] - points[v];
    for(std::uint32_t j = 0; j < d; ++j)
    {
      normal[j] = cross(e[j], e[j + 1 < d ? j + 1 : 0]);
      area[j] = length(normal[j]);
      total_area += area[j];
    }

    std::array<bool, highest_degree> has_chord = {};
    for(std::uint32_t j = 0; j < d; ++j)
      for(std::uint32_t k = j + 2; k < d - (j == 0 ? 1 : 0); ++k)
        if(are_neighbors(rings, ring[j], ring[k], is_exact))
          has_chord[j] = has_chord[k] = true;

    for(std::uint32_t j = 0; j < d; ++j)
    {
      if(has_chord[j])
        continue;
      double cost = edge_weight * total_area * squared_length(e[j]);
      for(std::uint32_t k = 0; k < d; ++k)
      {
        const double volume = dot(normal[k], e[j]);
        if(area[k] > 0.)
          cost += volume * volume / area[k];
      }
      double quality = 1.;
      for(std::uint32_t k = 1; k + 1 < d; ++k)
      {
        const Vector_3d a = e[(j + k) % d] - e[j], b = e[(j + k + 1) % d] - e[j];
        const double sum = squared_length(a) + squared_length(b) + squared_length(b - a);
        const double ratio = length(cross(a, b)) / sum;
        quality = (std::min)(quality, ratio > 0. ? 2. * std::sqrt(3.) * ratio : 0.); // 1 for an equilateral triangle
      }
      cost = (std::max)(cost, least_cost) / std::sqrt((std::max)(quality, least_quality));
      const std::size_t degree = rings.degree(ring[j]) + d - 4;
      if(degree > good_degree)
        cost *= 1. + static_cast<double>((degree - good_degree) * (degree - good_degree));
      const std::uint32_t rank = rank_of(cost);
      if(!result.is_possible() || rank < result.m_rank)
      {
        result.m_rank = rank;
        result.m_target = j;
      }
    }
    return result;
  }

  bool is_possible() const { return m_target != none; }

  // the target as an index into the ring of the vertex
  std::uint32_t target() const { return m_target; }

  // The cost as a key for sorting.
  std::uint32_t rank() const { return m_rank; }

private:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  static constexpr std::uint32_t highest_degree = 16; // of a vertex to be removed; every mesh has vertices below 6
  static constexpr std::size_t good_degree = 9;
  static constexpr std::size_t high_degree = 64;
  static constexpr double edge_weight = 1e-2;
  static constexpr double least_quality = 1e-6;
  static constexpr double least_cost = 1e-290; // where the surface says nothing, the degrees decide

  // Much coarser than the cost: costs that differ by rounding only nearly always have the same rank, so that no choice
  // depends on how the mesh is placed in space.
  static std::uint32_t rank_of(double cost)
  {
    constexpr double largest = (std::numeric_limits<double>::max)();
    constexpr int least_exponent = std::numeric_limits<double>::min_exponent, digits = 11;
    int exponent;
    const float mantissa = static_cast<float>(std::frexp(cost <= largest ? cost : largest, &exponent)); // from 0.5 to 1
    return (static_cast<std::uint32_t>(exponent - least_exponent) << digits) +
           static_cast<std::uint32_t>(std::ldexp(mantissa - 0.5f, digits + 1));
  }

  static bool are_neighbors(const Vertex_rings& rings, std::uint32_t a, std::uint32_t b, bool is_exact)
  {
    if(rings.degree(a) > rings.degree(b))
      std::swap(a, b);
    if(!is_exact && rings.degree(a) > high_degree)
      return true;
    const Vertex_rings::Ring ring = rings.ring(a);
    return std::find(ring.begin(), ring.end(), b) != ring.end();
  }

  std::uint32_t m_rank = 0, m_target = none;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERTEX_REMOVAL_H
