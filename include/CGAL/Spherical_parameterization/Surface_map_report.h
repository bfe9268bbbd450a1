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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAP_REPORT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAP_REPORT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <cstddef>
#include <vector>

/// \file Surface_map_report.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// What `map_surface()` has found.
struct Surface_map_report
{
  /// The symmetric Dirichlet energy of the map, measured on the common refinement: the mean of both directions. 2 is an
  /// isometry, up to scale.
  double energy = 0.;

  /// How well features agree after the spheres have been aligned, a correlation, at most 1; 0 if landmarks aligned them
  double agreement = 0.;

  /// How much better they agree than by the next best way to turn the spheres. Below 0.1 or so, the surface has a symmetry,
  /// or nearly, and the map may have exchanged its sides.
  double margin = 0.;

  /// For each landmark, how far its image is from where it should be, in the unit of length of the second surface; 0 if
  /// it is there but for rounding
  std::vector<double> landmark_distances;

  /// How many hard landmarks could not be met
  std::size_t number_of_missed_landmarks = 0;

  /// Whether `Surface_map_settings::go_further` has ended the sweeps
  bool is_stopped = false;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAP_REPORT_H
