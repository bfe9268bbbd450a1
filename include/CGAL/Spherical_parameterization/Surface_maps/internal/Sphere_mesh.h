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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SPHERE_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SPHERE_MESH_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>

#include <algorithm>
#include <cstddef>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The images of a surface on its sphere, with point location.
using Sphere_mesh = Sphere_triangulation<Sphere_kernel>;

inline Sphere_kernel::Point_3 point_of(const Vector_3d& p)
{
  return {p[0], p[1], p[2]};
}

inline std::vector<Sphere_kernel::Point_3> points_of(const std::vector<Vector_3d>& directions)
{
  std::vector<Sphere_kernel::Point_3> result;
  result.reserve(directions.size());
  for(const Vector_3d& p : directions)
    result.push_back(point_of(p));
  return result;
}

inline std::vector<Vector_3d> directions_of(const Sphere_mesh& sphere)
{
  std::vector<Vector_3d> result;
  result.reserve(sphere.points().size());
  for(std::size_t v = 0; v < sphere.points().size(); ++v)
    result.push_back(sphere.direction(v));
  return result;
}

inline std::vector<Vector_3d> rotated_directions(const Rotation_matrix& rotation, std::vector<Vector_3d> directions)
{
  for(Vector_3d& p : directions)
    p = normalized(rotated(rotation, p));
  return directions;
}

// The vertex with the largest barycentric coordinate of a location.
inline std::uint32_t nearest_vertex(const std::vector<Linked_triangle>& triangles,
                                    const Sphere_mesh::Triangle_location& location)
{
  const auto& w = location.coordinates;
  return triangles[location.triangle][static_cast<std::size_t>(std::max_element(w.begin(), w.end()) - w.begin())];
}

inline std::array<Vector_3d, 3> corners_of(const std::array<std::uint32_t, 3>& triangle,
                                           const std::vector<Vector_3d>& points)
{
  return {points[triangle[0]], points[triangle[1]], points[triangle[2]]};
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SPHERE_MESH_H
