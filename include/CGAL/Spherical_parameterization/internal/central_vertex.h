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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CENTRAL_VERTEX_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CENTRAL_VERTEX_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The number of edges from `source` to each vertex of a connected mesh.
inline std::vector<std::uint32_t> edge_distances(const Vertex_rings& rings, std::uint32_t source)
{
  const std::size_t n = rings.number_of_vertices();
  std::vector<std::uint32_t> distance(n, static_cast<std::uint32_t>(n)), queue = {source};
  queue.reserve(n);
  distance[source] = 0;
  for(std::size_t k = 0; k < queue.size(); ++k)
    for(const std::uint32_t w : rings.ring(queue[k]))
      if(distance[w] == n)
      {
        distance[w] = distance[queue[k]] + 1;
        queue.push_back(w);
      }
  return distance;
}

// A vertex in the middle of the surface: of all vertices, the one that is least far from the extremities. Those are
// found one after the other, each as far as possible from those before.
inline std::uint32_t central_vertex(const Vertex_rings& rings)
{
  constexpr int number_of_extremities = 8;
  std::vector<std::uint32_t> nearest = edge_distances(rings, 0), farthest(rings.number_of_vertices(), 0);
  for(int k = 0; k < number_of_extremities; ++k)
  {
    const auto extremity = std::max_element(nearest.begin(), nearest.end()) - nearest.begin();
    const std::vector<std::uint32_t> distance = edge_distances(rings, static_cast<std::uint32_t>(extremity));
    for(std::size_t v = 0; v < distance.size(); ++v)
    {
      nearest[v] = k == 0 ? distance[v] : (std::min)(nearest[v], distance[v]);
      farthest[v] = (std::max)(farthest[v], distance[v]);
    }
  }
  return static_cast<std::uint32_t>(std::min_element(farthest.begin(), farthest.end()) - farthest.begin());
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CENTRAL_VERTEX_H
