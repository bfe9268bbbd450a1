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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CENTER_MASS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CENTER_MASS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Moebius_transformation.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

inline Vector_3d center_of_mass(const std::vector<Vector_3d>& points, const std::vector<double>& masses)
{
  Vector_3d sum = {0., 0., 0.};
  double mass = 0.;
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    sum = sum + masses[v] * points[v];
    mass += masses[v];
  }
  return (1. / mass) * sum;
}

// The solution x of sum m (1 - u u^T) x = b. The matrix is symmetric, and positive definite unless all points are on
// one line.
inline Vector_3d solve_tangential(const std::vector<Vector_3d>& points, const std::vector<double>& masses,
                                  const Vector_3d& b)
{
  std::array<Vector_3d, 3> rows = {};
  for(std::size_t v = 0; v < points.size(); ++v)
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        rows[i][j] += masses[v] * ((i == j ? 1. : 0.) - points[v][i] * points[v][j]);
  // Cramer's rule
  const Vector_3d c0 = cross(rows[1], rows[2]), c1 = cross(rows[2], rows[0]), c2 = cross(rows[0], rows[1]);
  return (1. / dot(rows[0], c0)) * (b[0] * c0 + b[1] * c1 + b[2] * c2);
}

// Moves points of the unit sphere by Moebius transformations until their centre of mass is at the centre of the sphere.
// There is one such transformation, up to rotations, if no point has half of the mass or more; the masses of vertices,
// a third of the areas of their faces, are never as large.
//
// A transformation that `is_admissible(moved points)` refuses is replaced by weaker ones; if those are refused as well,
// the points stay where they are. Returns the distance that remains.
template <class IsAdmissible>
double center_mass(std::vector<Vector_3d>& points, const std::vector<double>& masses, const IsAdmissible& is_admissible)
{
  constexpr double tolerance = 1e-12, longest_push = 0.5;
  constexpr int most_pushes = 100, most_halvings = 8;

  double mass = 0.;
  for(const double m : masses)
    mass += m;
  std::vector<Vector_3d> moved(points.size());
  Vector_3d center = center_of_mass(points, masses);
  for(int k = 0; k < most_pushes && length(center) > tolerance; ++k)
  {
    // Newton's method: a weak push by c moves a point u by 2 (c - (c u) u).
    Vector_3d push = solve_tangential(points, masses, (-0.5 * mass) * center);
    const double size = length(push);
    if(!(size > 0.))
      break;
    if(size > longest_push)
      push = (longest_push / size) * push;
    bool is_moved = false;
    for(int halving = 0; halving < most_halvings && !is_moved; ++halving, push = 0.5 * push)
    {
      const Moebius_transformation transformation(push);
      for(std::size_t v = 0; v < points.size(); ++v)
        moved[v] = transformation(points[v]);
      const Vector_3d next_center = center_of_mass(moved, masses);
      if(length(next_center) < length(center) && is_admissible(moved))
      {
        center = next_center;
        points.swap(moved);
        is_moved = true;
      }
    }
    if(!is_moved)
      break;
  }
  return length(center);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CENTER_MASS_H
