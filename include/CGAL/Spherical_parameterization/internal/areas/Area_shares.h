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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_SHARES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_SHARES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The area of the spherical triangle of three points of the unit sphere, negative if it is inverted, as a function of
// its corner x. With the determinant D of the corners and S = 1 + x.p + p.q + q.x, it is 2 atan(D / S). Both are
// computed from differences of the corners, so that the areas of small triangles have a small relative error.
class Spherical_area
{
public:
  Spherical_area(const Vector_3d& x, const Vector_3d& p, const Vector_3d& q)
    : m_to_p(p - x)
    , m_to_q(q - x)
    , m_normal(cross(m_to_p, m_to_q))
    , m_determinant(dot(x, m_normal))
    , m_sum(4. - 0.5 * (squared_length(m_to_p) + squared_length(m_to_q) + squared_length(q - p)))
  {}

  double value() const { return 2. * arc_tangent(m_determinant, m_sum); }

  // The derivative with respect to x, without its component along x.
  Vector_3d gradient(const Vector_3d& x) const
  {
    const Vector_3d of_determinant = cross(x, m_to_q - m_to_p) + m_normal; // p x q
    const Vector_3d of_sum = 2. * x + m_to_p + m_to_q;                     // p + q
    const double factor = 2. / (m_sum * m_sum + m_determinant * m_determinant);
    const Vector_3d result = factor * (m_sum * of_determinant - m_determinant * of_sum);
    return result - dot(result, x) * x;
  }

private:
  Vector_3d m_to_p, m_to_q, m_normal;
  double m_determinant, m_sum;
};

// The ratios of the areas of the vertices' cells on the unit sphere to their prescribed areas. A cell has a third of
// the areas of the faces at its vertex.
inline void find_area_ratios(const Vertex_rings& rings, const std::vector<Vector_3d>& positions,
                             const std::vector<double>& wanted, std::vector<double>& ratios)
{
  ratios.assign(positions.size(), 0.);
  rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const double third = Spherical_area(positions[a], positions[b], positions[c]).value() / 3.;
    ratios[a] += third;
    ratios[b] += third;
    ratios[c] += third;
  });
  for(std::size_t v = 0; v < ratios.size(); ++v)
    ratios[v] /= wanted[v];
}

// The standard deviation of numbers divided by their mean.
inline double relative_deviation(const std::vector<double>& values)
{
  double sum = 0., squares = 0.;
  for(const double x : values)
    sum += x;
  const double mean = sum / static_cast<double>(values.size());
  for(const double x : values)
    squares += (x - mean) * (x - mean);
  return std::sqrt(squares / static_cast<double>(values.size())) / mean;
}

// The prescribed areas on the unit sphere, in the order of the surface. The area of a vertex is a third of those of its
// faces.
struct Area_shares
{
  std::vector<double> of_faces; // in the order of Vertex_rings::for_each_face()
  std::vector<double> of_vertices;
  std::size_t number_of_raised_faces = 0; // whose prescribed area would be too small to be represented
};

// The indices of the faces of a surface, in the order of Vertex_rings::for_each_face(), among the caller's triangles.
inline std::vector<std::uint32_t> callers_numbers_of_faces(const Surface& surface, const Index_triangles& triangles)
{
  struct Key
  {
    std::array<std::uint32_t, 3> vertices; // the smallest one first
    std::uint32_t number;
    bool operator<(const Key& other) const { return vertices < other.vertices; }
  };
  const auto sorted_keys = [](const Index_triangles& all) {
    std::vector<Key> keys;
    keys.reserve(all.size());
    for(const auto& t : all)
    {
      Key key = {{t[0], t[1], t[2]}, static_cast<std::uint32_t>(keys.size())};
      std::rotate(key.vertices.begin(), std::min_element(key.vertices.begin(), key.vertices.end()), key.vertices.end());
      keys.push_back(key);
    }
    std::sort(keys.begin(), keys.end());
    return keys;
  };
  const std::vector<Key> own = sorted_keys(surface.callers_triangles()), callers = sorted_keys(triangles);
  std::vector<std::uint32_t> result(own.size());
  for(std::size_t k = 0; k < own.size(); ++k)
    result[own[k].number] = callers[k].number;
  return result;
}

// Computes the prescribed areas from the areas of the faces times their densities, finite and at least 0, one for each
// of the caller's triangles; from the areas alone if there are no densities. A value below one millionth of the mean is
// raised to it: if all faces around a vertex had the area 0, no injective map could satisfy this.
inline Area_shares find_area_shares(const Surface& surface, const Index_triangles& triangles,
                                    const std::vector<double>& densities)
{
  constexpr double min_share = 1e-6; // of the mean
  const double largest = densities.empty() ? 0. : *std::max_element(densities.begin(), densities.end());
  const std::vector<std::uint32_t> numbers =
      largest > 0. ? callers_numbers_of_faces(surface, triangles) : std::vector<std::uint32_t>();
  const std::vector<Vector_3d>& points = surface.points();
  Area_shares result;
  result.of_faces.reserve(surface.rings().number_of_faces());
  surface.rings().for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const double area = doubled_area(points[a], points[b], points[c]);
    const double density = largest > 0. ? densities[numbers[result.of_faces.size()]] / largest : 1.;
    result.of_faces.push_back(area * density);
  });
  const auto scale_to = [&](double sum) {
    const double last = std::accumulate(result.of_faces.begin(), result.of_faces.end(), 0.);
    for(double& share : result.of_faces)
      share = last > 0. ? share * (sum / last) : sum / static_cast<double>(result.of_faces.size());
  };
  scale_to(static_cast<double>(result.of_faces.size()));
  for(double& share : result.of_faces)
  {
    result.number_of_raised_faces += share < min_share ? 1u : 0u;
    share = (std::max)(share, min_share);
  }
  scale_to(4. * CGAL_PI);

  std::size_t face = 0;
  result.of_vertices =
      vertex_sums(surface.rings(), surface.number_of_vertices(),
                  [&](std::uint32_t, std::uint32_t, std::uint32_t) { return result.of_faces[face++] / 3.; });
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_SHARES_H
