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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SURFACE_ALIGNMENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SURFACE_ALIGNMENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/align/Sphere_image.h>
#include <CGAL/Spherical_parameterization/internal/align/Feature_flow.h>
#include <CGAL/Spherical_parameterization/internal/align/Rotation_search.h>
#include <CGAL/Spherical_parameterization/internal/align/Sampled_surface.h>
#include <CGAL/Spherical_parameterization/internal/align/Sphere_grid.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/sampling/surface_samples.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Two surfaces on the same grid, and how the sphere of the first is to be turned, or bent, onto that of the second.
class Surface_alignment
{
public:
  using Channel = std::vector<double>;

  // What is known of a surface in the directions of the grid: points, and a caller's own features, or none.
  struct Samples
  {
    std::vector<Vector_3d> points;
    std::vector<Channel> features;
  };

  static bool are_finite(const std::vector<Channel>& channels)
  {
    for(const Channel& channel : channels)
      for(const double x : channel)
        if(!is_finite(x))
          return false;
    return true;
  }

  // Samples what the vertices of a mesh have. Its images have a grid to locate directions by.
  template <class K>
  static Samples samples_of(const Sphere_grid& grid, const Sphere_triangulation<K>& images,
                            const std::vector<Vector_3d>& points, const std::vector<Channel>& features,
                            const Execution& execution)
  {
    using FT = typename K::FT;
    std::vector<typename K::Point_3> directions;
    directions.reserve(grid.size());
    for(const Vector_3d& q : grid.directions())
      directions.emplace_back(FT(q[0]), FT(q[1]), FT(q[2]));
    const auto places = images.locate(directions, execution);
    Samples result;
    for(const auto& place : places)
      result.points.push_back(interpolated(points, images.triangles(), place));
    for(const Channel& feature : features)
    {
      result.features.emplace_back();
      for(const auto& place : places)
      {
        const Linked_triangle& t = images.triangles()[place.triangle];
        double sum = 0.;
        for(std::size_t i = 0; i < 3; ++i)
          sum += CGAL::to_double(place.coordinates[i]) * feature[t[i]];
        result.features.back().push_back(sum);
      }
    }
    return result;
  }

  Surface_alignment(const Sphere_grid& grid, Samples first, Samples second, const Execution& execution)
    : m_grid(grid)
    , m_raster(grid, execution)
    , m_execution(execution)
    , m_surfaces{Sampled_surface(grid, std::move(first.points)), Sampled_surface(grid, std::move(second.points))}
    , m_features{std::move(first.features), std::move(second.features)}
  {
    for_each_block(execution, 0, 2, 1, [&](std::size_t k, std::size_t) {
      if(m_features[k].empty())
        m_features[k] = m_surfaces[k].features();
      for(Channel& channel : m_features[k])
        rank_channel(channel);
    });
  }

  // The ranks of the features of a surface, 0 or 1.
  Sphere_image features(std::size_t surface) const { return Sphere_image(m_grid, m_raster, m_features[surface]); }

  // The best rotations that are at least 20 degrees apart, the best one first.
  std::vector<Scored_rotation> best_rotations(std::size_t n) const
  {
    constexpr double min_angle = CGAL_PI / 9.;
    return Rotation_search(m_grid, m_features[0], features(1), m_execution).best(n, min_angle);
  }

  // Bends the first sphere onto the second one from a rotation: returns where the vertices of the grid lead to, a
  // bijection. First the features guide it, from coarse to fine. Then the ends of limbs are known, and the distances
  // from them, which no pose changes, tell everywhere where to go.
  std::vector<Vector_3d> bent(const Rotation_matrix& rotation) const
  {
    constexpr int n_steps = 15;
    Feature_flow flow(m_grid, m_raster, rotation, m_execution);
    for(const std::array<int, 2> n : {std::array<int, 2>{30, 30}, {15, 20}, {6, 12}})
      flow.flow(m_features[0], m_features[1], n_steps, n[0], n[1]);
    std::array<std::vector<Channel>, 2> channels = distances_from_limbs(flow.directions());
    if(channels[0].empty())
      return flow.directions();
    constexpr double weight_of_features = 0.2;
    for(std::size_t k = 0; k < 2; ++k)
      for(Channel channel : m_features[k])
      {
        for(double& x : channel)
          x *= weight_of_features;
        channels[k].push_back(std::move(channel));
      }
    for(const std::array<int, 2> n : {std::array<int, 2>{6, 30}, {3, 20}, {1, 12}, {1, 6}})
      flow.flow(channels[0], channels[1], n_steps, n[0], n[1]);
    return flow.directions();
  }

  // how well the features agree where the vertices of the grid lead to: their correlation
  double agreement(const std::vector<Vector_3d>& directions) const
  {
    const Sphere_image image = features(1);
    std::vector<double> b(m_features[1].size());
    double ab = 0., aa = 0., bb = 0.;
    for(std::size_t v = 0; v < m_grid.size(); ++v)
    {
      image.interpolate(directions[v], b.data());
      for(std::size_t k = 0; k < b.size(); ++k)
      {
        const double a = m_features[0][k][v];
        ab += a * b[k];
        aa += a * a;
        bb += b[k] * b[k];
      }
    }
    return aa > 0. && bb > 0. ? ab / std::sqrt(aa * bb) : 0.;
  }

private:
  // The distances from ends of limbs that are found on both surfaces, each the nearest one of the other; none if these
  // are too few to tell a place.
  std::array<std::vector<Channel>, 2> distances_from_limbs(const std::vector<Vector_3d>& directions) const
  {
    constexpr std::size_t max_limbs = 10, min_limbs = 3;
    constexpr double min_cosine = 0.7;
    const std::vector<std::uint32_t> a = m_surfaces[0].extremities(max_limbs), b = m_surfaces[1].extremities(max_limbs);
    const auto cosine = [&](std::uint32_t v, std::uint32_t w) { return dot(directions[v], m_grid.directions()[w]); };
    std::array<std::vector<Channel>, 2> result;
    for(const std::uint32_t v : a)
      for(const std::uint32_t w : b)
      {
        bool is_nearest = cosine(v, w) > min_cosine;
        for(const std::uint32_t other : b)
          is_nearest = is_nearest && (other == w || cosine(v, other) < cosine(v, w));
        for(const std::uint32_t other : a)
          is_nearest = is_nearest && (other == v || cosine(other, w) < cosine(v, w));
        if(is_nearest)
        {
          result[0].push_back(m_surfaces[0].distances_from(v));
          result[1].push_back(m_surfaces[1].distances_from(w));
        }
      }
    if(result[0].size() < min_limbs)
      return {};
    for(auto& channels : result)
    {
      double sum = 0.;
      for(const Channel& channel : channels)
        for(const double d : channel)
          sum += d;
      const double scale = sum > 0. ? static_cast<double>(channels.size() * m_grid.size()) / sum : 1.;
      for(Channel& channel : channels)
        for(double& d : channel)
          d *= scale;
    }
    return result;
  }

  const Sphere_grid& m_grid;
  Cube_raster m_raster;
  Execution m_execution;
  std::array<Sampled_surface, 2> m_surfaces;
  std::array<std::vector<Channel>, 2> m_features; // ranks
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SURFACE_ALIGNMENT_H
