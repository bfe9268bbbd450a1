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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FIND_SURFACE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FIND_SURFACE_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_map_report.h>
#include <CGAL/Spherical_parameterization/internal/align/Sampled_surface.h>
#include <CGAL/Spherical_parameterization/internal/align/Surface_alignment.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/measuring/distortion.h>
#include <CGAL/Spherical_parameterization/internal/measuring/energy_between.h>
#include <CGAL/Spherical_parameterization/internal/overlay/Overlay_arrays.h>
#include <CGAL/Spherical_parameterization/internal/run/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/levels/Target_levels.h>
#include <CGAL/Spherical_parameterization/internal/levels/Target_metric.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// A surface on its sphere, in which directions can be located. The length that is 1 for its points is 2 to the power of
// `exponent`, see normalize().
template <class K>
struct Located_surface
{
  Sphere_triangulation<K> sphere;
  std::vector<Vector_3d> points;
  int exponent = 0;
};

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
    const Weighted_statistics measured =
        distortion_between(overlay.triangles.size(), default_smallest_area, [&](std::size_t k, std::size_t surface) {
          const auto& t = overlay.triangles[k];
          const std::vector<Vector_3d>& points = overlay.points[surface];
          return std::array<Vector_3d, 3>{points[t[0]], points[t[1]], points[t[2]]};
        }).energy;
    energy = {0.5 * (measured.averages[0] + measured.averages[1]), false};
  }
  else if(error == ERROR_TOO_LARGE_OVERLAY)
  {
    sphere.make_grid();
    const double there = mean_energy_over_first(sphere, first.points, second.sphere, second.points, control, execution),
                 back = mean_energy_over_first(second.sphere, second.points, sphere, first.points, control, execution);
    if(!control.is_stopped())
      energy = {0.5 * (there + back), true};
  }
  return error != ERROR_NO_1_TO_1_MAPPING;
}

// What is known of both surfaces beside their shapes, in the numbers of their arrays.
struct Surface_map_hints
{
  std::array<std::vector<Channel>, 2> features; // if there are none, those of the package are used
  std::vector<std::array<std::uint32_t, 2>> landmarks;
  double landmark_weight = 0.; // 0: they are to be met exactly
  double feature_weight = 0.;
};

// The start of the map: from landmarks if they determine a rotation, or else from features. These are asked for on the
// way as well, but those of the package only where they have led to the start.
template <class K>
Aligned_start start_of_map(const Located_surface<K>& first, const Located_surface<K>& second,
                           const Surface_map_hints& hints, Run_control& control, const Execution& execution)
{
  std::vector<std::pair<Vector_3d, Vector_3d>> pairs;
  for(const auto& [v, w] : hints.landmarks)
    pairs.emplace_back(first.sphere.direction(v), second.sphere.direction(w));
  const std::optional<Rotation_matrix> rotation = fitting_rotation(pairs);
  Aligned_start result;
  if(rotation)
    result.directions = rotated_directions(*rotation, first.sphere);
  if(rotation && (hints.features[0].empty() || !(hints.feature_weight > 0.)))
    return result;
  const Sphere_grid grid(execution);
  const auto samples = [&](const Located_surface<K>& surface, std::size_t k) {
    return Sampled_surface(grid, surface.sphere, surface.points, hints.features[k], execution);
  };
  Surface_alignment alignment(grid, samples(first, 0), samples(second, 1), control, execution);
  if(!rotation)
    result = alignment.start(first.sphere, second.sphere);
  result.features = {alignment.features(0), alignment.features(1)};
  return result;
}

template <class K>
Landmark_goals landmark_goals(const Located_surface<K>& second, const Surface_map_hints& hints, std::size_t n_vertices)
{
  Landmark_goals goals;
  if(hints.landmarks.empty())
    return goals;
  // The sum over the faces is 8 pi times the mean energy.
  goals.weight = 8. * CGAL_PI * hints.landmark_weight / static_cast<double>(hints.landmarks.size());
  goals.directions.resize(n_vertices);
  for(const auto& [v, w] : hints.landmarks)
    goals.directions[v] = second.sphere.direction(w);
  return goals;
}

template <class K>
Feature_goals feature_goals(const Located_surface<K>& first, const Aligned_start& start, const Surface_map_hints& hints)
{
  Feature_goals result;
  // A run that is stopped early may have no channels yet.
  if(start.features.empty() || start.features[0].number_of_channels() == 0 || !(hints.feature_weight > 0.))
    return result;
  result.image = start.features[1];
  // Those of the package count the less, the less they agree: on bodies without limbs they are noise.
  const double trust = std::clamp(start.agreement, 0., 1.);
  result.weight = hints.feature_weight * (hints.features[0].empty() ? trust * trust * trust * trust : 1.);
  const std::size_t n_channels = start.features[0].number_of_channels();
  result.values.resize(first.points.size() * n_channels);
  for(std::size_t v = 0; v < first.points.size(); ++v)
    start.features[0].interpolate(first.sphere.direction(v), &result.values[v * n_channels]);
  return result;
}

// Finds the map of the first surface, which is `mesh` as well, onto the second one: a start, and the descent from it. It is
// yet to be certified.
template <class K>
std::vector<Vector_3d> find_surface_map(const Surface& mesh, const Located_surface<K>& first,
                                        const Located_surface<K>& second, const Surface_map_hints& hints,
                                        Surface_map_report& report, Run_control& control, const Execution& execution)
{
  // Landmarks are moved on levels of very few vertices. Features have brought all that is large to its place, as far as
  // their grid can tell: on coarser levels than this, the two surfaces have lost too much to be compared.
  constexpr std::size_t min_size_with_landmarks = 60, min_size = 1000;
  constexpr double energy_of_copies = 2. + 1e-9; // the least, but for rounding: they need no descent

  const bool has_landmarks = !hints.landmarks.empty();
  control.on_initialization_begin(mesh.number_of_vertices());
  const Aligned_start start = start_of_map(first, second, hints, control, execution);
  control.on_initialization_end();
  report.agreement = start.agreement;
  report.margin = start.margin;
  std::vector<Vector_3d> directions = start.directions;
  Energy_between energy;
  const bool agrees_as_it_is = start.is_rotation && !has_landmarks;
  if(agrees_as_it_is)
    static_cast<void>(measure_energy_between(first, directions, second, energy, control, execution));
  report.seconds_for_alignment = control.lap();
  if(energy.value && *energy.value < energy_of_copies)
    report.stop_reason = CONVERGED;
  else
  {
    std::vector<Vector_3d> lowered = directions;
    const bool is_lowered =
        lower_on_target(mesh, Target_metric(second.sphere, second.points, execution),
                        landmark_goals(second, hints, mesh.number_of_vertices()), feature_goals(first, start, hints),
                        has_landmarks ? min_size_with_landmarks : min_size, lowered, control, execution);
    report.stop_reason = is_lowered ? control.report().stop_reason : OBSTRUCTED;
    report.number_of_sweeps = control.report().number_of_level_iterations;
    report.seconds_for_descent = control.lap();
    // The averaged metric moves even the identity: only the surfaces themselves tell whether that has helped.
    Energy_between lowered_energy;
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

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FIND_SURFACE_MAP_H
