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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_SPHERE_IMAGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_SPHERE_IMAGE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Where a direction is on a cube around the sphere, whose sides have n x n squares: in which of them, and between which
// nodes. An image with values at the nodes is looked up by it, without a search.
//
// The nodes are numbered side by side, and on a side row by row; those on the edges of the cube are on two sides or three.
class Cube_place
{
public:
  Cube_place(const Vector_3d& p, std::size_t n)
    : m_n(n)
  {
    const double a = std::abs(p[0]), b = std::abs(p[1]), c = std::abs(p[2]);
    m_axis = a >= b && a >= c ? 0 : b >= c ? 1 : 2;
    const bool is_negative = p[m_axis] < 0.;
    const double half = 0.5 * static_cast<double>(n);
    m_inverse = 1. / p[m_axis];
    m_scale = half * std::abs(m_inverse);
    m_slope = {m_inverse * p[axis(1)], m_inverse * p[axis(2)]};
    const double x = std::clamp(half + m_scale * p[axis(1)], 0., 2. * half);
    const double y = std::clamp(half + m_scale * p[axis(2)], 0., 2. * half);
    const std::size_t i = (std::min)(static_cast<std::size_t>(x), n - 1);
    const std::size_t j = (std::min)(static_cast<std::size_t>(y), n - 1);
    m_first = ((2 * m_axis + is_negative) * (n + 1) + i) * (n + 1) + j;
    m_u = x - static_cast<double>(i);
    m_v = y - static_cast<double>(j);
  }

  // the corners of the square
  std::array<std::size_t, 4> nodes() const { return {m_first, m_first + 1, m_first + m_n + 1, m_first + m_n + 2}; }
  std::size_t nearest_node() const { return m_first + (m_u < 0.5 ? 0 : m_n + 1) + (m_v < 0.5 ? 0 : 1); }

  // A vector less a multiple of the direction, so that it is in the plane of the side: its two coordinates there.
  std::array<double, 2> flattened(const Vector_3d& t) const
  {
    return {t[axis(1)] - m_slope[0] * t[m_axis], t[axis(2)] - m_slope[1] * t[m_axis]};
  }
  // That multiple, in units of the vector `p` that the place was made of. As p moves along t, flattened(e) changes by
  // -height(e) flattened(t).
  double height(const Vector_3d& t) const { return m_inverse * t[m_axis]; }

  // The bilinear weights of the corners, and how these change as `p` moves along a vector that has been flattened.
  std::array<double, 4> weights() const
  {
    return {(1. - m_u) * (1. - m_v), (1. - m_u) * m_v, m_u * (1. - m_v), m_u * m_v};
  }
  std::array<double, 4> change_of_weights(const std::array<double, 2>& t) const
  {
    const double du = m_scale * t[0], dv = m_scale * t[1];
    return {-(1. - m_v) * du - (1. - m_u) * dv, -m_v * du + (1. - m_u) * dv, (1. - m_v) * du - m_u * dv,
            m_v * du + m_u * dv};
  }

  // The half of the square, cut along its diagonal, that the direction is in: its number, its corners, and the weights
  // that interpolate linearly in it.
  struct Half
  {
    std::size_t index;
    std::array<std::size_t, 3> nodes;
    std::array<double, 3> weights;
  };
  Half half() const
  {
    const std::size_t last = m_first + m_n + 2;
    return m_u > m_v ? Half{2 * m_first + 1, {m_first, m_first + m_n + 1, last}, {1. - m_u, m_u - m_v, m_v}}
                     : Half{2 * m_first, {m_first, m_first + 1, last}, {1. - m_v, m_v - m_u, m_u}};
  }

  // A point of a side, with coordinates from -1 to 1.
  static Vector_3d point(std::size_t side, double u, double v)
  {
    Vector_3d result;
    result[side / 2] = side % 2 == 0 ? 1. : -1.;
    result[(side / 2 + 1) % 3] = u;
    result[(side / 2 + 2) % 3] = v;
    return result;
  }

  // Calls f(side, u, v) for all nodes, in the order of their numbers.
  template <class Function>
  static void for_each_node(std::size_t n, const Function& f)
  {
    const double step = 2. / static_cast<double>(n);
    for(std::size_t side = 0; side < 6; ++side)
      for(std::size_t i = 0; i <= n; ++i)
        for(std::size_t j = 0; j <= n; ++j)
          f(side, step * static_cast<double>(i) - 1., step * static_cast<double>(j) - 1.);
  }

private:
  std::size_t axis(std::size_t k) const { return m_axis + k < 3 ? m_axis + k : m_axis + k - 3; }

  std::size_t m_n, m_axis, m_first;
  double m_inverse, m_scale, m_u, m_v;
  std::array<double, 2> m_slope;
};

