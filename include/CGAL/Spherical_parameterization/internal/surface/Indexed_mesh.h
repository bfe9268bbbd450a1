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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_INDEXED_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_INDEXED_MESH_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A closed triangle mesh of genus 0 as flat arrays: the points, scaled such that the area is 4 pi, and the rings of the
// vertices.
//
// The numbering is the package's own: breadth first from the vertex that is farthest from the centre, around each
// vertex in counterclockwise order. It follows from the shape of the surface alone, not from the position of the
// surface in space, and not from the order of the caller's vertices unless several are the farthest; and so does
// everything that is computed from it. Besides, neighbours get close numbers.
class Indexed_mesh
{
public:
  // Takes the mesh with these points and triangles, all of them oriented alike. Vertices without a triangle are left
  // out.
  Error_code assign(std::vector<Vector_3d> points, const std::vector<std::array<std::uint32_t, 3>>& triangles)
  {
    for(const Vector_3d& p : points)
      if(!is_finite(p))
        return ERROR_NON_FINITE_COORDINATE;
    normalize(points);

    Vertex_rings rings;
    std::vector<std::uint32_t> used; // the vertices of the rings, with the numbers of `points`
    if(!build_rings(points.size(), triangles, rings, used))
      return ERROR_NO_SIMPLICIAL_COMPLEX;
    if(used.size() < 4)
      return ERROR_TOO_FEW_VERTICES;
    m_points.resize(used.size());
    for(std::size_t v = 0; v < used.size(); ++v)
      m_points[v] = points[used[v]];

    if(!renumber(rings, used))
      return ERROR_SEVERAL_COMPONENTS;
    if(2 * m_points.size() != triangles.size() + 4) // Euler: V - E + F = 2 with 2 E = 3 F
      return ERROR_NO_TOPOLOGICAL_SPHERE;
    scale_to_unit_area();
    return OK;
  }

  std::size_t number_of_vertices() const { return m_points.size(); }
  const std::vector<Vector_3d>& points() const { return m_points; }
  const Vertex_rings& rings() const { return m_rings; }

