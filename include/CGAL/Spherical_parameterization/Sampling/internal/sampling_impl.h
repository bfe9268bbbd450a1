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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_SAMPLING_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_SAMPLING_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Sampling/Sphere_resampler_3.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Subdivided_solid.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Interpolation_weights.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Triangle_set.h>
#include <CGAL/Spherical_parameterization/Sampling/measure_distance.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Sphere_domain_3 Sphere_domain_3::regular(std::size_t n_faces, std::uint32_t n)
{
  Sphere_domain_3 result;
  const auto take = [&](auto solid) {
    result.m_triangles = std::move(solid.triangles);
    result.m_directions.reserve(solid.directions.size());
    for(const internal::Vector_3d& p : solid.directions)
      result.m_directions.emplace_back(p[0], p[1], p[2]);
  };
  if(n == 0 || n > max_subdivision)
    return result;
  if(n_faces == 6)
    take(internal::subdivided_cube(n));
  else
    take(n_faces == 8 ? internal::subdivided_octahedron(n) : internal::subdivided_icosahedron(n));
  return result;
}

namespace internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code measure_distance(std::vector<Vector_3d> corners, std::size_t n_first,
                                                                   const std::array<std::size_t, 2>& n_samples,
                                                                   Surface_distance& distance, Run_control& control,
                                                                   const Execution& execution)
{
  const int exponent = normalize(corners);
  const Triangle_set first(corners.data(), n_first), second(corners.data() + n_first, corners.size() - n_first);
  const auto one_way = [&](const Triangle_set& from, const Triangle_set& to, std::size_t n) {
    constexpr std::size_t block_size = 256; // large enough that the overhead of parallel execution is negligible
    std::vector<double> squares(n);
    for_each_block_until_stopped(control, execution, n, block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
        squares[k] = to.squared_distance_to(from.place(k, n));
    });
    const double mean = std::accumulate(squares.begin(), squares.end(), 0.) / static_cast<double>(n),
                 max = *std::max_element(squares.begin(), squares.end());
    return Surface_distance::One_way{std::scalbn(std::sqrt(mean), exponent), std::scalbn(std::sqrt(max), exponent)};
  };
  const Surface_distance result = {one_way(first, second, n_samples[0]), one_way(second, first, n_samples[1]),
                                   std::scalbn(first.diagonal(), exponent)};
  if(control.is_stopped())
    return ERROR_STOPPED;
  distance = result;
  return OK;
}

using Resampled_sphere = Sphere_triangulation<Exact_predicates_inexact_constructions_kernel>;

// The barycentric weights of the vertices of `of` in `in`: the corners of triangles with positive coordinates.
inline Interpolation_weights barycentric_weights(const Resampled_sphere& of, const Resampled_sphere& in)
{
  const auto places = locations_of_vertices(of, in);
  return Interpolation_weights(places.size(), [&](const auto& add) {
    for(std::size_t k = 0; k < places.size(); ++k)
      for(std::size_t i = 0; i < 3; ++i)
        if(const double weight = places[k].coordinates[i]; weight > 0.)
          add(k, Weighted_source{in.triangles()[places[k].triangle][i], weight});
  });
}

inline bool are_areas(const std::vector<double>& areas, std::size_t n)
{
  return areas.size() == n && std::all_of(areas.begin(), areas.end(), [](double x) { return x >= 0. && is_finite(x); });
}

inline Error_code read_sphere(const std::vector<Vector_3d>& points, const Index_triangles& triangles,
                              Resampled_sphere& result, const Execution& execution)
{
  constexpr std::size_t max = (std::numeric_limits<std::uint32_t>::max)() / 6;
  if(triangles.empty())
    return ERROR_EMPTY_MESH;
  if(points.size() >= max || triangles.size() >= max)
    return ERROR_TOO_LARGE_MESH;
  for(const auto& t : triangles)
    for(const std::uint32_t v : t)
    {
      if(v >= points.size())
        return ERROR_WRONG_PARAMETER;
      if(!is_finite(points[v]))
        return ERROR_NON_FINITE_COORDINATE;
    }
  std::vector<Linked_triangle> linked = link_triangles(triangles, points.size());
  if(linked.empty())
    return ERROR_NON_CLOSED_MESH;
  if(!are_bijective(triangles, points, execution))
    return ERROR_NO_1_TO_1_MAPPING;
  std::vector<Resampled_sphere::Point_3> images;
  images.reserve(points.size());
  for(const Vector_3d& p : points)
    images.emplace_back(p[0], p[1], p[2]);
  result.assign(std::move(images), std::move(linked));
  return OK;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code check_sphere(const std::vector<Vector_3d>& points,
                                                               const Index_triangles& triangles,
                                                               const Execution& execution)
{
  Resampled_sphere sphere;
  return read_sphere(points, triangles, sphere, execution);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code
connect_spheres(const Resampling_settings& settings, const std::vector<Vector_3d>& source,
                const Index_triangles& source_triangles, const std::vector<Vector_3d>& target,
                const Index_triangles& target_triangles, Interpolation_weights& weights, const Execution& execution)
{
  const auto& [method, source_areas, target_areas, mask] = settings;
  const bool is_adaptive = method == Resampling_method::adaptive || method == Resampling_method::largest;
  if((!mask.empty() && mask.size() != source.size()) ||
     (is_adaptive && !(are_areas(source_areas, source.size()) && are_areas(target_areas, target.size()))))
    return ERROR_WRONG_PARAMETER;
  Resampled_sphere from, to;
  if(const Error_code error = read_sphere(source, source_triangles, from, execution))
    return error;
  if(const Error_code error = read_sphere(target, target_triangles, to, execution))
    return error;
  Interpolation_weights interpolated, distributed;
  run_both(
      execution,
      [&] {
        if(is_adaptive)
          distributed = barycentric_weights(from, to);
      },
      [&] { interpolated = barycentric_weights(to, from); });
  if(is_adaptive)
    interpolated =
        adaptive_weights(interpolated, distributed, relative_areas(source_areas), relative_areas(target_areas));
  const bool is_only_largest = method == Resampling_method::nearest || method == Resampling_method::largest;
  weights = is_only_largest || !mask.empty() ? selected(interpolated, mask, is_only_largest) : std::move(interpolated);
  return OK;
}

} // namespace internal
} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_SAMPLING_IMPL_H
