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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_DETERMINANT_BARRIER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_DETERMINANT_BARRIER_3_H

#include <CGAL/license/Spherical_parameterization.h>

/// \file Determinant_barrier_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationBarriers
///
/// The tag `Determinant_barrier_3` makes the energies measure the image of a face by the determinant of its corners on
/// the unit sphere: twice its flat area times the distance of its plane from the centre. This agrees with the flat area
/// for small faces, and is zero exactly where a face turns over. So the energy is infinite there, and no face comes to
/// lie across a great circle. It is the default of the package.
///
/// \sa `Flat_area_barrier_3`
struct Determinant_barrier_3
{};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_DETERMINANT_BARRIER_3_H
