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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_OCTAHEDRAL_GRID_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_OCTAHEDRAL_GRID_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Spherical_parameterization::internal {

// A grid of n x n cells over the directions: the octahedron |x| + |y| + |z| = 1 with its lower half unfolded, which is
// a square. The areas of cells on the sphere differ by a factor of about 5.
class Octahedral_grid
{
public:
  explicit Octahedral_grid(std::uint32_t n = 1)
    : m_n(n)
  {}

  std::size_t number_of_cells() const { return std::size_t(m_n) * m_n; }

  // the cell of a direction, which need not be finite
  std::uint32_t cell(const Vector_3d& q) const
  {
    const std::array<double, 2> p = unfolded(q);
    return part_of(p[0], m_n) + m_n * part_of(p[1], m_n);
  }

  // Calls f(cell, center) for all cells, each of them next to the one before.
  template <class Function>
  void for_each_cell(const Function& f) const
  {
    const double size = 2. / m_n;
    for(std::uint32_t j = 0; j < m_n; ++j)
      for(std::uint32_t k = 0; k < m_n; ++k)
      {
        const std::uint32_t i = j % 2 == 0 ? k : m_n - 1 - k;
        f(i + m_n * j, folded({(i + 0.5) * size - 1., (j + 0.5) * size - 1.}));
      }
  }

  // The place of a direction along the Morton curve through 2^16 x 2^16 cells.
  static std::uint32_t place_on_curve(const Vector_3d& q)
  {
    const std::array<double, 2> p = unfolded(q);
    return spread_bits(part_of(p[0], 1u << 16)) | spread_bits(part_of(p[1], 1u << 16)) << 1;
  }

private:
  // the place in [-1, 1]^2 of a direction
  static std::array<double, 2> unfolded(const Vector_3d& q)
  {
    const double s = std::abs(q[0]) + std::abs(q[1]) + std::abs(q[2]);
    const double u = q[0] / s, v = q[1] / s;
    if(q[2] < 0.)
      return {std::copysign(1. - std::abs(v), u), std::copysign(1. - std::abs(u), v)};
    return {u, v};
  }

  static Vector_3d folded(const std::array<double, 2>& p)
  {
    const double z = 1. - std::abs(p[0]) - std::abs(p[1]);
    if(z < 0.)
      return {std::copysign(1. - std::abs(p[1]), p[0]), std::copysign(1. - std::abs(p[0]), p[1]), z};
    return {p[0], p[1], z};
  }

  // which of n parts of [-1, 1] x is in; the first one for what is none of them, such as NaN
  static std::uint32_t part_of(double x, std::uint32_t n)
  {
    const double part = 0.5 * (x + 1.) * n;
    return part > 0. && part < 0x1p31 ? (std::min)(static_cast<std::uint32_t>(part), n - 1) : 0;
  }

  // bit k of a number of 16 bits becomes bit 2 k
  static std::uint32_t spread_bits(std::uint32_t x)
  {
    x = (x | x << 8) & 0x00FF00FFu;
    x = (x | x << 4) & 0x0F0F0F0Fu;
    x = (x | x << 2) & 0x33333333u;
    return (x | x << 1) & 0x55555555u;
  }

  std::uint32_t m_n;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_OCTAHEDRAL_GRID_H
