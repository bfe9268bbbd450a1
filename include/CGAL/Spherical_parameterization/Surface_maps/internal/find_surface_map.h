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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FIND_SURFACE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FIND_SURFACE_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/Surface_map_report.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_map_hints.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Surface_alignment.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Surface_descriptor.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/map_score.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/Overlay_arrays.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/energy_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_levels.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_metric.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface_diffusion.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// A surface on its sphere, in which directions can be located. The length that is 1 for its points is 2 to the power of
// `exponent`, see normalize().
template <class K>
struct Located_surface
{
  Surface mesh; // the same surface; all else is in the order of the caller
  Sphere_triangulation<K> sphere;
  std::vector<Vector_3d> points;
  int exponent = 0;
};

// Takes over the arrays of a surface, and makes the grid of its sphere.
template <class Arrays, class K>
Error_code locate_surface(Arrays& arrays, Located_surface<K>& surface)
{
  if(const Error_code error = surface.mesh.assign(arrays.points, arrays.triangles))
    return error;
  surface.points = std::move(arrays.points);
  surface.exponent = normalize(surface.points);
  surface.sphere.assign(std::move(arrays.images), std::move(arrays.triangles));
  surface.sphere.make_grid();
  return OK;
}

// How far what lies in a direction is from a vertex.
template <class K>
double distance_left(const Located_surface<K>& surface, const Vector_3d& p, std::size_t w)
{
  typename Sphere_triangulation<K>::Hint hint;
  const auto place = surface.sphere.locate(typename K::Point_3(p[0], p[1], p[2]), hint);
  return std::ldexp(length(interpolated(surface.points, surface.sphere.triangles(), place) - surface.points[w]),
                    surface.exponent);
}

// What is known of the energy of a map between surfaces: the mean of both ways.
struct Energy_between
{
  std::optional<double> value; // There is none once the run has been stopped.
  bool is_sampled = false;
  std::optional<Distortion_between> distortion; // unless it is sampled
};

// Measures the map that puts the vertices of the first surface at these directions of the second one's sphere: on the common
// refinement, or by samples if that would be too large. Returns false if the map is no bijection.
template <class K>
bool measure_energy_between(const Located_surface<K>& first, const std::vector<Vector_3d>& directions,
                            const Located_surface<K>& second, Energy_between& energy, Run_control& control,
                            const Execution& execution)
{
  std::vector<typename K::Point_3> images;
  for(const Vector_3d& p : directions)
    images.emplace_back(p[0], p[1], p[2]);
  Sphere_triangulation<K> sphere;
  sphere.assign(std::move(images), first.sphere.triangles());
  if(!certify_bijectivity<K>(sphere.points(), sphere.triangles(), execution).is_bijective())
    return false;
  Overlay_arrays overlay;
  const std::size_t max_vertices = Sphere_overlay<K>::default_max_vertices(sphere, second.sphere);
  const Error_code error =
      overlay.assign(sphere, first.points, second.sphere, second.points, max_vertices, control, execution);
  if(error == OK)
  {
    const Distortion_between measured = distortion_between(
        overlay.triangles.size(), default_smallest_area,
        [&](std::size_t k, std::size_t surface) {
          const auto& t = overlay.triangles[k];
          const std::vector<Vector_3d>& points = overlay.points[surface];
          return std::array<Vector_3d, 3>{points[t[0]], points[t[1]], points[t[2]]};
        },
        execution);
    energy = {0.5 * (measured.energy.average_over_first + measured.energy.average_over_second), false, measured};
  }
  else if(error == ERROR_TOO_LARGE_OVERLAY)
  {
    sphere.make_grid();
    const double there = mean_energy_over_first(sphere, first.points, second.sphere, second.points, control, execution),
                 back = mean_energy_over_first(second.sphere, second.points, sphere, first.points, control, execution);
    if(!control.is_stopped())
      energy = {0.5 * (there + back), true, std::nullopt};
  }
  return error != ERROR_NO_1_TO_1_MAPPING;
}

