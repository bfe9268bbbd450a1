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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_FEATURE_FLOW_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_FEATURE_FLOW_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/align/Rotation_search.h>
#include <CGAL/Spherical_parameterization/internal/align/Sphere_grid.h>
#include <CGAL/Spherical_parameterization/internal/align/Sphere_image.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Bends one sphere onto another one such that their features agree: an optical flow on the vertices of a grid, each of
// which has a direction on the other sphere. All triangles stay positive, so that the map of the grid is a bijection.
class Feature_flow
{
public:
  using Channel = std::vector<double>;

  Feature_flow(const Sphere_grid& grid, const Cube_raster& raster, const Rotation_matrix& rotation,
               const Execution& execution)
    : m_grid(grid)
    , m_raster(raster)
    , m_execution(execution)
  {
    for(const Vector_3d& q : grid.directions())
      m_directions.push_back(normalized(rotated(rotation, q)));
    for(const Linked_triangle& t : grid.triangles())
      m_determinants.push_back(determinant(t, grid.directions()));
    m_spacing = length(grid.directions()[grid.triangles()[0][1]] - grid.directions()[grid.triangles()[0][0]]);
  }

  // where the vertices of the grid lead to
  const std::vector<Vector_3d>& directions() const { return m_directions; }

  // Steps by the method of Gauss and Newton on the squares of the differences between the channels `a` at the vertices
  // and `b` where they lead to, after both have been smoothed `n_image` times. The equations of a vertex are averaged
  // with those of its neighbours, `n_motion` times: so the motion is smooth, most of all where there are no features.
  void flow(std::vector<Channel> a, std::vector<Channel> b, int n_steps, int n_image, int n_motion)
  {
    const std::size_t n = a.size();
    for(auto* channels : {&a, &b})
      for_each_block(m_execution, 0, n, 1, [&](std::size_t k, std::size_t) { smooth((*channels)[k], n_image); });
    const Sphere_image image(m_grid, m_raster, b);
    std::vector<Equations> equations(m_grid.size());
    std::vector<Vector_3d> motion(m_grid.size());
    for(int step = 0; step < n_steps; ++step)
    {
      for_each_block(m_execution, 0, m_grid.size(), block_size, [&](std::size_t begin, std::size_t end) {
        std::vector<double> values(5 * n);
        for(std::size_t v = begin; v < end; ++v)
          equations[v] = equations_at(v, a, image, values);
      });
      smooth(equations, n_motion);
      for(std::size_t v = 0; v < m_grid.size(); ++v)
        motion[v] = solution(equations[v], m_directions[v]);
      limit_length(motion);
      smooth(motion, 2);
      if(!move(motion))
        return;
    }
  }

private:
  static constexpr std::size_t block_size = 256;

  // H d = g for the motion d of a vertex: xx, xy, xz, yy, yz, zz of H, then g
  using Equations = std::array<double, 9>;

  static double determinant(const Linked_triangle& t, const std::vector<Vector_3d>& p)
  {
    return dot(p[t[0]], cross(p[t[1]], p[t[2]]));
  }

  static void add(double x, double& sum) { sum += x; }
  template <std::size_t n>
  static void add(const std::array<double, n>& x, std::array<double, n>& sum)
  {
    for(std::size_t i = 0; i < n; ++i)
      sum[i] += x[i];
  }
  static void scale(double s, double& x) { x *= s; }
  template <std::size_t n>
  static void scale(double s, std::array<double, n>& x)
  {
    for(double& y : x)
      y *= s;
  }

  // the average of a vertex and its neighbours
  template <class T>
  T average_at(std::size_t v, const std::vector<T>& values) const
  {
    T result = values[v];
    double n = 1.;
    m_grid.for_each_neighbor(v, [&](std::uint32_t w) {
      add(values[w], result);
      n += 1.;
    });
    scale(1. / n, result);
    return result;
  }

  template <class T>
  void smooth(std::vector<T>& values, int n_times) const
  {
    std::vector<T> next(values.size());
    for(int k = 0; k < n_times; ++k)
    {
      for_each_block(m_execution, 0, values.size(), 4 * block_size, [&](std::size_t begin, std::size_t end) {
        for(std::size_t v = begin; v < end; ++v)
          next[v] = average_at(v, values);
      });
      values.swap(next);
    }
  }

