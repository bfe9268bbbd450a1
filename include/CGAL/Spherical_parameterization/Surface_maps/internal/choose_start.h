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
#include <CGAL/Spherical_parameterization/Surface_maps/internal/feature_goals.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// An alignment from which the map between two surfaces is refined.
struct Surface_start
{
  struct Rival
  {
    std::vector<Vector_3d> directions; // of the vertices of the first coarse surface
    double lag;                        // the score of the alignment minus its score
  };

  Alignment alignment;
  double margin = 0.;
  bool is_uncertain = false;
  std::vector<Rival> rivals;              // alternative alignments that are nearly as good
  std::unique_ptr<Surface_levels> levels; // of the first surface; null if the alignment is kept or by landmarks alone
  std::unique_ptr<Coarse_pair> surfaces;  // null in these cases, and if double precision does not suffice
  Feature_goals features;                 // features of the first surface and of the sphere of the second one

  // Replaces the alignment by a rotation that was determined by landmarks alone.
  void take_rotation(const Rotation_matrix& rotation)
  {
    alignment = {};
    alignment.rotation = rotation;
    margin = 0.;
    is_uncertain = false;
    rivals.clear();
    levels.reset();
    surfaces.reset();
  }
};

// Computes the levels of the first surface, and the coarse surfaces, unless double precision does not suffice for these.
inline void build_coarse_surfaces(const Surface_pair& pair, Surface_start& start)
{
  const Surface_map_settings& settings = pair.settings;
  const auto levels_of = [&](const Located_surface& surface) {
    return std::make_unique<Surface_levels>(surface.mesh, directions_of(surface.sphere), pair.control, pair.execution);
  };
  start.levels = levels_of(pair.first);
  const std::unique_ptr<Surface_levels> levels_of_second = levels_of(pair.second);
  Surface_descriptor coarse1 = start.levels->coarse_surface(settings.features[0], settings.masks[0]),
                     coarse2 = levels_of_second->coarse_surface(settings.features[1], settings.masks[1]);
  if(coarse1.is_bijective() && coarse2.is_bijective())
    start.surfaces =
        std::make_unique<Coarse_pair>(std::move(coarse1), std::move(coarse2), pair.control, pair.execution);
}

// Chooses among alignments, of which the first one is the best. It and those that are nearly as good are refined with the guidance of
// eigenfunctions, and compared on a finer level.
inline void choose_alignment(const Surface_pair& pair, std::vector<Alignment> candidates, Surface_start& start)
{
  constexpr double max_lag = 0.15; // the largest known lag of a correct one that won on the finer level is 0.11
  constexpr std::size_t max_candidates = 4, batch_size = 2;
  start.margin = candidates.size() > 1 ? (std::min)(candidates[0].score - candidates[1].score, max_lag) : max_lag;
  std::size_t n = candidates[0].directions.empty() ? 0 : 1;
  while(n > 0 && start.features.image && // there is none if the weight of features is 0
        n < candidates.size() && n < max_candidates && candidates[n].score > candidates[0].score - max_lag)
    ++n;
  if(n > 0)
    start.surfaces->find_spectra();
  const Alignment_descent descent(*start.surfaces, pair.metric);
  std::vector<double> scores(n, 0.); // on the finer level
  const bool are_compared = n > 1;
  n = run_in_batches(*start.surfaces, n, batch_size, [&](std::size_t k) {
    Alignment& alignment = candidates[k];
    descent.match_functions(alignment);
    if(!are_compared)
      return;
    Run_control silent; // Only the levels of the final refinement are reported to a visitor.
    const Target_goals goals = {pair.metric, start.features, weight_of_features(alignment.agreement, pair.settings)};
    scores[k] = start.levels->agreement_on_finer_level(alignment.directions, goals,
                                                       weights_in_last_choice(start.features, pair.settings), silent,
                                                       pair.execution) -
                alignment.missed;
  });
  scores.resize(n);
  const std::size_t best = static_cast<std::size_t>(std::max_element(scores.begin(), scores.end()) - scores.begin());
  start.alignment = std::move(candidates[best]);
  if(n > 1)
    start.margin = max_lag;
  for(std::size_t k = 0; k < n; ++k)
    if(k != best)
    {
      const double lag = scores[best] - scores[k];
      start.margin = (std::min)(start.margin, lag);
      start.rivals.push_back({std::move(candidates[k].directions), lag});
    }
}

// Whether the alignment is ambiguous for features of the caller, for which no expected errors are known: the surfaces agree too little,
// or an alternative agrees nearly as well.
inline bool is_ambiguous_by_callers_features(const Surface_start& start)
{
  return start.alignment.agreement < 0.73 || start.margin < 0.1;
}

// Finds the start: the best alignment of the coarse surfaces; the rotation given by landmarks, if the surfaces do not agree; or the
// spheres as given.
inline Surface_start choose_start(const Surface_pair& pair)
{
  // With the guidance of landmarks, a gorilla and a person agree by at least 0.57, a sphere and an octahedron by 0.44.
  constexpr double min_agreement_beside_landmarks = 0.5;
  const Surface_map_settings& settings = pair.settings;
  Surface_start result;
  if(settings.keeps_alignment)
    result.features = feature_goals(pair, nullptr);
  else
  {
    build_coarse_surfaces(pair, result);
    std::vector<Alignment> candidates(1);
    if(result.surfaces)
    {
      result.surfaces->set_landmarks(pair.landmarks);
      candidates = best_alignments(*result.surfaces, pair);
    }
    const std::optional<Rotation_matrix> rotation = fitting_rotation(pair.landmarks);
    const bool is_by_landmarks = rotation && candidates[0].agreement < min_agreement_beside_landmarks;
    if(is_by_landmarks)
      result.take_rotation(*rotation);
    result.features = feature_goals(pair, result.surfaces.get());
    if(result.surfaces)
      choose_alignment(pair, std::move(candidates), result);
    result.is_uncertain =
        !is_by_landmarks && (pair.control.is_stopped() || !result.surfaces ||
                             (!settings.features[0].empty() && is_ambiguous_by_callers_features(result)));
  }
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_CHOOSE_START_H
