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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_MEAN_CURVATURE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_MEAN_CURVATURE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/align/surface_features.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// How far a surface of area 1 is outside of itself smoothed: along the normal, after heat has been conducted for the time `t` by
// one implicit step. For short times, this is `t` times the sum of the curvatures. It solves (M + t L) x = M p by the method of
// conjugate gradients, with the cotangents of the triangles in L. They are kept positive and finite, and `min_area` is more than 0
// where points coincide, so that the matrix is positive definite.
inline Channel mean_curvature(const Vertex_rings& rings, const std::vector<Vector_3d>& points, double t,
                              double min_area)
{
  const std::size_t n = points.size();
  Channel areas(n, 0.);
  std::vector<Vector_3d> normals(n, {0., 0., 0.});
  rings.for_each_face([&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    const Vector_3d normal = cross(points[j] - points[i], points[k] - points[i]);
    for(const std::uint32_t v : {i, j, k})
    {
      normals[v] = normals[v] + normal;
      areas[v] += length(normal) / 6.;
    }
  });
  for(double& area : areas)
    area = (std::max)(area, min_area);
  // The cotangents of 89 and 1 degrees, nearly. A larger minimum has obtuse triangles conduct too much; a smaller one, or a
  // larger maximum, which needles have, makes the weights more unequal, which takes more steps.
  constexpr double min_cotangent = 0.02, max_cotangent = 1. / min_cotangent;
  std::vector<std::tuple<std::uint32_t, std::uint32_t, double>> sides; // and their weights
  Channel diagonal = areas;
  rings.for_each_face([&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    for(const auto& [o, v, w] : {std::array<std::uint32_t, 3>{i, j, k}, {j, k, i}, {k, i, j}})
    {
      const Vector_3d a = points[v] - points[o], b = points[w] - points[o];
      const double cotangent = dot(a, b) / (length(cross(a, b)) + min_area);
      const double weight = 0.5 * t * (std::min)((std::max)(cotangent, min_cotangent), max_cotangent);
      sides.emplace_back(v, w, weight);
      diagonal[v] += weight;
      diagonal[w] += weight;
    }
  });
  using Vectors = std::vector<Vector_3d>;
  const auto product = [&](const Vectors& x) {
    Vectors y(n);
    for(std::size_t v = 0; v < n; ++v)
      y[v] = diagonal[v] * x[v];
    for(const auto& [v, w, weight] : sides)
    {
      y[v] = y[v] - weight * x[w];
      y[w] = y[w] - weight * x[v];
    }
    return y;
  };
  const auto inner_product = [](const Vectors& x, const Vectors& y) {
    return std::inner_product(x.begin(), x.end(), y.begin(), 0., std::plus<>(), dot<double>);
  };
  // The tolerance, of the square of the residual, stands for an error of 1e-5, far less than by what samplings of the same
  // surface differ; a smaller one takes more steps. The limit of these bounds the time on surfaces of needles.
  constexpr std::size_t max_steps = 300;
  constexpr double tolerance = 1e-10;
  Vectors x = points, r = product(x), z(n);
  for(std::size_t v = 0; v < n; ++v)
  {
    r[v] = areas[v] * points[v] - r[v];
    z[v] = (1. / diagonal[v]) * r[v];
  }
  Vectors p = z;
  const double first = inner_product(r, z);
  double rz = first;
  for(std::size_t k = 0; k < max_steps && rz > tolerance * first; ++k)
  {
    const Vectors q = product(p);
    const double alpha = rz / inner_product(p, q);
    for(std::size_t v = 0; v < n; ++v)
    {
      x[v] = x[v] + alpha * p[v];
      r[v] = r[v] - alpha * q[v];
      z[v] = (1. / diagonal[v]) * r[v];
    }
    const double next = inner_product(r, z), beta = next / rz;
    rz = next;
    for(std::size_t v = 0; v < n; ++v)
      p[v] = z[v] + beta * p[v];
  }
  Channel result;
  for(std::size_t v = 0; v < n; ++v)
    result.push_back(length(normals[v]) > 0. ? dot(points[v] - x[v], normalized(normals[v])) : 0.);
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_MEAN_CURVATURE_H