// The levels of a surface on its sphere, down to that by which it is compared with others.
template <class K>
class Surface_levels
{
public:
  Surface_levels(const Located_surface<K>& surface, Run_control& control, const Execution& execution)
    : m_surface(surface)
    , m_images(surface.mesh.in_own_order(rotated_directions(rotation_matrix({1., 0., 0., 0.}), surface.sphere)))
    , m_hierarchy(surface.mesh.rings(), surface.mesh.points(),
                  vertex_areas(surface.mesh.rings(), surface.mesh.points()), control, execution, m_images, {},
                  Surface_descriptor::max_size)
  {}

  // The features and the mask are in the order of the mesh.
  Surface_descriptor coarse_surface(const std::vector<Vertex_scalars>& features, const Mask& mask) const
  {
    return Surface_descriptor(m_hierarchy, m_surface.mesh, m_images, features, mask);
  }

  // Takes a map of the coarsest level to the finest one; `positions` receives it. Returns false if doubles cannot hold it. The
  // levels are used up.
  bool refine(const std::vector<Vector_3d>& coarse, const Target_goals& goals, std::vector<Vector_3d>& positions,
              Run_control& control, const Execution& execution)
  {
    return refine(m_hierarchy, coarse, goals, 0, positions, control, execution);
  }

  // The score of a map of the coarsest level, taken to a level that has up to 8000 vertices, where the features of the mesh itself
  // tell more than on the coarsest one; least if doubles cannot hold it.
  double score_on_finer_level(const std::vector<Vector_3d>& coarse, const Target_goals& goals, Run_control& control,
                              const Execution& execution) const
  {
    // Of 72 choices between near ties, in five positions of the spheres, six are wrong, and with a half, eleven: the energy is often lower
    // back to front. If it decided alone, it would be 37.
    constexpr double weight_of_stretching = 0.15;
    constexpr std::size_t max_size = 8000;
    std::size_t k = 0;
    while(k + 1 < m_hierarchy.number_of_levels() && m_hierarchy.level(k).vertices.size() > max_size)
      ++k;
    Mesh_hierarchy levels = m_hierarchy;
    std::vector<Vector_3d> positions;
    if(!refine(levels, coarse, goals, k, positions, control, execution))
      return std::numeric_limits<double>::lowest();
    return feature_agreement(goals.features, levels.level(k), positions) -
           weight_of_stretching *
               stretching(goals.metric, levels.level(k), levels.rings(k), m_surface.mesh.points(), positions);
  }

private:
  bool refine(Mesh_hierarchy& levels, const std::vector<Vector_3d>& coarse, const Target_goals& goals,
              std::size_t last_level, std::vector<Vector_3d>& positions, Run_control& control,
              const Execution& execution) const
  {
    const Mesh_hierarchy::Level& level = levels.level(levels.number_of_levels() - 1);
    positions = m_images;
    for(std::size_t v = 0; v < coarse.size(); ++v)
      positions[level.vertices[v]] = coarse[v];
    return lower_on_levels(levels, m_surface.mesh.points(), m_images, goals, Target_sweeps(), positions, control,
                           execution, last_level);
  }

  const Located_surface<K>& m_surface;
  std::vector<Vector_3d> m_images; // in the order of the mesh
  Mesh_hierarchy m_hierarchy;
};

// What features tell of how two surfaces lie on each other. They are asked for on the way as well.
struct Surface_start
{
  std::unique_ptr<Surface_alignment> surfaces; // if these could be compared
  Alignment alignment;
  std::vector<Alignment> rivals; // that are nearly as good
  double margin = 0.;
  std::vector<Sphere_image> features; // of both surfaces, if these could be compared
};