  std::vector<std::array<std::uint32_t, 3>> triangles() const
  {
    std::vector<std::array<std::uint32_t, 3>> result;
    result.reserve(m_rings.number_of_faces());
    m_rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { result.push_back({a, b, c}); });
    return result;
  }

  // the number that a vertex has in the arrays that the mesh was taken from
  std::uint32_t original(std::size_t v) const { return m_originals[v]; }

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
  // Moves the points around the origin and scales them to a size of about 1 by a power of two, which is exact.
  void normalize(std::vector<Vector_3d>& points)
  {
    Vector_3d low = {0., 0., 0.}, high = {0., 0., 0.};
    if(!points.empty())
      low = high = points[0];
    for(const Vector_3d& p : points)
      for(std::size_t i = 0; i < 3; ++i)
      {
        low[i] = (std::min)(low[i], p[i]);
        high[i] = (std::max)(high[i], p[i]);
      }
    double extent = 0.;
    for(std::size_t i = 0; i < 3; ++i)
      extent = (std::max)(extent, 0.5 * high[i] - 0.5 * low[i]); // halves, because the difference may overflow
    m_exponent = 0;
    if(extent > 0.)
      std::frexp(extent, &m_exponent);
    const Vector_3d center = 0.5 * low + 0.5 * high;
    if(std::abs(m_exponent) < 1000)
    {
      const double factor = std::ldexp(1., -m_exponent);
      for(Vector_3d& p : points)
        p = factor * (p - center);
      return;
    }
    // In two steps, because 2^-m_exponent may overflow itself.
    const int first = -m_exponent / 2, second = -m_exponent - first;
    for(Vector_3d& p : points)
      for(std::size_t i = 0; i < 3; ++i)
        p[i] = std::ldexp(std::ldexp(p[i] - center[i], first), second);
  }

  // Builds the rings of all vertices that have a triangle, renumbered without the others. Fails if a vertex meets
  // another one twice, if its triangles form more than one fan, or if they leave a gap.
  static bool build_rings(std::size_t n, const std::vector<std::array<std::uint32_t, 3>>& triangles,
                          Vertex_rings& rings, std::vector<std::uint32_t>& used)
  {
    std::vector<std::uint32_t> first(n + 1, 0);
    for(const auto& t : triangles)
      for(const std::uint32_t v : t)
        ++first[v + 1];
    std::vector<std::uint32_t> number(n, none);
    for(std::size_t v = 0; v < n; ++v)
    {
      if(first[v + 1] > 0)
      {
        number[v] = static_cast<std::uint32_t>(used.size());
        used.push_back(static_cast<std::uint32_t>(v));
      }
      first[v + 1] += first[v];
    }
    std::vector<std::array<std::uint32_t, 2>> sides(3 * triangles.size()); // of the triangles at each vertex
    std::vector<std::uint32_t> end(first.begin(), first.end() - 1);
    for(const auto& t : triangles)
      for(std::size_t i = 0; i < 3; ++i)
        sides[end[t[i]]++] = {number[t[(i + 1) % 3]], number[t[(i + 2) % 3]]};

    rings.reserve(used.size(), sides.size());
    std::vector<std::uint32_t> successor(used.size(), none); // around the vertex at hand
    for(const std::uint32_t v : used)
    {
      for(std::uint32_t k = first[v]; k < first[v + 1]; ++k)
      {
        if(successor[sides[k][0]] != none)
          return false;
        successor[sides[k][0]] = sides[k][1];
      }
      std::uint32_t w = sides[first[v]][0];
      for(std::uint32_t k = first[v]; k < first[v + 1]; ++k)
      {
        if(w == none || successor[w] == none)
          return false;
        rings.push_neighbor(w);
        const std::uint32_t next = successor[w];
        successor[w] = none;
        w = next;
      }
      if(w != sides[first[v]][0])
        return false;
      rings.end_ring();
    }
    return true;
  }

  // Gives the vertices of `rings` and m_points their final numbers. Fails if some cannot be reached from the others.
  bool renumber(const Vertex_rings& rings, const std::vector<std::uint32_t>& used)
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
    for(std::size_t k = 0; k < order.size(); ++k)
    {
      const Vertex_rings::Ring ring = rings.ring(order[k]);
      const std::size_t d = ring.size(), shift = position(ring, entry[order[k]]);
      for(std::size_t j = 0; j < d; ++j)
      {
        const std::uint32_t w = ring.around(shift + j);
        if(number[w] == none)
          visit(w, order[k]);
      }
    }
    if(order.size() < n)
      return false;

    std::vector<Vector_3d> points(n);
    m_originals.resize(n);
    m_rings = Vertex_rings();
    m_rings.reserve(n, rings.number_of_corners());
    for(std::size_t k = 0; k < n; ++k)
    {
      points[k] = m_points[order[k]];
      m_originals[k] = used[order[k]];
      const Vertex_rings::Ring ring = rings.ring(order[k]);
      const std::size_t d = ring.size(), shift = position(ring, entry[order[k]]);
      for(std::size_t j = 0; j < d; ++j)
        m_rings.push_neighbor(number[ring.around(shift + j)]);
      m_rings.end_ring();
    }
    m_points.swap(points);
    return true;
  }

  // whether p is farther from the origin o than q by more than rounding can make it; where a shape has ties, the first
  // of the caller's vertices is chosen, wherever the shape is placed
  static bool is_farther(const Vector_3d& p, const Vector_3d& q, const Vector_3d& o)
  {
    return squared_length(p - o) > (1. + 1e-7) * squared_length(q - o);
  }

  static std::size_t position(const Vertex_rings::Ring& ring, std::uint32_t v)
  {
    return static_cast<std::size_t>(std::find(ring.begin(), ring.end(), v) - ring.begin());
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
      if(Rest_triangle::is_too_flat(m_points[a], m_points[b], m_points[c]))
        ++m_number_of_flat_faces;
    });
  }

  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  std::vector<Vector_3d> m_points;
  Vertex_rings m_rings;
  std::vector<std::uint32_t> m_originals;
  std::size_t m_number_of_flat_faces = 0;
  double m_unit = 1.; // the length that is 1 here is m_unit * 2^m_exponent in the caller's unit
  int m_exponent = 0;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_INDEXED_MESH_H
