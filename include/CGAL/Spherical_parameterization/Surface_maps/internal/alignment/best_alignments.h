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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_BEST_ALIGNMENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_BEST_ALIGNMENTS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Alignment_descent.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Extremity_search.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

// Candidates are proposed, and chosen among on coarse surfaces. Spheres of poses of a body differ by more than a rotation: a map of low
// distortion may let an extremity lean to one side or to the other. So many starts are taken through the descent, and the outcome
// decides.

namespace CGAL::Spherical_parameterization::internal {

// Calls f for all starts, in parallel; those that the control does not wait for are removed.
template <class Function>
void for_each_start(const Coarse_pair& surfaces, std::vector<Alignment_start>& starts, const Function& f)
{
  constexpr std::size_t batch_size = 4; // between two questions to the control, a fifth of a second
  std::size_t n_done = 0;
  while(n_done < starts.size() && surfaces.goes_on())
  {
    const std::size_t end = (std::min)(n_done + batch_size, starts.size());
    for_each_block(surfaces.execution(), n_done, end, 1, [&](std::size_t k, std::size_t) { f(starts[k]); });
    n_done = end;
  }
  starts.erase(starts.begin() + static_cast<std::ptrdiff_t>(n_done), starts.end());
}

// Keeps the starts that doubles hold and that differ from better ones by this angle in the mean over the level that all have come to;
// the best one comes first.
inline void keep_best(double min_angle, std::vector<Alignment_start>& starts)
{
  starts.erase(
      std::remove_if(starts.begin(), starts.end(), [](const Alignment_start& start) { return !start.is_valid; }),
      starts.end());
  std::stable_sort(starts.begin(), starts.end(), [](const Alignment_start& a, const Alignment_start& b) {
    return a.alignment.score > b.alignment.score;
  });
  std::vector<Alignment_start> result;
  for(Alignment_start& start : starts)
  {
    const auto is_near = [&](const Alignment_start& other) {
      const Mesh_hierarchy::Level& level = start.hierarchy->level(start.hierarchy->number_of_levels() - 1);
      double sum = 0., area = 0.;
      for(std::size_t i = 0; i < level.vertices.size(); ++i)
      {
        const std::uint32_t v = level.vertices[i];
        sum += level.areas[i] * dot(start.alignment.directions[v], other.alignment.directions[v]);
        area += level.areas[i];
      }
      return sum > cosine(min_angle) * area;
    };
    if(std::none_of(result.begin(), result.end(), is_near))
      result.push_back(std::move(start));
  }
  starts.swap(result);
}

// The starts: these rotations, by which features agree, and others that bring extremities together which may correspond.
inline std::vector<Alignment_start> propose(Coarse_pair& surfaces, const std::vector<Alignment>& rotations,
                                            const Alignment_descent& descent)
{
  constexpr std::size_t n_matchings = 12;
  std::vector<Alignment_start> starts;
  const Mesh_hierarchy levels = descent.levels();
  const auto extremities = surfaces.extremities();
  for(const Alignment& alignment : rotations)
    starts.push_back(descent.start_from(levels, alignment.rotation, surfaces.distance_guides(extremities, {})));
  for(const Extremity_matching& matching :
      Extremity_search(extremities[0], extremities[1])
          .best(n_matchings, surfaces.first().directions(), surfaces.second().directions()))
    starts.push_back(
        descent.start_from(levels, matching.rotation, surfaces.distance_guides(extremities, matching.pairs)));
  return starts;
}

// The best maps of the first coarse surface to the sphere of the second surface, which has this metric, the best one first; at
// least one. They differ from each other, by 20 degrees or more in the mean. They are rotations, without directions, if surfaces are
// copies or the run is stopped. The weight is that of the features of a caller in the end; those of the package have less then.
inline std::vector<Alignment> best_alignments(Coarse_pair& surfaces, const Target_metric& metric, double feature_weight,
                                              const Sphere_mesh& sphere1, const Sphere_mesh& sphere2)
{
  // Copies of a surface with rotated copies of its sphere have a score of nearly 1, poses of a body less. With a larger one, copies go
  // through the descent and end 1.3 degrees off, where the rotation is 0.2 off; with a smaller one, poses are but rotated.
  constexpr double min_score_of_same_shape = 0.97;
  // Different alignments are farther apart, in the mean. Before the end of the descent, it is not clear which of two near ones
  // is better, unless they are the same.
  constexpr double min_angle = CGAL_PI / 9., min_angle_at_first = CGAL_PI / 36.;
  // How far the score of a start may be below the best one after the first levels. With 0.08, a right one is lost now and then;
  // with 0.2, the same ones win, in 1.1 times the time.
  constexpr double max_lag = 0.12;
  constexpr std::size_t n_rotations = 8, n_carried_on = 8; // with fewer, a right one is lost now and then
  std::vector<Alignment> result;
  for(const Scored_rotation& r : surfaces.best_rotations(n_rotations))
  {
    const double missed = surfaces.distance_from_landmarks([&](const Vector_3d& p) { return rotated(r.rotation, p); });
    result.push_back({r.rotation, {}, {}, r.score, r.score - missed, missed});
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Alignment& a, const Alignment& b) { return a.score > b.score; });
  const bool is_same_shape = result[0].score > min_score_of_same_shape;
  if(is_same_shape)
    result[0].rotation =
        closest_point_rotation(result[0].rotation, sphere1, sphere2, surfaces.control(), surfaces.execution());
  if(is_same_shape || !surfaces.goes_on())
    return result;
  const Alignment_descent descent(surfaces, metric);
  std::vector<Alignment_start> starts = propose(surfaces, result, descent);
  for_each_start(surfaces, starts, [&](Alignment_start& start) { descent.lead(true, start); });
  keep_best(min_angle_at_first, starts);
  while(starts.size() > n_carried_on ||
        (!starts.empty() && starts.back().alignment.score < starts.front().alignment.score - max_lag))
    starts.pop_back();
  for_each_start(surfaces, starts, [&](Alignment_start& start) {
    descent.lead(false, start);
    descent.settle(feature_weight, start);
  });
  keep_best(min_angle, starts);
  if(starts.empty())
    return result;
  result.clear();
  for(Alignment_start& start : starts)
    result.push_back(std::move(start.alignment));
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_BEST_ALIGNMENTS_H
