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
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Translates points to the origin and scales them to a size of about 1 by a power of two, which is exact. Returns its
// exponent; `origin`, if it is not null, receives the original position of the new origin. Products of coordinates of
// normalized points neither overflow nor underflow, so later computations need not guard against it.
int normalize(std::vector<Vector_3d>& points, Vector_3d* origin = nullptr);

// The length 1 of a surface of the area 4 pi, in the caller's unit of length: factor * 2^exponent.
struct Length_unit
{
  double factor = 1.;
  int exponent = 0;

  // The radius of the sphere that has the area of the surface, in the caller's unit. For a surface at the limits of the
  // range of double, it is the radius of the largest representable sphere.
  double equal_area_radius() const
  {
    return (std::min)(std::ldexp(factor, exponent), 0.25 * (std::numeric_limits<double>::max)());
  }

  // Converts a radius from the caller's unit.
  double scaled_radius(double radius) const { return std::ldexp(radius, -exponent) / factor; }
};

// A closed triangle mesh of genus 0 as flat arrays: the points, scaled to the area 4 pi, and the rings of the vertices.
//
// It has its own vertex order: breadth first from the vertex that is farthest from the center, and around each vertex
// in counterclockwise order. This order depends only on the shape of the surface, not on its position in space, nor on
// the order of the caller's vertices unless several are the farthest; the same then holds for all results. In addition,
// neighbors get indices that are close to each other.
class Surface
{
public:
  // Sets the mesh with these points, which are finite, and these triangles, none if link_triangles() has failed.
  Error_code assign(std::vector<Vector_3d> points, const std::vector<Linked_triangle>& triangles);

  std::size_t number_of_vertices() const { return m_points.size(); }
  const std::vector<Vector_3d>& points() const { return m_points; }
  const Vertex_rings& rings() const { return m_rings; }

  // The triangles, with the caller's indices.
  Index_triangles callers_triangles() const;

  // Converts values of vertices from the order of the caller's arrays to the order of the surface, and back.
  template <class T>
  std::vector<T> in_own_order(const std::vector<T>& callers) const
  {
    const std::size_t n = callers.size() / m_originals.size(); // per vertex
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

  const Length_unit& unit() const { return m_unit; }
  double equal_area_radius() const { return m_unit.equal_area_radius(); }

private:
  // Assigns final indices to the vertices of `rings` and m_points. Fails if the mesh is not connected.
  bool renumber(const Vertex_rings& rings);

  void scale_to_area_of_unit_sphere();

  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  std::vector<Vector_3d> m_points;
  Vertex_rings m_rings;
  std::vector<std::uint32_t> m_originals; // the indices of the vertices in the caller's arrays
  std::size_t m_number_of_flat_faces = 0;
  Length_unit m_unit;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/internal/surface/Surface_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_H
