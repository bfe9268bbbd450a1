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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_LEVELS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_LEVELS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Surface_descriptor.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/map_score.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_levels.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The levels of a surface on its sphere, down to the level that is compared with other surfaces.
class Surface_levels
{
public:
  // The directions are those of the images, in the order of the caller.
  Surface_levels(const Surface& mesh, const std::vector<Vector_3d>& directions, Run_control& control,
                 const Execution& execution)
    : m_mesh(mesh)
    , m_images(mesh.in_own_order(rotated_directions(rotation_matrix({1., 0., 0., 0.}), directions)))
    , m_hierarchy(mesh.rings(), mesh.points(), vertex_areas(mesh.rings(), mesh.points()), control, execution, m_images,
                  {}, Surface_descriptor::max_size)
  {}

  // Features and mask are in the order of the mesh.
  Surface_descriptor coarse_surface(const std::vector<Vertex_scalars>& features, const Mask& mask) const
  {
    return Surface_descriptor(m_hierarchy, m_mesh, m_images, features, mask);
  }

  // Refines a map of the coarsest level to the finest one; `positions` receives it. Returns false if double precision does not
  // suffice. The levels are consumed.
  bool lower(const std::vector<Vector_3d>& coarse, const Target_goals& goals, std::vector<Vector_3d>& positions,
             Run_control& control, const Execution& execution)
  {
    return lower(m_hierarchy, coarse, goals, Target_sweeps(), positions, control, execution);
  }

  // The agreement of features with these weights for a map of the coarsest level after refinement to a level of up to 8000 vertices,
  // where the features of the mesh contain more detail. The lowest value of double if double precision does not suffice.
  double agreement_on_finer_level(const std::vector<Vector_3d>& coarse, const Target_goals& goals,
                                  const std::vector<double>& weights, Run_control& control,
                                  const Execution& execution) const
  {
    constexpr std::size_t max_size = 8000;
    constexpr Target_sweeps sweeps = {10, 1e-3, 0.04}; // With six times as many, the same alignments win.
    std::size_t k = 0;
    while(k + 1 < m_hierarchy.number_of_levels() && m_hierarchy.level(k).vertices.size() > max_size)
      ++k;
    Mesh_hierarchy levels = m_hierarchy.from_level(k);
    std::vector<Vector_3d> positions;
    if(!lower(levels, coarse, goals, sweeps, positions, control, execution))
      return std::numeric_limits<double>::lowest();
    return feature_agreement(goals.features, levels.level(0), positions, weights);
  }

private:
  bool lower(Mesh_hierarchy& levels, const std::vector<Vector_3d>& coarse, const Target_goals& goals,
             const Target_sweeps& sweeps, std::vector<Vector_3d>& positions, Run_control& control,
             const Execution& execution) const
  {
    const Mesh_hierarchy::Level& level = levels.level(levels.number_of_levels() - 1);
    positions = m_images;
    for(std::size_t v = 0; v < coarse.size(); ++v)
      positions[level.vertices[v]] = coarse[v];
    return minimize_on_levels(levels, m_mesh.points(), m_images, goals, sweeps, positions, control, execution);
  }

  const Surface& m_mesh;
  std::vector<Vector_3d> m_images; // in the order of the mesh
  Mesh_hierarchy m_hierarchy;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_LEVELS_H
