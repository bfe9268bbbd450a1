// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_MAPS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_MAPS_H

// Maps from the vertices of a mesh to points, read back and compared.

#include "test_meshes.h"

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

namespace test_maps {

using test_meshes::Coordinates;

// The images of all vertices in the order of the mesh.
template <class Mesh, class VertexPointMap>
std::vector<Coordinates> images(const Mesh& mesh, const VertexPointMap& map)
{
  std::vector<Coordinates> result;
  for(const auto v : vertices(mesh))
  {
    const auto& p = get(map, v);
    result.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  return result;
}

// Whether two maps are the same to the last bit; unlike ==, this tells 0 from -0, and a NaN is equal to itself.
inline bool have_same_bits(const std::vector<Coordinates>& a, const std::vector<Coordinates>& b)
{
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Coordinates)) == 0);
}

inline double norm(const Coordinates& p)
{
  return std::hypot(p[0], p[1], p[2]);
}

inline double distance(const Coordinates& a, const Coordinates& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The largest distance between the images of a vertex under two maps.
inline double largest_distance(const std::vector<Coordinates>& a, const std::vector<Coordinates>& b)
{
  double result = a.size() == b.size() ? 0. : HUGE_VAL;
  for(std::size_t v = 0; v < (std::min)(a.size(), b.size()); ++v)
  {
    const double d = distance(a[v], b[v]);
    result = d > result || d != d ? d : result;
  }
  return result;
}

// A map full of values that no parameterizer would write, so that every write shows.
template <class Point, class Mesh>
auto make_sentinel_map(const Mesh& mesh)
{
  std::vector<Coordinates> points;
  for(std::size_t i = 0; i < num_vertices(mesh); ++i)
  {
    const double x = static_cast<double>(i);
    points.push_back({1e9 + x, -1e-9 * x, 1e6 * x});
  }
  return test_meshes::make_vertex_map<Point>(mesh, points);
}

} // namespace test_maps

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_MAPS_H
