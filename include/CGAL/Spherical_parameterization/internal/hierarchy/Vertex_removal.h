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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HIERARCHY_VERTEX_REMOVAL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HIERARCHY_VERTEX_REMOVAL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The best half-edge collapse that removes a given vertex: the neighbor into which it is collapsed, its target. The
// cost is the quadric error of the target with respect to the planes of the faces at the vertex, plus a small multiple
// of the squared edge length, so that flat regions are coarsened evenly. Thin new faces and targets of high degree
// increase the cost.
struct Vertex_removal
{
  // Finds the best target of vertex v. Only targets that keep the mesh a simplicial complex are considered (link
  // condition). If `is_exact` is false, two vertices of high degree are assumed to be neighbors, so that the time for a
  // vertex is bounded. Images of faces must stay positively oriented.
  static Vertex_removal best(const Vertex_rings& rings, const std::vector<Vector_3d>& points, std::uint32_t v,
                             bool is_exact, const std::vector<Vector_3d>& images = {})
  {
    Vertex_removal result;
    const Vertex_rings::Ring ring = rings.ring(v);
    const std::uint32_t d = static_cast<std::uint32_t>(ring.size());
    if(d > max_degree)
      return result;

    std::array<Vector_3d, 2 * max_degree> e; // edges from v, twice around, so that no index wraps
    for(std::uint32_t j = 0; j < d; ++j)
      e[j] = e[j + d] = points[ring[j]] - points[v];
    // The quadratic form of the cost: n n^T / |n| for each face, where the length of the normal n is twice the area of
    // the face, and a multiple of the squared edge.
    double xx = 0., xy = 0., xz = 0., yy = 0., yz = 0., zz = 0., total_doubled_area = 0.;
    for(std::uint32_t j = 0; j < d; ++j)
    {
      const Vector_3d n = cross(e[j], e[j + 1]);
      const double doubled_area = length(n);
      if(!(doubled_area > 0.))
        continue;
      total_doubled_area += doubled_area;
      const Vector_3d unit = (1. / doubled_area) * n;
      xx += unit[0] * n[0];
      xy += unit[0] * n[1];
      xz += unit[0] * n[2];
      yy += unit[1] * n[1];
      yz += unit[1] * n[2];
      zz += unit[2] * n[2];
    }
    const double weight = edge_weight * total_doubled_area;
    const auto cost_of = [&](const Vector_3d& a) {
      return a[0] * ((xx + weight) * a[0] + 2. * xy * a[1] + 2. * xz * a[2]) +
             a[1] * ((yy + weight) * a[1] + 2. * yz * a[2]) + (zz + weight) * a[2] * a[2];
    };

    std::array<double, max_degree> cost;
    for(std::uint32_t j = 0; j < d; ++j)
    {
      cost[j] = (std::max)(cost_of(e[j]), min_cost);
      const std::size_t degree = rings.degree(ring[j]) + d - 4;
      if(degree > good_degree)
        cost[j] *= 1. + static_cast<double>((degree - good_degree) * (degree - good_degree));
    }
    // The expensive tests are done last, and only for targets that can still be the best; so the cheapest target comes
    // first.
    const std::uint32_t cheapest =
        static_cast<std::uint32_t>(std::min_element(cost.begin(), cost.begin() + d) - cost.begin());
    const auto is_better = [&](std::uint32_t r, std::uint32_t j) {
      return !result.is_possible() || r < result.rank || (r == result.rank && j < result.target);
    };
    const auto try_target = [&](std::uint32_t j) {
      if(!is_better(rank_of(cost[j]), j))
        return;
      double squared_quality = 1.;
      for(std::uint32_t k = j + 1; k + 1 < j + d; ++k)
        squared_quality = (std::min)(squared_quality, squared_quality_of(e[k] - e[j], e[k + 1] - e[j]));
      const std::uint32_t r = rank_of(cost[j] / std::sqrt(std::sqrt((std::max)(squared_quality, min_squared_quality))));
      if(is_better(r, j) && (images.empty() || is_fan_positive(ring, j, images)) &&
         !has_chord(rings, ring, j, is_exact))
      {
        result.rank = r;
        result.target = j;
      }
    };
    try_target(cheapest);
    for(std::uint32_t j = 0; j < d; ++j)
      if(j != cheapest)
        try_target(j);
    return result;
  }

  bool is_possible() const { return target != none; }

  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  std::uint32_t rank = 0;      // the cost as a sort key
  std::uint32_t target = none; // as an index into the ring of the vertex

private:
  static constexpr std::uint32_t max_degree = 16; // of a vertex to be removed; every mesh has vertices below 6
  static constexpr std::size_t good_degree = 9;   // of the target; beyond, the cost and the time for a star grow
  static constexpr std::size_t high_degree = 64;  // two vertices beyond may be assumed neighbors without a search
  static constexpr double edge_weight = 1e-2;     // of the squared edge; it decides if all distances from planes are 0
  static constexpr double min_squared_quality = 1e-12; // a flat fan costs 1000 times as much as an equilateral one
  static constexpr double min_cost = 1e-290;           // if the geometry gives no preference, the degrees decide

  // Much coarser than the cost: costs that differ only by rounding errors almost always have the same rank, so that the
  // result does not depend on the position of the mesh in space.
  static std::uint32_t rank_of(double cost)
  {
    static_assert(std::numeric_limits<double>::is_iec559, "The exponent is followed by the mantissa.");
    constexpr double largest = (std::numeric_limits<double>::max)();
    const double number = cost <= largest ? cost : largest;
    std::uint64_t bits;
    std::memcpy(&bits, &number, sizeof(bits));
    return static_cast<std::uint32_t>(bits >> 41); // the exponent and 11 binary digits
  }

  // The squared quality of a triangle with these edges, from 0 for a flat triangle to 1 for an equilateral one.
  static double squared_quality_of(const Vector_3d& a, const Vector_3d& b)
  {
    const double sum = squared_length(a) + squared_length(b) + squared_length(b - a);
    const double squared_ratio = squared_length(cross(a, b)) / (sum * sum);
    return squared_ratio > 0. ? 12. * squared_ratio : 0.;
  }

  // Whether the new faces are positively oriented if vertex j of a ring is the target.
  static bool is_fan_positive(const Vertex_rings::Ring& ring, std::uint32_t j, const std::vector<Vector_3d>& images)
  {
    for(std::size_t k = j + 1; k + 1 < j + ring.size(); ++k)
      if(!is_safely_positive(images[ring[j]], images[ring.around(k)], images[ring.around(k + 1)]))
        return false;
    return true;
  }

  // Whether vertex j of a ring is adjacent to a vertex of the ring other than the previous and the next one.
  static bool has_chord(const Vertex_rings& rings, const Vertex_rings::Ring& ring, std::uint32_t j, bool is_exact)
  {
    const std::uint32_t d = static_cast<std::uint32_t>(ring.size());
    for(std::uint32_t k = j + 2; k + 1 < j + d; ++k)
      if(are_neighbors(rings, ring[j], ring.around(k), is_exact))
        return true;
    return false;
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
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HIERARCHY_VERTEX_REMOVAL_H
