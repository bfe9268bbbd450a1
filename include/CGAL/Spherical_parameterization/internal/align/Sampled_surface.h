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

#include <CGAL/Spherical_parameterization/internal/locate/Sphere_image.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/sampling/Subdivided_solid.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// A value for each vertex of a grid.
using Channel = std::vector<double>;

template <class K>
std::vector<typename K::Point_3> points_of(const std::vector<Vector_3d>& directions)
{
  std::vector<typename K::Point_3> result;
  for(const Vector_3d& p : directions)
    result.emplace_back(p[0], p[1], p[2]);
  return result;
}

// Directions that cover the sphere evenly, by which two surfaces are compared: what is computed on them takes the same
// time for all meshes, and does not depend on how these are triangulated.
class Sphere_grid
{
public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Triangulation = Sphere_triangulation<Kernel>;

  explicit Sphere_grid(const Execution& execution)
  {
    Subdivided_solid<3> solid = subdivided_icosahedron(n_steps);
    m_triangulation.assign(points_of<Kernel>(solid.directions),
                           link_triangles(solid.triangles, solid.directions.size()));
    m_triangulation.make_grid();
    m_nodes = Sphere_image::places_of_nodes(m_triangulation, execution);
    m_directions = std::move(solid.directions);
    build_rings(triangles(), size(), m_rings);
  }

  std::size_t size() const { return m_directions.size(); }
  const std::vector<Vector_3d>& directions() const { return m_directions; }
  const Triangulation& triangulation() const { return m_triangulation; }
  const std::vector<Linked_triangle>& triangles() const { return m_triangulation.triangles(); }
  Vertex_rings::Ring neighbors(std::size_t v) const { return m_rings.ring(v); }

  Sphere_image image(const std::vector<Channel>& channels) const
  {
    return Sphere_image(m_nodes, triangles(), channels);
  }

private:
  // Along an edge of the icosahedron: 4002 directions, 3 to 4 degrees apart, by which surfaces of 26,002 vertices are compared
  // in 0.14 s. Time and memory grow with the square; fewer steps leave out what is narrower on the sphere.
  static constexpr std::uint32_t n_steps = 20;

  std::vector<Vector_3d> m_directions;
  Triangulation m_triangulation;
  Vertex_rings m_rings;
  std::vector<Triangulation::Place> m_nodes; // of images
};

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
    , m_joints(grid.size())
  {
    const auto places = images.locate(points_of<K>(grid.directions()), execution);
    for(const auto& place : places)
      m_points.push_back(interpolated(points, images.triangles(), place));
    for(const Channel& feature : features)
    {
      Channel channel;
      for(const auto& place : places)
        channel.push_back(interpolated(feature, images.triangles(), place));
      add_ranks(channel);
    }
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
      m_areas[v] = (std::max)(scale * scale * m_areas[v], min_area);
      if(length(m_normals[v]) > 0.)
        m_normals[v] = normalized(m_normals[v]);
    }
    join_vertices();
  }

  // the ranks of the features
  const std::vector<Channel>& features() const { return m_features; }

  // Adds one of the features of the package: how much the map to the sphere shrinks; how far away the rest of the surface is,
  // on average; and how much the surface is curved, inwards or outwards, at two scales, which differs between front and back
  // where the other features would allow for a half turn.
  static constexpr int number_of_own_features = 4;
  void add_own_feature(int k)
  {
    // The time of heat that goes 0.045, where the vertices of the grid are 0.017 apart, and twice as far. With less time, the
    // curvature is that of the sampling; with more, that of the whole body, and small features are lost.
    constexpr double fine = 0.002, coarse = 0.008;
    add_ranks(k == 0 ? shrinking() : k == 1 ? average_distance() : curvature(k == 2 ? fine : coarse));
  }

  struct Limb
  {
    std::uint32_t end;
    Channel distances; // from the end
  };

  // Those whose ends are farthest away: where the average distance is largest all around, and above the mean.
  std::vector<Limb> limbs()
  {
    // Between two ends, in units of the root of the area. With a smaller one, an end that is blunt counts twice; with a larger
    // one, a limb beside a longer one goes without an end.
    constexpr double min_distance = 0.25;
    const Channel& average = average_distance();
    const double mean = std::inner_product(m_areas.begin(), m_areas.end(), average.begin(), 0.);
    std::vector<std::uint32_t> ends;
    for(std::uint32_t v = 0; v < m_grid.size(); ++v)
      if(const auto& ring = m_grid.neighbors(v);
         average[v] > mean &&
         std::all_of(ring.begin(), ring.end(), [&](std::uint32_t w) { return average[w] <= average[v]; }))
        ends.push_back(v);
    std::stable_sort(ends.begin(), ends.end(),
                     [&](std::uint32_t v, std::uint32_t w) { return average[v] > average[w]; });
    std::vector<Limb> result;
    for(const std::uint32_t v : ends)
      if(std::all_of(result.begin(), result.end(), [&](const Limb& limb) { return limb.distances[v] > min_distance; }))
        result.push_back({v, distances_from(v)});
    return result;
  }

