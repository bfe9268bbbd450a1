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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FIND_SURFACE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FIND_SURFACE_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_map_report.h>
#include <CGAL/Spherical_parameterization/internal/align/Rotation_search.h>
#include <CGAL/Spherical_parameterization/internal/align/Surface_alignment.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/surface/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/overlay/Overlay_arrays.h>
#include <CGAL/Spherical_parameterization/internal/measuring/distortion_between.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/sampling/surface_samples.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/align/Aligned_start.h>
#include <CGAL/Spherical_parameterization/internal/levels/Surface_descent.h>
#include <CGAL/Spherical_parameterization/internal/levels/Target_metric.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A surface on its sphere, in which directions can be located. Its points are moved to the origin and scaled, such that
// products of coordinates neither overflow nor underflow.
template <class K>
struct Located_surface
{
  Sphere_triangulation<K> sphere;
  std::vector<Vector_3d> points;
  double unit = 0.; // the length that is 1 here

  void set_points(std::vector<Vector_3d> new_points)
  {
    points = std::move(new_points);
    const Vector_3d origin = points[0];
    for(Vector_3d& p : points)
    {
      p = 0.5 * p - 0.5 * origin; // halves, because the difference may overflow
      unit = (std::max)({unit, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    }
    for(Vector_3d& p : points)
      for(double& x : p)
        x = unit > 0. ? x / unit : 0.;
    unit *= 2.;
  }
};

// How far what lies in a direction is from a vertex.
template <class K>
double distance_left(const Located_surface<K>& surface, const Vector_3d& p, std::size_t w)
{
  typename Sphere_triangulation<K>::Hint hint;
  const auto place = surface.sphere.locate(typename K::Point_3(p[0], p[1], p[2]), hint);
  return surface.unit * length(interpolated(surface.points, surface.sphere.triangles(), place) - surface.points[w]);
}

// The energy of the map that puts the vertices of the first surface at these directions of the second one's sphere: the
// mean of both ways, on the common refinement; none if the map is no bijection.
template <class K>
std::optional<double> energy_between(const Located_surface<K>& first, const std::vector<Vector_3d>& directions,
                                     const Located_surface<K>& second, const Execution& execution)
{
  std::vector<typename K::Point_3> images;
  for(const Vector_3d& p : directions)
    images.emplace_back(p[0], p[1], p[2]);
  Sphere_triangulation<K> sphere;
  sphere.assign(std::move(images), first.sphere.triangles());
  Overlay_arrays overlay;
  if(!certify_bijectivity<K>(sphere.points(), sphere.triangles(), execution).is_bijective() ||
     !overlay.assign(sphere, first.points, second.sphere, second.points, execution))
    return std::nullopt;
  constexpr double smallest_area = 1e-10; // as measure_distortion_between() has it
  const Distortion_between distortion =
      distortion_between(overlay.triangles.size(), smallest_area, [&](std::size_t k, std::size_t surface) {
        const auto& t = overlay.triangles[k];
        const std::vector<Vector_3d>& points = overlay.points[surface];
        return std::array<Vector_3d, 3>{points[t[0]], points[t[1]], points[t[2]]};
      });
  return 0.5 * (distortion.energy.average_over_first + distortion.energy.average_over_second);
}

// What is known of both surfaces beside their shapes, in the numbers of their arrays.
struct Surface_map_hints
{
  std::array<std::vector<Surface_alignment::Channel>, 2> features; // if there are none, those of the package are used
  std::vector<std::array<std::uint32_t, 2>> landmarks;
  double landmark_weight = 0.; // 0: they are to be met exactly
  double feature_weight = 0.;
  std::function<bool()> go_further;
};

// The start of the map: from landmarks if they determine a rotation, or else from features. These are asked for on the
// way as well, but those of the package only where they have led to the start.
template <class K>
Aligned_start start_of_map(const Located_surface<K>& first, const Located_surface<K>& second,
                           const Surface_map_hints& hints, const Execution& execution)
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
  const Sphere_grid grid;
  const auto samples = [&](const Located_surface<K>& surface, std::size_t k) {
    return Surface_alignment::samples_of(grid, surface.sphere, surface.points, hints.features[k], execution);
  };
  const Surface_alignment alignment(grid, samples(first, 0), samples(second, 1), execution);
  if(!rotation)
    result = align(grid, alignment, first.sphere, second.sphere, execution);
  result.features = {alignment.features(0), alignment.features(1)};
  return result;
}

// The map of the first surface to the sphere of the second one, and what is told of it.
struct Found_surface_map
{
  std::vector<Vector_3d> positions; // of the vertices, in the numbering of the mesh
  Surface_map_report report;
};

// Finds the map of the first surface, which is `mesh` as well, onto the second one: a start, and the descent from it. None
// if doubles cannot hold it.
template <class K>
std::optional<Found_surface_map> find_surface_map(const Indexed_mesh& mesh, const Located_surface<K>& first,
                                                  const Located_surface<K>& second, const Surface_map_hints& hints,
                                                  const Execution& execution)
{
  // Landmarks are moved on levels of very few vertices. Features have brought all that is large to its place, as far as
  // their grid can tell: on coarser levels than this, the two surfaces have lost too much to be compared.
  constexpr std::size_t min_size_with_landmarks = 60, min_size = 1000;
  constexpr double energy_of_copies = 2. + 1e-9; // which need no descent

  const bool has_landmarks = !hints.landmarks.empty();
  const Aligned_start start = start_of_map(first, second, hints, execution);
  const std::size_t n = mesh.number_of_vertices();
  Found_surface_map result;
  result.positions.resize(n);
  std::vector<std::uint32_t> numbers(n);
  for(std::uint32_t v = 0; v < n; ++v)
  {
    result.positions[v] = start.directions[mesh.original(v)];
    numbers[mesh.original(v)] = v;
  }
  Landmark_goals goals;
  goals.weight = hints.landmark_weight;
  for(const auto& [v, w] : hints.landmarks)
  {
    goals.vertices.push_back(numbers[v]);
    goals.directions.push_back(second.sphere.direction(w));
  }

  Feature_goals features;
  if(!start.features.empty() && hints.feature_weight > 0.)
  {
    features.image = start.features[1];
    // Those of the package count the less, the less they agree: on bodies without limbs they are noise.
    const double trust = (std::min)((std::max)(start.agreement, 0.), 1.);
    features.weight = hints.feature_weight * (hints.features[0].empty() ? trust * trust * trust * trust : 1.);
    const std::size_t n_channels = start.features[0].number_of_channels();
    features.values.resize(n * n_channels);
    for(std::size_t v = 0; v < n; ++v)
      start.features[0].interpolate(first.sphere.direction(mesh.original(v)), &features.values[v * n_channels]);
  }

  std::optional<double> energy;
  if(start.is_rotation && !has_landmarks)
    energy = energy_between(first, start.directions, second, execution);
  if(!(energy && *energy < energy_of_copies))
  {
    if(!are_safely_positive(mesh.rings(), result.positions))
      return std::nullopt;
    std::vector<Vector_3d> lowered = result.positions, directions(n);
    const Target_metric metric(second.sphere, second.points, execution);
    Surface_descent descent(mesh, metric, goals, features, execution);
    descent.run(lowered, has_landmarks ? min_size_with_landmarks : min_size, hints.go_further);
    result.report.is_stopped = descent.is_stopped();
    for(std::size_t v = 0; v < n; ++v)
      directions[mesh.original(v)] = lowered[v];
    // The averaged metric moves even the identity: only the common refinement tells whether that has helped.
    const std::optional<double> lowered_energy = energy_between(first, directions, second, execution);
    if(lowered_energy && !(energy && *energy <= *lowered_energy))
    {
      energy = lowered_energy;
      result.positions.swap(lowered);
    }
  }
  if(!energy)
    return std::nullopt;

  Surface_map_report& report = result.report;
  report.energy = *energy;
  report.agreement = start.agreement;
  report.margin = start.margin;
  for(std::size_t k = 0; k < hints.landmarks.size(); ++k)
  {
    const Vector_3d& p = result.positions[goals.vertices[k]];
    const bool is_met = p == goals.directions[k];
    report.landmark_distances.push_back(is_met ? 0. : distance_left(second, p, hints.landmarks[k][1]));
    report.number_of_missed_landmarks += goals.is_hard() && !is_met;
  }
  return result;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FIND_SURFACE_MAP_H
