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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_SULCAL_MEASURES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_SULCAL_MEASURES_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Cortex/compute_sulcal_measures.h>
#include <CGAL/Spherical_parameterization/Cortex/fit_rotation_to_surface.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface_diffusion.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/surface/vertex_scalars.h>

#include <CGAL/number_type_config.h>

#include <numeric>
#include <optional>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Sulcal_measures sulcal_measures_of(const Surface& surface,
                                                                          unsigned int selection,
                                                                          const Execution& execution)
{
  const Vertex_rings& rings = surface.rings();
  const std::vector<Vector_3d>& points = surface.points();
  constexpr double area = 4. * CGAL_PI, min_area = 1e-12;
  // Shorter times retain the noise of segmented images; longer times remove the smaller sulci and gyri. The unit is the
  // area.
  constexpr double time_of_curvature = 1.5e-5 * area, time_of_depth = 1e-3 * area, time_of_inflated = 4e-5 * area;
  constexpr std::size_t n_steps = 10; // Larger steps yield smaller displacements in deep sulci.
  constexpr double tolerance = 1e-3;  // a thousandth of the deviation of the measures
  const double unit = surface.equal_area_radius();
  const auto curvature = [&](Vertex_scalars ways, double t) {
    for(double& x : ways)
      x = 1. / unit * (x / (-2. * t));
    return surface.in_callers_order(ways);
  };
  const Surface_diffusion diffusion(rings, points, min_area, execution);
  Sulcal_measures result;
  if(selection & Sulcal_measures::CURVATURE)
    result.curvature =
        curvature(diffusion.outside(points, diffusion.after(time_of_curvature, points, tolerance)), time_of_curvature);
  if(!(selection & (Sulcal_measures::DEPTH | Sulcal_measures::INFLATED_CURVATURE)))
    return result;
  result.depth.assign(points.size(), 0.);
  std::vector<Vector_3d> inflated = points;
  for(std::size_t k = 0; k < n_steps; ++k)
  {
    std::vector<Vector_3d> next = diffusion.after(time_of_depth / static_cast<double>(n_steps), inflated, tolerance);
    const Vertex_scalars ways = diffusion.outside(inflated, next);
    for(std::size_t v = 0; v < points.size(); ++v)
      result.depth[v] -= ways[v];
    inflated.swap(next);
  }
  if(selection & Sulcal_measures::INFLATED_CURVATURE)
    result.inflated_curvature =
        curvature(mean_curvature(rings, inflated, time_of_inflated, min_area, execution), time_of_inflated);
  if(!(selection & Sulcal_measures::DEPTH))
  {
    result.depth.clear();
    return result;
  }
  const Vertex_scalars areas = vertex_areas(rings, points);
  const double mean = inner_product(areas, result.depth) / std::accumulate(areas.begin(), areas.end(), 0.);
  for(double& x : result.depth)
    x = unit * (x - mean);
  result.depth = surface.in_callers_order(result.depth);
  return result;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code
fit_rotation_to_surface(const Surface& surface, const std::vector<Vector_3d>& images,
                        Aff_transformation_3<Exact_predicates_inexact_constructions_kernel>& rotation)
{
  const std::vector<Vector_3d>& points = surface.points();
  const std::vector<double> masses = vertex_masses(surface.rings(), points);
  const Vector_3d center = center_of_mass(points, masses);
  const double average = std::accumulate(masses.begin(), masses.end(), 0.) / static_cast<double>(masses.size());
  std::vector<std::pair<Vector_3d, Vector_3d>> directions;
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    const Vector_3d offset = points[v] - center;
    const double distance = length(offset);
    if(distance > 0.)
      directions.emplace_back(images[v], (masses[v] / average / distance) * offset);
  }
  const std::optional<Rotation_matrix> matrix = fitting_rotation(directions);
  if(!matrix)
    return ERROR_UNDETERMINED_ROTATION;
  rotation = as_transformation(*matrix);
  return OK;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_SULCAL_MEASURES_IMPL_H
