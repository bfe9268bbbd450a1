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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_ENERGY_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_ENERGY_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationEnergies
///
/// The class `Conformal_energy_3` is the angle distortion
/// \f$ E = I / d = \sigma_1 / \sigma_2 + \sigma_2 / \sigma_1 \f$.
///
/// This is eq. 2 of \cgalCite{cgal:whfl-bspld-16} with \f$ \alpha = 1 \f$. The energy is at least 2, with equality for
/// a similarity. It does not depend on the radius, so it is usually combined with `Fixed_radius_3`.
///
/// \cgalModels{DistortionEnergy_3}
///
/// \sa `Isometric_energy_3`
class Conformal_energy_3 : public Isometric_energy_3
{
public:
  /// constructs the energy.
  Conformal_energy_3()
    : Isometric_energy_3(1.)
  {}
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_ENERGY_3_H
