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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_REFINE_START_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_REFINE_START_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/choose_start.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

inline Landmark_goals landmark_goals(const Surface_pair& pair)
{
  const auto& landmarks = pair.settings.landmarks;
  Landmark_goals goals;
  if(landmarks.empty())
    return goals;
  // The sum over the faces is 8 pi times the mean energy.
  goals.weight = 8. * CGAL_PI * pair.settings.landmark_weight.value_or(0.) / static_cast<double>(landmarks.size());
  goals.directions.resize(pair.first.points.size());
  for(const auto& [v, w] : landmarks)
    goals.directions[v] = pair.second.sphere.direction(w);
  goals.directions = pair.first.mesh.in_own_order(goals.directions);
  return goals;
}

// The features of the package at the vertices of one of the surfaces, in the order of the mesh: those of the coarse surfaces, and
// the curvature as the mesh itself has it, which the coarse one has lost.
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
  constexpr double squared_edges = 3.5; // heat goes some two edges far; three times as much is as good
  const double t = squared_edges / static_cast<double>(n), min_area = 1e-6 / static_cast<double>(n);
  result.push_back(
      ranks_by_area(mean_curvature(surface.mesh.rings(), points, t, min_area), areas_outside(mask, areas)));
  continue_over(mask, surface.mesh.rings(), result.back());
  return result;
}

// The weight of the features once they have aligned the surfaces: those of the package count the less, the less they agree, as
// they are noise on bodies without extremities.
inline double weight_of_features(const Alignment& alignment, const Surface_map_settings& settings)
{
  const double trust = settings.features[0].empty() ? std::clamp(alignment.agreement, 0., 1.) : 1.;
  return settings.feature_weight * trust * trust * trust * trust;
}

// The goals by the features of the package, or by a caller's.
inline Feature_goals feature_goals(const Surface_pair& pair, const Surface_start& start)
{
  // Between nodes of an image it is about as far as between vertices, up to 1.6 million nodes, 50 MB for each four features.
  constexpr std::size_t max_steps = 512;
  const Surface_map_settings& settings = pair.settings;
  Feature_goals result;
  std::array<std::vector<Vertex_scalars>, 2> features = settings.features;
  result.weight = weight_of_features(start.alignment, settings);
  if(features[0].empty() && start.surfaces && settings.feature_weight > 0.)
  {
    const std::vector<Sphere_image> coarse = start.surfaces->feature_images();
    run_both(
        pair.execution, [&] { features[0] = own_features(pair.first, coarse[0], settings.masks[0]); },
        [&] { features[1] = own_features(pair.second, coarse[1], settings.masks[1]); });
  }
  if(features[0].empty() || !(result.weight > 0.))
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

// Chooses among the start and its rivals, after a descent on finer levels from each.
inline void choose_among_rivals(const Surface_pair& pair, Target_goals& goals, Surface_start& start)
{
  const auto score = [&](const Alignment& alignment) {
    goals.features.weight = weight_of_features(alignment, pair.settings);
    return start.levels->score_on_finer_level(alignment.directions, goals, pair.control, pair.execution) -
           alignment.missed;
  };
  double best = score(start.alignment);
  for(Alignment& rival : start.rivals)
    if(const double s = score(rival); s > best && pair.control.go_further(0, 0.))
    {
      best = s;
      std::swap(start.alignment, rival);
    }
  goals.features.weight = weight_of_features(start.alignment, pair.settings);
}

// Lowers the energy down to the finest level. `directions`, the rotation of the start, receives the map; returns false, and
// leaves them, if doubles cannot hold it.
inline bool refine_start(const Surface_pair& pair, Surface_start& start, std::vector<Vector_3d>& directions)
{
  // Landmarks are moved on levels of very few vertices. Surfaces that correspond already have lost too much to be compared on
  // coarser levels than the other one.
  constexpr std::size_t min_size_with_landmarks = 60, min_size = 1000;
  const Surface_map_settings& settings = pair.settings;
  const bool is_rotation = start.alignment.directions.empty(), has_landmarks = !settings.landmarks.empty();
  Target_goals features_alone = {pair.metric, feature_goals(pair, start)};
  if(features_alone.features.image && !start.rivals.empty())
    choose_among_rivals(pair, features_alone, start);
  if(!is_rotation && start.surfaces->goes_on())
  {
    start.surfaces->measure_distances();
    Alignment_descent(*start.surfaces, pair.metric).keep_distances(start.alignment.directions);
  }
  const Target_goals goals = {pair.metric, features_alone.features, landmark_goals(pair)};
  const auto lower = [&](const Target_goals& all, std::size_t coarsest_size, std::vector<Vector_3d>& map) {
    return lower_on_target(pair.first.mesh.rings(), pair.first.mesh.points(), all, coarsest_size, Target_sweeps(), map,
                           pair.control, pair.execution);
  };
  std::vector<Vector_3d> lowered;
  bool is_lowered = is_rotation || start.levels->refine(start.alignment.directions, features_alone, lowered,
                                                        pair.control, pair.execution);
  if(is_rotation)
    lowered = pair.first.mesh.in_own_order(directions);
  // Coarser levels would take apart what an earlier descent has found.
  const bool is_found =
      settings.keeps_alignment && std::all_of(pair.landmarks.begin(), pair.landmarks.end(), [](const auto& landmark) {
        constexpr double cosine_of_rounding = 1. - 1e-14;
        return dot(landmark.first, landmark.second) > cosine_of_rounding;
      });
  if(is_lowered && (is_rotation || has_landmarks))
    is_lowered = lower(goals,
                       is_found        ? pair.first.points.size()
                       : has_landmarks ? min_size_with_landmarks
                                       : min_size,
                       lowered);
  // Landmarks may be missed from a start by features where they are met from a rotation alone.
  const auto n_missed = [&](const std::vector<Vector_3d>& own_order) {
    const std::vector<Vector_3d> found = pair.first.mesh.in_callers_order(own_order);
    return std::count_if(settings.landmarks.begin(), settings.landmarks.end(), [&](const auto& landmark) {
      return found[landmark[0]] != pair.second.sphere.direction(landmark[1]);
    });
  };
  if(!is_rotation && settings.has_hard_landmarks() && (!is_lowered || n_missed(lowered) > 0))
    if(const std::optional<Rotation_matrix> rotation = fitting_rotation(pair.landmarks))
    {
      const Target_goals without_own_features = {
          pair.metric, settings.features[0].empty() ? Feature_goals() : goals.features, goals.landmarks};
      std::vector<Vector_3d> other =
          pair.first.mesh.in_own_order(rotated_directions(*rotation, directions_of(pair.first.sphere)));
      if(lower(without_own_features, min_size_with_landmarks, other) &&
         (!is_lowered || n_missed(other) < n_missed(lowered)))
      {
        is_lowered = true;
        lowered.swap(other);
      }
    }
  if(is_lowered)
    directions = pair.first.mesh.in_callers_order(lowered);
  return is_lowered;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_REFINE_START_H
