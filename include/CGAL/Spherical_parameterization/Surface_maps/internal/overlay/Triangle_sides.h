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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_TRIANGLE_SIDES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_TRIANGLE_SIDES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// A side of a triangle is numbered 3 t + i if it is opposite to vertex i of triangle t, from vertex i + 1 to vertex
// i + 2. An edge has the number of its side in the triangle with the smaller number.
class Triangle_sides
{
public:
  using Index = std::uint32_t;

  explicit Triangle_sides(const std::vector<Linked_triangle>& triangles)
    : m_triangles(triangles)
  {}

  std::size_t size() const { return 3 * m_triangles.size(); }
  Index source(std::size_t side) const { return m_triangles[side / 3][(side % 3 + 1) % 3]; }
  Index target(std::size_t side) const { return m_triangles[side / 3][(side % 3 + 2) % 3]; }
  Index triangle(std::size_t side) const { return static_cast<Index>(side / 3); }
  Index opposite_triangle(std::size_t side) const { return m_triangles[side / 3].neighbors[side % 3]; }

  std::size_t opposite(std::size_t side) const
  {
    const Index t = opposite_triangle(side);
    return 3 * std::size_t(t) + m_triangles[t].side_of(triangle(side));
  }

  bool is_edge(std::size_t side) const { return triangle(side) < opposite_triangle(side); }
  std::size_t edge(std::size_t side) const { return is_edge(side) ? side : opposite(side); }

private:
  const std::vector<Linked_triangle>& m_triangles;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_TRIANGLE_SIDES_H
