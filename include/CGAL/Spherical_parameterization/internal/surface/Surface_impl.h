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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE int normalize(std::vector<Vector_3d>& points, Vector_3d* origin)
{
  if(points.empty())
    return 0;
  Vector_3d low = points[0], high = low;
  for(const Vector_3d& p : points)
    for(std::size_t i = 0; i < 3; ++i)
    {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  double extent = 0.;
  for(std::size_t i = 0; i < 3; ++i)
    extent = (std::max)(extent, 0.5 * high[i] - 0.5 * low[i]); // halves, because the difference may overflow
  int exponent = 0;
  if(extent > 0.)
    std::frexp(extent, &exponent);
  const Vector_3d center = 0.5 * low + 0.5 * high;
  const int first = -exponent / 2, second = -exponent - first; // 2^-exponent may overflow itself
  const double factor = std::ldexp(1., first), other_factor = std::ldexp(1., second);
  for(Vector_3d& p : points)
    p = other_factor * (factor * (p - center));
  if(origin)
    *origin = center;
  return exponent;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code Surface::assign(std::vector<Vector_3d> points,
                                                                  const std::vector<Linked_triangle>& triangles)
{
  m_unit.exponent = normalize(points);
  m_points = std::move(points);
  Vertex_rings rings;
  if(!build_rings(triangles, m_points.size(), rings))
    return ERROR_NO_SIMPLICIAL_COMPLEX;
  if(m_points.size() < 4)
    return ERROR_TOO_FEW_VERTICES;
  if(!renumber(rings))
    return ERROR_SEVERAL_COMPONENTS;
  if(2 * m_points.size() != triangles.size() + 4) // Euler: V - E + F = 2 with 2 E = 3 F
    return ERROR_NO_TOPOLOGICAL_SPHERE;
  scale_to_area_of_unit_sphere();
  return OK;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Index_triangles Surface::callers_triangles() const
{
  Index_triangles result;
  result.reserve(m_rings.number_of_faces());
  m_rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    result.push_back({m_originals[a], m_originals[b], m_originals[c]});
  });
  return result;
}

// Whether p is farther from the origin o than q, by more than rounding errors; for ties, the first of the caller's
// vertices is chosen, wherever the surface is in space.
inline bool is_farther(const Vector_3d& p, const Vector_3d& q, const Vector_3d& o)
{
  return squared_length(p - o) > (1. + 1e-7) * squared_length(q - o);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE bool Surface::renumber(const Vertex_rings& rings)
{
  const std::size_t n = m_points.size();
  Vector_3d center = {0., 0., 0.};
  for(const Vector_3d& p : m_points)
    center = center + (1. / static_cast<double>(n)) * p;
  std::uint32_t start = 0;
  for(std::uint32_t v = 1; v < n; ++v)
    if(is_farther(m_points[v], m_points[start], center))
      start = v;

  std::vector<std::uint32_t> order, entry(n), number(n, none); // entry[v]: where the ring of v starts
  order.reserve(n);
  const auto visit = [&](std::uint32_t v, std::uint32_t from) {
    number[v] = static_cast<std::uint32_t>(order.size());
    order.push_back(v);
    entry[v] = from;
  };
  std::uint32_t farthest = rings.ring(start)[0];
  for(const std::uint32_t w : rings.ring(start))
    if(is_farther(m_points[w], m_points[farthest], m_points[start]))
      farthest = w;
  visit(start, farthest);
  m_rings = Vertex_rings();
  m_rings.reserve(n, rings.number_of_corners());
  for(std::size_t k = 0; k < order.size(); ++k)
  {
    const Vertex_rings::Ring ring = rings.ring(order[k]);
    const std::size_t shift = ring.position_of(entry[order[k]]);
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      const std::uint32_t w = ring.around(shift + j);
      if(number[w] == none)
        visit(w, order[k]);
      m_rings.push_neighbor(number[w]);
    }
    m_rings.end_ring();
  }
  if(order.size() < n)
    return false;

  m_originals = std::move(order);
  m_points = in_own_order(m_points);
  return true;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE void Surface::scale_to_area_of_unit_sphere()
{
  double area = 0.;
  m_number_of_flat_faces = 0;
  m_rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    area += 0.5 * length(cross(m_points[b] - m_points[a], m_points[c] - m_points[a]));
  });
  // A surface without area is measured by its extent, which is about 1 after normalize().
  m_unit.factor = area > (std::numeric_limits<double>::min)() ? std::sqrt(area / (4. * CGAL_PI)) : 1.;
  for(Vector_3d& p : m_points)
    p = (1. / m_unit.factor) * p;
  m_rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    m_number_of_flat_faces += Rest_triangle::is_too_flat(m_points[a], m_points[b], m_points[c]);
  });
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_IMPL_H
