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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SLIVER_VERTICES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SLIVER_VERTICES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Marks the vertices of slivers: faces whose height is below a hundredth of their longest edge. No map of low distortion
// gives them their shape, so that their energies may exceed those of all other faces by orders of magnitude. The faces
// around these vertices, which have to make room for them, are the group of the slivers.
//
// The result is empty if there is none, or if the group is so large that the surface is made of it.
inline std::vector<char> sliver_vertices(const Vertex_rings& rings, const std::vector<Vector_3d>& points)
{
  constexpr double max_height = 0.01, max_share = 0.25;
  std::vector<char> result(rings.number_of_vertices(), 0);
  rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if(Rest_triangle::height(points[a], points[b], points[c]) < max_height)
      result[a] = result[b] = result[c] = 1;
  });
  std::size_t size_of_group = 0;
  rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    size_of_group += result[a] || result[b] || result[c] ? 1u : 0u;
  });
  if(size_of_group == 0 ||
     static_cast<double>(size_of_group) > max_share * static_cast<double>(rings.number_of_faces()))
    result.clear();
  return result;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SLIVER_VERTICES_H
