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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MESH_MEASURES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MESH_MEASURES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Twice the area of a triangle with these corners.
inline double doubled_area(const Vector_3d& p, const Vector_3d& q, const Vector_3d& r)
{
  return length(cross(q - p, r - p));
}

// Sums up the contributions of triangles at each vertex: of_triangle(a, b, c) is added to each corner. The triangles
// are a range, or the rings of a surface.
template <class Triangles, class Function>
std::vector<double> vertex_sums(const Triangles& triangles, std::size_t n_vertices, const Function& of_triangle)
{
  std::vector<double> sums(n_vertices, 0.);
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const double x = of_triangle(a, b, c);
    for(const std::uint32_t v : {a, b, c})
      sums[v] += x;
  };
  if constexpr(std::is_same<Triangles, Vertex_rings>::value)
    triangles.for_each_face(add);
  else
    for(const auto& t : triangles)
      add(t[0], t[1], t[2]);
  return sums;
}

// A third of the area of its triangles, for each vertex.
template <class Triangles>
std::vector<double> vertex_areas(const Triangles& triangles, const std::vector<Vector_3d>& points)
{
  return vertex_sums(triangles, points.size(), [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return doubled_area(points[a], points[b], points[c]) / 6.;
  });
}

// The same as weights of the vertices, so that there is a center of mass even if the surface has no area.
inline std::vector<double> vertex_masses(const Vertex_rings& rings, const std::vector<Vector_3d>& points)
{
  std::vector<double> masses = vertex_areas(rings, points);
  if(!(std::accumulate(masses.begin(), masses.end(), 0.) > 0.))
    masses.assign(masses.size(), 1.);
  return masses;
}

// The same with a density that grows with the curvature, and with the same sum. If samples are at a distance h, the
// error at curvature k is about k h^2, and its mean square is minimal if the samples are as dense as k^(2/3). The
// curvature is measured at the edges: their dihedral angle divided by the width of the surface at the edge. It does not
// change if a face is subdivided without bending.
inline std::vector<double> curvature_masses(const Vertex_rings& rings, const std::vector<Vector_3d>& points)
{
  constexpr double flat = 0.05;      // of the mean squared curvature, for flat regions: they need samples as well
  constexpr double max_ratio = 100.; // of a squared edge to its area, so that needles do not get all samples
  std::vector<double> masses = vertex_areas(rings, points), squares(masses.size(), 0.); // integrals of k^2
  for(std::uint32_t v = 0; v < rings.number_of_vertices(); ++v)
  {
    const Vertex_rings::Ring ring = rings.ring(v);
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      const Vector_3d edge = points[ring[j]] - points[v];
      const Vector_3d left = cross(edge, points[ring.around(j + 1)] - points[v]),
                      right = cross(points[ring.around(j + ring.size() - 1)] - points[v], edge);
      const double l = length(left), r = length(right);
      if(!(l > 0. && r > 0.))
        continue;
      // Approximately the squared angle, times the squared edge divided by a third of the area of its faces.
      squares[v] += squared_length((1. / l) * left - (1. / r) * right) *
                    (std::min)(6. * squared_length(edge) / (l + r), max_ratio);
    }
  }
  const double area = std::accumulate(masses.begin(), masses.end(), 0.),
               square = std::accumulate(squares.begin(), squares.end(), 0.);
  if(!(square > 0.)) // a surface that is flat, or has no area
    return masses;
  double mass = 0.;
  for(std::size_t v = 0; v < masses.size(); ++v)
  {
    masses[v] = cube_root((squares[v] * (area / square) + flat * masses[v]) * masses[v] * masses[v]);
    mass += masses[v];
  }
  for(double& m : masses)
    m *= area / mass;
  return masses;
}

inline Vector_3d center_of_mass(const std::vector<Vector_3d>& points, const std::vector<double>& masses)
{
  Vector_3d sum = {0., 0., 0.};
  double mass = 0.;
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    sum = sum + masses[v] * points[v];
    mass += masses[v];
  }
  return (1. / mass) * sum;
}

// The ratio of the area that the vertices of a coarse mesh represent to the area that they have; 1 if no area has been
// lost. It is 1 for a vertex whose faces have no area, because their rest shapes are replaced.
inline std::vector<double> vertex_densities(const Vertex_rings& rings, const std::vector<Vector_3d>& points,
                                            const std::vector<double>& areas)
{
  constexpr double max_density = 1e6; // for an extremity whose faces are gone; more is due to rounding
  std::vector<double> densities = vertex_areas(rings, points);
  for(std::size_t v = 0; v < densities.size(); ++v)
  {
    const double density = areas[v] / densities[v];
    densities[v] = density > 0. ? (std::min)((std::max)(density, 1. / max_density), max_density) : 1.;
  }
  return densities;
}

// The minimum weight of an edge if all weights must be positive: an edge opposite to two right angles has 0.
constexpr double min_positive_weight = 0.01; // small compared to the 0.58 of equilateral faces

// The cotangent weight of every edge, half the sum of the cotangents of the two opposite angles, in the order of the
// corners of `rings`: that of the edge (v, ring[j]) at rings.offset(v) + j. No weight is below `min_weight`. Both
// copies of a weight are bitwise equal.
inline std::vector<double> cotangent_weights(const Vertex_rings& rings, const std::vector<Vector_3d>& points,
                                             double min_weight)
{
  std::vector<double> weights(rings.number_of_corners());
  const auto opposite_cotangent = [&](std::uint32_t v, std::uint32_t p, std::uint32_t q) {
    const Rest_triangle rest = Rest_triangle::from_points(points[v], points[p], points[q]);
    return rest.opposite_2 / rest.inverse_doubled_area;
  };
  for(std::uint32_t v = 0; v < rings.number_of_vertices(); ++v)
  {
    const Vertex_rings::Ring ring = rings.ring(v);
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      const std::uint32_t w = ring[j];
      if(w < v)
        continue;
      const std::uint32_t left = ring.around(j + 1), right = ring.around(j + ring.size() - 1);
      const double weight = 0.5 * (opposite_cotangent(v, w, left) + opposite_cotangent(w, v, right));
      weights[rings.offset(v) + j] = weights[rings.offset(w) + rings.ring(w).position_of(v)] =
          (std::max)(weight, min_weight);
    }
  }
  return weights;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MESH_MEASURES_H
