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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SPHERE_BENDING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SPHERE_BENDING_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/align/Sampled_surface.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_image.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Bends one sphere onto another one such that their features agree: an optical flow on the vertices of a grid, each of
// which has a direction on the other sphere. All triangles stay positive, so that the map of the grid is a bijection.
//
// What is smoothed n times is a mean over a place of about 0.65 sqrt(n) steps of the grid: that is the standard deviation.
// Constants have been chosen on ten pairs of people in other poses, where the mean geodesic error is 3.9 percent; six
// settings of two of them give 3.9 to 4.7.
class Feature_flow
{
public:
  Feature_flow(const Sphere_grid& grid, const Rotation_matrix& rotation, const Execution& execution)
    : m_grid(grid)
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

  // What is to agree from now on: the channels `a` at the vertices and `b` where they lead to, after both have been
  // smoothed `n_image` times. The equations of a vertex are averaged with those of its neighbours, `n_motion` times: so
  // the motion is smooth, most of all where there are no features.
  void set_features(std::vector<Channel> a, std::vector<Channel> b, int n_image, int n_motion)
  {
    m_b.reset();
    if(a.empty())
      return;
    for(auto* channels : {&a, &b})
      for_each_block(m_execution, 0, channels->size(), 1,
                     [&](std::size_t k, std::size_t) { smooth((*channels)[k], n_image); });
    m_a = std::move(a);
    m_b = m_grid.image(b);
    m_n_motion = n_motion;
  }

  // Steps by the method of Gauss and Newton on the squares of the differences: not without features, nor once no step has
  // been possible.
  void step()
  {
    // In steps of the grid: about as far as a gradient holds in the last stages. Shorter steps do not come as far in a stage.
    constexpr double max_length = 1.5;
    constexpr int n_smoothed = 2; // Less leaves creases, which are in the way of move(); more takes away what is local.
    if(!m_b)
      return;
    std::vector<Equations> equations(m_grid.size());
    for_each_block(m_execution, 0, m_grid.size(), block_size, [&](std::size_t begin, std::size_t end) {
      std::vector<double> values(5 * m_a.size());
      for(std::size_t v = begin; v < end; ++v)
        equations[v] = equations_at(v, values);
    });
    smooth(equations, m_n_motion);
    std::vector<Vector_3d> motion;
    double longest = 0.;
    for(std::size_t v = 0; v < m_grid.size(); ++v)
    {
      motion.push_back(solution(equations[v], m_directions[v]));
      longest = (std::max)(longest, length(motion[v]));
    }
    const double share = (std::min)(1., max_length * m_spacing / longest);
    for(Vector_3d& d : motion)
      d = share * d;
    smooth(motion, n_smoothed);
    if(!move(motion))
      m_b.reset();
  }

private:
  static constexpr std::size_t block_size = 256; // 16 blocks: enough for the threads of a small machine

  // H d = g for the motion d of a vertex: xx, xy, xz of H, then yy, yz, zz, then g
  using Equations = std::array<Vector_3d, 3>;

  static double determinant(const Linked_triangle& t, const std::vector<Vector_3d>& p)
  {
    return dot(p[t[0]], cross(p[t[1]], p[t[2]]));
  }

