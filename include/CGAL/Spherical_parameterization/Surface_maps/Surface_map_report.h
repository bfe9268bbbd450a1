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
/// The class `Surface_map_report` contains the results of `map_surface()`.
struct Surface_map_report
{
  /// The symmetric Dirichlet energy of the map, measured on the common refinement: the mean of both directions. It is 2 for
  /// an isometry up to scale. It is infinite if a surface has no area. It is 0 if it has not been measured, because the run
  /// was stopped or because double precision suffices for a rotation only.
  double energy = 0.;

  /// The distortion of the map as measured by `measure_distortion_between()`; none if the energy has not been measured, or
  /// has been measured by samples
  std::optional<Distortion_between> distortion;

  /// Whether the energy was measured at samples in each face, because the common refinement exceeds the default bound of
  /// `overlay()`. Samples miss a part of the energy near vertices: 5 to 15 percent of the total where both were measured.
  bool is_energy_sampled = false;

  /// The correlation of the features after the surfaces have been aligned on coarse levels, at most 1. It is 0 if the
  /// rotation was determined by landmarks alone, because the features did not agree or because it misses fewer landmarks, or
  /// if the alignment was kept; the margin is then 0 as well.
  double agreement = 0.;

  /// The difference between the scores of the chosen alignment and of the best alternative, at most 0.15. The value 0.15
  /// means that no alternative is closer. Alternatives that are nearly as good on coarse surfaces are compared on a finer
  /// level. There, the score is the agreement of the features minus the mean distance from the landmarks. Of the features of
  /// the package, the mean curvatures at the two finest scales count ten times as much as the others.
  double margin = 0.;

  /// The expected distance between the images of vertices and the correct corresponding points, divided by the square root
  /// of the area of the second surface: the mean over the first surface. `Surface_mapper_3::get_expected_errors()` writes the
  /// value of each vertex. There is no estimate if the caller has provided features, if the rotation was determined by
  /// landmarks alone, if the alignment was kept, or if the alignment was stopped. For the form of the estimate, see
  /// \ref PkgSphericalParameterizationHowItWorks.
  std::optional<double> expected_error;

  /// Whether the alignment is ambiguous, so that the map may be off by a half-turn. This holds if the expected error is above
  /// 0.105. For features of the caller, it holds if their agreement is below 0.73 or the margin is below 0.1. It also holds if
  /// the alignment was stopped, or if the coarse surfaces cannot be represented in double precision. Inspect the map in this
  /// case, or provide landmarks. The value is `false` if the rotation was determined by landmarks alone, or if the alignment
  /// was kept.
  bool is_uncertain = false;

  /// For each landmark, the distance between its image and the corresponding vertex, in the unit of length of the second
  /// surface; 0 if the landmark is met up to rounding error
  std::vector<double> landmark_distances;

  /// The number of hard landmarks that are not met
  std::size_t number_of_missed_landmarks = 0;

  /// The reason why the descent on the last level ended: `CONVERGED`, also for copies, which are only rotated;
  /// `ITERATION_LIMIT`; `STOPPED`; `TIME_LIMIT`; or `OBSTRUCTED` if double precision does not suffice for the descent, so that
  /// the map is a rotation
  Stop_reason stop_reason = NOT_RUN;

  std::size_t number_of_sweeps = 0;  ///< The number of sweeps over levels of the first surface
  double seconds_for_reading = 0.;   ///< The time for reading both surfaces and certifying their maps
  double seconds_for_alignment = 0.; ///< The time for aligning the surfaces, and for measuring the energy of a rotation
  double seconds_for_descent = 0.;   ///< The time for minimizing the energy
  double seconds_for_overlay = 0.;   ///< The time for measuring the energy, usually on the common refinement
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SURFACE_MAP_REPORT_H
