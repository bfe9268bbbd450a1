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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EMBED_HIERARCHICALLY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EMBED_HIERARCHICALLY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Relative_sharpness_3.h>
#include <CGAL/Spherical_parameterization/internal/Guarded_energy.h>
#include <CGAL/Spherical_parameterization/internal/Hierarchical_embedding.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/Rest_limits.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/update_on_coarse_levels.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// An update that moves vertices one by one even if it could move several at once, which compiles faster.
template <class VertexUpdate>
struct One_by_one
{
  VertexUpdate update;

  template <class VertexEnergy>
  bool operator()(const VertexEnergy& energy, std::array<double, 2>& step) const
  {
    return update(energy, step);
  }

  One_by_one on_coarse_levels() const { return {update_on_coarse_levels(update)}; }
};

// Maps a mesh to the unit sphere through a hierarchy. It may happen that faces get so small that doubles cannot hold
// the map: because the energy lets them, as a conformal one does on long limbs, or because the surface itself has no
// room for them, as where many vertices share one place. Then it is tried again with a growing guard against the former
// and growing limits of the latter, and in the end without regard to the surface, each face having the same room, with
// more and more sweeps. Returns whether there is a map. The finest level is only swept if `sweeps_finest_level`, as the
// levels are.
template <class ConcurrencyTag, class Energy, class SharpnessPolicy, class VertexUpdate, class RunControl>
bool embed_hierarchically(const Indexed_mesh& mesh, const Energy& energy, const SharpnessPolicy& sharpness,
                          const VertexUpdate& update, std::size_t sweeps_per_level, bool sweeps_finest_level,
                          std::vector<Vector_3d>& positions, RunControl& control)
{
  const auto embed = [&](const auto& level_energy, const auto& level_sharpness, const auto& level_update,
                         const Rest_limits& limits, std::size_t sweeps_factor) {
    // An attempt uses the hierarchy up, and a second one is rare.
    Mesh_hierarchy hierarchy = Mesh_hierarchy::build<ConcurrencyTag>(mesh.rings(), mesh.points());
    if(++control.report().number_of_attempts == 1)
    {
      control.report().number_of_levels = hierarchy.number_of_levels();
      control.report().seconds_for_hierarchy = control.lap();
    }
    Hierarchical_embedding<std::decay_t<decltype(level_energy)>, std::decay_t<decltype(level_sharpness)>,
                           std::decay_t<decltype(level_update)>, ConcurrencyTag>
        embedding(hierarchy, mesh.points(), level_energy, level_sharpness, level_update,
                  sweeps_factor * sweeps_per_level, limits);
    return embedding.run(positions, sweeps_finest_level, control);
  };
  const auto embed_guarded = [&](double weight, const Rest_limits& limits, std::size_t sweeps_factor) {
    return embed(Guarded_energy<Energy>(energy, weight), Relative_sharpness_3(0.), One_by_one<VertexUpdate>{update},
                 limits, sweeps_factor);
  };
  bool is_embedded = embed(energy, sharpness, update, Rest_limits(), 1);
  for(const double weight : {1e-10, 1e-8, 1e-6, 1e-4, 1e-2})
    is_embedded = is_embedded || embed_guarded(weight, {std::pow(weight, 0.25), 0.1 * weight, false}, 1);
  Rest_limits without_shape;
  without_shape.is_uniform = true;
  for(const std::size_t sweeps_factor : {std::size_t(1), std::size_t(4), std::size_t(16)})
    is_embedded = is_embedded || embed_guarded(1., without_shape, sweeps_factor);
  control.report().seconds_for_embedding = control.lap();
  return is_embedded;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EMBED_HIERARCHICALLY_H