private:
  // Far below the mean, 1 / 4002, and still more than 0 where points coincide: for the matrix of curvature() to be positive
  // definite, and for its cotangents not to be 0 / 0. Smaller areas have the same rank.
  static constexpr double min_area = 1e-12;

  using Joint = std::pair<double, std::uint32_t>; // how far it is to a vertex

  // Adds the ranks of the values of a channel, from -1 to 1: neither outliers nor scales matter. Equal values have the same
  // rank, the middle of theirs.
  void add_ranks(const Channel& channel)
  {
    const std::size_t n = channel.size();
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), std::uint32_t(0));
    std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) { return channel[v] < channel[w]; });
    Channel& ranks = m_features.emplace_back(n);
    for(std::size_t i = 0, j; i < n; i = j)
    {
      for(j = i + 1; j < n && channel[order[j]] == channel[order[i]];)
        ++j;
      for(std::size_t k = i; k < j; ++k)
        ranks[order[k]] = static_cast<double>(i + j) / static_cast<double>(n) - 1.;
    }
  }

  Channel shrinking() const
  {
    Channel sphere_areas(m_grid.size(), 0.), result(m_grid.size());
    const auto& q = m_grid.directions();
    for(const Linked_triangle& t : m_grid.triangles())
      for(const std::uint32_t v : t.vertices)
        sphere_areas[v] += length(cross(q[t[1]] - q[t[0]], q[t[2]] - q[t[0]]));
    std::transform(m_areas.begin(), m_areas.end(), sphere_areas.begin(), result.begin(), std::divides<>());
    return result;
  }

  // How far places are from each other on the surface changes little when it is bent: these are the lengths of shortest paths
  // along the edges of the grid and across pairs of its triangles, within 4 percent on regular triangles.
  void join_vertices()
  {
    const auto join = [&](std::uint32_t v, std::uint32_t w, double length) {
      m_joints[v].emplace_back(length, w);
      m_joints[w].emplace_back(length, v);
    };
    const std::vector<Linked_triangle>& triangles = m_grid.triangles();
    for(std::uint32_t t = 0; t < triangles.size(); ++t)
      for(std::size_t i = 0; i < 3; ++i)
        if(const std::uint32_t s = triangles[t].neighbors[i]; t < s)
        {
          const std::uint32_t a = triangles[t][(i + 1) % 3], b = triangles[t][(i + 2) % 3];
          const std::uint32_t c = triangles[t][i], d = triangles[s][triangles[s].side_of(t)];
          join(a, b, length(m_points[b] - m_points[a]));
          join(c, d, length_across(m_points[a], m_points[b], m_points[c], m_points[d]));
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

  Channel distances_from(std::uint32_t source) const
  {
    Channel result(m_grid.size(), (std::numeric_limits<double>::max)());
    std::priority_queue<Joint, std::vector<Joint>, std::greater<Joint>> queue;
    result[source] = 0.;
    queue.emplace(0., source);
    while(!queue.empty())
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d > result[v])
        continue;
      for(const auto& [step, w] : m_joints[v])
        if(const double x = d + step; x < result[w])
        {
          result[w] = x;
          queue.emplace(x, w);
        }
    }
    return result;
  }

  // The average distance of each vertex from the whole surface: from sources that are spread over it, each as far as
  // possible from those before. Computed once.
  const Channel& average_distance()
  {
    if(!m_average_distance.empty())
      return m_average_distance;
    // Each stands for 1 / 48 of the area, a disc of the radius 0.08, below which the average is not exact. More of them take
    // more time, in proportion.
    constexpr std::size_t n_sources = 48;
    auto source = static_cast<std::uint32_t>(std::max_element(m_areas.begin(), m_areas.end()) - m_areas.begin());
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
    Channel weights(n_sources, 0.);
    for(std::size_t v = 0; v < m_grid.size(); ++v)
      weights[nearest[v]] += m_areas[v];
    m_average_distance.assign(m_grid.size(), 0.);
    for(std::size_t k = 0; k < n_sources; ++k)
      for(std::size_t v = 0; v < m_grid.size(); ++v)
        m_average_distance[v] += weights[k] * distances[k][v];
    return m_average_distance;
  }

  // How far the surface is outside of itself smoothed: along the normal, after heat has been conducted for the time `t` by
  // one implicit step. This solves (M + t L) x = M p by the method of conjugate gradients, with the cotangents of the triangles
  // in L. They are kept positive and finite, so that the matrix is positive definite.
  Channel curvature(double t) const
  {
    // The cotangents of 89 and 1 degrees, nearly. A larger minimum has obtuse triangles conduct too much; a smaller one, or a
    // larger maximum, which needles have, makes the weights more unequal, which takes more steps.
    constexpr double min_cotangent = 0.02, max_cotangent = 1. / min_cotangent;
    const std::size_t n = m_grid.size();
    std::vector<std::tuple<std::uint32_t, std::uint32_t, double>> sides; // and their weights
    Channel diagonal = m_areas;
    for(const Linked_triangle& triangle : m_grid.triangles())
      for(std::size_t i = 0; i < 3; ++i)
      {
        const std::uint32_t o = triangle[i], v = triangle[(i + 1) % 3], w = triangle[(i + 2) % 3];
        const Vector_3d a = m_points[v] - m_points[o], b = m_points[w] - m_points[o];
        const double cotangent = dot(a, b) / (length(cross(a, b)) + min_area);
        const double weight = 0.5 * t * (std::min)((std::max)(cotangent, min_cotangent), max_cotangent);
        sides.emplace_back(v, w, weight);
        diagonal[v] += weight;
        diagonal[w] += weight;
      }
    using Vectors = std::vector<Vector_3d>;
    const auto product = [&](const Vectors& x) {
      Vectors y(n);
      for(std::size_t v = 0; v < n; ++v)
        y[v] = diagonal[v] * x[v];
      for(const auto& [v, w, weight] : sides)
      {
        y[v] = y[v] - weight * x[w];
        y[w] = y[w] - weight * x[v];
      }
      return y;
    };
    const auto inner_product = [](const Vectors& x, const Vectors& y) {
      return std::inner_product(x.begin(), x.end(), y.begin(), 0., std::plus<>(), dot<double>);
    };
    // The tolerance, of the square of the residual, stands for an error of 1e-5, far less than by what samplings of the same
    // surface differ; a smaller one takes more steps. The limit of these bounds the time on surfaces of needles.
    constexpr std::size_t max_steps = 300;
    constexpr double tolerance = 1e-10;
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
    Channel result;
    for(std::size_t v = 0; v < n; ++v)
      result.push_back(dot(m_points[v] - x[v], m_normals[v]));
    return result;
  }

  const Sphere_grid& m_grid;
  std::vector<Vector_3d> m_points, m_normals;
  Channel m_areas; // around the vertices
  std::vector<Channel> m_features;
  std::vector<std::vector<Joint>> m_joints; // of each vertex, with its neighbours and those across from them
  Channel m_average_distance;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SAMPLED_SURFACE_H
