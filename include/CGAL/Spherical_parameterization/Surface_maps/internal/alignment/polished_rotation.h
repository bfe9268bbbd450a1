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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_POLISHED_ROTATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_POLISHED_ROTATION_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Sphere_mesh.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The rotation that brings each vertex nearest to one of the second sphere, in a few rounds from a rotation that is nearly
// so. For copies of a sphere it is exact but for rounding.
inline Rotation_matrix polished(Rotation_matrix rotation, const Sphere_mesh& sphere1, const Sphere_mesh& sphere2,
                                Run_control& control, const Execution& execution)
{
  // One is enough where vertices are farther apart than the rotation is off; of dense copies, more meet in each further one.
  constexpr int n_rounds = 8;
  constexpr std::size_t block_size =
      4096; // that is located until the control is asked: exact signs take long on copies
  for(int round = 0; round < n_rounds; ++round)
  {
    const auto points = points_of(rotated_directions(rotation, directions_of(sphere1)));
    std::vector<std::pair<Vector_3d, Vector_3d>> pairs;
    for(std::size_t begin = 0; begin < points.size(); begin += block_size)
    {
      if(!control.go_further(0, 0.))
        return rotation;
      const auto end = static_cast<std::ptrdiff_t>((std::min)(begin + block_size, points.size()));
      const std::vector<Sphere_kernel::Point_3> block(points.begin() + static_cast<std::ptrdiff_t>(begin),
                                                      points.begin() + end);
      for(const auto& location : sphere2.locate(block, execution))
        pairs.emplace_back(sphere1.direction(pairs.size()),
                           sphere2.direction(nearest_vertex(sphere2.triangles(), location)));
    }
    if(const std::optional<Rotation_matrix> next = fitting_rotation(pairs))
      rotation = *next;
  }
  return rotation;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_POLISHED_ROTATION_H