// Compares two surfaces; if `wants_alignment` is false, only their features are found. Landmarks, as directions on both spheres, choose
// among alignments.
template <class K>
Surface_start compare_surfaces(const Located_surface<K>& first, const Located_surface<K>& second,
                               const std::array<Surface_levels<K>*, 2>& levels, const Target_metric& metric,
                               const Surface_map_hints& hints, bool wants_alignment,
                               const std::vector<std::pair<Vector_3d, Vector_3d>>& landmarks, Run_control& control,
                               const Execution& execution)
{
  Surface_start result;
  Surface_descriptor coarse1 = levels[0]->coarse_surface(hints.features[0], hints.masks[0]),
                     coarse2 = levels[1]->coarse_surface(hints.features[1], hints.masks[1]);
  if(!coarse1.is_bijective() || !coarse2.is_bijective())
    return result;
  result.surfaces = std::make_unique<Surface_alignment>(std::move(coarse1), std::move(coarse2), control, execution);
  result.features = {result.surfaces->features(0), result.surfaces->features(1)};
  if(!wants_alignment)
    return result;
  result.surfaces->set_landmarks(landmarks);
  // As close as this, the score on coarse surfaces is not exact enough to choose.
  constexpr double min_margin = 0.1;
  const std::vector<Alignment> best = result.surfaces->best(metric, hints.feature_weight, first.sphere, second.sphere);
  result.alignment = best[0];
  result.margin = best.size() > 1 ? best[0].score - best[1].score : Surface_alignment::max_lag;
  for(std::size_t k = 1; k < best.size(); ++k)
    if(best[0].score - best[k].score < min_margin && !best[k].directions.empty())
      result.rivals.push_back(best[k]);
  return result;
}

template <class K>
Landmark_goals landmark_goals(const Located_surface<K>& first, const Located_surface<K>& second,
                              const Surface_map_hints& hints)
{
  Landmark_goals goals;
  if(hints.landmarks.empty())
    return goals;
  // The sum over the faces is 8 pi times the mean energy.
  goals.weight = 8. * CGAL_PI * hints.landmark_weight / static_cast<double>(hints.landmarks.size());
  goals.directions.resize(first.points.size());
  for(const auto& [v, w] : hints.landmarks)
    goals.directions[v] = second.sphere.direction(w);
  goals.directions = first.mesh.in_own_order(goals.directions);
  return goals;
}

// The features of the package at the vertices of one of the surfaces, in the order of the mesh: those of the coarse surfaces, and
// the curvature as the mesh itself has it, which the coarse one has lost.
template <class K>
std::vector<Vertex_scalars> own_features(const Located_surface<K>& surface, const Sphere_image& coarse,
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
  // Heat goes some two edges far. Three times as much does the same for cortices of macaques, 1.90 percent, without this
  // feature 1.99; poses of people 2.59 and 2.64, animals 2.31 and 2.38.
  constexpr double squared_edges = 3.5;
  const double t = squared_edges / static_cast<double>(n), min_area = 1e-6 / static_cast<double>(n);
  result.push_back(
      ranks_by_area(mean_curvature(surface.mesh.rings(), points, t, min_area), areas_outside(mask, areas)));
  continue_over(mask, surface.mesh.rings(), result.back());
  return result;
}

// The weight of the features once they have aligned the surfaces: those of the package count the less, the less they agree, as
// they are noise on bodies without extremities.
inline double feature_weight(const Alignment& alignment, const Surface_map_hints& hints)
{
  const double trust = hints.features[0].empty() ? std::clamp(alignment.agreement, 0., 1.) : 1.;
  return hints.feature_weight * trust * trust * trust * trust;
}

// The goals by the features of the package, or by a caller's, at full resolution.
template <class K>
Feature_goals feature_goals(const Located_surface<K>& first, const Located_surface<K>& second,
                            const Surface_start& start, const Surface_map_hints& hints, const Execution& execution)
{
  // Between nodes of an image it is about as far as between vertices, up to 1.6 million nodes, 50 MB for each four features.
  constexpr std::size_t max_steps = 512;
  Feature_goals result;
  std::array<std::vector<Vertex_scalars>, 2> features = hints.features;
  result.weight = feature_weight(start.alignment, hints);
  if(features[0].empty() && !start.features.empty() && hints.feature_weight > 0.)
    run_both(
        execution, [&] { features[0] = own_features(first, start.features[0], hints.masks[0]); },
        [&] { features[1] = own_features(second, start.features[1], hints.masks[1]); });
  if(features[0].empty() || !(result.weight > 0.))
    return result;
  result.mask = hints.masks[0];
  const auto n_steps =
      (std::min)((std::max)(static_cast<std::size_t>(std::sqrt(static_cast<double>(second.points.size()) / 6.)),
                            Sphere_image::default_steps),
                 max_steps);
  for(Vertex_scalars& feature : features[1])
    feature = second.mesh.in_callers_order(feature);
  result.image.emplace(Sphere_image::places_of_nodes(second.sphere, execution, n_steps), second.sphere.triangles(),
                       features[1], n_steps);
  result.set_values(features[0]);
  return result;
}

