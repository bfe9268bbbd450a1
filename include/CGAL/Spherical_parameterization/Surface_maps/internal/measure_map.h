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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_MEASURE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_MEASURE_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_pair.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/overlay_surfaces.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/refine_in_common.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/measuring/distortion.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The images of the edges of a triangle under the differential of a map to a surface. The corners of the triangle have directions a, and
// the differential is evaluated at q = w0 a0 + w1 a1 + w2 a2, because the map is projective.
//
// In the face with images b and corners Q, q is s (v0 b0 + v1 b1 + v2 b2) with coordinates v of sum 1, and is mapped to
// P = v0 Q0 + v1 Q1 + v2 Q2. A displacement d of q adds det(d, b1, b2) / det(b0, b1, b2), and so on, to s v. Hence the sum of these
// quotients times Q0 - P, and so on, is added to s P.
inline Triangle_edges image_edges(const std::array<Vector_3d, 3>& a, const std::array<double, 3>& w,
                                  const Sphere_mesh& sphere, const std::vector<Vector_3d>& points,
                                  Sphere_mesh::Hint& hint)
{
  const Vector_3d q = w[0] * a[0] + w[1] * a[1] + w[2] * a[2];
  const auto location = sphere.locate(point_of(q), hint);
  const Linked_triangle& t = sphere.triangles()[location.triangle];
  const std::array<Vector_3d, 3> b = sphere.corners(t);
  const Vector_3d p = interpolated(points, sphere.triangles(), location);
  const auto& v = location.coordinates;
  const double s = length(q) / length(v[0] * b[0] + v[1] * b[1] + v[2] * b[2]);
  const double determinant = s * dot(b[0], cross(b[1] - b[0], b[2] - b[0]));
  const auto image_of = [&](const Vector_3d& d) {
    Vector_3d result = {0., 0., 0.};
    for(std::size_t i = 0; i < 3; ++i)
      result = result + dot(d, cross(b[(i + 1) % 3], b[(i + 2) % 3])) / determinant * (points[t[i]] - p);
    return result;
  };
  return {image_of(a[2] - a[1]), image_of(a[0] - a[2]), image_of(a[1] - a[0])};
}

// Barycentric coordinates that are evenly distributed over a triangle: the centers of the n^2 parts that result if each edge is divided
// into n parts.
inline std::vector<std::array<double, 3>> samples_in_triangle(std::size_t n)
{
  std::vector<std::array<double, 3>> result;
  const auto add = [&](std::size_t x, std::size_t y) { // coordinates in thirds of a part
    const double u = static_cast<double>(x) / static_cast<double>(3 * n),
                 v = static_cast<double>(y) / static_cast<double>(3 * n);
    result.push_back({u, v, 1. - u - v});
  };
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; i + j < n; ++j)
    {
      add(3 * i + 1, 3 * j + 1);
      if(i + j + 1 < n)
        add(3 * i + 2, 3 * j + 2);
    }
  return result;
}

