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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FIND_SURFACE_MAP_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FIND_SURFACE_MAP_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/expected_errors.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/find_surface_map.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/measure_map.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/refine_start.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The stages of map_surface():
//
//   choose_start()
//     build_coarse_surfaces()
//     best_alignments()       proposes alignments, and chooses among them on coarse surfaces:
//                             propose_rotations(), with_counterparts(), propose_starts(), choose_on_first_levels(),
//                             add_inverse_starts(), which does the same in the opposite direction, choose_on_last_levels()
//     choose_alignment()      the guidance of eigenfunctions, and the choice on a finer level
//   refine_start()            the descent to the finest level, or from the rotation by landmarks alone
//   measure_map()             the energy: of a rotation before the descent, and of the result
//   expected_errors()
//
// The certificate of the map is that of write_map().
CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code find_surface_map(Surface_on_sphere first_surface, Surface_on_sphere second_surface,
                            Surface_map_settings settings, std::vector<Vector_3d>& directions,
                            std::vector<double>& errors, Surface_map_report& report, Run_control& control,
                            const Execution& execution)
{
  constexpr double energy_of_copies = 2. + 1e-9; // the minimum up to rounding error; copies need no descent
  constexpr double max_expected_error = 0.105; // With less, more correct maps are flagged; see the page "Experiments".
  Located_surface first, second;
  Error_code error1 = OK, error2 = OK;
  run_both(
      execution, [&] { error1 = first.assign(std::move(first_surface)); },
      [&] { error2 = second.assign(std::move(second_surface)); });
  if(error1 != OK || error2 != OK)
    return error1 != OK ? error1 : error2;
  report.seconds_for_reading = control.lap();
  prepare_features({&first.mesh, &second.mesh}, settings);
  control.on_initialization_begin(first.points.size());
  Surface_pair pair = {
      first, second, settings, control, execution, {second.sphere, second.points, first.points.size(), execution}, {}};
  for(const auto& [v, w] : settings.landmarks)
    pair.landmarks.emplace_back(first.sphere.direction(v), second.sphere.direction(w));

  Surface_start start = choose_start(pair);
  control.on_initialization_end();
  directions = rotated_directions(start.alignment.rotation, directions_of(first.sphere));
  Map_energy energy;
  const bool is_from_rotation = start.alignment.directions.empty() && settings.landmarks.empty();
  if(is_from_rotation)
    measure_map(pair, directions, energy);
  report.seconds_for_alignment = control.lap();
  if(energy.value && *energy.value < energy_of_copies)
    report.stop_reason = CONVERGED;
  else
  {
    std::vector<Vector_3d> refined = directions;
    const bool is_refined = refine_start(pair, start, refined);
    report.number_of_sweeps = control.report().number_of_level_iterations;
    report.seconds_for_descent = control.lap();

    Map_energy refined_energy;
    const bool is_bijection = is_refined && measure_map(pair, refined, refined_energy);
    // The averaged metric moves even the identity: only the surfaces themselves show whether the descent was an improvement. Energies
    // measured by samples are lower than those on the refinement, and are not comparable with them. If a run is stopped before both
    // energies are known, the result of the descent is taken.
    const bool are_comparable = energy.value && refined_energy.value && energy.is_sampled == refined_energy.is_sampled;
    const bool is_better =
        !is_from_rotation || (are_comparable ? *refined_energy.value < *energy.value : control.is_stopped());
    report.stop_reason = is_bijection ? control.report().stop_reason : OBSTRUCTED;
    if(is_bijection && is_better)
    {
      energy = refined_energy;
      directions.swap(refined);
    }
    report.seconds_for_overlay = control.lap();
  }
  if(control.is_stopped())
    report.stop_reason = control.stop_reason();
  report.energy = energy.value.value_or(0.);
  report.is_energy_sampled = energy.is_sampled;
  report.agreement = start.alignment.agreement;
  report.margin = start.margin;
  report.is_uncertain = start.is_uncertain;
  if(start.surfaces && !start.is_uncertain && settings.features[0].empty())
  {
    report.expected_error = expected_errors(pair, start, directions, errors);
    report.is_uncertain = *report.expected_error > max_expected_error;
  }
  report.distortion = energy.distortion;
  for(const auto& [v, w] : settings.landmarks)
  {
    const bool is_met = directions[v] == second.sphere.direction(w);
    report.landmark_distances.push_back(is_met ? 0. : distance_left(second, directions[v], w));
    report.number_of_missed_landmarks += settings.has_hard_landmarks() && !is_met;
  }
  control.on_optimization_end();
  return OK;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code find_rotations(const Surface_to_align& first, const Surface_to_align& second, Sphere_alignment_3& alignment,
                          Run_control& control, const Execution& execution)
{
  constexpr std::size_t n_candidates = 4; // alternatives in case of a nearly symmetric surface
  std::array<std::optional<Surface_descriptor>, 2> coarse;
  for(std::size_t k = 0; k < 2; ++k)
  {
    const Surface_to_align& surface = k == 0 ? first : second;
    Surface mesh;
    if(const Error_code error = mesh.assign(surface.points, surface.triangles))
      return error;
    const Vertex_scalars areas = vertex_areas(mesh.rings(), mesh.points());
    std::vector<Vertex_scalars> ranks;
    for(const Vertex_scalars& feature : surface.features)
      ranks.push_back(ranks_by_area(mesh.in_own_order(feature), areas));
    coarse[k].emplace(Surface_levels(mesh, surface.directions, control, execution).coarse_surface(ranks, {}));
    if(!coarse[k]->is_bijective())
      return ERROR_INSUFFICIENT_PRECISION;
  }
  const Coarse_pair surfaces(std::move(*coarse[0]), std::move(*coarse[1]), control, execution);
  alignment.candidates.clear();
  for(const Scored_rotation& candidate : surfaces.best_rotations(n_candidates))
    alignment.candidates.push_back({as_transformation(candidate.rotation), candidate.score});
  alignment.is_stopped = control.is_stopped();
  return OK;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FIND_SURFACE_MAP_IMPL_H
