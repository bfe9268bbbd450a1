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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_DESCENT_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_DESCENT_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Conformal_energy_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/descent/Descent_loop.h>
#include <CGAL/Spherical_parameterization/internal/descent/Hierarchical_embedding.h>
#include <CGAL/Spherical_parameterization/internal/descent/Vertex_step.h>
#include <CGAL/Spherical_parameterization/internal/run/first_map.h>
#include <CGAL/Spherical_parameterization/internal/run/run_descent.h>
#include <CGAL/Spherical_parameterization/internal/surface/Run.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <cstddef>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

template <class Energy>
void embed_surface(const Energy& energy, const Level_settings& settings, Run& run, const std::vector<double>& shares)
{
  run.control.on_initialization_begin(run.surface.number_of_vertices());
  if(!embed_hierarchically(run.surface, energy, settings, run.positions, run.control, run.execution, shares))
  {
    draw_surface(run);
    run.control.report().used_last_resort = true;
    run.control.report().stop_reason = OBSTRUCTED;
  }
  run.control.on_initialization_end();
}

template <class Step, class Energy>
void descend(const Energy& energy, Radius_chooser* radius, const Sharpness& sharpness, const Descent_settings& settings,
             std::size_t max_sweeps, Run& run, const std::vector<double>& shares)
{
  Parameterization_report& report = run.control.report();
  const bool can_be_swept = !report.used_last_resort || are_safely_positive(run.surface.rings(), run.positions);
  const Surface& surface = run.surface;
  const Vertex_rings& rings = surface.rings();
  const std::vector<Vector_3d>& points = surface.points();
  std::vector<double> densities;
  if(!shares.empty())
    densities = vertex_densities(rings, points, shares);
  else if constexpr(follows_curvature<Energy>)
    densities = vertex_densities(rings, points, curvature_masses(rings, points));
  using Space = Round_sphere<Energy, Step>;
  Block_coordinate_descent<Space, Step> descent(Space(Face_energy<Energy>(energy)), Step(), run.execution);
  descent.assign(rings, Independent_sets(rings), points, densities, Rest_limits());
  Descent_loop<Energy, Step> loop(descent, surface.unit(), sharpness, radius, settings, run.control, run.execution);
  run.radius = loop.run(run.positions, can_be_swept ? max_sweeps : 0);
  if(!can_be_swept && report.stop_reason == ITERATION_LIMIT)
    report.stop_reason = OBSTRUCTED;
}

// The library, in src/, defines the descents for the energies of the package. Descents for other energies are compiled
// where they are called.

#define CGAL_SPHERICAL_PARAMETERIZATION_DESCENT(EXTERN, Energy, Step)                                                  \
  EXTERN template void descend<Step>(const Energy&, Radius_chooser*, const Sharpness&, const Descent_settings&,        \
                                     std::size_t, Run&, const std::vector<double>&);

#define CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(EXTERN, Energy)                                                    \
  EXTERN template void embed_surface(const Energy&, const Level_settings&, Run&, const std::vector<double>&);          \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENT(EXTERN, Energy, Newton_step)

#define CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS(EXTERN)                                                               \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(EXTERN, Symmetric_Dirichlet_energy_3)                                    \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(EXTERN, Isometric_energy_3)                                              \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(EXTERN, Conformal_energy_3)                                              \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(EXTERN, Stretch_energy_3)                                                \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENT(EXTERN, Isometric_energy_3, Gradient_step)

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_USE_LIBRARY
CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS(extern)
#endif

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_DESCENT_IMPL_H
