// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_SPHERE_RADIUS_POLICY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_SPHERE_RADIUS_POLICY_H

#include "Copy_constructible.h"

#include <CGAL/Spherical_parameterization/Face_invariants_3.h>

#include <type_traits>

namespace archetypes {

// SphereRadiusPolicy_3 without the optional members. It makes use of all that it is promised of the range of faces.
class Sphere_radius_policy : public Copy_constructible
{
public:
  using Copy_constructible::Copy_constructible;

  double initial_radius(double equal_area_radius) const { return equal_area_radius; }

  template <class Energy, class FaceRange>
  double operator()(const Energy& energy, const FaceRange& faces, double radius)
  {
    using Iterator = typename FaceRange::const_iterator;
    using Size = typename FaceRange::size_type;

    const Size size = faces.size();
    double sum = 0.;
    for(Iterator it = faces.begin(); it != faces.end(); ++it)
    {
      static_assert(
          std::is_convertible<decltype(*it), const CGAL::Spherical_parameterization::Face_invariants_3&>::value,
          "The value type is Face_invariants_3.");
      sum += energy(it->i, it->d) > 0. ? it->d : 0.;
    }
    return faces.empty() || !(sum > 0.) ? radius : radius * static_cast<double>(size) / sum;
  }
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_SPHERE_RADIUS_POLICY_H
