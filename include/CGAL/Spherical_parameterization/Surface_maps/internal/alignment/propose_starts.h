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
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The rotations for which features agree best.
struct Rotation_candidates
{
  std::vector<Alignment> alignments; // in the order of decreasing score; at least one
  bool are_copies = false;           // by their features: the best rotation maps one to the other
};

inline Rotation_candidates propose_rotations(const Coarse_pair& surfaces, const Sphere_mesh& sphere1,
                                             const Sphere_mesh& sphere2)
{
  // Copies of a surface with rotated copies of its sphere have a score of nearly 1, poses of a body a smaller one. With a larger
  // threshold, copies go through the descent and end with an error of 1.3 degrees, while that of the rotation is 0.2; with a smaller
  // one, poses are only rotated.
  constexpr double min_score_of_copies = 0.97;
  constexpr std::size_t n_rotations = 4; // with 5, and 7 matchings, the same maps win
  Rotation_candidates result;
  std::vector<Alignment>& alignments = result.alignments;
  for(const Scored_rotation& r : surfaces.best_rotations(n_rotations))
  {
    const double missed = surfaces.distance_from_landmarks([&](const Vector_3d& p) { return rotated(r.rotation, p); });
    alignments.push_back({r.rotation, {}, {}, r.score, r.score - missed, missed});
  }
  std::stable_sort(alignments.begin(), alignments.end(),
                   [](const Alignment& a, const Alignment& b) { return a.score > b.score; });
  result.are_copies = alignments[0].score > min_score_of_copies;
  if(result.are_copies)
    alignments[0].rotation =
        closest_point_rotation(alignments[0].rotation, sphere1, sphere2, surfaces.control(), surfaces.execution());
  return result;
}

// These rotations, and their counterparts by the approximate symmetry of the second surface. If features of a person prefer a half-turn,
// the correct rotation may be no local maximum, and no other one near it.
inline std::vector<Rotation_matrix> with_counterparts(const Coarse_pair& surfaces,
                                                      const std::vector<Alignment>& alignments)
{
  constexpr std::size_t n_counterparts = 3;
  const Rotation_matrix symmetry = surfaces.symmetry_of_second();
  std::vector<Rotation_matrix> result;
  for(const Alignment& alignment : alignments)
    result.push_back(alignment.rotation);
  for(std::size_t k = 0; k < alignments.size() && k < n_counterparts; ++k)
    result.push_back(product(symmetry, alignments[k].rotation));
  return result;
}

// The starts of descents: these rotations, and rotations that align extremities which may correspond.
inline std::vector<Alignment_start> propose_starts(Coarse_pair& surfaces, const std::vector<Rotation_matrix>& rotations,
                                                   const Alignment_descent& descent)
{
  constexpr std::size_t n_matchings = 5;
  std::vector<Alignment_start> starts;
  const Mesh_hierarchy levels = descent.levels();
  const auto extremities = surfaces.extremities();
  for(const Rotation_matrix& rotation : rotations)
    starts.push_back(descent.start_from(levels, rotation, surfaces.distance_guides(extremities, {})));
  for(const Extremity_matching& matching :
      Extremity_search(extremities[0], extremities[1])
          .best(n_matchings, surfaces.first().directions(), surfaces.second().directions()))
    starts.push_back(
        descent.start_from(levels, matching.rotation, surfaces.distance_guides(extremities, matching.pairs)));
  return starts;
}

// Moves the corners of inverted faces to the means of their neighbors until no face is inverted; returns false if that fails.
inline bool untangle(const Vertex_rings& rings, std::vector<Vector_3d>& directions)
{
  constexpr int max_rounds = 200; // 4 to 20 suffice for some 50 vertices of which a few faces are inverted
  for(int round = 0; round < max_rounds && !are_safely_positive(rings, directions); ++round)
  {
    std::vector<char> is_moved(directions.size(), 0);
    rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if(!is_safely_positive(directions[a], directions[b], directions[c]))
        is_moved[a] = is_moved[b] = is_moved[c] = 1;
    });
    for(std::size_t v = 0; v < directions.size(); ++v)
      if(is_moved[v])
      {
        Vector_3d sum = directions[v];
        for(const std::uint32_t w : rings.ring(v))
          sum = sum + directions[w];
        directions[v] = normalized(sum);
      }
  }
  return are_safely_positive(rings, directions);
}

// A start from the inverse of a map from the second surface to the first sphere, which also guides it on all levels. Between vertices,
// the inverse is not linear on the faces of the first surface, and inverts some of them on the coarsest level. There is no start if they
// cannot be untangled, or if the inverse determines no rotation.
inline std::optional<Alignment_start> start_from_inverse(const Coarse_pair& surfaces,
                                                         const std::vector<Vector_3d>& directions,
                                                         const Mesh_hierarchy& levels, const Alignment_descent& descent)
{
  const std::vector<Linked_triangle>& triangles = surfaces.second().sphere().triangles();
  Sphere_mesh map;
  map.assign(points_of(directions), triangles);
  map.make_grid();
  std::vector<Vector_3d> images;
  std::vector<std::pair<Vector_3d, Vector_3d>> pairs;
  for(const auto& location : map.locate(points_of(surfaces.first().directions()), surfaces.execution()))
  {
    images.push_back(normalized(interpolated(surfaces.second().directions(), triangles, location)));
    pairs.emplace_back(surfaces.first().directions()[pairs.size()], images.back());
  }
  const std::size_t coarsest = levels.number_of_levels() - 1;
  std::vector<Vector_3d> positions = levels.level(coarsest).gathered(images);
  const std::optional<Rotation_matrix> rotation = fitting_rotation(pairs);
  if(!rotation || !untangle(levels.rings(coarsest), positions))
    return {};
  Alignment_start result = descent.start_from(levels, *rotation, surfaces.position_guides(images));
  for(std::size_t i = 0; i < positions.size(); ++i)
    result.alignment.directions[levels.level(coarsest).vertices[i]] = positions[i];
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_PROPOSE_STARTS_H
