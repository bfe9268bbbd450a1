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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STAR_VIEW_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STAR_VIEW_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Lanes.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// One star, or several of them lane by lane, where they lie in memory: the numbers of the vertices and their
// neighbours, and the rest shapes of the faces. Corner j of lane k is the one of the face (vertex, neighbor j,
// neighbor j + 1) and has the index first + j * stride + k in the arrays of the neighbors and, by rest_index(), of the
// rest shapes. A star that has fewer faces than others of its packet has its first neighbor in the remaining corners, and
// 0 in the place of the rest shapes.
template <class FT>
class Star_view
{
public:
  Star_view() = default;
  Star_view(const std::uint32_t* vertices, const std::uint32_t* neighbors, const double* rest, std::size_t first,
            std::size_t stride, std::size_t size)
    : m_vertices(vertices)
    , m_neighbors(neighbors)
    , m_rest(rest)
    , m_first(first)
    , m_stride(stride)
    , m_size(size)
  {}

  std::size_t size() const { return m_size; }

  Vector_3<FT> center(const Vector_3d* positions) const { return points(m_vertices, positions); }
  Vector_3<FT> neighbor(std::size_t j, const Vector_3d* positions) const
  {
    return points(m_neighbors + m_first + j * m_stride, positions);
  }

  // see Rest_triangle
  FT opposite_0(std::size_t j) const { return rest(j, 0); }
  FT opposite_1(std::size_t j) const { return rest(j, 1); }
  FT opposite_2(std::size_t j) const { return rest(j, 2); }
  FT inverse_area(std::size_t j) const { return rest(j, 3); }

  // Where number k of the rest shape of a corner is: those of eight corners lie side by side.
  static std::size_t rest_index(std::size_t corner, std::size_t k)
  {
    return 4 * (corner - corner % 8) + 8 * k + corner % 8;
  }

private:
  FT rest(std::size_t j, std::size_t k) const
  {
    return Lanes<FT>::load(m_rest + rest_index(m_first + j * m_stride, k));
  }

  static Vector_3<FT> points(const std::uint32_t* vertices, const Vector_3d* positions)
  {
    const auto coordinate = [&](std::size_t i) {
      return Lanes<FT>::generate([&](std::size_t lane) { return positions[vertices[lane]][i]; });
    };
    return {coordinate(0), coordinate(1), coordinate(2)};
  }

  const std::uint32_t* m_vertices = nullptr;
  const std::uint32_t* m_neighbors = nullptr;
  const double* m_rest = nullptr;
  std::size_t m_first = 0, m_stride = 0, m_size = 0;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STAR_VIEW_H
