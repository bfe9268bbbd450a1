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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPRODUCIBILITY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPRODUCIBILITY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/library.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// names the results of this version of the package: versions of equal names give the same bits for the same input and settings,
/// wherever `is_reproducible()`. It is the digest of a table of results that the tests compare on all platforms.
constexpr const char* results_version = "0eedbd72";

/// \ingroup PkgSphericalParameterizationMethods
///
/// returns whether the package, as it is compiled here, has the results of every other machine, to the last bit: whether each
/// floating-point operation is rounded by itself, to the nearest number of 64 bits, as IEEE 754 has it. This is tried out. The page
/// \ref PkgSphericalParameterizationReproducibility tells what is promised, and what to do if this is
/// `false`, as with `-ffast-math`: maps are made and certified all the same.
///
/// It takes a few nanoseconds.
bool is_reproducible();

} // namespace CGAL::Spherical_parameterization

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/internal/numbers/reproducibility_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPRODUCIBILITY_H
