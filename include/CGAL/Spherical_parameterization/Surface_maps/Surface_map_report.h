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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SURFACE_MAP_REPORT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SURFACE_MAP_REPORT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Distortion_between.h>

#include <cstddef>
#include <optional>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// What `map_surface()` has found.
struct Surface_map_report
{
  /// The symmetric Dirichlet energy of the map, measured on the common refinement: the mean of both directions. 2 is an
  /// isometry, up to scale; infinite if a surface has no area; 0 if it has not been measured: the run had been stopped, or
  /// doubles could hold the start alone.
  double energy = 0.;

  /// The distortion of the map, as `measure_distortion_between()` has it; none if the energy has not been measured, or by samples
  std::optional<Distortion_between> distortion;

  /// Whether it has been measured at samples in each face instead, as the refinement has more vertices than `overlay()`
  /// makes by default. That misses a part of the energy near vertices: 5 to 15 percent of all where both were measured.
  bool is_energy_sampled = false;

  /// How well features agree after the surfaces have been aligned on coarse levels, a correlation, at most 1; 0 if landmarks
  /// alone rotated the spheres, as features did not agree
  double agreement = 0.;

  /// How much better the alignment is than the next best one that differs from it: those that are nearly as good on coarse surfaces are
  /// compared on a finer level, in agreement less 0.15 times how much is stretched, the mean root of the logarithm of half the symmetric
  /// Dirichlet energy. At least 0.15 if no other one came that near
  double margin = 0.;

  /// How far the images of vertices are expected to be from where they should be, over the root of the area of the second surface, in
  /// the mean over the first one; `Surface_mapper_3::get_expected_errors()` has that of each vertex. It is estimated from how far
  /// features differ, over how fast they change on the surface; how far images have moved during the descent; how well the surfaces
  /// agree; and how far away images are by other alignments that are nearly as good. There is none for features of a caller, if
  /// landmarks alone rotated the spheres, if the alignment is kept, or if it was stopped
  std::optional<double> expected_error;

  /// Whether the alignment is ambiguous, so that the map may be a half-turn off: the expected error is above 0.105. For features of a
  /// caller: they agree by less than 0.73, or the margin is below 0.1. So it is if the alignment was stopped, or doubles could not hold
  /// coarse surfaces. Look at the map, or give landmarks. It is never so if landmarks alone rotated the spheres, or the alignment is kept
  bool is_uncertain = false;

  /// For each landmark, how far its image is from where it should be, in the unit of length of the second surface; 0 if
  /// it is there but for rounding
  std::vector<double> landmark_distances;

  /// How many hard landmarks could not be met
  std::size_t number_of_missed_landmarks = 0;

  /// Why the last level was left: `CONVERGED`, also for surfaces that agree as they are; `ITERATION_LIMIT`; `STOPPED` or
  /// `TIME_LIMIT`; `OBSTRUCTED` if doubles could not hold the descent, so that the map is the one from which it started
  Stop_reason stop_reason = NOT_RUN;

  std::size_t number_of_sweeps = 0;  ///< over levels of the first surface
  double seconds_for_reading = 0.;   ///< to read both surfaces, and to certify their maps
  double seconds_for_alignment = 0.; ///< to align the surfaces
  double seconds_for_descent = 0.;   ///< to lower the energy
  double seconds_for_overlay = 0.;   ///< to measure it, as a rule on the common refinement
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SURFACE_MAP_REPORT_H
