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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_SUBDIVIDED_SOLID_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_SUBDIVIDED_SOLID_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A solid whose edges are divided into n parts, projected to the sphere. A vertex is a weighted sum of the corners of its face. The
// weight of a corner depends on the number of parts between it and the vertex: on an edge from a to b, the sum is weights[n - i] a
// + weights[i] b. The faces of the solid have k corners each, 3 or 4.
//
// The vertices of the solid come first, followed by those on edges and those in faces, row by row.
template <std::size_t k>
class Subdivided_solid
{
public:
  using Index = std::uint32_t;
  using Triangle = std::array<Index, 3>;
  using Face = std::array<Index, k>;

  Subdivided_solid(std::vector<Vector_3d> corners, const std::vector<Face>& faces, std::vector<double> weights)
    : m_corners(std::move(corners))
    , m_weights(std::move(weights))
    , m_n(static_cast<Index>(m_weights.size() - 1))
  {
    for(const Vector_3d& corner : m_corners)
      directions.push_back(normalized(corner));
    for(const Face& face : faces)
      for(std::size_t i = 0; i < k; ++i)
        if(const Index a = face[i], b = face[(i + 1) % k]; a < b) // the other face has the opposite direction
        {
          m_edges.push_back({{a, b}, static_cast<Index>(directions.size())});
          for(Index j = 1; j < m_n; ++j)
            add(between(a, b, j, m_n));
        }
    for(const Face& face : faces)
      subdivide(face);
  }

  std::vector<Vector_3d> directions; // of length 1
  std::vector<Triangle> triangles;   // counterclockwise as seen from outside
  std::vector<Index> rows; // the vertices of each face, including its edges; row j is j parts away from the edge from
                           // the first to the second corner, and each row starts at the edge to the last corner

private:
  struct Edge
  {
    std::array<Index, 2> ends;
    Index first; // the first of its n - 1 vertices
  };

  Index add(const Vector_3d& direction)
  {
    directions.push_back(normalized(direction));
    return static_cast<Index>(directions.size() - 1);
  }

  // The point at i of n parts of the way from a to b, not normalized.
  Vector_3d between(Index a, Index b, Index i, Index n) const
  {
    return m_weights[n - i] * m_corners[a] + m_weights[i] * m_corners[b];
  }

  // The vertex that is i parts away from a.
  Index vertex_on_edge(Index a, Index b, Index i) const
  {
    if(i == 0 || i == m_n)
      return i == 0 ? a : b;
    const std::array<Index, 2> ends = {(std::min)(a, b), (std::max)(a, b)};
    const auto edge = std::find_if(m_edges.begin(), m_edges.end(), [&](const Edge& e) { return e.ends == ends; });
    return edge->first + (a < b ? i : m_n - i) - 1;
  }

  void subdivide(const Face& face)
  {
    constexpr bool is_square = k == 4;
    const Index a = face[0], b = face[1], c = face[2], last_corner = face[k - 1];
    std::vector<Index> last, row;
    for(Index j = 0; j <= m_n; ++j)
    {
      const Index length = is_square ? m_n : m_n - j;
      row.clear();
      for(Index i = 0; i <= length; ++i)
        row.push_back(j == 0                  ? vertex_on_edge(a, b, i)
                      : i == 0                ? vertex_on_edge(a, last_corner, j)
                      : i == length           ? vertex_on_edge(b, c, j)
                      : is_square && j == m_n ? vertex_on_edge(last_corner, c, i)
                      : is_square             ? add(m_weights[m_n - j] * between(a, b, i, m_n) +
                                                    m_weights[j] * between(last_corner, c, i, m_n))
                                              : add(between(a, b, i, length) + m_weights[j] * m_corners[c]));
      for(Index i = 0; j > 0 && i < last.size() - 1; ++i)
      {
        triangles.push_back({last[i], last[i + 1], row[is_square ? i + 1 : i]});
        if(i < length)
          triangles.push_back({is_square ? last[i] : last[i + 1], row[i + 1], row[i]});
      }
      rows.insert(rows.end(), row.begin(), row.end());
      last.swap(row);
    }
  }

  std::vector<Vector_3d> m_corners;
  std::vector<double> m_weights;
  Index m_n;
  std::vector<Edge> m_edges;
};

// Weights that divide an edge, whose ends are directions at this angle, into n arcs of equal angle.
inline std::vector<double> weights_of_equal_arcs(double angle_of_edge, std::uint32_t n)
{
  std::vector<double> weights;
  for(std::uint32_t i = 0; i <= n; ++i)
    weights.push_back(sine(angle_of_edge * i / n));
  return weights;
}

// Corner k is on the axis k % 3, on its negative side if k >= 3.
constexpr std::array<std::array<std::uint32_t, 3>, 8> octahedron_faces = {
    {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}}};

inline Subdivided_solid<3> subdivided_octahedron(std::uint32_t n)
{
  const std::vector<Vector_3d> corners = {{1., 0., 0.},  {0., 1., 0.},  {0., 0., 1.},
                                          {-1., 0., 0.}, {0., -1., 0.}, {0., 0., -1.}};
  return {corners, {octahedron_faces.begin(), octahedron_faces.end()}, weights_of_equal_arcs(CGAL_PI / 2., n)};
}

inline Subdivided_solid<3> subdivided_icosahedron(std::uint32_t n)
{
  std::vector<Vector_3d> corners = {{0., 0., 1.}};
  for(const double z : {1., -1.})
    for(int i = 0; i < 5; ++i) // five vertices around each pole, at z = +-1 / sqrt(5)
    {
      const double angle = (2 * i + (z < 0.)) * CGAL_PI / 5.;
      corners.push_back({std::sqrt(0.8) * cosine(angle), std::sqrt(0.8) * sine(angle), z * std::sqrt(0.2)});
    }
  corners.push_back({0., 0., -1.});
  std::vector<std::array<std::uint32_t, 3>> faces;
  for(std::uint32_t i = 0; i < 5; ++i)
  {
    const std::uint32_t next = (i + 1) % 5;
    faces.push_back({0, 1 + i, 1 + next});
    faces.push_back({1 + i, 6 + i, 1 + next});
    faces.push_back({6 + i, 6 + next, 1 + next});
    faces.push_back({6 + i, 11, 6 + next});
  }
  return {corners, faces, weights_of_equal_arcs(arc_tangent(2., 1.), n)};
}

// Bit k of the index of a corner is the sign of its coordinate k.
constexpr std::array<std::array<std::uint32_t, 4>, 6> cube_faces = {
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

// Lines on the faces of a cube that are equally spaced in the angle about the axes yield the most uniform squares.
inline Subdivided_solid<4> subdivided_cube(std::uint32_t n)
{
  std::vector<Vector_3d> corners;
  for(int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? 1. : -1., i & 2 ? 1. : -1., i & 4 ? 1. : -1.});
  return {corners, {cube_faces.begin(), cube_faces.end()}, weights_of_equal_arcs(CGAL_PI / 2., n)};
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_SUBDIVIDED_SOLID_H