  // the average of a vertex and its neighbours
  template <class T>
  T average_at(std::size_t v, const std::vector<T>& values) const
  {
    T sum = values[v];
    for(const std::uint32_t w : m_grid.neighbors(v))
      sum = sum + values[w];
    const double s = 1. / static_cast<double>(m_grid.neighbors(v).size() + 1);
    if constexpr(std::is_same<T, Equations>::value)
      return {s * sum[0], s * sum[1], s * sum[2]};
    else
      return s * sum;
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

  Equations equations_at(std::size_t v, std::vector<double>& values) const
  {
    const Vector_3d& p = m_directions[v];
    const Tangent_frame frame(p);
    const double h =
        0.5 * m_spacing; // The nodes of an image are that far apart: less is within a square, more smooths.
    const Vector_3d x = frame.vector_of(1., 0.), y = frame.vector_of(0., 1.);
    const std::size_t n = m_a.size();
    const std::array<Vector_3d, 5> places = {p, p + h * x, p - h * x, p + h * y, p - h * y};
    for(std::size_t i = 0; i < 5; ++i)
      m_b->interpolate(places[i], &values[i * n]);
    Equations result{};
    for(std::size_t k = 0; k < n; ++k)
    {
      const Vector_3d g = ((values[n + k] - values[2 * n + k]) / (2. * h)) * x +
                          ((values[3 * n + k] - values[4 * n + k]) / (2. * h)) * y; // the gradient
      result[0] = result[0] + g[0] * g;
      result[1] = result[1] + Vector_3d{g[1] * g[1], g[1] * g[2], g[2] * g[2]};
      result[2] = result[2] + (m_a[k][v] - values[k]) * g;
    }
    return result;
  }

  // The motion in the tangent plane at p. Without features it is zero.
  static Vector_3d solution(const Equations& e, const Vector_3d& p)
  {
    // The square of a gradient, of ranks from -1 to 1 by radians. What is flatter, by less than 0.2, moves less than it would
    // have to: if it is more, real slopes are slow; if it is less, noise moves what is flat.
    constexpr double damping = 0.05;
    const Tangent_frame frame(p);
    const Vector_3d x = frame.vector_of(1., 0.), y = frame.vector_of(0., 1.);
    const auto apply = [&](const Vector_3d& d) {
      return Vector_3d{dot(e[0], d), dot({e[0][1], e[1][0], e[1][1]}, d), dot({e[0][2], e[1][1], e[1][2]}, d)};
    };
    const double xx = dot(x, apply(x)) + damping, xy = dot(x, apply(y)), yy = dot(y, apply(y)) + damping;
    const double gx = dot(x, e[2]), gy = dot(y, e[2]), determinant = xx * yy - xy * xy;
    return ((yy * gx - xy * gy) / determinant) * x + ((xx * gy - xy * gx) / determinant) * y;
  }

  // Moves all vertices, each a bit towards the centre of its neighbours as well; less where a triangle would become
  // smaller than half of what it was, in the grid or before. Returns whether there is such a motion.
  bool move(const std::vector<Vector_3d>& motion)
  {
    // More elasticity straightens what the features have bent; less lets triangles shrink until they are in the way.
    constexpr double elasticity = 0.3;
    // More than 0 for all triangles to stay positive. What is near 1 stops all motion; what is near 0 lets a triangle collapse
    // in one step, from which it does not come back.
    constexpr double min_share = 0.5;
    // Steps are halved to 1 / 256, next to nothing, and then are 0, which may go on to the neighbours. More halvings take more
    // time for less motion. The limit of trials bounds the time; what is in the way then ends the stage.
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
  Execution m_execution;
  std::vector<Vector_3d> m_directions;
  std::vector<double> m_determinants; // of the triangles of the grid
  double m_spacing;

  std::vector<Channel> m_a;
  std::optional<Sphere_image> m_b;
  int m_n_motion = 0;
};

// The mean of the neighbours of a vertex with weights (mean value coordinates) by which its image is such a mean.
inline Vector_3d mean_of_neighbors(const Vertex_rings::Ring& ring, const Vector_3d& image,
                                   const std::vector<Vector_3d>& images, const std::vector<Vector_3d>& p)
{
  Vector_3d sum = {0., 0., 0.};
  for(std::size_t j = 0; j < ring.size(); ++j)
  {
    const std::uint32_t a = ring[j], b = ring.around(j + 1);
    const Vector_3d u = images[a] - image, w = images[b] - image;
    const double r = length(u), s = length(w);
    const double tangent = length(cross(u, w)) / (r * s + dot(u, w)); // of half the angle
    sum = sum + (tangent / r) * p[a] + (tangent / s) * p[b];
  }
  return sum;
}

// Carries the images of a mesh along with a grid that is bent, such that no triangle turns over. `K` is a kernel with
// exact predicates on doubles. Returns the directions of the vertices, a bijection if the images are one: nearly where the
// grid leads to; or none if that cannot be had, or the control says no meanwhile.
//
// Edges of the mesh are straight, where the grid bends them, so that some triangles turn over. The vertices around these
// go to the weighted means of their neighbours: it turns the bent map into the rigid one, locally, and step by step
// farther around what remains, for the more rounds it does.
template <class K>
std::optional<std::vector<Vector_3d>> bent_directions(const Sphere_triangulation<K>& images, const Sphere_grid& grid,
                                                      const std::vector<Vector_3d>& bent_grid, Run_control& control,
                                                      const Execution& execution)
{
  // A vertex takes one ring more along every four rounds, of five passes each: sooner, what is repaired is larger than it has
  // to be; later, it takes longer. After 200 rounds that is 50 rings, which is most of a mesh, or there is no hope.
  constexpr int n_rounds = 200, n_passes = 5, rounds_for_each_ring = 4;

  const std::size_t n = images.points().size();
  std::vector<Vector_3d> rigid;
  for(std::size_t v = 0; v < n; ++v)
    rigid.push_back(images.direction(v));
  std::vector<Vector_3d> p;
  for(const auto& place : grid.triangulation().locate(points_of<K>(rigid), execution))
    p.push_back(normalized(interpolated(bent_grid, grid.triangles(), place)));
  Vertex_rings rings;
  build_rings(images.triangles(), n, rings);
  const Orientation_about_origin_3<K> orientation;
  const auto is_positive = [&](const Linked_triangle& t) {
    const auto point = [&](std::size_t i) { return typename K::Point_3(p[t[i]][0], p[t[i]][1], p[t[i]][2]); };
    return orientation(point(0), point(1), point(2)) == CGAL::POSITIVE;
  };

  std::vector<int> ages(n, 0), n_rings(n); // for how many rounds a vertex has moved, and how many rings around it do
  std::vector<std::uint32_t> moving;
  for(int round = 0; round < n_rounds; ++round)
  {
    moving.clear();
    std::fill(n_rings.begin(), n_rings.end(), -1);
    const auto add = [&](std::uint32_t v, int k) {
      if(k > n_rings[v])
      {
        n_rings[v] = k;
        moving.push_back(v); // perhaps again
      }
    };
    for(const Linked_triangle& t : images.triangles())
      if(!is_positive(t))
        for(const std::uint32_t v : t.vertices)
          add(v, ages[v] / rounds_for_each_ring);
    if(moving.empty())
      return p;
    if(!control.go_further(0, 0.))
      return std::nullopt;
    for(const std::uint32_t v : moving)
      ++ages[v];
    for(std::size_t k = 0; k < moving.size(); ++k)
      if(const std::uint32_t v = moving[k]; n_rings[v] > 0)
        for(const std::uint32_t w : rings.ring(v))
          add(w, n_rings[v] - 1);
    std::sort(moving.begin(), moving.end());
    moving.erase(std::unique(moving.begin(), moving.end()), moving.end());
    for(int k = 0; k < n_passes; ++k)
      for(const std::uint32_t v : moving)
      {
        const Vector_3d mean = mean_of_neighbors(rings.ring(v), rigid[v], rigid, p);
        const double size = length(mean);
        p[v] = size > 0. && is_finite(size) ? (1. / size) * mean : p[v];
      }
  }
  return std::nullopt;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SPHERE_BENDING_H