// The mean over the first surface of the symmetric Dirichlet energy of the map to the second one through their common sphere, with both
// scaled to the same area: 2 for an isometry. It is measured at samples in each face of the first surface, in the time of their point
// location, because the common refinement may have as many parts as the product of the sizes. Samples with zero or nearly zero area on
// one of the surfaces are excluded; the mean is infinite if none is left. The second sphere must have a grid. Returns 0 if the control
// stops the run.
inline double mean_energy_over_first(const Sphere_mesh& sphere1, const std::vector<Vector_3d>& points1,
                                     const Sphere_mesh& sphere2, const std::vector<Vector_3d>& points2,
                                     Run_control& control, const Execution& execution)
{
  constexpr std::size_t min_samples = 20000; // applies to surfaces with few faces
  constexpr std::size_t block_size = 256;    // large enough that the overhead of parallel execution is negligible
  const std::vector<Linked_triangle>& triangles = sphere1.triangles();
  const auto area = [](const Triangle_edges& edges) { return 0.5 * length(cross(edges[0], edges[1])); };
  std::array<double, 2> areas = {0., 0.};
  for(const Linked_triangle& t : triangles)
    areas[0] += area(scaled_edges(corners_of(t.vertices, points1), 1.));
  for(const Linked_triangle& t : sphere2.triangles())
    areas[1] += area(scaled_edges(corners_of(t.vertices, points2), 1.));
  const double scale = std::sqrt(areas[0] / areas[1]); // the scale of the second surface

  std::size_t n = 1;
  while(n * n * triangles.size() < min_samples)
    ++n;
  const std::vector<std::array<double, 3>> samples = samples_in_triangle(n);
  const double share = 1. / static_cast<double>(samples.size());
  std::vector<std::array<double, 2>> sums(triangles.size(), {0., 0.}); // sums of energies and weights
  const auto measure = [&](std::size_t begin, std::size_t end) {
    Sphere_mesh::Hint hint;
    for(std::size_t k = begin; k < end; ++k)
    {
      const Linked_triangle& t = triangles[k];
      const Triangle_edges edges = scaled_edges(corners_of(t.vertices, points1), 1.);
      const std::array<Vector_3d, 3> images = sphere1.corners(t);
      const double weight = share * area(edges);
      for(const auto& w : samples)
      {
        Triangle_edges image = image_edges(images, w, sphere2, points2, hint);
        for(Vector_3d& edge : image)
          edge = scale * edge;
        const Triangle_stretch stretch(edges, image);
        if(stretch.is_degenerate || !(weight > default_smallest_area * areas[0]) ||
           !(share * area(image) > default_smallest_area * areas[0]))
          continue;
        sums[k][0] += weight * 0.5 * stretch.angle * stretch.area; // (I / d) (d + 1 / d) / 2
        sums[k][1] += weight;
      }
    }
  };
  if(!for_each_block_until_stopped(control, execution, triangles.size(), block_size, measure))
    return 0.;
  double energy = 0., weight = 0.;
  for(const auto& [e, w] : sums)
  {
    energy += e;
    weight += w;
  }
  return weight > 0. ? energy / weight : std::numeric_limits<double>::infinity();
}

// The distance of the surface point in a direction from a vertex.
inline double distance_left(const Located_surface& surface, const Vector_3d& p, std::size_t w)
{
  Sphere_mesh::Hint hint;
  const auto location = surface.sphere.locate(point_of(p), hint);
  return std::ldexp(length(interpolated(surface.points, surface.sphere.triangles(), location) - surface.points[w]),
                    surface.exponent);
}

// The energy of a map between surfaces: the mean of both directions.
struct Map_energy
{
  std::optional<double> value; // none if the run has been stopped
  bool is_sampled = false;
  std::optional<Distortion_between> distortion; // none if the energy is sampled
};

// Measures the map with these directions of the vertices of the first surface on the sphere of the second one: on the common refinement,
// or by samples if the refinement would be too large. Returns false if the map is not bijective.
inline bool measure_map(const Surface_pair& pair, const std::vector<Vector_3d>& directions, Map_energy& energy)
{
  const std::vector<Vector_3d>&points1 = pair.first.points, &points2 = pair.second.points;
  const Sphere_mesh& sphere2 = pair.second.sphere;
  Sphere_mesh sphere1;
  sphere1.assign(points_of(directions), pair.first.sphere.triangles());
  if(!certify_bijectivity<Sphere_kernel>(sphere1.points(), sphere1.triangles(), pair.execution).is_bijective())
    return false;
  Overlay_arrays overlay;
  const Error_code error =
      refine_in_common(sphere1, points1, sphere2, points2, std::nullopt, overlay, pair.control, pair.execution);
  if(error == OK)
  {
    const Distortion_between measured =
        distortion_between(overlay.points, overlay.triangles, default_smallest_area, pair.execution);
    energy = {0.5 * (measured.energy.average_over_first + measured.energy.average_over_second), false, measured};
  }
  else if(error == ERROR_TOO_LARGE_OVERLAY)
  {
    sphere1.make_grid();
    const double there = mean_energy_over_first(sphere1, points1, sphere2, points2, pair.control, pair.execution),
                 back = mean_energy_over_first(sphere2, points2, sphere1, points1, pair.control, pair.execution);
    if(!pair.control.is_stopped())
      energy = {0.5 * (there + back), true, std::nullopt};
  }
  return error != ERROR_NO_1_TO_1_MAPPING;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_MEASURE_MAP_H
