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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_CUBE_LOCATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_CUBE_LOCATION_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The location of a direction on a cube around the sphere, whose sides have n x n squares: the square that contains it,
// and the nodes at the corners of the square. It gives access to an image with values at the nodes, without a search.
// With a packed number type, it is the location of a direction in each lane.
//
// The nodes are numbered side by side, and on a side row by row; those on the edges of the cube occur two or three
// times.
template <class FT>
class Basic_cube_location
{
  static constexpr std::size_t width = Lanes<FT>::width;

public:
  Basic_cube_location(const Vector_3<FT>& p, std::size_t n)
    : m_n(n)
    , m_is_along_x(!(absolute(p[0]) < absolute(p[1])) && !(absolute(p[0]) < absolute(p[2])))
    , m_is_along_y(!(absolute(p[1]) < absolute(p[2])))
  {
    const Vector_3<FT> q = turned(p);
    const FT half = 0.5 * static_cast<double>(n), whole = static_cast<double>(n);
    m_inverse = 1. / q[2];
    m_scale = half * absolute(m_inverse);
    m_slope = {m_inverse * q[0], m_inverse * q[1]};
    const FT x = maximum(FT(0.), minimum(half + m_scale * q[0], whole)),
             y = maximum(FT(0.), minimum(half + m_scale * q[1], whole));
    const FT side =
        select(m_is_along_x, FT(0.), select(m_is_along_y, FT(2.), FT(4.))) + select(q[2] < 0., FT(1.), FT(0.));
    const FT i = begin_of_step(x), j = begin_of_step(y);
    m_u = x - i;
    m_v = y - j;
    const FT row = whole + 1., first = (side * row + i) * row + j;
    for(std::size_t k = 0; k < width; ++k)
      m_first[k] = static_cast<std::size_t>(static_cast<std::int64_t>(lane(first, k)));
  }

  // The corners of the square in a lane.
  std::array<std::size_t, 4> nodes(std::size_t lane = 0) const
  {
    const std::size_t first = m_first[lane];
    return {first, first + 1, first + m_n + 1, first + m_n + 2};
  }
  std::size_t nearest_node(std::size_t k = 0) const
  {
    return m_first[k] + (lane(m_u, k) < 0.5 ? 0 : m_n + 1) + (lane(m_v, k) < 0.5 ? 0 : 1);
  }

  // A vector minus a multiple of the direction, so that it is in the plane of the side: its two coordinates there.
  std::array<FT, 2> flattened(const Vector_3<FT>& t) const
  {
    const Vector_3<FT> s = turned(t);
    return {s[0] - m_slope[0] * s[2], s[1] - m_slope[1] * s[2]};
  }
  // This multiple, in units of the vector `p` passed to the constructor. As p moves along t, flattened(e) changes by
  // -height(e) flattened(t).
  FT height(const Vector_3<FT>& t) const { return m_inverse * turned(t)[2]; }

  // The coordinates in the square, from 0 to 1, and their change as `p` moves along a vector that has been flattened.
  const FT& u() const { return m_u; }
  const FT& v() const { return m_v; }
  std::array<FT, 2> change(const std::array<FT, 2>& t) const { return {m_scale * t[0], m_scale * t[1]}; }

  // The bilinear weights of the corners.
  std::array<FT, 4> weights() const { return {(1. - m_u) * (1. - m_v), (1. - m_u) * m_v, m_u * (1. - m_v), m_u * m_v}; }

  // The half of the square, divided by its diagonal, that contains the direction: its index and its corners in each
  // lane, and the weights of linear interpolation in it.
  struct Half
  {
    std::array<std::size_t, width> index;
    std::array<std::array<std::size_t, width>, 3> nodes;
    std::array<FT, 3> weights;
  };
  Half half() const
  {
    const FT second = select(m_u > m_v, FT(1.), FT(0.));
    const FT smaller = minimum(m_u, m_v), larger = maximum(m_u, m_v);
    Half result;
    result.weights = {1. - larger, larger - smaller, smaller};
    for(std::size_t k = 0; k < width; ++k)
    {
      const std::size_t first = m_first[k], is_second = static_cast<std::size_t>(static_cast<int>(lane(second, k)));
      result.index[k] = 2 * first + is_second;
      result.nodes[0][k] = first;
      result.nodes[1][k] = first + 1 + is_second * m_n;
      result.nodes[2][k] = first + m_n + 2;
    }
    return result;
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

  // The nodes, and the side and the coordinates of one of them.
  static std::size_t number_of_nodes(std::size_t n) { return 6 * (n + 1) * (n + 1); }
  struct Node
  {
    std::size_t side;
    double u, v;
  };
  static Node node(std::size_t index, std::size_t n)
  {
    const double step = 2. / static_cast<double>(n);
    const std::size_t row = index / (n + 1), i = row % (n + 1), j = index % (n + 1);
    return {row / (n + 1), step * static_cast<double>(i) - 1., step * static_cast<double>(j) - 1.};
  }

  // Calls f(side, u, v) for all nodes, in the order of their indices.
  template <class Function>
  static void for_each_node(std::size_t n, const Function& f)
  {
    for(std::size_t index = 0; index < number_of_nodes(n); ++index)
    {
      const auto [side, u, v] = node(index, n);
      f(side, u, v);
    }
  }

private:
  using Condition = decltype(std::declval<FT>() < std::declval<FT>());

  // The coordinates of a vector with respect to the side: two in its plane, and the one along its axis.
  Vector_3<FT> turned(const Vector_3<FT>& t) const
  {
    return {select(m_is_along_x, t[1], select(m_is_along_y, t[2], t[0])),
            select(m_is_along_x, t[2], select(m_is_along_y, t[0], t[1])),
            select(m_is_along_x, t[0], select(m_is_along_y, t[1], t[2]))};
  }

  FT begin_of_step(const FT& x) const { return minimum(rounded_down(x), FT(static_cast<double>(m_n - 1))); }

  std::size_t m_n;
  Condition m_is_along_x, m_is_along_y; // the latter only if the former is false
  std::array<std::size_t, width> m_first;
  FT m_inverse, m_scale, m_u, m_v;
  std::array<FT, 2> m_slope;
};

using Cube_location = Basic_cube_location<double>;

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_CUBE_LOCATION_H
