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
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A surface, scaled to area 1, by its places in the directions of a grid: the mesh of the grid with the points of the
// surface. What is computed here changes little when the surface is bent, and not at all when it is moved.
class Sampled_surface
{
public:
  using Channel = std::vector<double>; // one value for each vertex of the grid

  Sampled_surface(const Sphere_grid& grid, std::vector<Vector_3d> points)
    : m_grid(grid)
    , m_points(std::move(points))
    , m_normals(grid.size(), Vector_3d{0., 0., 0.})
    , m_areas(grid.size(), 0.)
  {
    move_to_origin();
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
    join_neighbors();
  }

  const std::vector<double>& areas() const { return m_areas; }

  // Four channels: how much the map to the sphere shrinks; how far away the rest of the surface is, on average; and how
  // much it is curved, finely and coarsely, inwards or outwards. The last two differ between front and back where the
  // others would allow for a half turn.
  std::vector<Channel> features() const
  {
    std::vector<double> sphere_areas(m_grid.size(), 0.);
    for(const Linked_triangle& t : m_grid.triangles())
    {
      const auto& q = m_grid.directions();
      for(const std::uint32_t v : t.vertices)
        sphere_areas[v] += length(cross(q[t[1]] - q[t[0]], q[t[2]] - q[t[0]]));
    }
    Channel shrinking(m_grid.size());
    for(std::size_t v = 0; v < m_grid.size(); ++v)
      shrinking[v] = m_areas[v] / sphere_areas[v]; // Only their order counts.
    return {shrinking, average_distance(), curvature(0.002), curvature(0.008)};
  }

  // The lengths of shortest paths along the edges and across pairs of triangles: within 4 percent on regular triangles.
  Channel distances_from(std::uint32_t source) const
  {
    using Entry = std::pair<double, std::uint32_t>;
    Channel result(m_grid.size(), (std::numeric_limits<double>::max)());
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    result[source] = 0.;
    queue.emplace(0., source);
    while(!queue.empty())
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d > result[v])
        continue;
      for(std::uint32_t k = m_begins[v]; k < m_begins[v + 1]; ++k)
        if(const double x = d + m_joints[k].length; x < result[m_joints[k].vertex])
        {
          result[m_joints[k].vertex] = x;
          queue.emplace(x, m_joints[k].vertex);
        }
    }
    return result;
  }

  // the ends of limbs: where the average distance is largest all around, at most `max_number`
  std::vector<std::uint32_t> extremities(std::size_t max_number) const
  {
    constexpr double min_distance = 0.25; // between two of them
    const Channel average_distance = this->average_distance();
    double mean = 0.;
    for(std::size_t v = 0; v < m_grid.size(); ++v)
      mean += m_areas[v] * average_distance[v];
    std::vector<std::uint32_t> result;
    for(std::uint32_t v = 0; v < m_grid.size(); ++v)
    {
      bool is_largest = average_distance[v] > mean;
      m_grid.for_each_neighbor(
          v, [&](std::uint32_t w) { is_largest = is_largest && average_distance[w] <= average_distance[v]; });
      if(is_largest)
        result.push_back(v);
    }
    std::stable_sort(result.begin(), result.end(),
                     [&](std::uint32_t v, std::uint32_t w) { return average_distance[v] > average_distance[w]; });
    std::vector<double> nearest(m_grid.size(), (std::numeric_limits<double>::max)());
    std::size_t n = 0;
    for(std::size_t i = 0; i < result.size() && n < max_number; ++i)
      if(nearest[result[i]] > min_distance)
      {
        result[n++] = result[i];
        const Channel d = distances_from(result[i]);
        for(std::size_t v = 0; v < nearest.size(); ++v)
          nearest[v] = (std::min)(nearest[v], d[v]);
      }
    result.resize(n);
    return result;
  }

