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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SAMPLED_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SAMPLED_SURFACE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/align/Sphere_grid.h>
#include <CGAL/Spherical_parameterization/internal/align/Surface_distances.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>

#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Replaces the values of a channel by their ranks, from -1 to 1: neither outliers nor scales matter. Equal values have
// the same rank, the middle of theirs.
inline void rank_channel(Channel& channel)
{
  const std::size_t n = channel.size();
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), std::uint32_t(0));
  std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) { return channel[v] < channel[w]; });
  Channel ranks(n);
  for(std::size_t i = 0, j; i < n; i = j)
  {
    for(j = i + 1; j < n && channel[order[j]] == channel[order[i]];)
      ++j;
    for(std::size_t k = i; k < j; ++k)
      ranks[order[k]] = static_cast<double>(i + j) / static_cast<double>(n) - 1.;
  }
  channel = std::move(ranks);
}

// A surface, scaled to area 1, by its points in the directions of a grid: the mesh of the grid with the points of the
// surface. What is computed here changes little when the surface is bent, and not at all when it is moved.
class Sampled_surface
{
public:
  // Samples what the vertices of a mesh have: points, and a caller's own features or none. Its images have a grid to locate
  // directions by.
  template <class K>
  Sampled_surface(const Sphere_grid& grid, const Sphere_triangulation<K>& images, const std::vector<Vector_3d>& points,
                  const std::vector<Channel>& features, const Execution& execution)
    : m_grid(grid)
    , m_normals(grid.size(), Vector_3d{0., 0., 0.})
    , m_areas(grid.size(), 0.)
    , m_features(features.size())
  {
    using FT = typename K::FT;
    std::vector<typename K::Point_3> directions;
    for(const Vector_3d& q : grid.directions())
      directions.emplace_back(FT(q[0]), FT(q[1]), FT(q[2]));
    for(const auto& place : images.locate(directions, execution))
    {
      m_points.push_back(interpolated(points, images.triangles(), place));
      for(std::size_t k = 0; k < features.size(); ++k)
        m_features[k].push_back(interpolated(features[k], images.triangles(), place));
    }
    for(Channel& channel : m_features)
      rank_channel(channel);
    normalize(m_points);
    for(const Linked_triangle& t : grid.triangles())
    {
      const Vector_3d normal = cross(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]]);
      for(const std::uint32_t v : t.vertices)
      {
        m_normals[v] = m_normals[v] + normal;
        m_areas[v] += length(normal) / 6.;
      }
    }
    const double area = std::accumulate(m_areas.begin(), m_areas.end(), 0.);
    const double scale = area > 0. ? 1. / std::sqrt(area) : 1.;
    for(std::size_t v = 0; v < grid.size(); ++v)
    {
      m_points[v] = scale * m_points[v];
      m_areas[v] = (std::max)(scale * scale * m_areas[v], 1e-12); // It is divided by.
      if(length(m_normals[v]) > 0.)
        m_normals[v] = normalized(m_normals[v]);
    }
    m_distances.emplace(grid, m_points, m_areas);
  }

  // the ranks of the features
  const std::vector<Channel>& features() const { return m_features; }

  // the features of the package
  using Feature = Channel (Sampled_surface::*)();
  void add_feature(Feature feature)
  {
    m_features.push_back((this->*feature)());
    rank_channel(m_features.back());
  }

  // how much the map to the sphere shrinks
  Channel shrinking()
  {
    Channel sphere_areas(m_grid.size(), 0.), result;
    const auto& q = m_grid.directions();
    for(const Linked_triangle& t : m_grid.triangles())
      for(const std::uint32_t v : t.vertices)
        sphere_areas[v] += length(cross(q[t[1]] - q[t[0]], q[t[2]] - q[t[0]]));
    for(std::size_t v = 0; v < m_grid.size(); ++v)
      result.push_back(m_areas[v] / sphere_areas[v]);
    return result;
  }

  // how far away the rest of the surface is, on average
  Channel average_distance() { return m_distances->average(); }

  // How much it is curved, inwards or outwards, at two scales: it differs between front and back where the other features
  // would allow for a half turn.
  Channel fine_curvature() { return curvature(0.002); }
  Channel coarse_curvature() { return curvature(0.008); }

  Surface_distances& distances() { return *m_distances; }

