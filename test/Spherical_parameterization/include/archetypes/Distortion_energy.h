// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_DISTORTION_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_DISTORTION_ENERGY_H

#include "Copy_constructible.h"

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>

namespace archetypes {

// DistortionEnergy_3 without the optional members
class Distortion_energy : public Copy_constructible
{
public:
  using Copy_constructible::Copy_constructible;

  double operator()(double i, double d) const { return m_energy(i, d); }

  CGAL::Spherical_parameterization::Energy_derivatives_3 derivatives(double i, double d) const
  {
    return m_energy.derivatives(i, d);
  }

private:
  CGAL::Spherical_parameterization::Symmetric_Dirichlet_energy_3 m_energy;
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_DISTORTION_ENERGY_H