// Puts the best one in the place of the alignment, after a descent on finer levels from each.
template <class K>
void choose_among_rivals(const Surface_levels<K>& levels, Target_goals& goals, const Surface_map_hints& hints,
                         Surface_start& start, Run_control& control, const Execution& execution)
{
  const auto score = [&](const Alignment& alignment) {
    goals.features.weight = feature_weight(alignment, hints);
    return levels.score_on_finer_level(alignment.directions, goals, control, execution) - alignment.missed;
  };
  double best = score(start.alignment);
  for(Alignment& rival : start.rivals)
    if(const double s = score(rival); s > best && control.go_further(0, 0.))
    {
      best = s;
      std::swap(start.alignment, rival);
    }
  goals.features.weight = feature_weight(start.alignment, hints);
}

// Finds the map of the first surface onto the second one: a start, and the descent from it. It is yet to be certified.
template <class K>
std::vector<Vector_3d> find_surface_map(const Located_surface<K>& first, const Located_surface<K>& second,
                                        Surface_map_hints hints, Surface_map_report& report, Run_control& control,
                                        const Execution& execution)
{
  // Landmarks are moved on levels of very few vertices. Surfaces that lie well already have lost too much to be compared
  // on coarser levels than the other one.
  constexpr std::size_t min_size_with_landmarks = 60, min_size = 1000;
  constexpr double energy_of_copies = 2. + 1e-9; // the least, but for rounding: they need no descent

  prepare_features({&first.mesh, &second.mesh}, hints);
  const bool has_landmarks = !hints.landmarks.empty();
  control.on_initialization_begin(first.points.size());
  std::vector<std::pair<Vector_3d, Vector_3d>> pairs;
  for(const auto& [v, w] : hints.landmarks)
    pairs.emplace_back(first.sphere.direction(v), second.sphere.direction(w));
  const std::optional<Rotation_matrix> rotation_by_landmarks = fitting_rotation(pairs);
  const Target_metric metric(second.sphere, second.points, execution);
  std::optional<Surface_levels<K>> levels;
  Surface_start start;
  if(!hints.keeps_alignment || (!hints.features[0].empty() && hints.feature_weight > 0.))
  {
    std::optional<Surface_levels<K>> levels_of_second;
    levels.emplace(first, control, execution);
    levels_of_second.emplace(second, control, execution);
    start = compare_surfaces<K>(first, second, {&*levels, &*levels_of_second}, metric, hints, !hints.keeps_alignment,
                                pairs, control, execution);
  }
  // Once landmarks have led them, a gorilla and a person agree by 0.57 or more, a sphere and an octahedron by 0.44.
  constexpr double min_agreement_beside_landmarks = 0.5;
  const bool are_landmarks_alone =
      !hints.keeps_alignment && rotation_by_landmarks && start.alignment.agreement < min_agreement_beside_landmarks;
  if(are_landmarks_alone)
  {
    start = {};
    start.alignment.rotation = *rotation_by_landmarks;
  }
  // Of 259 that are off by more than 10 percent, as the starts that are right were left out, 243 are; of 130 that are not by 8, 13.
  report.is_uncertain =
      !hints.keeps_alignment && !are_landmarks_alone && (start.alignment.agreement < 0.73 || start.margin < 0.1);
  control.on_initialization_end();
  report.agreement = start.alignment.agreement;
  report.margin = start.margin;
  std::vector<Vector_3d> directions = rotated_directions(start.alignment.rotation, first.sphere);
  Energy_between energy;
  const bool is_rotation = start.alignment.directions.empty(), agrees_as_it_is = is_rotation && !has_landmarks;
  if(agrees_as_it_is)
    static_cast<void>(measure_energy_between(first, directions, second, energy, control, execution));
  report.seconds_for_alignment = control.lap();
  if(energy.value && *energy.value < energy_of_copies)
    report.stop_reason = CONVERGED;
  else
  {
    Target_goals features_alone = {metric, feature_goals(first, second, start, hints, execution)};
    if(features_alone.features.image && !start.rivals.empty())
    {
      choose_among_rivals(*levels, features_alone, hints, start, control, execution);
      report.agreement = start.alignment.agreement;
    }
    if(!is_rotation)
      start.surfaces->keep_distances(metric, start.alignment.directions);
    const Target_goals goals = {metric, features_alone.features, landmark_goals(first, second, hints)};
    std::vector<Vector_3d> lowered;
    bool is_lowered =
        is_rotation || levels->refine(start.alignment.directions, features_alone, lowered, control, execution);
    if(is_rotation)
      lowered = first.mesh.in_own_order(directions);
    // What an earlier descent has found is taken apart by coarser levels: cat_horse refined by half, to an energy of 2.477 in 2.7 s
    // on levels, to 2.467 in 1.7 s without.
    const bool is_found = hints.keeps_alignment && std::all_of(pairs.begin(), pairs.end(), [](const auto& pair) {
                            constexpr double cosine_of_rounding = 1. - 1e-14;
                            return dot(pair.first, pair.second) > cosine_of_rounding;
                          });
    if(is_lowered && (is_rotation || has_landmarks))
      is_lowered = lower_on_target(first.mesh.rings(), first.mesh.points(), goals,
                                   is_found        ? first.points.size()
                                   : has_landmarks ? min_size_with_landmarks
                                                   : min_size,
                                   Target_sweeps(), lowered, control, execution);
    // What features have led may be blocked where a rotation alone is not.
    const auto n_missed = [&](const std::vector<Vector_3d>& own_order) {
      const std::vector<Vector_3d> found = first.mesh.in_callers_order(own_order);
      return std::count_if(hints.landmarks.begin(), hints.landmarks.end(), [&](const auto& landmark) {
        return found[landmark[0]] != second.sphere.direction(landmark[1]);
      });
    };
    if(!is_rotation && rotation_by_landmarks && !(hints.landmark_weight > 0.) && (!is_lowered || n_missed(lowered) > 0))
    {
      const Target_goals without_own_features = {metric, hints.features[0].empty() ? Feature_goals() : goals.features,
                                                 goals.landmarks};
      std::vector<Vector_3d> other = first.mesh.in_own_order(rotated_directions(*rotation_by_landmarks, first.sphere));
      if(lower_on_target(first.mesh.rings(), first.mesh.points(), without_own_features, min_size_with_landmarks,
                         Target_sweeps(), other, control, execution) &&
         (!is_lowered || n_missed(other) < n_missed(lowered)))
      {
        is_lowered = true;
        lowered.swap(other);
      }
    }
    report.stop_reason = is_lowered ? control.report().stop_reason : OBSTRUCTED;
    report.number_of_sweeps = control.report().number_of_level_iterations;
    report.seconds_for_descent = control.lap();
    // The averaged metric moves even the identity: only the surfaces themselves tell whether that has helped.
    Energy_between lowered_energy;
    lowered = is_lowered ? first.mesh.in_callers_order(lowered) : directions;
    const bool is_bijection = measure_energy_between(first, lowered, second, lowered_energy, control, execution);
    // Samples find less than the refinement, and cannot be compared with it.
    const bool is_better =
        !agrees_as_it_is || (energy.value && lowered_energy.value && energy.is_sampled == lowered_energy.is_sampled &&
                             *lowered_energy.value < *energy.value);
    if(is_bijection && is_better)
    {
      energy = lowered_energy;
      directions.swap(lowered);
    }
    report.seconds_for_overlay = control.lap();
  }
  if(control.is_stopped())
    report.stop_reason = control.stop_reason();
  report.energy = energy.value.value_or(0.);
  report.is_energy_sampled = energy.is_sampled;
  report.distortion = energy.distortion;
  for(const auto& [v, w] : hints.landmarks)
  {
    const bool is_met = directions[v] == second.sphere.direction(w);
    report.landmark_distances.push_back(is_met ? 0. : distance_left(second, directions[v], w));
    report.number_of_missed_landmarks += !(hints.landmark_weight > 0.) && !is_met;
  }
  control.on_optimization_end();
  return directions;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FIND_SURFACE_MAP_H
