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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FLAT_AREA_BARRIER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FLAT_AREA_BARRIER_3_H

#include <CGAL/license/Spherical_parameterization.h>

/// \file Flat_area_barrier_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationBarriers
///
/// The tag `Flat_area_barrier_3` makes the energies measure the image of a face by the area of the flat triangle.
///
/// So do eq. 4 and 5 of \cgalCite{cgal:whfl-bspld-16}. The flat area is positive where a face turns over, so that
/// nothing but the test of every step prevents that, and faces may get stuck across a great circle. It is here for
/// comparison.
///
/// \sa `Determinant_barrier_3`
struct Flat_area_barrier_3
{};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FLAT_AREA_BARRIER_3_H
