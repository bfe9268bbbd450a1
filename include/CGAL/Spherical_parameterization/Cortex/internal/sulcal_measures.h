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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_SULCAL_MEASURES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_SULCAL_MEASURES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface_diffusion.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/surface/vertex_scalars.h>

#include <CGAL/number_type_config.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// What compute_sulcal_measures() measures, see there.
struct Sulcal_scalars
{
  Vertex_scalars curvature, depth, inflated_curvature;
};

// That of a surface of area 4 pi.
inline Sulcal_scalars sulcal_measures_of(const Vertex_rings& rings, const std::vector<Vector_3d>& points,
                                         const Execution& execution)
{
  constexpr double area = 4. * CGAL_PI, min_area = 1e-12;
  // Shorter times leave the noise of segmented images; longer ones take the smaller folds away. All of them in units of the area.
  constexpr double time_of_curvature = 1.5e-5 * area, time_of_depth = 1e-3 * area, time_of_inflated = 4e-5 * area;
  constexpr std::size_t n_steps = 10; // Large steps go less far in deep sulci.
  constexpr double tolerance = 1e-3;  // a thousandth of the deviation of the measures
  const auto curvature = [](Vertex_scalars ways, double t) {
    for(double& x : ways)
      x /= -2. * t;
    return ways;
  };
  const Surface_diffusion diffusion(rings, points, min_area, execution);
  Sulcal_scalars result;
  result.curvature =
      curvature(diffusion.outside(points, diffusion.after(time_of_curvature, points, tolerance)), time_of_curvature);
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
  const Vertex_scalars areas = vertex_areas(rings, points);
  const double mean = std::inner_product(areas.begin(), areas.end(), result.depth.begin(), 0.) /
                      std::accumulate(areas.begin(), areas.end(), 0.);
  for(double& x : result.depth)
    x -= mean;
  result.inflated_curvature =
      curvature(mean_curvature(rings, inflated, time_of_inflated, min_area, execution), time_of_inflated);
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_SULCAL_MEASURES_H
