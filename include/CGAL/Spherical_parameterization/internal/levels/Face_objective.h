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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_FACE_OBJECTIVE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_FACE_OBJECTIVE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>

namespace CGAL::Spherical_parameterization::internal {

// What the faces add to the objective, as a function of their energy E:
//   psi(E) = (1 - a) E + (a / s) exp(s (E - R)),   psi' = (1 - a) + a exp(s (E - R)),
// or E for s = 0. Eq. 6 of the paper is s = 0, and eq. 7 is a = 1, where R is but a factor.
//
// The group of the slivers, see sliver_vertices(), may have its own s and R, and its own sphere, which stays where it is
// when the radius changes.
struct Face_objective
{
  struct Exponential
  {
    double sharpness = 0.; // s
    double level = 0.;     // R
  };

  Face_objective() = default;
  // eq. 6 or 7: a sharpness is an objective
  Face_objective(double sharpness)
    : ordinary{sharpness, 0.}
    , of_slivers{sharpness, 0.}
  {}

  bool is_average() const { return !(ordinary.sharpness > 0.); }
  bool has_levels() const { return share < 1.; }

  // What the d of a face is multiplied by. Its image is measured by the determinant of the corners, which is less than the
  // doubled area by the distance of its plane from the centre: 1 - c^2 / 2 + ... for an isometric image on the unit
  // sphere, whose area is that of the surface, with the circumradius c; and c^2 is a ninth of the sum of the squared
  // edges of an equilateral face. So isometric images have d = 1 up to higher order on coarse meshes as well.
  // It is bounded, since no image of a face is as long as the faces of coarse and long surfaces are.
  template <class FT>
  FT area_factor(const FT& opposite_0, const FT& opposite_1, const FT& opposite_2, const FT& doubled_area) const
  {
    constexpr double max_correction = 4.;
    const FT correction = area_correction * (opposite_0 + opposite_1 + opposite_2) * doubled_area * doubled_area;
    return 1. + minimum(correction, FT(max_correction));
  }

  double share = 1.; // a
  Exponential ordinary, of_slivers;
  double sliver_radius = 0.; // or 0: that of all faces
  double area_correction = 0.;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_FACE_OBJECTIVE_H
