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

// Minimizes the energy down to the finest level. An alignment descends on the levels of which it is; then, if there are landmarks, on
// others that keep their vertices. If that misses hard landmarks, the start is replaced by the rotation of landmarks alone, if this misses
// fewer. `directions` contains the rotation of the start, and receives the map. Returns false, and does not change the directions, if double
// precision does not suffice.
inline bool refine_start(const Surface_pair& pair, Surface_start& start, std::vector<Vector_3d>& directions)
{
  // With landmarks, the descent begins with very few vertices, so that large parts can move. Without landmarks, it begins with more:
  // coarser levels would destroy the existing correspondence.
  constexpr std::size_t min_size_with_landmarks = 60, min_size = 1000;
  const Surface_map_settings& settings = pair.settings;
  const bool is_rotation = start.alignment.directions.empty(), has_landmarks = !settings.landmarks.empty();
  const double feature_weight = weight_of_features(start.alignment.agreement, settings);
  const Target_goals features_alone = {pair.metric, start.features, feature_weight};
  const Target_goals goals = {pair.metric, start.features, feature_weight, landmark_goals(pair)};
  const auto lower = [&](const Target_goals& target, std::size_t coarsest_size, std::vector<Vector_3d>& map) {
    return minimize_on_target(pair.first.mesh.rings(), pair.first.mesh.points(), target, coarsest_size, Target_sweeps(),
                              map, pair.control, pair.execution);
  };
  std::vector<Vector_3d> lowered;
  bool is_lowered = is_rotation || start.levels->lower(start.alignment.directions, features_alone, lowered,
                                                       pair.control, pair.execution);
  if(is_rotation)
    lowered = pair.first.mesh.in_own_order(directions);
  // Coarser levels would destroy the result of an earlier descent.
  const bool continues_map =
      settings.keeps_alignment && (!settings.has_hard_landmarks() ||
                                   std::all_of(pair.landmarks.begin(), pair.landmarks.end(), [](const auto& landmark) {
                                     constexpr double cosine_of_rounding = 1. - 1e-14;
                                     return dot(landmark.first, landmark.second) > cosine_of_rounding;
                                   }));
  if(is_lowered && (is_rotation || has_landmarks))
    is_lowered = lower(goals,
                       continues_map   ? pair.first.points.size()
                       : has_landmarks ? min_size_with_landmarks
                                       : min_size,
                       lowered) ||
                 !is_rotation;
  // A start by features may miss landmarks that a start from a rotation alone meets.
  const auto n_missed = [&](const std::vector<Vector_3d>& own_order) {
    const std::vector<Vector_3d> found = pair.first.mesh.in_callers_order(own_order);
    return std::count_if(settings.landmarks.begin(), settings.landmarks.end(), [&](const auto& landmark) {
      return found[landmark[0]] != pair.second.sphere.direction(landmark[1]);
    });
  };
  if(!is_rotation && settings.has_hard_landmarks() && (!is_lowered || n_missed(lowered) > 0) &&
     !pair.control.is_stopped())
    if(const std::optional<Rotation_matrix> rotation = fitting_rotation(pair.landmarks))
    {
      const Target_goals without_own_features = {pair.metric, start.features,
                                                 settings.features[0].empty() ? 0. : feature_weight, goals.landmarks};
      std::vector<Vector_3d> other =
          pair.first.mesh.in_own_order(rotated_directions(*rotation, directions_of(pair.first.sphere)));
      if(lower(without_own_features, min_size_with_landmarks, other) &&
         (!is_lowered || n_missed(other) < n_missed(lowered)))
      {
        is_lowered = true;
        lowered.swap(other);
        start.take_rotation(*rotation);
      }
    }
  if(is_lowered)
    directions = pair.first.mesh.in_callers_order(lowered);
  return is_lowered;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_REFINE_START_H
