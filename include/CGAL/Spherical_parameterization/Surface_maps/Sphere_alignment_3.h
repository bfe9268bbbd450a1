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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SPHERE_ALIGNMENT_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SPHERE_ALIGNMENT_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// The class `Sphere_alignment_3` contains the result of `align_spheres()`: the rotations that best align the sphere of one
/// surface with the sphere of another surface.
struct Sphere_alignment_3
{
  /// Type of a rotation about the origin
  using Rotation_3 = CGAL::Aff_transformation_3<Exact_predicates_inexact_constructions_kernel>;

  /// A rotation and its score
  struct Candidate
  {
    Rotation_3 rotation; ///< The rotation of the first sphere
    double score;        ///< The correlation of the features of the rotated surfaces, at most 1
  };

  /// The best rotations, at most four, at least 20 degrees apart, in the order of decreasing score
  std::vector<Candidate> candidates;

  /// Whether the visitor or the time limit has stopped the search. The candidates are then the best rotations found so far,
  /// at least the identity with score 0.
  bool is_stopped = false;

  /// returns the difference between the scores of the best and the second best candidate, or the score of the best
  /// candidate if it is the only one.
  ///
  /// A margin below about 0.1 indicates an exact or approximate symmetry of the surface. The alignment is then ambiguous,
  /// and both candidates should be examined.
  double margin() const
  {
    if(candidates.empty())
      return 0.;
    return candidates[0].score - (candidates.size() > 1 ? candidates[1].score : 0.);
  }
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SPHERE_ALIGNMENT_3_H
