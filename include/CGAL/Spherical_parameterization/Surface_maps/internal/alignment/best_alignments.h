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

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_pair.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/propose_starts.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

// Proposes candidates, and chooses among them on coarse surfaces. The spheres of poses of a body differ by more than a rotation: a map
// of low distortion may displace an extremity to either side. Therefore, many starts are refined, and the results are compared.

namespace CGAL::Spherical_parameterization::internal {

// Calls f(0) to f(n - 1), in parallel within each batch. The control is called before each batch. Returns the number of completed
// calls.
template <class Function>
std::size_t run_in_batches(const Coarse_pair& surfaces, std::size_t n, std::size_t batch_size, const Function& f)
{
  std::size_t n_done = 0;
  while(n_done < n && surfaces.goes_on())
  {
    const std::size_t end = (std::min)(n_done + batch_size, n);
    for_each_in_blocks(surfaces.execution(), n_done, end, 1, f);
    n_done = end;
  }
  return n_done;
}

// Calls f for all starts; removes those that are not processed because the control has stopped the run.
template <class Function>
void for_each_start(const Coarse_pair& surfaces, std::vector<Alignment_start>& starts, const Function& f)
{
  constexpr std::size_t batch_size = 8; // a fifth of a second per batch
  const std::size_t n_done = run_in_batches(surfaces, starts.size(), batch_size, [&](std::size_t k) { f(starts[k]); });
  starts.erase(starts.begin() + static_cast<std::ptrdiff_t>(n_done), starts.end());
}

// Keeps the valid starts that differ from all better ones by at least this mean angle over their common level. The best one comes
// first.
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

// The first levels of these starts, after which most are discarded.
inline void choose_on_first_levels(const Coarse_pair& surfaces, const Alignment_descent& descent, std::size_t n_kept,
                                   std::vector<Alignment_start>& starts)
{
  // Before the end of the descent, the better one of two similar starts is not yet known, so only nearly identical ones are merged.
  constexpr double min_angle = CGAL_PI / 36.;
  constexpr double max_lag = 0.2; // behind the best score; with 0.12, a person is mapped onto a gorilla by a half-turn
  for_each_start(surfaces, starts, [&](Alignment_start& start) { descent.lead(true, start); });
  keep_best(min_angle, starts);
  while(starts.size() > n_kept ||
        (!starts.empty() && starts.back().alignment.score < starts.front().alignment.score - max_lag))
    starts.pop_back();
}

// The remaining levels, from the last one of the first levels on; for inverses, all levels. Afterwards, starts differ by 20 degrees or
// more in the mean. `finish(start)` completes the descent of each.
template <class Function>
void choose_on_last_levels(const Coarse_pair& surfaces, const Alignment_descent& descent,
                           std::vector<Alignment_start>& starts, const Function& finish)
{
  constexpr double min_angle = CGAL_PI / 9.; // Different alignments are farther apart.
  for_each_start(surfaces, starts, [&](Alignment_start& start) {
    descent.lead(false, start);
    finish(start);
  });
  keep_best(min_angle, starts);
}

// Adds the inverses of the best maps from the second to the first surface as starts. A descent in one direction often finds a map that
// no start leads to in the other one. These maps are not settled; their inverses are.
inline void add_inverse_starts(const Coarse_pair& surfaces, const Surface_pair& pair,
                               const std::vector<Rotation_matrix>& rotations, const Alignment_descent& descent,
                               std::vector<Alignment_start>& starts)
{
  constexpr std::size_t n_kept = 4; // with 8, the same maps win
  constexpr std::size_t n_inverses = 2;
  Coarse_pair reversed = surfaces.reversed();
  const Target_metric metric(pair.first.sphere, pair.first.points, surfaces.second().size(), pair.execution);
  const Alignment_descent descent_back(reversed, metric);
  std::vector<Rotation_matrix> rotations_back;
  for(const Rotation_matrix& rotation : rotations)
    rotations_back.push_back(transposed(rotation));
  std::vector<Alignment_start> found = propose_starts(reversed, rotations_back, descent_back);
  choose_on_first_levels(reversed, descent_back, n_kept, found);
  choose_on_last_levels(reversed, descent_back, found, [](Alignment_start&) {});
  const Mesh_hierarchy levels = descent.levels();
  for(std::size_t k = 0; k < found.size() && k < n_inverses; ++k)
    if(auto start = start_from_inverse(surfaces, found[k].alignment.directions, levels, descent))
      starts.push_back(std::move(*start));
}

// The best maps of the first coarse surface to the sphere of the second surface, in the order of decreasing score; at least one. They
// differ by 20 degrees or more in the mean. They are rotations, without directions, if the surfaces are copies or the run is stopped.
inline std::vector<Alignment> best_alignments(Coarse_pair& surfaces, const Surface_pair& pair)
{
  constexpr std::size_t n_kept = 8; // with 5, a gorilla is mapped onto a person incorrectly
  const Rotation_candidates found = propose_rotations(surfaces, pair.first.sphere, pair.second.sphere);
  if(found.are_copies || !surfaces.goes_on())
    return found.alignments;
  const std::vector<Rotation_matrix> rotations = with_counterparts(surfaces, found.alignments);
  const Alignment_descent descent(surfaces, pair.metric);
  std::vector<Alignment_start> starts = propose_starts(surfaces, rotations, descent);
  choose_on_first_levels(surfaces, descent, n_kept, starts);
  add_inverse_starts(surfaces, pair, rotations, descent, starts);
  choose_on_last_levels(surfaces, descent, starts,
                        [&](Alignment_start& start) { descent.settle(pair.settings.feature_weight, start); });
  if(starts.empty())
    return found.alignments;
  std::vector<Alignment> result;
  for(Alignment_start& start : starts)
    result.push_back(std::move(start.alignment));
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_BEST_ALIGNMENTS_H
