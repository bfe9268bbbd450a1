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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_SETTINGS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_SETTINGS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>

#include <cstddef>
#include <optional>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The stopping criterion of the loop, and whether the method has the extensions to the paper.
struct Descent_settings
{
  // The run has converged if two sweeps, with the smooth step before one of them, change the energy and the radius by
  // at most these tolerances, relative; without acceleration, one sweep.
  double energy_tolerance = 1e-3, radius_tolerance = 2e-3;
  // If true, there are smooth steps and extra sweeps around the worst faces, a radius policy is followed by half steps,
  // and convergence requires more than that of the sum of eq. 6 or 7.
  bool is_accelerated = true;
};

// Sweeps over a mesh below this size cost little, so the number of sweeps increases in inverse proportion to the size.
// Smaller levels of a hierarchy are swept until they converge, and have no descents.
constexpr std::size_t size_of_small_meshes = 2000;

// Sweeps over a level of a hierarchy that is not small. They improve the map after vertex insertion; more sweeps hardly
// change the result of the descent over the mesh.
constexpr std::size_t default_sweeps_per_level = 5;

// How the levels of a hierarchy are swept.
struct Level_settings
{
  std::size_t sweeps_per_level = default_sweeps_per_level;
  bool sweeps_finest_level = false;
  // If given, and if it is relative, the objective with this sharpness is also minimized on some of the levels, with
  // tolerances of at least twice the defaults, see Hierarchical_embedding.
  std::optional<Sharpness> sharpness;
  Descent_settings descent;
};

// Enough sweeps for most meshes to converge.
inline std::size_t default_number_of_sweeps(std::size_t n_vertices)
{
  return 250 * (1 + size_of_small_meshes / (n_vertices + 1));
}

// The radius policy of a run, see SphereRadiusPolicy_3, called once per sweep. Radii are in the caller's unit of
// length.
class Radius_chooser
{
public:
  virtual ~Radius_chooser() = default;
  virtual double initial_radius(double equal_area_radius) const = 0;
  virtual double next_radius(const Face_range_3& faces, double radius) = 0;
  virtual bool next_phase() = 0;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_DESCENT_SETTINGS_H
