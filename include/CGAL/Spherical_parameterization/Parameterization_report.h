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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZATION_REPORT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZATION_REPORT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <cstddef>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationEnums
///
/// List of the reasons for which a parameterizer stops.
enum Stop_reason
{
  NOT_RUN = 0,      ///< There was no run yet, or the mesh or the initial map was rejected.
  CONVERGED,        ///< The stopping criterion was met.
  ITERATION_LIMIT,  ///< The maximum number of sweeps was made.
  OBSTRUCTED,       ///< Every further step would invert a face or increase the energy.
  TIME_LIMIT,       ///< The time limit was exceeded.
  STOPPED,          ///< The visitor stopped the run.
  NON_FINITE_ENERGY ///< The energy of the map is not finite: the model of `DistortionEnergy_3` returned infinity or NaN.
};

/// \ingroup PkgSphericalParameterizationEnums
///
/// returns a short English description of `reason`, a constant string.
inline const char* get_stop_message(Stop_reason reason)
{
  switch(reason)
  {
  case NOT_RUN:
    return "not run";
  case CONVERGED:
    return "converged";
  case ITERATION_LIMIT:
    return "iteration limit";
  case OBSTRUCTED:
    return "no acceptable step left";
  case TIME_LIMIT:
    return "time limit";
  case STOPPED:
    return "stopped by the visitor";
  case NON_FINITE_ENERGY:
    return "the energy is not finite";
  }
  return "unknown";
}

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Parameterization_report` describes the last run of a parameterizer.
///
/// Energies are those of the method: means over faces for `Bijective_low_distortion_parameterizer_3`, and means over
/// the area for methods that move all vertices by global steps. Members that do not apply to a method are 0.
/// `Hierarchical_parameterizer_3` treats the mesh as the finest level: it reports no energies and counts all its sweeps
/// as sweeps over levels.
struct Parameterization_report
{
  std::size_t number_of_vertices = 0;          ///< number of vertices that were mapped
  std::size_t number_of_faces = 0;             ///< number of faces of the mesh
  std::size_t number_of_isolated_vertices = 0; ///< number of vertices without a face, which were skipped
  std::size_t number_of_flat_faces = 0;        ///< number of (nearly) degenerate faces, mapped as if slightly less flat

  double radius = 0.;                 ///< radius of the sphere, in the unit of length of the mesh
  Stop_reason stop_reason = NOT_RUN;  ///< reason for which the last phase ended
  std::size_t number_of_levels = 0;   ///< number of levels of the hierarchy
  std::size_t number_of_attempts = 0; ///< number of attempts to map the hierarchy; above 1, the first attempts failed
  bool used_last_resort =
      false; ///< whether all attempts failed, so that the initial map is that of `Schnyder_parameterizer_3`
  std::size_t number_of_level_iterations = 0;   ///< number of sweeps over levels of the hierarchy
  std::size_t number_of_average_iterations = 0; ///< sweeps over the mesh itself with sharpness 0, or global steps
  std::size_t number_of_sharp_iterations = 0;   ///< sweeps over the mesh itself with positive sharpness
  double sharpness = 0.; ///< the \f$ s \f$ of the last sweep, \f$ b / R \f$ for a relative sharpness, see `Sharpness`
  double initial_energy = 0.; ///< average energy of the initial map
  double average_energy = 0.; ///< average energy of the final map, NaN if it is not finite
  double largest_energy = 0.; ///< largest energy of a face of the final map, NaN if the average is

  double seconds_for_reading = 0.;   ///< time for checking and copying the mesh and starting threads
  double seconds_for_hierarchy = 0.; ///< time for removing vertices until a tetrahedron is left
  double seconds_for_embedding = 0.; ///< time for vertex insertion with all sweeps over levels, or for the initial map
  double seconds_for_optimization = 0.; ///< time for sweeps over the mesh itself, or for global steps
  double seconds_for_certificate = 0.;  ///< time for writing and certifying the map

  /// returns the number of sweeps over the mesh itself, or of global steps.
  std::size_t number_of_iterations() const { return number_of_average_iterations + number_of_sharp_iterations; }

  /// returns the total time of all stages.
  double seconds() const
  {
    return seconds_for_reading + seconds_for_hierarchy + seconds_for_embedding + seconds_for_optimization +
           seconds_for_certificate;
  }
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZATION_REPORT_H