// An image on the sphere with several values for each direction, on the faces of a cube: fast to look up.
class Sphere_image
{
public:
  // along an edge of the cube: 1.9 degrees at most, a quarter of how far the vertices of a Coarse_surface are from each other
  static constexpr std::size_t default_steps = 48;

  // Where the nodes of the cube are in a triangulation of the sphere, which has a grid.
  template <class K>
  static std::vector<typename Sphere_triangulation<K>::Place> places_of_nodes(const Sphere_triangulation<K>& sphere,
                                                                              const Execution& execution,
                                                                              std::size_t n_steps = default_steps)
  {
    std::vector<typename K::Point_3> nodes;
    Cube_place::for_each_node(n_steps, [&](std::size_t side, double u, double v) {
      const Vector_3d p = Cube_place::point(side, u, v);
      nodes.emplace_back(p[0], p[1], p[2]);
    });
    return sphere.locate(nodes, execution);
  }

  // Interpolates channels that have a value for each vertex of that triangulation.
  template <class Place>
  Sphere_image(const std::vector<Place>& places_of_nodes, const std::vector<Linked_triangle>& triangles,
               const std::vector<std::vector<double>>& channels, std::size_t n_steps = default_steps)
    : m_n_steps(n_steps)
    , m_n_channels(channels.size())
    , m_values(places_of_nodes.size() * channels.size())
  {
    for(std::size_t i = 0; i < places_of_nodes.size(); ++i)
    {
      const Place& place = places_of_nodes[i];
      const Linked_triangle& t = triangles[place.triangle];
      for(std::size_t k = 0; k < m_n_channels; ++k)
        m_values[i * m_n_channels + k] = place.coordinates[0] * channels[k][t[0]] +
                                         place.coordinates[1] * channels[k][t[1]] +
                                         place.coordinates[2] * channels[k][t[2]];
    }
  }

  std::size_t number_of_channels() const { return m_n_channels; }

  // the values at the node that is nearest to a direction, in the side of the cube that it leads to
  const double* nearest(const Vector_3d& p) const { return at_node(Cube_place(p, m_n_steps).nearest_node()); }

  void interpolate(const Vector_3d& p, double* result) const
  {
    const Square square(*this, p);
    const auto w = square.place.weights();
    for(std::size_t k = 0; k < m_n_channels; ++k)
      result[k] = square.mixed(k, w);
  }

  // The sum of the squares of the differences from given values.
  double squared_difference(const Vector_3d& p, const double* values) const
  {
    const Square square(*this, p);
    const auto w = square.place.weights();
    double result = 0.;
    for(std::size_t k = 0; k < m_n_channels; ++k)
    {
      const double difference = square.mixed(k, w) - values[k];
      result += difference * difference;
    }
    return result;
  }

  // The same with half of its derivatives in two tangential directions; the second ones are those of Gauss and Newton,
  // without those of the image.
  double squared_difference(const Vector_3d& p, const double* values, const Vector_3d& t1, const Vector_3d& t2,
                            std::array<double, 2>& gradient, std::array<double, 3>& hessian) const
  {
    const Square square(*this, p);
    const auto w = square.place.weights(), w1 = square.place.change_of_weights(square.place.flattened(t1)),
               w2 = square.place.change_of_weights(square.place.flattened(t2));
    double result = 0.;
    gradient = {0., 0.};
    hessian = {0., 0., 0.};
    for(std::size_t k = 0; k < m_n_channels; ++k)
    {
      const double difference = square.mixed(k, w) - values[k], x = square.mixed(k, w1), y = square.mixed(k, w2);
      result += difference * difference;
      gradient[0] += difference * x;
      gradient[1] += difference * y;
      hessian[0] += x * x;
      hessian[1] += x * y;
      hessian[2] += y * y;
    }
    return result;
  }

private:
  const double* at_node(std::size_t node) const { return &m_values[node * m_n_channels]; }

  // The values around a direction.
  struct Square
  {
    Square(const Sphere_image& image, const Vector_3d& p)
      : place(p, image.m_n_steps)
    {
      const auto nodes = place.nodes();
      for(std::size_t i = 0; i < 4; ++i)
        corners[i] = image.at_node(nodes[i]);
    }

    double mixed(std::size_t k, const std::array<double, 4>& w) const
    {
      return w[0] * corners[0][k] + w[1] * corners[1][k] + w[2] * corners[2][k] + w[3] * corners[3][k];
    }

    Cube_place place;
    std::array<const double*, 4> corners;
  };

  std::size_t m_n_steps, m_n_channels;
  std::vector<double> m_values;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_SPHERE_IMAGE_H
