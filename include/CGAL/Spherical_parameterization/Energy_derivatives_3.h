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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ENERGY_DERIVATIVES_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ENERGY_DERIVATIVES_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationEnergies
///
/// The class `Energy_derivatives_3` holds the value of the distortion energy of a triangle, with its first and second
/// derivatives in the two invariants of the triangle's map, \f$ I = \sigma_1^2 + \sigma_2^2 \f$ and
/// \f$ d = \sigma_1 \sigma_2 \f$. A model of `DistortionEnergy_3` returns it to Newton's method.
///
/// \tparam FT the number type: `double`, or a pack of several numbers that supports the four arithmetic operations but
///         not the functions of `<cmath>`; see `DistortionEnergy_3`
template <class FT = double>
struct Energy_derivatives_3
{
  FT value; ///< \f$ E \f$
  FT i;     ///< \f$ \partial E / \partial I \f$
  FT d;     ///< \f$ \partial E / \partial d \f$
  FT ii;    ///< \f$ \partial^2 E / \partial I^2 \f$
  FT id;    ///< \f$ \partial^2 E / \partial I \partial d \f$
  FT dd;    ///< \f$ \partial^2 E / \partial d^2 \f$
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ENERGY_DERIVATIVES_3_H
