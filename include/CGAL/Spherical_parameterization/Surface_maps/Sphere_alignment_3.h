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
/// The rotations that bring the sphere of one surface onto the sphere of another one: what `align_spheres()` finds.
struct Sphere_alignment_3
{
  /// Type of a rotation about the origin
  using Rotation_3 = CGAL::Aff_transformation_3<Exact_predicates_inexact_constructions_kernel>;

  /// A rotation, and how well the surfaces agree by it
  struct Candidate
  {
    Rotation_3 rotation; ///< Of the first sphere
    double score;        ///< Correlation of the features, at most 1
  };

  /// The best rotations that differ by 20 degrees or more, at most four, the best one first
  std::vector<Candidate> candidates;

  /// Whether the visitor or the time limit has ended the search: the candidates are the best of what has been tried by then,
  /// at worst the identity alone, with the score 0
  bool is_stopped = false;

  /// returns how much higher the score of the best candidate is than that of the second best, or than 0 if there is one only.
  /// A margin below 0.1 or so means that the surface has a symmetry, or nearly: then look at both.
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
