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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_DISTANCE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_DISTANCE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <algorithm>
#include <cmath>

/// \file Surface_distance.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The distances between two surfaces, in the unit of their coordinates: what `measure_distance()` returns.
struct Surface_distance
{
  /// Distances from places of one surface to the nearest places of the other one
  struct One_way
  {
    double root_mean_square = 0.; ///< Root of the mean of their squares
    double maximum = 0.;          ///< The largest one
  };

  One_way from_first;   ///< From the first surface to the second one
  One_way from_second;  ///< From the second surface to the first one
  double diagonal = 0.; ///< Length of the diagonal of the bounding box of the first surface

  /// returns the peak signal-to-noise ratio in decibels: twenty decadic logarithms of the diagonal over the larger one of
  /// the two root mean squares. It is infinite if these are 0.
  double psnr() const
  {
    return 20. * std::log10(diagonal / (std::max)(from_first.root_mean_square, from_second.root_mean_square));
  }
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_DISTANCE_H
