// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_DISTORTION_ENERGY_IN_LANES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_DISTORTION_ENERGY_IN_LANES_H

#include "Copy_constructible.h"

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/tags.h>

namespace archetypes {

// DistortionEnergy_3 with Is_lanewise: the symmetric Dirichlet energy in the four operations with FT and double alone
class Distortion_energy_in_lanes : public Copy_constructible
{
public:
  using Is_lanewise = CGAL::Tag_true;
  using Copy_constructible::Copy_constructible;

  template <class FT>
  FT operator()(const FT& i, const FT& d) const
  {
    return 0.5 * i * (1. + 1. / (d * d));
  }

  template <class FT>
  CGAL::Spherical_parameterization::Basic_energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const
  {
    const FT inverse = 1. / (d * d);
    return {0.5 * i * (1. + inverse),    0.5 * (1. + inverse), -i * inverse / d, FT(0.), -inverse / d,
            3. * i * (inverse * inverse)};
  }
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_DISTORTION_ENERGY_IN_LANES_H
