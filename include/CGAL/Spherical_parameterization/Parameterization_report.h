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
/// Why a parameterizer has stopped.
enum Stop_reason
{
  NOT_RUN = 0,     ///< It has not run yet, or has refused the mesh or the map to start from.
  CONVERGED,       ///< What is optimized has settled.
  ITERATION_LIMIT, ///< The given number of sweeps has been made.
  OBSTRUCTED,      ///< Every further step would turn a face over or raise the energy.
  TIME_LIMIT,      ///< The given time was over.
  STOPPED,         ///< The visitor has asked for it.
  NON_FINITE_ENERGY ///< The energy of the map is not finite: the model of `DistortionEnergy_3` has returned infinity or NaN.
};

/// \ingroup PkgSphericalParameterizationEnums
///
/// returns a few English words for `reason`, a constant text.
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
/// What a parameterizer did in its last run. The energies are those of the method, per face for
/// `Bijective_low_distortion_parameterizer_3` and per area for those that make global steps; what a method does not
/// have is 0. To `Hierarchical_parameterizer_3` the mesh is but the finest of the levels: it has no energies, and all
/// its sweeps are those over levels.
struct Parameterization_report
{
  std::size_t number_of_vertices = 0;          ///< vertices that were mapped
  std::size_t number_of_faces = 0;             ///< faces of the mesh
  std::size_t number_of_isolated_vertices = 0; ///< vertices without a face, which were skipped
  std::size_t number_of_flat_faces = 0; ///< faces (nearly) without area, mapped as if they were a little less flat

  double radius = 0.;                 ///< radius of the sphere, in the unit of length of the mesh
  Stop_reason stop_reason = NOT_RUN;  ///< why the last phase ended
  std::size_t number_of_levels = 0;   ///< levels of the hierarchy
  std::size_t number_of_attempts = 0; ///< times that the hierarchy was mapped; above 1, the first attempts failed
  bool used_last_resort =
      false; ///< whether no attempt was successful: the first map is that of `Schnyder_parameterizer_3`
  std::size_t number_of_level_iterations = 0;   ///< sweeps over levels of the hierarchy
  std::size_t number_of_average_iterations = 0; ///< sweeps over the finest mesh with sharpness 0, or global steps
  std::size_t number_of_sharp_iterations = 0;   ///< sweeps over the finest mesh with a positive sharpness
  double sharpness = 0.;      ///< the \f$ s \f$ of the last sweep, \f$ b / R \f$ for a dial, see `Sharpness`
  double initial_energy = 0.; ///< average energy of the initial map
  double average_energy = 0.; ///< average energy of the map, NaN if it is not finite
  double largest_energy = 0.; ///< largest energy of a face, NaN if the average is

  double seconds_for_reading = 0.;      ///< checking and copying the mesh; starting threads
  double seconds_for_hierarchy = 0.;    ///< removing vertices down to a tetrahedron
  double seconds_for_embedding = 0.;    ///< inserting them again, and sweeps over coarse levels; or the initial map
  double seconds_for_optimization = 0.; ///< sweeps over the finest mesh, or global steps
  double seconds_for_certificate = 0.;  ///< writing the map and certifying it

  /// returns the number of sweeps over the finest mesh, or of global steps.
  std::size_t number_of_iterations() const { return number_of_average_iterations + number_of_sharp_iterations; }

  /// returns the time of all stages.
  double seconds() const
  {
    return seconds_for_reading + seconds_for_hierarchy + seconds_for_embedding + seconds_for_optimization +
           seconds_for_certificate;
  }
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZATION_REPORT_H
