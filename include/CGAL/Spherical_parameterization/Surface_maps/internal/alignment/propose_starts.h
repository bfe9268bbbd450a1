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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_PROPOSE_STARTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_PROPOSE_STARTS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Alignment_descent.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Extremity_search.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The rotations for which features agree best.
struct Rotation_candidates
{
  std::vector<Alignment> alignments; // in the order of decreasing score; at least one
  bool are_of_same_shape = false;    // The surfaces are copies, and the best rotation maps one to the other.
};

inline Rotation_candidates propose_rotations(const Coarse_pair& surfaces, const Sphere_mesh& sphere1,
                                             const Sphere_mesh& sphere2)
{
  // Copies of a surface with rotated copies of its sphere have a score of nearly 1, poses of a body a smaller one. With a larger
  // threshold, copies go through the descent and end with an error of 1.3 degrees, while that of the rotation is 0.2; with a smaller
  // one, poses are only rotated.
  constexpr double min_score_of_same_shape = 0.97;
  constexpr std::size_t n_rotations = 8; // with fewer, a correct one is occasionally lost
  Rotation_candidates result;
  std::vector<Alignment>& alignments = result.alignments;
  for(const Scored_rotation& r : surfaces.best_rotations(n_rotations))
  {
    const double missed = surfaces.distance_from_landmarks([&](const Vector_3d& p) { return rotated(r.rotation, p); });
    alignments.push_back({r.rotation, {}, {}, r.score, r.score - missed, missed});
  }
  std::stable_sort(alignments.begin(), alignments.end(),
                   [](const Alignment& a, const Alignment& b) { return a.score > b.score; });
  result.are_of_same_shape = alignments[0].score > min_score_of_same_shape;
  if(result.are_of_same_shape)
    alignments[0].rotation =
        closest_point_rotation(alignments[0].rotation, sphere1, sphere2, surfaces.control(), surfaces.execution());
  return result;
}

// The starts of descents: these rotations, and rotations that align extremities which may correspond.
inline std::vector<Alignment_start> propose_starts(Coarse_pair& surfaces, const std::vector<Alignment>& rotations,
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

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_PROPOSE_STARTS_H