  Equations equations_at(std::size_t v, const std::vector<Channel>& a, const Sphere_image& b,
                         std::vector<double>& values) const
  {
    const Vector_3d& p = m_directions[v];
    const Tangent_frame frame(p);
    const double h = 0.5 * m_spacing;
    const Vector_3d x = frame.vector_of(1., 0.), y = frame.vector_of(0., 1.);
    const std::size_t n = a.size();
    const std::array<Vector_3d, 5> places = {p, p + h * x, p - h * x, p + h * y, p - h * y};
    for(std::size_t i = 0; i < 5; ++i)
      b.interpolate(places[i], &values[i * n]);
    Equations result{};
    for(std::size_t k = 0; k < n; ++k)
    {
      const Vector_3d gradient = ((values[n + k] - values[2 * n + k]) / (2. * h)) * x +
                                 ((values[3 * n + k] - values[4 * n + k]) / (2. * h)) * y;
      const double difference = a[k][v] - values[k];
      for(std::size_t i = 0, e = 0; i < 3; ++i)
        for(std::size_t j = i; j < 3; ++j, ++e)
          result[e] += gradient[i] * gradient[j];
      for(std::size_t i = 0; i < 3; ++i)
        result[6 + i] += difference * gradient[i];
    }
    return result;
  }

  // The motion in the tangent plane at p. Without features it is zero.
  static Vector_3d solution(const Equations& e, const Vector_3d& p)
  {
    constexpr double damping = 0.05;
    const Tangent_frame frame(p);
    const Vector_3d x = frame.vector_of(1., 0.), y = frame.vector_of(0., 1.);
    const auto apply = [&](const Vector_3d& d) {
      return Vector_3d{e[0] * d[0] + e[1] * d[1] + e[2] * d[2], e[1] * d[0] + e[3] * d[1] + e[4] * d[2],
                       e[2] * d[0] + e[4] * d[1] + e[5] * d[2]};
    };
    const double xx = dot(x, apply(x)) + damping, xy = dot(x, apply(y)), yy = dot(y, apply(y)) + damping;
    const Vector_3d g = {e[6], e[7], e[8]};
    const double gx = dot(x, g), gy = dot(y, g), determinant = xx * yy - xy * xy;
    return ((yy * gx - xy * gy) / determinant) * x + ((xx * gy - xy * gx) / determinant) * y;
  }

  void limit_length(std::vector<Vector_3d>& motion) const
  {
    double longest = 0.;
    for(const Vector_3d& d : motion)
      longest = (std::max)(longest, length(d));
    const double limit = 1.5 * m_spacing;
    if(longest > limit)
      for(Vector_3d& d : motion)
        d = (limit / longest) * d;
  }

  // Moves all vertices, each a bit towards the centre of its neighbours as well; less where a triangle would become
  // smaller than half of what it was, in the grid or before. Returns whether there is such a motion.
  bool move(const std::vector<Vector_3d>& motion)
  {
    constexpr double elasticity = 0.3, min_share = 0.5;
    constexpr int n_halvings = 8, max_trials = 40;
    std::vector<Vector_3d> steps(m_grid.size()), moved(m_grid.size());
    for(std::size_t v = 0; v < m_grid.size(); ++v)
    {
      const Vector_3d& p = m_directions[v];
      const Vector_3d to_center = average_at(v, m_directions) - p;
      steps[v] = motion[v] + elasticity * (to_center - dot(to_center, p) * p);
    }
    std::vector<double> shares(m_grid.size(), 1.);
    for(int trial = 0; trial < max_trials; ++trial)
    {
      for(std::size_t v = 0; v < m_grid.size(); ++v)
        moved[v] = normalized(m_directions[v] + shares[v] * steps[v]);
      bool is_positive = true;
      for(std::size_t t = 0; t < m_grid.triangles().size(); ++t)
      {
        const Linked_triangle& triangle = m_grid.triangles()[t];
        const double before = determinant(triangle, m_directions);
        if(determinant(triangle, moved) < min_share * (std::min)(before, m_determinants[t]))
        {
          is_positive = false;
          for(const std::uint32_t v : triangle.vertices)
            shares[v] = trial < n_halvings ? 0.5 * shares[v] : 0.;
        }
      }
      if(is_positive)
      {
        m_directions.swap(moved);
        return true;
      }
    }
    return false;
  }

  const Sphere_grid& m_grid;
  const Cube_raster& m_raster;
  Execution m_execution;
  std::vector<Vector_3d> m_directions;
  std::vector<double> m_determinants; // of the triangles of the grid
  double m_spacing;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_FEATURE_FLOW_H
