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

#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/sampling/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/simd/Vector_3.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// what the vertices have, interpolated at places
template <class Place>
std::vector<Vector_3d> interpolated(const std::vector<Vector_3d>& values, const std::vector<Linked_triangle>& triangles,
                                    const std::vector<Place>& places, const Execution& execution)
{
  constexpr std::size_t block_size = 4096;
  std::vector<Vector_3d> result(places.size());
  for_each_block(execution, 0, places.size(), block_size, [&](std::size_t begin, std::size_t end) {
    for(std::size_t k = begin; k < end; ++k)
    {
      const Linked_triangle& t = triangles[places[k].triangle];
      const auto& w = places[k].coordinates;
      result[k] = CGAL::to_double(w[0]) * values[t[0]] + CGAL::to_double(w[1]) * values[t[1]] +
                  CGAL::to_double(w[2]) * values[t[2]];
    }
  });
  return result;
}

// the same vectors with length 1, but for those without a length
inline void normalize(std::vector<Vector_3d>& vectors)
{
  for(Vector_3d& v : vectors)
    if(length(v) > 0.)
      v = normalized(v);
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
  normalize(result);
  return result;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_SURFACE_SAMPLES_H
