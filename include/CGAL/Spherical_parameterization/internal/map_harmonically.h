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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MAP_HARMONICALLY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MAP_HARMONICALLY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/Guarantee.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Spherical_harmonic_map.h>
#include <CGAL/Spherical_parameterization/internal/Stereographic_embedding.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/cotangent_weights.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Maps a mesh to the unit sphere with the least harmonic energy, starting through the plane. If the map has to be
// one-to-one, it is so all the way, and the weights of the edges are positive; if not, the weights are the cotangents
// as they are.
template <class SolverTraits, class ConcurrencyTag, class RunControl>
Error_code map_harmonically(const Indexed_mesh& mesh, Guarantee guarantee, std::size_t most_iterations,
                            std::vector<Vector_3d>& positions, RunControl& control)
{
  control.visitor().on_initialization_begin(mesh.number_of_vertices());
  Stereographic_embedding<SolverTraits> embedding(mesh);
  if(!embedding.solve())
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  if(!embedding.project_bijectively(positions))
  {
    if(guarantee == Guarantee::ONE_TO_ONE)
      return ERROR_INSUFFICIENT_PRECISION;
    embedding.project(positions);
  }
  control.report().seconds_for_embedding = control.lap();
  control.visitor().on_initialization_end();

  const bool is_guarded = guarantee == Guarantee::ONE_TO_ONE;
  const std::vector<double> weights = cotangent_weights(
      mesh.rings(), mesh.points(), is_guarded ? least_positive_weight : std::numeric_limits<double>::lowest());
  Spherical_harmonic_map<SolverTraits, ConcurrencyTag> map(mesh, weights, is_guarded);
  if(!map.run(positions, most_iterations, control))
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  control.report().seconds_for_optimization = control.lap();
  control.visitor().on_optimization_end();
  return OK;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MAP_HARMONICALLY_H
