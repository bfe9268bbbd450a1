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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_ALIGNED_START_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_ALIGNED_START_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/align/Bent_map.h>
#include <CGAL/Spherical_parameterization/internal/align/Rotation_search.h>
#include <CGAL/Spherical_parameterization/internal/align/Sphere_grid.h>
#include <CGAL/Spherical_parameterization/internal/align/Surface_alignment.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Where the vertices of the first surface start on the sphere of the second one.
struct Aligned_start
{
  std::vector<Vector_3d> directions;
  double agreement = 0., margin = 0.; // see Surface_map_report
  bool is_rotation = false;           // The spheres agree as they are.
  std::vector<Sphere_image> features; // of both surfaces, if they are to agree
};

template <class K>
std::vector<Vector_3d> rotated_directions(const Rotation_matrix& rotation, const Sphere_triangulation<K>& sphere)
{
  std::vector<Vector_3d> result;
  result.reserve(sphere.points().size());
  for(std::size_t v = 0; v < sphere.points().size(); ++v)
    result.push_back(normalized(rotated(rotation, sphere.direction(v))));
  return result;
}

// The rotation that brings each vertex nearest to one of the second sphere, in a few rounds from a rotation that is nearly
// so. For copies of a sphere it is exact but for rounding.
template <class K>
Rotation_matrix polished(Rotation_matrix rotation, const Sphere_triangulation<K>& sphere1,
                         const Sphere_triangulation<K>& sphere2, const Execution& execution)
{
  constexpr int n_rounds = 8;
  for(int round = 0; round < n_rounds; ++round)
  {
    std::vector<typename K::Point_3> queries;
    for(const Vector_3d& p : rotated_directions(rotation, sphere1))
      queries.emplace_back(p[0], p[1], p[2]);
    const auto places = sphere2.locate(queries, execution);
    std::vector<std::pair<Vector_3d, Vector_3d>> pairs;
    for(std::size_t v = 0; v < queries.size(); ++v)
    {
      const auto& w = places[v].coordinates;
      const std::size_t nearest = static_cast<std::size_t>(std::max_element(w.begin(), w.end()) - w.begin());
      pairs.emplace_back(sphere1.direction(v), sphere2.direction(sphere2.triangles()[places[v].triangle][nearest]));
    }
    if(const std::optional<Rotation_matrix> next = fitting_rotation(pairs))
      rotation = *next;
  }
  return rotation;
}

// Finds the start by features that do not depend on how the surfaces lie in space. Poses of a body have spheres that
// differ by more than a rotation: then they are bent onto each other, from the two best rotations, and the better one is
// taken. Both spheres have grids.
template <class K>
Aligned_start align(const Sphere_grid& grid, const Surface_alignment& alignment, const Sphere_triangulation<K>& sphere1,
                    const Sphere_triangulation<K>& sphere2, const Execution& execution)
{
  constexpr double min_score_of_same_shape = 0.97;
  const std::vector<Scored_rotation> candidates = alignment.best_rotations(2);
  Aligned_start result;
  if(candidates[0].score > min_score_of_same_shape)
  {
    result.is_rotation = true;
    result.agreement = candidates[0].score;
    result.margin = candidates[0].score - (candidates.size() > 1 ? candidates[1].score : 0.);
    result.directions = rotated_directions(polished(candidates[0].rotation, sphere1, sphere2, execution), sphere1);
    return result;
  }
  std::array<std::vector<Vector_3d>, 2> bent;
  std::array<double, 2> agreements = {0., 0.};
  for_each_block(execution, 0, candidates.size(), 1, [&](std::size_t k, std::size_t) {
    bent[k] = alignment.bent(candidates[k].rotation);
    agreements[k] = alignment.agreement(bent[k]);
  });
  const std::size_t best = agreements[1] > agreements[0] ? 1 : 0;
  result.agreement = agreements[best];
  result.margin = agreements[best] - agreements[1 - best];
  const auto directions = Bent_map<K>(sphere1).directions(grid, bent[best], candidates[best].rotation, execution);
  result.directions = directions ? *directions : rotated_directions(candidates[best].rotation, sphere1);
  return result;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_ALIGNED_START_H
