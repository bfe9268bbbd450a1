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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_DISTORTION_BETWEEN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_DISTORTION_BETWEEN_H

#include <CGAL/license/Spherical_parameterization.h>

#include <cstddef>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// The class `Distortion_between` contains the distortion of a map between two surfaces, both scaled to the same area.
///
/// \f$ s_1 \leq s_2 \f$ are the singular values of the linear part of the map in a triangle of the common refinement. Each
/// measure has the same value for the map and for its inverse. The averages are weighted with areas, so they depend on
/// the surface on which areas are measured.
struct Distortion_between
{
  /// The statistics of one measure
  struct Statistics
  {
    double maximum = 0.;             ///< The maximum
    double average_over_first = 0.;  ///< The mean weighted with areas on the first surface
    double average_over_second = 0.; ///< The mean weighted with areas on the second surface
  };

  Statistics isometric; ///< \f$ \max(s_2, 1 / s_1) \f$
  Statistics area;      ///< \f$ s_1 s_2 + 1 / (s_1 s_2) \f$
  Statistics angle;     ///< \f$ s_1 / s_2 + s_2 / s_1 \f$
  Statistics energy;    ///< \f$ ( s_1^2 + s_2^2 + 1 / s_1^2 + 1 / s_2^2 ) / 2 \f$, the symmetric Dirichlet energy

  std::size_t number_of_triangles = 0; ///< The number of triangles of the refinement
  std::size_t number_of_slivers = 0;   ///< The number of triangles that are excluded because they are too small
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_DISTORTION_BETWEEN_H
