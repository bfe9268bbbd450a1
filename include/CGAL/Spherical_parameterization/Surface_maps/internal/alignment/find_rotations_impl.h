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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_FIND_ROTATIONS_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_FIND_ROTATIONS_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_levels.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Surface_alignment.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Surface_descriptor.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/find_rotations.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/surface/vertex_scalars.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code find_rotations(const Aligned_surface& first, const Aligned_surface& second, Sphere_alignment_3& alignment,
                          Run_control& control, const Execution& execution)
{
  constexpr std::size_t n_candidates = 4; // to choose from, where a surface is nearly symmetric
  std::array<std::optional<Surface_descriptor>, 2> coarse;
  for(std::size_t k = 0; k < 2; ++k)
  {
    const Aligned_surface& surface = k == 0 ? first : second;
    Surface mesh;
    if(const Error_code error = mesh.assign(surface.points, surface.triangles))
      return error;
    const Vertex_scalars areas = vertex_areas(mesh.rings(), mesh.points());
    std::vector<Vertex_scalars> ranks;
    for(const Vertex_scalars& feature : surface.features)
      ranks.push_back(ranks_by_area(mesh.in_own_order(feature), areas));
    coarse[k].emplace(Surface_levels(mesh, surface.directions, control, execution).coarse_surface(ranks, {}));
    if(!coarse[k]->is_bijective())
      return ERROR_INSUFFICIENT_PRECISION;
  }
  const Coarse_pair surfaces(std::move(*coarse[0]), std::move(*coarse[1]), control, execution);
  alignment.candidates.clear();
  for(const Scored_rotation& candidate : surfaces.best_rotations(n_candidates))
    alignment.candidates.push_back({as_transformation(candidate.rotation), candidate.score});
  alignment.is_stopped = control.is_stopped();
  return OK;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_FIND_ROTATIONS_IMPL_H
