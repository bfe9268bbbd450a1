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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_TRIANGULATE_PATH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_TRIANGULATE_PATH_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <queue>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

using Path_triangle = std::array<std::size_t, 3>; // positions in a closed path, in increasing order

// Triangulates a closed path by cutting off corners, first those whose neighbors are closest to each other.
inline std::vector<Path_triangle> cut_corners(const std::vector<Vector_3d>& path)
{
  const std::size_t n = path.size();
  std::vector<std::size_t> before(n), behind(n);
  for(std::size_t k = 0; k < n; ++k)
  {
    before[k] = (k + n - 1) % n;
    behind[k] = (k + 1) % n;
  }
  using Entry = std::pair<double, Path_triangle>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto add = [&](std::size_t k) {
    queue.emplace(squared_length(path[before[k]] - path[behind[k]]), Path_triangle{before[k], k, behind[k]});
  };
  for(std::size_t k = 0; k < n; ++k)
    add(k);
  std::vector<Path_triangle> result;
  std::vector<char> is_cut(n, 0);
  while(result.size() + 2 < n)
  {
    const Path_triangle t = queue.top().second;
    queue.pop();
    const auto [a, b, c] = t;
    if(is_cut[b] || before[b] != a || behind[b] != c)
      continue;
    is_cut[b] = 1;
    result.push_back(t);
    behind[a] = c;
    before[c] = a;
    add(a);
    add(c);
  }
  return result;
}

// Triangulates a closed path of at least three points: with minimal area and bending if it is short, otherwise by
// cutting off corners.
inline std::vector<Path_triangle> triangulate_path(const std::vector<Vector_3d>& path)
{
  constexpr std::size_t max_size_for_search = 100; // which takes cubic time
  std::vector<Path_triangle> result;
  if(path.size() > 3 && path.size() <= max_size_for_search)
  {
    std::vector<Exact_predicates_inexact_constructions_kernel::Point_3> points;
    for(const Vector_3d& p : path)
      points.emplace_back(p[0], p[1], p[2]);
    std::vector<Triple<int, int, int>> triangles;
    Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(triangles),
                                                       parameters::use_delaunay_triangulation(false));
    for(const auto& t : triangles)
      result.push_back(
          {static_cast<std::size_t>(t.first), static_cast<std::size_t>(t.second), static_cast<std::size_t>(t.third)});
  }
  if(result.size() + 2 != path.size())
    result = cut_corners(path);
  for(Path_triangle& t : result)
    std::sort(t.begin(), t.end());
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_TRIANGULATE_PATH_H
