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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGES_GEOMETRY_IMAGE_LAYOUT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGES_GEOMETRY_IMAGE_LAYOUT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/internal/sampling/Subdivided_solid.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Which vertex of a domain each pixel of a geometry image shows: of an octahedron that is unfolded to a square, or of
// the faces of a cube, one below the other.
class Geometry_image_layout
{
public:
  using Index = std::uint32_t;

  // the layout for a mesh with so many vertices, which are those of an octahedron or of a cube
  static std::optional<Geometry_image_layout> of_vertices(std::size_t n_vertices)
  {
    for(const bool is_cube : {false, true})
    {
      const unsigned int factor = is_cube ? 6 : 4;
      const auto n = n_vertices < 2 ? 0 : std::llround(std::sqrt(static_cast<double>(n_vertices - 2) / factor));
      if(n > 0 && n <= Sphere_domain_3::max_subdivision &&
         factor * static_cast<std::size_t>(n) * static_cast<std::size_t>(n) + 2 == n_vertices)
        return Geometry_image_layout(is_cube, static_cast<Index>(n));
    }
    return std::nullopt;
  }

  // the layout of an image of this size
  static std::optional<Geometry_image_layout> of_size(std::size_t width, std::size_t height)
  {
    const bool is_cube = height == 6 * width;
    const std::size_t n = is_cube ? width - 1 : (width - 1) / 2;
    if(width < 2 || n == 0 || n > Sphere_domain_3::max_subdivision || (!is_cube && (height != width || width % 2 == 0)))
      return std::nullopt;
    return Geometry_image_layout(is_cube, static_cast<Index>(n));
  }

  std::size_t width() const { return m_width; }
  std::size_t height() const { return m_vertices.size() / m_width; }

  // the vertices that the pixels show, row by row
  const std::vector<Index>& vertices() const { return m_vertices; }

  Sphere_domain_3 domain() const { return m_is_cube ? Sphere_domain_3::cube(m_n) : Sphere_domain_3::octahedron(m_n); }

private:
  Geometry_image_layout(bool is_cube, Index n)
    : m_is_cube(is_cube)
    , m_n(n)
    , m_width(is_cube ? n + 1 : 2 * n + 1)
    , m_vertices(m_width * m_width * (is_cube ? 6 : 1))
  {
    if(is_cube)
      lay_out_cube();
    else
      lay_out_octahedron();
  }

  // Divided evenly, the solid has its vertices on the points of a lattice, with the numbers that they have when it is
  // divided otherwise.
  static std::vector<double> even_weights(Index n)
  {
    std::vector<double> weights;
    for(Index i = 0; i <= n; ++i)
      weights.push_back(i);
    return weights;
  }

  // the point of the lattice in a direction, in which `size` is n
  std::array<int, 3> lattice_point(const Vector_3d& direction, double size) const
  {
    std::array<int, 3> result;
    for(std::size_t k = 0; k < 3; ++k)
      result[k] = static_cast<int>(std::lround(direction[k] / size * m_n));
    return result;
  }

  // The upper half of the octahedron is in the middle of the square; each of the four lower faces is folded out at the
  // edge that it has there, so that what is on its other edges is in two places, or in four.
  void lay_out_octahedron()
  {
    const Subdivided_solid<3> solid = subdivided_octahedron(even_weights(m_n));
    const int n = static_cast<int>(m_n);
    for(Index v = 0; v < solid.directions.size(); ++v)
    {
      const Vector_3d& p = solid.directions[v];
      const auto [x, y, z] = lattice_point(p, std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]));
      for(const int sign_x : {-1, 1})
        for(const int sign_y : {-1, 1})
          if(z >= 0)
            pixel(n + x, n + y) = v;
          else if(sign_x * x >= 0 && sign_y * y >= 0)
            pixel(n + sign_x * (n - std::abs(y)), n + sign_y * (n - std::abs(x))) = v;
    }
  }

  void lay_out_cube()
  {
    const Subdivided_solid<4> solid = subdivided_cube(even_weights(m_n));
    const int n = static_cast<int>(m_n);
    for(Index v = 0; v < solid.directions.size(); ++v)
    {
      const Vector_3d& p = solid.directions[v];
      const std::array<int, 3> q = lattice_point(p, (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}));
      for(std::size_t face = 0; face < cube_faces.size(); ++face)
      {
        // Along the face from its first corner a to b and to d
        const auto corner = [&](std::size_t i, std::size_t k) { return (cube_faces[face][i] >> k & 1) ? 1 : -1; };
        int i = 0, j = 0;
        bool is_in_face = true;
        for(std::size_t k = 0; k < 3; ++k)
        {
          const int a = corner(0, k), u = corner(1, k) - a, w = corner(3, k) - a;
          i += u * (q[k] - a * n);
          j += w * (q[k] - a * n);
          is_in_face = is_in_face && (u != 0 || w != 0 || q[k] == a * n);
        }
        if(is_in_face)
          pixel(i / 4, static_cast<int>(face) * (n + 1) + j / 4) = v;
      }
    }
  }

  Index& pixel(int column, int row)
  {
    return m_vertices[static_cast<std::size_t>(row) * m_width + static_cast<std::size_t>(column)];
  }

  bool m_is_cube;
  Index m_n;
  std::size_t m_width;
  std::vector<Index> m_vertices;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGES_GEOMETRY_IMAGE_LAYOUT_H