private:
  // How far the surface is outside of itself smoothed: along the normal, after heat has been conducted for the time `t`
  // by one implicit step.
  Channel curvature(double t) const
  {
    const std::vector<Vector_3d> smoothed = conduct_heat(t);
    Channel result;
    for(std::size_t v = 0; v < m_grid.size(); ++v)
      result.push_back(dot(m_points[v] - smoothed[v], m_normals[v]));
    return result;
  }

  // Solves (M + t L) x = M p by the method of conjugate gradients, with the cotangents of the triangles in L. They are
  // kept positive and finite, so that the matrix is positive definite.
  std::vector<Vector_3d> conduct_heat(double t) const
  {
    const std::size_t n = m_grid.size();
    struct Side
    {
      std::uint32_t v, w;
      double weight;
    };
    std::vector<Side> sides;
    Channel diagonal = m_areas;
    for(const Linked_triangle& triangle : m_grid.triangles())
      for(std::size_t i = 0; i < 3; ++i)
      {
        const std::uint32_t o = triangle[i], v = triangle[(i + 1) % 3], w = triangle[(i + 2) % 3];
        const Vector_3d a = m_points[v] - m_points[o], b = m_points[w] - m_points[o];
        const double cotangent = dot(a, b) / (length(cross(a, b)) + 1e-12);
        const double weight = 0.5 * t * (std::min)((std::max)(cotangent, 0.02), 50.);
        sides.push_back({v, w, weight});
        diagonal[v] += weight;
        diagonal[w] += weight;
      }
    using Vectors = std::vector<Vector_3d>;
    const auto product = [&](const Vectors& x) {
      Vectors y(n);
      for(std::size_t v = 0; v < n; ++v)
        y[v] = diagonal[v] * x[v];
      for(const Side& side : sides)
      {
        y[side.v] = y[side.v] - side.weight * x[side.w];
        y[side.w] = y[side.w] - side.weight * x[side.v];
      }
      return y;
    };
    const auto inner_product = [&](const Vectors& x, const Vectors& y) {
      double sum = 0.;
      for(std::size_t v = 0; v < n; ++v)
        sum += dot(x[v], y[v]);
      return sum;
    };
    constexpr std::size_t max_steps = 300;
    constexpr double tolerance = 1e-10; // of the square of the residual
    Vectors x = m_points, r = product(x), z(n);
    for(std::size_t v = 0; v < n; ++v)
    {
      r[v] = m_areas[v] * m_points[v] - r[v];
      z[v] = (1. / diagonal[v]) * r[v];
    }
    Vectors p = z;
    const double first = inner_product(r, z);
    double rz = first;
    for(std::size_t k = 0; k < max_steps && rz > tolerance * first; ++k)
    {
      const Vectors q = product(p);
      const double alpha = rz / inner_product(p, q);
      for(std::size_t v = 0; v < n; ++v)
      {
        x[v] = x[v] + alpha * p[v];
        r[v] = r[v] - alpha * q[v];
        z[v] = (1. / diagonal[v]) * r[v];
      }
      const double next = inner_product(r, z), beta = next / rz;
      rz = next;
      for(std::size_t v = 0; v < n; ++v)
        p[v] = z[v] + beta * p[v];
    }
    return x;
  }

  const Sphere_grid& m_grid;
  std::vector<Vector_3d> m_points, m_normals;
  Channel m_areas; // around the vertices
  std::vector<Channel> m_features;
  std::optional<Surface_distances> m_distances;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SAMPLED_SURFACE_H
