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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_MAP_HINTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_MAP_HINTS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/surface/vertex_scalars.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// What is known of both surfaces beside their shapes, in the order of the caller.
struct Surface_map_hints
{
  std::array<std::vector<Vertex_scalars>, 2> features; // if there are none, those of the package are used
  std::vector<double> weights;                         // of these features; empty if all are the same
  bool compares_values = false;                        // of these features, and not ranks
  std::array<Mask, 2> masks;                           // where the surfaces do not count
  std::vector<std::array<std::uint32_t, 2>> landmarks;
  double landmark_weight = 0.; // 0: they are to be met exactly
  double feature_weight = 0.;
  bool keeps_alignment = false; // of the spheres as they are
};

// Brings the features to the scale in which they are compared, with their weights, and takes them and the masks to the own order
// of the surfaces.
inline void prepare_features(const std::array<const Surface*, 2>& surfaces, Surface_map_hints& hints)
{
  std::array<Vertex_scalars, 2> areas;
  for(std::size_t k = 0; k < 2; ++k)
  {
    const Surface& mesh = *surfaces[k];
    if(!hints.masks[k].empty())
      hints.masks[k] = mesh.in_own_order(hints.masks[k]);
    areas[k] = areas_outside(hints.masks[k], vertex_areas(mesh.rings(), mesh.points()));
    for(Vertex_scalars& feature : hints.features[k])
      feature = mesh.in_own_order(feature);
  }
  const double sum = std::accumulate(hints.weights.begin(), hints.weights.end(), 0.);
  const std::size_t n_features = hints.features[0].size();
  for(std::size_t i = 0; i < n_features; ++i)
  {
    std::array<Vertex_scalars*, 2> feature = {&hints.features[0][i], &hints.features[1][i]};
    if(hints.compares_values)
      standardize(feature, areas);
    const double factor = sum > 0. ? std::sqrt(hints.weights[i] / sum * static_cast<double>(n_features)) : 1.;
    for(std::size_t k = 0; k < 2; ++k)
    {
      if(!hints.compares_values)
        *feature[k] = ranks_by_area(*feature[k], areas[k]);
      continue_over(hints.masks[k], surfaces[k]->rings(), *feature[k]);
      for(double& x : *feature[k])
        x *= factor;
    }
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_MAP_HINTS_H
