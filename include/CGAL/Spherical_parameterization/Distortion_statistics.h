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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_STATISTICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_STATISTICS_H

#include <CGAL/license/Spherical_parameterization.h>

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The statistics of one measure of distortion over the faces of a mesh, each face counting the same whatever its area.
///
/// If the distortion of a face is infinite, all three numbers are. They are 0 if there is no face.
///
/// \sa `CGAL::Spherical_parameterization::Distortion_summary`
struct Distortion_statistics
{
  double maximum = 0.;   ///< the largest value
  double average = 0.;   ///< the arithmetic mean
  double deviation = 0.; ///< the standard deviation, the square root of the mean squared difference from the average
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_STATISTICS_H
