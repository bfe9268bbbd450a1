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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_PATHS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_PATHS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/vertex_scalars.h>

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

// How far points of a surface are from each other along it, which changes little when it is bent: the lengths of shortest paths
// along edges and across pairs of triangles, within 4 percent on regular triangles.
class Surface_paths
{
public:
  Surface_paths() = default;
  Surface_paths(const std::vector<Vector_3d>& points, const std::vector<Linked_triangle>& triangles)
    : m_joints(points.size())
  {
    const auto join = [&](std::uint32_t v, std::uint32_t w, double length) {
      m_joints[v].emplace_back(length, w);
      m_joints[w].emplace_back(length, v);
    };
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

  using Joint = std::pair<double, std::uint32_t>; // how far it is to a vertex

  Vertex_scalars distances_from(std::uint32_t source) const { return distances_from(std::vector<Joint>{{0., source}}); }

  // From a point that is this far from these vertices.
  Vertex_scalars distances_from(const std::vector<Joint>& corners) const
  {
    Vertex_scalars result(m_joints.size(), (std::numeric_limits<double>::max)());
    std::priority_queue<Joint, std::vector<Joint>, std::greater<Joint>> queue;
    for(const auto& [d, v] : corners)
    {
      result[v] = d;
      queue.emplace(d, v);
    }
    while(!queue.empty())
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d > result[v])
        continue;
      for(const auto& [step, w] : m_joints[v])
        if(const double x = d + step; x < result[w])
        {
          result[w] = x;
          queue.emplace(x, w);
        }
    }
    return result;
  }

private:
  // from c to d over the edge from a to b
  static double length_across(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c, const Vector_3d& d)
  {
    const double edge = length(b - a);
    if(!(edge > 0.))
      return length(c - a) + length(d - a);
    const Vector_3d u = (1. / edge) * (b - a);
    const double cx = dot(c - a, u), cy = std::sqrt((std::max)(squared_length(c - a) - cx * cx, 0.));
    const double dx = dot(d - a, u), dy = std::sqrt((std::max)(squared_length(d - a) - dx * dx, 0.));
    const double x = cy + dy > 0. ? (cx * dy + dx * cy) / (cy + dy) : 0.; // where the straight line meets the edge
    return x >= 0. && x <= edge ? std::hypot(cx - dx, cy + dy)
                                : (std::min)(length(c - a) + length(d - a), length(c - b) + length(d - b));
  }

  std::vector<std::vector<Joint>> m_joints; // of each vertex, with its neighbours and those across from them
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_PATHS_H
