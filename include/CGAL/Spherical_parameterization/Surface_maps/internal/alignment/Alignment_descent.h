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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_ALIGNMENT_DESCENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_ALIGNMENT_DESCENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Coarse_pair.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_levels.h>

#include <initializer_list>
#include <memory>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A correspondence of two coarse surfaces and of their spheres.
struct Alignment
{
  Rotation_matrix rotation = rotation_matrix({1., 0., 0., 0.});
  std::vector<Vector_3d> directions;      // of the vertices of the first coarse surface; empty if they are only rotated
  std::vector<Vector_3d> before_matching; // the directions before match_functions()
  double agreement = 0.;                  // the correlation of the features, before match_functions()
  double score = 0.;  // that in the choice on coarse surfaces minus stretching and distance from landmarks
  double missed = 0.; // the distance from landmarks, in units of the mean distance
};

// A start, and its state during the descent.
struct Alignment_start
{
  Alignment alignment;
  Coarse_pair::Guides guides;
  std::vector<Vector_3d> images;             // the rotated images of the first surface
  std::unique_ptr<Mesh_hierarchy> hierarchy; // the remaining levels, from the current one to the finest
  bool is_valid = true;                      // false if double precision does not suffice
};

// The descent of a start on the coarse surfaces, and the score of the result. First, the energy of the map between the surfaces is
// combined with features of large weight, including distances from extremities that may correspond: these do not depend on the
// pose, and guide vertices over large distances. Then it is combined with the features of the surfaces alone, with the weight of
// the settings. The candidates for the choice are also guided by eigenfunctions.
class Alignment_descent
{
public:
  // Both arguments must outlive this object.
  Alignment_descent(const Coarse_pair& surfaces, const Target_metric& metric)
    : m_surfaces(surfaces)
    , m_metric(metric)
  {}

  // The levels of the first surface, the same for all starts.
  Mesh_hierarchy levels() const
  {
    // From 60 vertices on, whole extremities move. With 30, the surfaces have lost too much detail; with 120, vertices are not
    // guided over large enough distances.
    constexpr std::size_t min_size = 60;
    const Surface_descriptor& surface = m_surfaces.first();
    Run_control control;
    return Mesh_hierarchy(surface.rings(), m_surfaces.points(), vertex_areas(surface.rings(), m_surfaces.points()),
                          control, Execution(), surface.directions(), {}, min_size);
  }

  Alignment_start start_from(const Mesh_hierarchy& levels, const Rotation_matrix& rotation,
                             Coarse_pair::Guides guides) const
  {
    Alignment_start result;
    result.alignment.rotation = rotation;
    result.alignment.directions = result.images = rotated_directions(rotation, m_surfaces.first().directions());
    result.guides = std::move(guides);
    result.hierarchy = std::make_unique<Mesh_hierarchy>(levels);
    return result;
  }

  // Minimizes the energy with features and guides, first on the coarse levels only, after which most starts are discarded.
  void lead(bool is_first, Alignment_start& start) const
  {
    constexpr std::size_t first_size = 700;
    std::size_t last_level = 0;
    Run_control control;
    while(is_first && last_level + 1 < start.hierarchy->number_of_levels() &&
          start.hierarchy->level(last_level).vertices.size() > first_size)
      ++last_level;
    const Feature_goals features = m_surfaces.goals(start.guides);
    start.is_valid = start.is_valid && minimize_on_levels(*start.hierarchy, m_surfaces.points(), start.images,
                                                          {m_metric, features, leading_weight}, m_sweeps,
                                                          start.alignment.directions, control, Execution(), last_level);
    assess(start);
  }

  // Minimizes the energy with the features alone.
  void settle(double feature_weight, Alignment_start& start) const
  {
    start.is_valid = start.is_valid && lower({}, feature_weight, m_sweeps, start.alignment.directions, Execution());
    assess(start);
  }

  // Refines a map with the guidance of eigenfunctions of both surfaces. They distinguish positions along an extremity or around a
  // body where the energy and features are nearly constant. Higher frequencies correspond once lower ones do, so their number
  // increases from round to round (Melzi et al., ZoomOut: Spectral Upsampling for Efficient Shape Correspondence, 2019).
  void match_functions(Alignment& alignment) const
  {
    constexpr Target_sweeps sweeps = {20, 1e-3, 0.04}; // with less than half as many, poses are matched less accurately
    alignment.before_matching = alignment.directions;
    std::vector<std::uint32_t> vertices(alignment.directions.size());
    std::iota(vertices.begin(), vertices.end(), 0u);
    // With more functions, the highest ones depend on the coarse triangles instead of the surfaces.
    const std::size_t max_functions = (std::min)(m_surfaces.first().size(), m_surfaces.second().size()) / 15;
    for(const std::size_t n_functions : std::initializer_list<std::size_t>{10, 32, 55, 77, 100})
      if(n_functions <= max_functions)
        lower(m_surfaces.eigenfunction_guides(alignment.directions, n_functions), leading_weight, sweeps,
              alignment.directions, m_surfaces.execution());
    alignment.missed = distance_from_landmarks(vertices, alignment.directions);
  }

private:
  bool lower(Coarse_pair::Guides guides, double weight, const Target_sweeps& sweeps, std::vector<Vector_3d>& directions,
             const Execution& execution) const
  {
    constexpr std::size_t min_size = 500; // the coarsest level, which suffices once large parts correspond
    Run_control control;
    const Feature_goals features = m_surfaces.goals(std::move(guides));
    return minimize_on_target(m_surfaces.first().rings(), m_surfaces.points(), {m_metric, features, weight}, min_size,
                              sweeps, directions, control, execution);
  }

  // Computes the score of a map on its current level.
  void assess(Alignment_start& start) const
  {
    const std::size_t k = start.hierarchy->number_of_levels() - 1;
    const Mesh_hierarchy::Level& level = start.hierarchy->level(k);
    // With values from 1/4 to 1/2, the same starts are chosen.
    constexpr double weight_of_stretching = 1. / 3.;
    const std::vector<Vector_3d>& directions = start.alignment.directions;
    start.alignment.agreement = feature_agreement(m_surfaces.feature_goals(), level, directions);
    start.alignment.missed = distance_from_landmarks(level.vertices, directions);
    start.alignment.score =
        feature_agreement(m_surfaces.feature_goals(), level, directions, m_surfaces.first().weights_in_choice()) -
        weight_of_stretching * stretching(m_metric, level, start.hierarchy->rings(k), m_surfaces.points(), directions) -
        start.alignment.missed;
  }

  // The mean distance of a map of these vertices from the landmarks.
  double distance_from_landmarks(const std::vector<std::uint32_t>& vertices,
                                 const std::vector<Vector_3d>& directions) const
  {
    return m_surfaces.distance_from_landmarks([&](const Vector_3d& p) {
      const auto cosine = [&](std::uint32_t v) { return dot(m_surfaces.first().directions()[v], p); };
      return directions[*std::max_element(vertices.begin(), vertices.end(),
                                          [&](std::uint32_t v, std::uint32_t w) { return cosine(v) < cosine(w); })];
    });
  }

  // With 40, extremities stay at their positions on the first surface; above 160, the regions between them are compressed too much.
  static constexpr double leading_weight = 80.;
  // Fewer sweeps than by default, because finer levels follow; with a settled part of 0.04, scores are less accurate, and more maps
  // are half-turns.
  static constexpr Target_sweeps m_sweeps = {20, 1e-3, 0.02};

  const Coarse_pair& m_surfaces;
  const Target_metric& m_metric;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_ALIGNMENT_DESCENT_H
