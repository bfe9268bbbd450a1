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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FEATURE_GOALS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FEATURE_GOALS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_pair.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Coarse_pair.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

// The features that guide a map on levels that are finer than the coarse surfaces.

namespace CGAL::Spherical_parameterization::internal {

// The features of the package at the vertices of one of the surfaces, in the order of the mesh: those of the coarse surface, and the
// curvature of the mesh itself, which is not preserved on the coarse surface.
inline std::vector<Vertex_scalars> own_features(const Located_surface& surface, const Sphere_image& coarse,
                                                const Mask& mask)
{
  const std::size_t n = surface.points.size(), n_channels = coarse.number_of_channels();
  std::vector<Vertex_scalars> result(n_channels, Vertex_scalars(n));
  Vertex_scalars values(n_channels);
  for(std::size_t v = 0; v < n; ++v)
  {
    coarse.interpolate(surface.sphere.direction(v), values.data());
    for(std::size_t k = 0; k < n_channels; ++k)
      result[k][v] = values[k];
  }
  for(Vertex_scalars& channel : result)
    channel = surface.mesh.in_own_order(channel);
  std::vector<Vector_3d> points = surface.mesh.points();
  Vertex_scalars areas = vertex_areas(surface.mesh.rings(), points);
  const double area = std::accumulate(areas.begin(), areas.end(), 0.), scale = area > 0. ? 1. / std::sqrt(area) : 1.;
  for(Vector_3d& p : points)
    p = scale * p;
  constexpr double squared_edges = 3.5; // diffusion over about two edges; three times as much is equally good
  const double t = squared_edges / static_cast<double>(n), min_area = 1e-6 / static_cast<double>(n);
  result.push_back(
      ranks_by_area(mean_curvature(surface.mesh.rings(), points, t, min_area), areas_outside(mask, areas)));
  continue_over(mask, surface.mesh.rings(), result.back());
  return result;
}

// The weight of the features after the alignment. The weight of features of the package increases with their agreement, because they are
// noise on bodies without extremities.
inline double weight_of_features(double agreement, const Surface_map_settings& settings)
{
  const double trust = settings.features[0].empty() ? std::clamp(agreement, 0., 1.) : 1.;
  return settings.feature_weight * trust * trust * trust * trust;
}

// The weights of the features in the choice among maps on finer levels. Of the features of the package, the fine curvatures decide: they
// prefer the right alignment for all of 247 pairs of poses and of kinds of bodies, where average distances often prefer a half-turn, and
// coarser curvatures, areas on the sphere and the energy sometimes. Only smooth bodies need the others.
inline std::vector<double> weights_in_last_choice(const Feature_goals& features, const Surface_map_settings& settings)
{
  constexpr double weight_of_fine_curvatures = 10.; // with 1, one of 70 gorillas and persons is a half-turn
  std::vector<double> result(features.image->number_of_channels(), 1.);
  if(settings.features[0].empty() && result.size() > Surface_descriptor::index_of_fine_curvature)
    result[Surface_descriptor::index_of_fine_curvature] = result.back() = weight_of_fine_curvatures;
  return result;
}

// The goals given by features of the package, if the coarse surfaces have been compared, or by features of the caller.
inline Feature_goals feature_goals(const Surface_pair& pair, const Coarse_pair* surfaces)
{
  // The distance of nodes of an image is about that of vertices, up to 1.6 million nodes, which take 50 MB for each four features.
  constexpr std::size_t max_steps = 512;
  const Surface_map_settings& settings = pair.settings;
  Feature_goals result;
  std::array<std::vector<Vertex_scalars>, 2> features = settings.features;
  if(features[0].empty() && surfaces && settings.feature_weight > 0.)
  {
    const std::vector<Sphere_image> coarse = surfaces->feature_images();
    run_both(
        pair.execution, [&] { features[0] = own_features(pair.first, coarse[0], settings.masks[0]); },
        [&] { features[1] = own_features(pair.second, coarse[1], settings.masks[1]); });
  }
  if(features[0].empty() || !(settings.feature_weight > 0.))
    return result;
  result.mask = settings.masks[0];
  const auto n_steps =
      (std::min)((std::max)(static_cast<std::size_t>(std::sqrt(static_cast<double>(pair.second.points.size()) / 6.)),
                            Sphere_image::default_steps),
                 max_steps);
  for(Vertex_scalars& feature : features[1])
    feature = pair.second.mesh.in_callers_order(feature);
  result.image.emplace(Sphere_image::locate_nodes(pair.second.sphere, pair.execution, n_steps),
                       pair.second.sphere.triangles(), features[1], n_steps);
  result.set_values(features[0]);
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FEATURE_GOALS_H
