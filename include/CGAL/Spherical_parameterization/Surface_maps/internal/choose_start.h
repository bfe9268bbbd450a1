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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_CHOOSE_START_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_CHOOSE_START_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_levels.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_pair.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/best_alignments.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// An alignment from which the map between two surfaces is refined.
struct Surface_start
{
  Alignment alignment;
  std::vector<Alignment> rivals; // that are nearly as good
  double margin = 0.;
  bool is_uncertain = false;
  std::unique_ptr<Surface_levels> levels; // of the first surface, if it has been compared with the second one
  std::unique_ptr<Coarse_pair> surfaces;  // if these could be compared
};

// Compares two surfaces on coarse levels. If the spheres are to be kept as they are, only features are found.
inline Surface_start compare_surfaces(const Surface_pair& pair)
{
  const Surface_map_settings& settings = pair.settings;
  Surface_start result;
  const auto levels_of = [&](const Located_surface& surface) {
    return std::make_unique<Surface_levels>(surface.mesh, directions_of(surface.sphere), pair.control, pair.execution);
  };
  result.levels = levels_of(pair.first);
  const std::unique_ptr<Surface_levels> levels_of_second = levels_of(pair.second);
  Surface_descriptor coarse1 = result.levels->coarse_surface(settings.features[0], settings.masks[0]),
                     coarse2 = levels_of_second->coarse_surface(settings.features[1], settings.masks[1]);
  if(!coarse1.is_bijective() || !coarse2.is_bijective())
    return result;
  result.surfaces = std::make_unique<Coarse_pair>(std::move(coarse1), std::move(coarse2), pair.control, pair.execution);
  if(settings.keeps_alignment)
    return result;
  result.surfaces->set_landmarks(pair.landmarks);
  const std::vector<Alignment> best =
      best_alignments(*result.surfaces, pair.metric, settings.feature_weight, pair.first.sphere, pair.second.sphere);
  // As close as this, the score on coarse surfaces is not exact enough to choose.
  constexpr double min_margin = 0.1;
  result.alignment = best[0];
  result.margin = best.size() > 1 ? best[0].score - best[1].score : max_lag_of_starts;
  for(std::size_t k = 1; k < best.size(); ++k)
    if(best[0].score - best[k].score < min_margin && !best[k].directions.empty())
      result.rivals.push_back(best[k]);
  return result;
}

// Finds the start: the best alignment of coarse surfaces; the rotation by landmarks, if surfaces do not agree; or the spheres as
// they are.
inline Surface_start choose_start(const Surface_pair& pair)
{
  Surface_start result;
  if(pair.settings.keeps_alignment && (pair.settings.features[0].empty() || !(pair.settings.feature_weight > 0.)))
    return result;
  result = compare_surfaces(pair);
  if(pair.settings.keeps_alignment)
    return result;
  // Once landmarks have led them, a gorilla and a person agree by 0.57 or more, a sphere and an octahedron by 0.44.
  constexpr double min_agreement_beside_landmarks = 0.5;
  const std::optional<Rotation_matrix> rotation = fitting_rotation(pair.landmarks);
  if(rotation && result.alignment.agreement < min_agreement_beside_landmarks)
  {
    result = {};
    result.alignment.rotation = *rotation;
  }
  else if(pair.settings.features[0].empty())
    // As are all wrong maps of 127, one of 38 right ones of poses, and one of four between a gorilla and a person.
    result.is_uncertain = result.margin < 0.03 || result.alignment.agreement < 0.6 ||
                          (result.margin < 0.1 && result.alignment.agreement < 0.72);
  else // the features of a caller, of which less is known
    result.is_uncertain = result.alignment.agreement < 0.73 || result.margin < 0.1;
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_CHOOSE_START_H
