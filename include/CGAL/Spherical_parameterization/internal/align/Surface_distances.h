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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SURFACE_DISTANCES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SURFACE_DISTANCES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/align/Sphere_grid.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// How far places of a surface are from each other on the surface, which changes little when it is bent: the lengths of
// shortest paths along the edges of the grid and across pairs of its triangles, within 4 percent on regular triangles.
class Surface_distances
{
public:
  // Points of the surface, of area 1, and the areas around them.
  Surface_distances(const Sphere_grid& grid, const std::vector<Vector_3d>& points, const Channel& areas)
    : m_grid(grid)
    , m_areas(areas)
    , m_joints(grid.size())
  {
    const auto join = [&](std::uint32_t v, std::uint32_t w, double length) {
      m_joints[v].push_back({w, length});
      m_joints[w].push_back({v, length});
    };
    const std::vector<Linked_triangle>& triangles = grid.triangles();
    for(std::uint32_t t = 0; t < triangles.size(); ++t)
      for(std::size_t i = 0; i < 3; ++i)
        if(const std::uint32_t s = triangles[t].neighbors[i]; t < s)
        {
          const std::uint32_t a = triangles[t][(i + 1) % 3], b = triangles[t][(i + 2) % 3];
          const std::uint32_t c = triangles[t][i], d = triangles[s][triangles[s].side_of(t)];
          join(a, b, length(points[b] - points[a]));
          join(c, d, length_across(points[a], points[b], points[c], points[d]));
        }
  }

  Channel from(std::uint32_t source) const
  {
    using Entry = std::pair<double, std::uint32_t>;
    Channel result(m_grid.size(), (std::numeric_limits<double>::max)());
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    result[source] = 0.;
    queue.emplace(0., source);
    while(!queue.empty())
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d > result[v])
        continue;
      for(const Joint& joint : m_joints[v])
        if(const double x = d + joint.length; x < result[joint.vertex])
        {
          result[joint.vertex] = x;
          queue.emplace(x, joint.vertex);
        }
    }
    return result;
  }

  // The average distance of each vertex from the whole surface: from sources that are spread over it, each as far as
  // possible from those before. Computed once.
  const Channel& average()
  {
    if(!m_average.empty())
      return m_average;
    constexpr std::size_t n_sources = 48;
    auto source = static_cast<std::uint32_t>(std::max_element(m_areas.begin(), m_areas.end()) - m_areas.begin());
    std::vector<Channel> distances;
    std::vector<std::size_t> nearest(m_grid.size(), 0);
    for(std::size_t k = 0; k < n_sources; ++k)
    {
      distances.push_back(from(source));
      double largest = -1.;
      for(std::uint32_t v = 0; v < m_grid.size(); ++v)
      {
        if(distances[k][v] < distances[nearest[v]][v])
          nearest[v] = k;
        if(distances[nearest[v]][v] > largest)
        {
          largest = distances[nearest[v]][v];
          source = v;
        }
      }
    }
    Channel weights(n_sources, 0.);
    for(std::size_t v = 0; v < m_grid.size(); ++v)
      weights[nearest[v]] += m_areas[v];
    m_average.assign(m_grid.size(), 0.);
    for(std::size_t k = 0; k < n_sources; ++k)
      for(std::size_t v = 0; v < m_grid.size(); ++v)
        m_average[v] += weights[k] * distances[k][v];
    return m_average;
  }

  struct Limb
  {
    std::uint32_t end;
    Channel distances; // from the end
  };

  // Those whose ends are farthest away: where the average distance is largest all around, and above the mean.
  std::vector<Limb> limbs()
  {
    constexpr double min_distance = 0.25; // between two ends
    const Channel& average = this->average();
    double mean = 0.;
    for(std::size_t v = 0; v < m_grid.size(); ++v)
      mean += m_areas[v] * average[v];
    std::vector<std::uint32_t> ends;
    for(std::uint32_t v = 0; v < m_grid.size(); ++v)
      if(const auto& ring = m_grid.neighbors(v);
         average[v] > mean &&
         std::all_of(ring.begin(), ring.end(), [&](std::uint32_t w) { return average[w] <= average[v]; }))
        ends.push_back(v);
    std::stable_sort(ends.begin(), ends.end(),
                     [&](std::uint32_t v, std::uint32_t w) { return average[v] > average[w]; });
    std::vector<Limb> result;
    for(const std::uint32_t v : ends)
      if(std::all_of(result.begin(), result.end(), [&](const Limb& limb) { return limb.distances[v] > min_distance; }))
        result.push_back({v, from(v)});
    return result;
  }

private:
  struct Joint
  {
    std::uint32_t vertex;
    double length;
  };

  // from c to d over the edge from a to b
  static double length_across(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c, const Vector_3d& d)
  {
    const double edge = length(b - a);
    if(!(edge > 0.))
      return length(c - a) + length(d - a);
    const Vector_3d u = (1. / edge) * (b - a);
    const double cx = dot(c - a, u), cy = std::sqrt((std::max)(squared_length(c - a) - cx * cx, 0.));
    const double dx = dot(d - a, u), dy = std::sqrt((std::max)(squared_length(d - a) - dx * dx, 0.));
    const double x = cy + dy > 0. ? (cx * dy + dx * cy) / (cy + dy) : 0.; // where the straight way meets the line
    return x >= 0. && x <= edge ? std::hypot(cx - dx, cy + dy)
                                : (std::min)(length(c - a) + length(d - a), length(c - b) + length(d - b));
  }

  const Sphere_grid& m_grid;
  Channel m_areas, m_average;
  std::vector<std::vector<Joint>> m_joints; // of each vertex, with its neighbours and those across from them
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SURFACE_DISTANCES_H
