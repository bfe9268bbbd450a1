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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_MAP_SCORE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_MAP_SCORE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_sphere.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

// The terms of the score of a map between surfaces, on a level of the first one.

namespace CGAL::Spherical_parameterization::internal {

// The agreement of features: the correlation of values with mean 0, given the sums of their products.
inline double correlation(double ab, double aa, double bb)
{
  return aa > 0. && bb > 0. ? ab / std::sqrt(aa * bb) : 0.;
}

// The correlation over the first surface between its features and those of the corresponding points. Features may have weights.
inline double feature_agreement(const Feature_goals& features, const Mesh_hierarchy::Level& level,
                                const std::vector<Vector_3d>& directions, const std::vector<double>& weights = {})
{
  double ab = 0., aa = 0., bb = 0.;
  std::vector<double> b(features.image->number_of_channels());
  for(std::size_t i = 0; i < level.vertices.size(); ++i)
  {
    const std::uint32_t v = level.vertices[i];
    if(!features.mask.empty() && features.mask[v])
      continue;
    features.image->interpolate(directions[v], b.data());
    const double* values = features.values_of(v);
    for(std::size_t k = 0; k < b.size(); ++k)
    {
      const double weight = level.areas[i] * (weights.empty() ? 1. : weights[k]);
      ab += weight * values[k] * b[k];
      aa += weight * values[k] * values[k];
      bb += weight * b[k] * b[k];
    }
  }
  return correlation(ab, aa, bb);
}

// The mean over the first surface of the square root of the logarithm of half the symmetric Dirichlet energy, 0 for an isometry. The
// root is proportional to the deviation of a face from an isometry; the mean of the energy itself is dominated by its worst faces. The
// points belong to a surface of area 4 pi.
inline double stretching(const Target_metric& metric, const Mesh_hierarchy::Level& level, const Vertex_rings& rings,
                         const std::vector<Vector_3d>& points, const std::vector<Vector_3d>& directions)
{
  const std::size_t metric_level = metric.level_for(level.vertices.size());
  double sum = 0., area = 0.;
  rings.for_each_face([&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    const std::uint32_t a = level.vertices[i], b = level.vertices[j], c = level.vertices[k];
    const Vector_3d u = points[b] - points[a], w = points[c] - points[a];
    const Cube_location location = metric.locate(directions[a] + directions[b] + directions[c], metric_level);
    const Metric_sample<double> s = metric.at(location, metric_level);
    const auto p = location.flattened(directions[b] - directions[a]),
               q = location.flattened(directions[c] - directions[a]);
    const double uu = dot(u, u), uw = dot(u, w), ww = dot(w, w), pp = s.product(p, p), pq = s.product(p, q),
                 qq = s.product(q, q);
    const double squared_area = uu * ww - uw * uw, squared_image = pp * qq - pq * pq;
    if(!(squared_area > 0.) || !(squared_image > 0.))
      return;
    const double squared_norm = (pp * ww - 2. * pq * uw + qq * uu) / squared_area, face = std::sqrt(squared_area);
    sum += face * std::sqrt(logarithm((std::max)(0.25 * squared_norm * (1. + squared_area / squared_image), 1.)));
    area += face;
  });
  return area > 0. ? sum / area : 0.;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_MAP_SCORE_H
