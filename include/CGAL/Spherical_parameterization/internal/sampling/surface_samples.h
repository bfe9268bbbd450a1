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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_SURFACE_SAMPLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_SURFACE_SAMPLES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/number_utils.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// what the vertices have, interpolated at a place
template <class Place>
Vector_3d interpolated(const std::vector<Vector_3d>& values, const std::vector<Linked_triangle>& triangles,
                       const Place& place)
{
  const Linked_triangle& t = triangles[place.triangle];
  const auto& w = place.coordinates;
  return CGAL::to_double(w[0]) * values[t[0]] + CGAL::to_double(w[1]) * values[t[1]] +
         CGAL::to_double(w[2]) * values[t[2]];
}

inline Vector_3d normalized_or_zero(const Vector_3d& v)
{
  return length(v) > 0. ? normalized(v) : v;
}

// the normals of the vertices: sums of those of the faces, weighted with their areas
inline std::vector<Vector_3d> vertex_normals(const std::vector<Vector_3d>& points,
                                             const std::vector<Linked_triangle>& triangles)
{
  std::vector<Vector_3d> result(points.size(), Vector_3d{0., 0., 0.});
  for(const Linked_triangle& t : triangles)
  {
    const Vector_3d normal = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    for(const std::uint32_t v : t.vertices)
      result[v] = result[v] + normal;
  }
  for(Vector_3d& normal : result)
    normal = normalized_or_zero(normal);
  return result;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_SURFACE_SAMPLES_H
