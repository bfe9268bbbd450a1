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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FIXED_RADIUS_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FIXED_RADIUS_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationRadius
///
/// The class `Fixed_radius_3` keeps the radius at a given value, in the unit of length of the surface. It suits
/// energies that do not depend on the radius, such as `Conformal_energy_3`, and spheres of prescribed size.
///
/// \cgalModels{SphereRadiusPolicy_3}
class Fixed_radius_3
{
public:
  /// constructs the policy with the radius `radius`, which must be positive and finite, in the unit of length of the
  /// surface.
  explicit Fixed_radius_3(double radius = 1.)
    : m_radius(radius)
  {}

  /// returns the radius.
  double radius() const { return m_radius; }

  /// returns whether the radius is positive and finite.
  bool is_valid() const { return internal::is_positive_and_finite(m_radius); }

  /// returns the radius, for any area of the surface.
  double initial_radius(double /* equal_area_radius */) const { return m_radius; }

  /// returns the radius, for any arguments.
  template <class Energy>
  double operator()(const Energy& /* energy */, const Face_range_3& /* faces */, double /* radius */)
  {
    return m_radius;
  }

private:
  double m_radius;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FIXED_RADIUS_3_H
