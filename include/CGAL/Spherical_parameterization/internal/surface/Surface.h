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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Moves points around the origin and scales them to a size of about 1 by a power of two, which is exact; returns its
// exponent, and `origin`, where it is not null, becomes the point that is the origin now. Products of coordinates neither
// overflow nor underflow then, so that nothing that works on normalized points has to guard against it.
inline int normalize(std::vector<Vector_3d>& points, Vector_3d* origin = nullptr)
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
  const int first = -exponent / 2, second = -exponent - first; // as 2^-exponent may overflow itself
  const double factor = std::ldexp(1., first), other_factor = std::ldexp(1., second);
  for(Vector_3d& p : points)
    p = other_factor * (factor * (p - center));
  if(origin)
    *origin = center;
  return exponent;
}

// A closed triangle mesh of genus 0 as flat arrays: the points, scaled such that the area is 4 pi, and the rings of the
// vertices.
//
// The numbering is its own: breadth first from the vertex that is farthest from the centre, around each vertex in
// counterclockwise order. It follows from the shape of the surface alone, not from its position in space, and not from
// the order of the caller's vertices unless several are the farthest; and so does everything that is computed from it.
// Besides, neighbours get close numbers.
class Surface
{
public:
  // Takes the mesh with these points, which are finite, and these triangles, none if link_triangles() has failed.
  Error_code assign(std::vector<Vector_3d> points, const std::vector<Linked_triangle>& triangles)
  {
    m_exponent = normalize(points);
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
    scale_to_unit_area();
    return OK;
  }

  std::size_t number_of_vertices() const { return m_points.size(); }
  const std::vector<Vector_3d>& points() const { return m_points; }
  const Vertex_rings& rings() const { return m_rings; }

  // The triangles, in the caller's numbers.
  Index_triangles callers_triangles() const
  {
    Index_triangles result;
    result.reserve(m_rings.number_of_faces());
    m_rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      result.push_back({m_originals[a], m_originals[b], m_originals[c]});
    });
    return result;
  }

  // What the vertices have, from the order of the arrays that the surface was taken from to its own, and back.
  template <class T>
  std::vector<T> in_own_order(const std::vector<T>& callers) const
  {
    const std::size_t n = callers.size() / m_originals.size(); // of each vertex
    std::vector<T> result;
    result.reserve(callers.size());
    for(const std::size_t v : m_originals)
      result.insert(result.end(), callers.begin() + static_cast<std::ptrdiff_t>(n * v),
                    callers.begin() + static_cast<std::ptrdiff_t>(n * (v + 1)));
    return result;
  }
  template <class T>
  std::vector<T> in_callers_order(const std::vector<T>& own) const
  {
    std::vector<T> result(own.size());
    for(std::size_t v = 0; v < own.size(); ++v)
      result[m_originals[v]] = own[v];
    return result;
  }

  std::size_t number_of_flat_faces() const { return m_number_of_flat_faces; }

  // The radius of the sphere that has the area of the surface, in the caller's unit of length: the length that is 1
  // here. A surface that reaches to the ends of the range of doubles gets the largest sphere that fits.
  double equal_area_radius() const
  {
    return (std::min)(std::ldexp(m_unit, m_exponent), 0.25 * (std::numeric_limits<double>::max)());
  }

  // converts a radius in the caller's unit of length to the one of the mesh
  double scaled_radius(double radius) const { return std::ldexp(radius, -m_exponent) / m_unit; }

private:
  // Gives the vertices of `rings` and m_points their final numbers. Fails if some cannot be reached from the others.
  bool renumber(const Vertex_rings& rings)
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

  // whether p is farther from the origin o than q by more than rounding can make it; where a shape has ties, the first
  // of the caller's vertices is chosen, wherever the shape is placed
  static bool is_farther(const Vector_3d& p, const Vector_3d& q, const Vector_3d& o)
  {
    return squared_length(p - o) > (1. + 1e-7) * squared_length(q - o);
  }

  void scale_to_unit_area()
  {
    double area = 0.;
    m_number_of_flat_faces = 0;
    m_rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      area += 0.5 * length(cross(m_points[b] - m_points[a], m_points[c] - m_points[a]));
    });
    // A surface without area is measured by its extent, which normalize() has made about 1.
    m_unit = area > (std::numeric_limits<double>::min)() ? std::sqrt(area / (4. * CGAL_PI)) : 1.;
    for(Vector_3d& p : m_points)
      p = (1. / m_unit) * p;
    m_rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      m_number_of_flat_faces += Rest_triangle::is_too_flat(m_points[a], m_points[b], m_points[c]);
    });
  }

  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  std::vector<Vector_3d> m_points;
  Vertex_rings m_rings;
  std::vector<std::uint32_t> m_originals; // the numbers of the vertices in the arrays of the caller
  std::size_t m_number_of_flat_faces = 0;
  double m_unit = 1.; // the length that is 1 here is m_unit * 2^m_exponent in the caller's unit
  int m_exponent = 0;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_H
