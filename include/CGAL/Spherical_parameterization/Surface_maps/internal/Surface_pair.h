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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_PAIR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_PAIR_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_on_sphere.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_metric.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/surface/vertex_scalars.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A surface on its sphere, with point location. Points are scaled by powers of two: the unit of length of `points` is 2 to the
// power of `exponent`, see normalize().
struct Located_surface
{
  Surface mesh; // the same surface in its internal order; all other members are in the order of the caller
  Sphere_mesh sphere;
  std::vector<Vector_3d> points;
  int exponent = 0;

  Error_code assign(Surface_on_sphere surface)
  {
    if(const Error_code error = mesh.assign(surface.points, surface.triangles))
      return error;
    points = std::move(surface.points);
    exponent = normalize(points);
    sphere.assign(std::move(surface.images), std::move(surface.triangles));
    sphere.make_grid();
    return OK;
  }
};

// Converts features to the scale in which they are compared, including their weights, and converts features and masks to the
// internal order of the surfaces.
inline void prepare_features(const std::array<const Surface*, 2>& surfaces, Surface_map_settings& settings)
{
  std::array<Vertex_scalars, 2> areas;
  for(std::size_t k = 0; k < 2; ++k)
  {
    const Surface& mesh = *surfaces[k];
    if(!settings.masks[k].empty())
      settings.masks[k] = mesh.in_own_order(settings.masks[k]);
    areas[k] = areas_outside(settings.masks[k], vertex_areas(mesh.rings(), mesh.points()));
    for(Vertex_scalars& feature : settings.features[k])
      feature = mesh.in_own_order(feature);
  }
  const std::vector<double>& weights = settings.feature_weights;
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
  const std::size_t n_features = settings.features[0].size();
  for(std::size_t i = 0; i < n_features; ++i)
  {
    std::array<Vertex_scalars*, 2> feature = {&settings.features[0][i], &settings.features[1][i]};
    if(settings.compares_values)
      standardize(feature, areas);
    const double factor = sum > 0. ? std::sqrt(weights[i] / sum * static_cast<double>(n_features)) : 1.;
    for(std::size_t k = 0; k < 2; ++k)
    {
      if(!settings.compares_values)
        *feature[k] = ranks_by_area(*feature[k], areas[k]);
      continue_over(settings.masks[k], surfaces[k]->rings(), *feature[k]);
      for(double& x : *feature[k])
        x *= factor;
    }
  }
}

// The two surfaces of a map from the first to the second one, with the data that all stages require.
struct Surface_pair
{
  const Located_surface &first, &second;
  const Surface_map_settings& settings;
  Run_control& control;
  const Execution& execution;
  Target_metric metric;                                   // the metric of the second surface
  std::vector<std::pair<Vector_3d, Vector_3d>> landmarks; // the directions of landmarks on both spheres
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_PAIR_H
