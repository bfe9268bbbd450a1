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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_LOCATIONS_OF_VERTICES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_LOCATIONS_OF_VERTICES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <cstdint>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Where the vertices of a connected triangulation of the sphere are in another one, which needs no grid: each is found by a
// walk from the place of a neighbour. Vertices without a triangle are in none.
template <class K>
std::vector<typename Sphere_triangulation<K>::Triangle_location> locations_of_vertices(
    const Sphere_triangulation<K>& of, const Sphere_triangulation<K>& in)
{
  constexpr std::uint32_t none = Sphere_triangulation<K>::none;
  std::vector<typename Sphere_triangulation<K>::Triangle_location> result(of.points().size());
  visit_from_neighbors(of.triangles(), of.points().size(), none, [&](std::uint32_t v, std::uint32_t w) {
    result[v] = in.locate_from(w == none ? 0 : result[w].triangle, of.points()[v]);
  });
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_LOCATIONS_OF_VERTICES_H
