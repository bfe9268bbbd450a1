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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FACE_INVARIANTS_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FACE_INVARIANTS_3_H

#include <CGAL/license/Spherical_parameterization.h>

/// \file Face_invariants_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationEnergies
///
/// What a radius policy gets to know of one face: its area on the surface and the two invariants of its map onto the
/// sphere of the current radius. They follow a change of the radius: multiplying it by \f$ \rho \f$ multiplies `i`, `d`
/// and `flat_d` by \f$ \rho^2 \f$. A face that is (nearly) flat counts as if it were a little less so.
///
/// \sa `Face_range_3`
struct Face_invariants_3
{
  double area;   ///< \f$ A \f$, the area of the face on the surface, in a unit in which that of the surface is 4 pi
  double i;      ///< \f$ I = \sigma_1^2 + \sigma_2^2 \f$ of the map onto the flat image triangle
  double d;      ///< what the energy sees: \f$ \det(u_0, u_1, u_2) / (2 A r) \f$; the published method: `flat_d`
  double flat_d; ///< \f$ \sigma_1 \sigma_2 = a / A \f$ of the map onto the flat image triangle, whose area is \f$ a \f$
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FACE_INVARIANTS_3_H
