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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_EXPECTED_ERRORS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_EXPECTED_ERRORS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/choose_start.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

// The expected distance of the image of each vertex from the correct corresponding point.

namespace CGAL::Spherical_parameterization::internal {

// For each vertex, the mean over its faces of the squared gradient of all features together.
inline Vertex_scalars squared_slopes(const Surface_descriptor& surface)
{
  const std::vector<Vector_3d>& points = surface.points();
  Vertex_scalars sums(surface.size(), 0.), areas(surface.size(), 0.);
  for(const Linked_triangle& t : surface.sphere().triangles())
  {
    const Vector_3d u = points[t[1]] - points[t[0]], w = points[t[2]] - points[t[0]];
    const double uu = dot(u, u), uw = dot(u, w), ww = dot(w, w), squared_area = uu * ww - uw * uw,
                 area = std::sqrt(squared_area);
    if(!(area > 0.))
      continue;
    double sum = 0.;
    for(const Vertex_scalars& f : surface.features())
    {
      const double du = f[t[1]] - f[t[0]], dw = f[t[2]] - f[t[0]];
      sum += (ww * du * du - 2. * uw * du * dw + uu * dw * dw) / squared_area;
    }
    for(const std::uint32_t v : t.vertices)
    {
      sums[v] += area * sum;
      areas[v] += area;
    }
  }
  for(std::size_t v = 0; v < sums.size(); ++v)
    sums[v] = areas[v] > 0. ? sums[v] / areas[v] : 0.;
  return sums;
}

// Estimates the distances of the images of the vertices of the first surface from the correct corresponding points, divided by the square
// root of the area of the second surface, for features of the package; returns the mean over the first surface. The inputs are the
// agreement a; the distances m1 and m2 by which the image has moved since before and since after the guidance by eigenfunctions; and the
// difference f and the gradient g of the features at the image, smoothed over the surface. The estimate is
//
//   13.3 exp(-3.3 a) ((m1 + 0.003) (m2 + 0.003))^(1/4) f^(1/2) / (g + 1)^(1/3),
//
// a regression of the errors of 55 maps at known points, with rounded exponents. An alternative alignment that is nearly as good adds a
// fraction of the distance of its image. Distances are measured in space; they are slightly shorter than those along the surface.
inline double expected_errors(const Surface_pair& pair, const Surface_start& start,
                              const std::vector<Vector_3d>& directions, Vertex_scalars& errors)
{
  constexpr double factor = 13.3, of_agreement = -3.3, least_displacement = 0.003, least_slope = 1.;
  constexpr double decay_with_lag = 0.1, fraction_of_rival = 0.25;
  constexpr double max_error = 0.5; // the mean distance of two points of most surfaces
  constexpr double time_of_heat = 0.0025, tolerance = 1e-3, min_area = 1e-12; // diffusion over 0.05, two edges
  const Surface_descriptor &first = start.surfaces->first(), &second = start.surfaces->second();
  if(!(start.alignment.agreement > 0.)) // there is no information, for example on a regular tetrahedron
  {
    errors.assign(pair.first.points.size(), max_error);
    return max_error;
  }
  const std::vector<Linked_triangle>&triangles1 = pair.first.sphere.triangles(),
        &triangles2 = second.sphere().triangles();
  const std::size_t n = first.size();
  const auto locate = [&](const std::vector<Vector_3d>& images) {
    return second.sphere().locate(points_of(images), pair.execution);
  };
  std::vector<Vector_3d> images;
  for(const auto& location : pair.first.sphere.locate(points_of(first.directions()), pair.execution))
    images.push_back(interpolated(directions, triangles1, location));
  const auto locations = locate(images);
  const auto at_images = [&](const Vertex_scalars& values) {
    Vertex_scalars result;
    for(const auto& location : locations)
      result.push_back(interpolated(values, triangles2, location));
    return result;
  };
  const auto displacements_from = [&](const std::vector<Vector_3d>& coarse) {
    const auto others =
        locate(coarse.empty() ? rotated_directions(start.alignment.rotation, first.directions()) : coarse);
    Vertex_scalars result;
    for(std::size_t v = 0; v < n; ++v)
      result.push_back(length(interpolated(second.points(), triangles2, locations[v]) -
                              interpolated(second.points(), triangles2, others[v])));
    return result;
  };
  const Surface_diffusion diffusion(first.rings(), first.points(), min_area, pair.execution);
  const auto smoothed = [&](const Vertex_scalars& values) {
    Vertex_scalars result = diffusion.after(time_of_heat, values, tolerance);
    for(double& x : result)
      x = (std::max)(x, 0.); // removes negative rounding errors
    return result;
  };
  const auto smoothed_roots = [&](Vertex_scalars values) {
    for(double& x : values)
      x = std::sqrt((std::max)(x, 0.)); // removes negative rounding errors
    return smoothed(values);
  };

  Vertex_scalars squared_differences(n, 0.);
  for(std::size_t k = 0; k < first.features().size(); ++k)
  {
    const Vertex_scalars there = at_images(second.features()[k]);
    for(std::size_t v = 0; v < n; ++v)
      squared_differences[v] += (first.features()[k][v] - there[v]) * (first.features()[k][v] - there[v]);
  }
  const Vertex_scalars differences = smoothed_roots(squared_differences),
                       slopes = smoothed_roots(at_images(squared_slopes(second))),
                       before = smoothed(displacements_from(start.alignment.before_matching)),
                       since = smoothed(displacements_from(start.alignment.directions));
  Vertex_scalars by_rivals(n, 0.);
  for(const Surface_start::Rival& rival : start.rivals)
  {
    const Vertex_scalars ways = displacements_from(rival.directions);
    const double share = fraction_of_rival * exponential(-rival.lag / decay_with_lag);
    for(std::size_t v = 0; v < n; ++v)
      by_rivals[v] = (std::max)(by_rivals[v], share * ways[v]);
  }
  const double scale = factor * exponential(of_agreement * start.alignment.agreement);
  Vertex_scalars coarse_errors(n);
  double sum = 0., area = 0.;
  for(std::size_t v = 0; v < n; ++v)
  {
    const double way = std::sqrt((before[v] + least_displacement) * (since[v] + least_displacement));
    coarse_errors[v] = (std::min)(
        scale * std::sqrt(way * differences[v]) / cube_root(slopes[v] + least_slope) + by_rivals[v], max_error);
    if(!first.counts(v))
      continue;
    sum += first.areas()[v] * coarse_errors[v];
    area += first.areas()[v];
  }
  errors.clear();
  for(const auto& location : first.sphere().locate(pair.first.sphere.points(), pair.execution))
    errors.push_back(
        (std::min)(interpolated(coarse_errors, first.sphere().triangles(), location), max_error)); // rounding error
  return area > 0. ? sum / area : 0.;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_EXPECTED_ERRORS_H
