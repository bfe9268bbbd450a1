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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_READ_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_READ_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Reads a map from the vertices of the caller's mesh and projects it to the unit sphere. Returns whether it is a
// bijection there.
template <class ConcurrencyTag, class VertexDescriptor, class VertexSphereMap>
bool read_map(const Indexed_mesh& mesh, const std::vector<VertexDescriptor>& vertices_of_mesh, VertexSphereMap map,
              std::vector<Vector_3d>& positions)
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  positions.resize(mesh.number_of_vertices());
  std::vector<Kernel::Point_3> points;
  points.reserve(positions.size());
  for(std::size_t v = 0; v < positions.size(); ++v)
  {
    const auto& p = get(map, vertices_of_mesh[mesh.original(v)]);
    const Vector_3d x = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
    const double size = (std::max)({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])}); // squares could overflow
    positions[v] = normalized({x[0] / size, x[1] / size, x[2] / size});
    points.push_back(Kernel::Point_3(positions[v][0], positions[v][1], positions[v][2]));
  }
  return certify_bijectivity<Kernel, ConcurrencyTag>(points, mesh.triangles()).is_bijective();
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_READ_MAP_H
