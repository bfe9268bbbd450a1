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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERTEX_AREAS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERTEX_AREAS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// returns for each vertex a third of the area of its faces
inline std::vector<double> vertex_areas(const Vertex_rings& rings, const std::vector<Vector_3d>& points)
{
  std::vector<double> areas(rings.number_of_vertices(), 0.);
  rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const double third = length(cross(points[b] - points[a], points[c] - points[a])) / 6.;
    areas[a] += third;
    areas[b] += third;
    areas[c] += third;
  });
  return areas;
}

// the same to weigh the vertices with, so that they have a centre of mass even if the surface has no area
inline std::vector<double> vertex_masses(const Vertex_rings& rings, const std::vector<Vector_3d>& points)
{
  std::vector<double> masses = vertex_areas(rings, points);
  if(!(std::accumulate(masses.begin(), masses.end(), 0.) > 0.))
    masses.assign(masses.size(), 1.);
  return masses;
}

// How much more area the vertices of a coarse mesh stand for than they have: 1 where nothing has been lost. A vertex
// whose faces have no area is left alone, as their rest shapes are not their own.
inline std::vector<double> vertex_densities(const Vertex_rings& rings, const std::vector<Vector_3d>& points,
                                            const std::vector<double>& areas)
{
  constexpr double largest_density = 1e6;
  std::vector<double> densities = vertex_areas(rings, points);
  for(std::size_t v = 0; v < densities.size(); ++v)
  {
    const double density = areas[v] / densities[v];
    densities[v] = density > 0. ? (std::min)((std::max)(density, 1. / largest_density), largest_density) : 1.;
  }
  return densities;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERTEX_AREAS_H
