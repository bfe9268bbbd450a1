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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_CUBE_PLACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_CUBE_PLACE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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
    m_scale = half / std::abs(p[m_axis]);
    m_slope = {p[axis(1)] / p[m_axis], p[axis(2)] / p[m_axis]};
    const double x = (std::min)((std::max)(half + m_scale * p[axis(1)], 0.), 2. * half);
    const double y = (std::min)((std::max)(half + m_scale * p[axis(2)], 0.), 2. * half);
    const std::size_t i = (std::min)(static_cast<std::size_t>(x), n - 1);
    const std::size_t j = (std::min)(static_cast<std::size_t>(y), n - 1);
    m_first = ((2 * m_axis + is_negative) * (n + 1) + i) * (n + 1) + j;
    m_u = x - static_cast<double>(i);
    m_v = y - static_cast<double>(j);
  }

  // the corners of the square
  std::array<std::size_t, 4> nodes() const { return {m_first, m_first + 1, m_first + m_n + 1, m_first + m_n + 2}; }
  std::size_t nearest_node() const { return m_first + (m_u < 0.5 ? 0 : m_n + 1) + (m_v < 0.5 ? 0 : 1); }

  // The bilinear weights of the corners, and how these change as the direction moves along t.
  std::array<double, 4> weights() const
  {
    return {(1. - m_u) * (1. - m_v), (1. - m_u) * m_v, m_u * (1. - m_v), m_u * m_v};
  }
  std::array<double, 4> change_of_weights(const Vector_3d& t) const
  {
    const double du = m_scale * (t[axis(1)] - m_slope[0] * t[m_axis]),
                 dv = m_scale * (t[axis(2)] - m_slope[1] * t[m_axis]);
    return {-(1. - m_v) * du - (1. - m_u) * dv, -m_v * du + (1. - m_u) * dv, (1. - m_v) * du - m_u * dv,
            m_v * du + m_u * dv};
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
  double m_scale, m_u, m_v;
  std::array<double, 2> m_slope;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_CUBE_PLACE_H