private:
  struct Joint
  {
    std::uint32_t vertex;
    double length;
  };

  // Moves and scales the surface such that products of coordinates neither overflow nor underflow.
  void move_to_origin()
  {
    const Vector_3d origin = m_points[0];
    double size = 0.;
    for(Vector_3d& p : m_points)
    {
      p = 0.5 * p - 0.5 * origin;
      size = (std::max)({size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    }
    for(Vector_3d& p : m_points)
      for(double& x : p)
        x = size > 0. ? x / size : 0.;
  }

  // Joins the ends of each edge, and the two vertices opposite to it by the way across.
  void join_neighbors()
  {
    std::vector<std::vector<Joint>> joints(m_grid.size());
    const auto join = [&](std::uint32_t v, std::uint32_t w, double length) {
      joints[v].push_back({w, length});
      joints[w].push_back({v, length});
    };
    const std::vector<Linked_triangle>& triangles = m_grid.triangles();
    for(std::uint32_t t = 0; t < triangles.size(); ++t)
      for(std::size_t i = 0; i < 3; ++i)
        if(const std::uint32_t s = triangles[t].neighbors[i]; t < s)
        {
          const auto& back = triangles[s].neighbors;
          const std::uint32_t c = triangles[t][i], d = triangles[s][back[0] == t ? 0 : back[1] == t ? 1 : 2];
          const std::uint32_t a = triangles[t][(i + 1) % 3], b = triangles[t][(i + 2) % 3];
          join(a, b, length(m_points[b] - m_points[a]));
          join(c, d, length_across(m_points[a], m_points[b], m_points[c], m_points[d]));
        }
    m_begins.push_back(0);
    for(const auto& list : joints)
    {
      m_joints.insert(m_joints.end(), list.begin(), list.end());
      m_begins.push_back(static_cast<std::uint32_t>(m_joints.size()));
    }
  }

  // from c to d over the edge from a to b
  static double length_across(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c, const Vector_3d& d)
  {
    const double edge = length(b - a);
    if(!(edge > 0.))
      return length(c - a) + length(d - a);
    const Vector_3d u = (1. / edge) * (b - a);
    const double cx = dot(c - a, u), cy = std::sqrt((std::max)(squared_length(c - a) - cx * cx, 0.));
    const double dx = dot(d - a, u), dy = std::sqrt((std::max)(squared_length(d - a) - dx * dx, 0.));
    const double x = cy + dy > 0. ? (cx * dy + dx * cy) / (cy + dy) : 0.; // where the straight way meets the line
    return x >= 0. && x <= edge ? std::hypot(cx - dx, cy + dy)
                                : (std::min)(length(c - a) + length(d - a), length(c - b) + length(d - b));
  }

  // from places that are spread over the surface, each as far as possible from those before
  Channel average_distance() const
  {
    constexpr std::size_t n_sources = 48;
    std::uint32_t source =
        static_cast<std::uint32_t>(std::max_element(m_areas.begin(), m_areas.end()) - m_areas.begin());
    std::vector<Channel> distances;
    std::vector<std::size_t> nearest(m_grid.size(), 0);
    for(std::size_t k = 0; k < n_sources; ++k)
    {
      distances.push_back(distances_from(source));
      double largest = -1.;
      for(std::uint32_t v = 0; v < m_grid.size(); ++v)
      {
        if(distances[k][v] < distances[nearest[v]][v])
          nearest[v] = k;
        if(distances[nearest[v]][v] > largest)
        {
          largest = distances[nearest[v]][v];
          source = v;
        }
      }
    }
    std::vector<double> weights(n_sources, 0.);
    for(std::size_t v = 0; v < m_grid.size(); ++v)
      weights[nearest[v]] += m_areas[v];
    Channel result(m_grid.size(), 0.);
    for(std::size_t k = 0; k < n_sources; ++k)
      for(std::size_t v = 0; v < m_grid.size(); ++v)
        result[v] += weights[k] * distances[k][v];
    return result;
  }

  // How far the surface is outside of itself smoothed: along the normal, after heat has been conducted for the time `t`
  // by one implicit step.
  Channel curvature(double t) const
  {
    const std::vector<Vector_3d> smoothed = conduct_heat(t);
    Channel result(m_grid.size());
    for(std::size_t v = 0; v < m_grid.size(); ++v)
      result[v] = dot(m_points[v] - smoothed[v], m_normals[v]);
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
    std::vector<double> diagonal = m_areas;
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
    const auto product = [&](const Vectors& x, Vectors& y) {
      for(std::size_t v = 0; v < n; ++v)
        y[v] = diagonal[v] * x[v];
      for(const Side& side : sides)
      {
        y[side.v] = y[side.v] - side.weight * x[side.w];
        y[side.w] = y[side.w] - side.weight * x[side.v];
      }
    };
    constexpr std::size_t max_steps = 300;
    constexpr double tolerance = 1e-10; // of the square of the residual
    Vectors x = m_points, r(n), z(n), p(n), q(n);
    product(x, q);
    double rz = 0., first = 0.;
    for(std::size_t v = 0; v < n; ++v)
    {
      r[v] = m_areas[v] * m_points[v] - q[v];
      p[v] = z[v] = (1. / diagonal[v]) * r[v];
      rz += dot(r[v], z[v]);
    }
    first = rz;
    for(std::size_t k = 0; k < max_steps && rz > tolerance * first; ++k)
    {
      product(p, q);
      double pq = 0.;
      for(std::size_t v = 0; v < n; ++v)
        pq += dot(p[v], q[v]);
      const double alpha = rz / pq;
      double next = 0.;
      for(std::size_t v = 0; v < n; ++v)
      {
        x[v] = x[v] + alpha * p[v];
        r[v] = r[v] - alpha * q[v];
        z[v] = (1. / diagonal[v]) * r[v];
        next += dot(r[v], z[v]);
      }
      const double beta = next / rz;
      rz = next;
      for(std::size_t v = 0; v < n; ++v)
        p[v] = z[v] + beta * p[v];
    }
    return x;
  }

  const Sphere_grid& m_grid;
  std::vector<Vector_3d> m_points, m_normals;
  std::vector<double> m_areas; // around the vertices
  std::vector<std::uint32_t> m_begins;
  std::vector<Joint> m_joints;
};

// Replaces the values of a channel by their ranks, from -1 to 1: neither outliers nor scales matter. Equal values have
// the same rank, the middle of theirs.
inline void rank_channel(std::vector<double>& channel)
{
  const std::size_t n = channel.size();
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), std::uint32_t(0));
  std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) { return channel[v] < channel[w]; });
  std::vector<double> ranks(n);
  for(std::size_t i = 0, j; i < n; i = j)
  {
    for(j = i + 1; j < n && channel[order[j]] == channel[order[i]];)
      ++j;
    for(std::size_t k = i; k < j; ++k)
      ranks[order[k]] = static_cast<double>(i + j) / static_cast<double>(n) - 1.;
  }
  channel = std::move(ranks);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SAMPLED_SURFACE_H
