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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGNMENT_SPHERE_IMAGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGNMENT_SPHERE_IMAGE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/alignment/Sphere_grid.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/simd/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Values on the sphere, some for each direction, on the faces of a cube: fast to look up.
class Cube_raster
{
public:
  static constexpr std::size_t size = 48; // of the edges of the cube, in steps

  // The steps on all faces with the places in a grid that they have.
  Cube_raster(const Sphere_grid& grid, const Execution& execution)
  {
    std::vector<Sphere_grid::Kernel::Point_3> nodes;
    for(std::size_t side = 0; side < 6; ++side)
      for(std::size_t i = 0; i <= size; ++i)
        for(std::size_t j = 0; j <= size; ++j)
        {
          Vector_3d p;
          p[side / 2] = side % 2 == 0 ? 1. : -1.;
          p[(side / 2 + 1) % 3] = 2. * static_cast<double>(i) / size - 1.;
          p[(side / 2 + 2) % 3] = 2. * static_cast<double>(j) / size - 1.;
          nodes.emplace_back(p[0], p[1], p[2]);
        }
    m_places = grid.triangulation().locate(nodes, execution);
  }

  const std::vector<Sphere_grid::Triangulation::Place>& places() const { return m_places; }

  // the node that is nearest to a direction, in the face of the cube that it leads to
  static std::size_t nearest(const Vector_3d& p)
  {
    const Position q = position(p);
    return q.first + static_cast<std::size_t>(q.x + 0.5) * (size + 1) + static_cast<std::size_t>(q.y + 0.5);
  }

  struct Position
  {
    std::size_t first; // node of the face
    double x, y;       // from 0 to `size`
  };

  static Position position(const Vector_3d& p)
  {
    const double a = std::abs(p[0]), b = std::abs(p[1]), c = std::abs(p[2]);
    const std::size_t axis = a >= b && a >= c ? 0 : b >= c ? 1 : 2;
    const double scale = 0.5 * size / std::abs(p[axis]);
    const auto coordinate = [&](std::size_t k) {
      return (std::min)((std::max)(0.5 * size + scale * p[k], 0.), static_cast<double>(size));
    };
    return {(2 * axis + (p[axis] < 0. ? 1 : 0)) * (size + 1) * (size + 1), coordinate((axis + 1) % 3),
            coordinate((axis + 2) % 3)};
  }

private:
  std::vector<Sphere_grid::Triangulation::Place> m_places;
};

// An image with several values for each direction, made of those at the vertices of a grid.
class Sphere_image
{
public:
  Sphere_image(const Sphere_grid& grid, const Cube_raster& raster, const std::vector<std::vector<double>>& channels)
    : m_n_channels(channels.size())
    , m_values(raster.places().size() * channels.size())
  {
    for(std::size_t i = 0; i < raster.places().size(); ++i)
    {
      const auto& place = raster.places()[i];
      const Linked_triangle& t = grid.triangles()[place.triangle];
      for(std::size_t k = 0; k < m_n_channels; ++k)
        m_values[i * m_n_channels + k] = place.coordinates[0] * channels[k][t[0]] +
                                         place.coordinates[1] * channels[k][t[1]] +
                                         place.coordinates[2] * channels[k][t[2]];
    }
  }

  std::size_t number_of_channels() const { return m_n_channels; }

  const double* at_node(std::size_t node) const { return &m_values[node * m_n_channels]; }

  void interpolate(const Vector_3d& p, double* result) const
  {
    const Cube_raster::Position q = Cube_raster::position(p);
    constexpr std::size_t last = Cube_raster::size - 1;
    const std::size_t i = (std::min)(static_cast<std::size_t>(q.x), last);
    const std::size_t j = (std::min)(static_cast<std::size_t>(q.y), last);
    const double u = q.x - static_cast<double>(i), v = q.y - static_cast<double>(j);
    const std::size_t node = q.first + i * (Cube_raster::size + 1) + j;
    const double* const a = at_node(node);
    const double* const b = at_node(node + Cube_raster::size + 1);
    for(std::size_t k = 0; k < m_n_channels; ++k)
      result[k] =
          (1. - u) * ((1. - v) * a[k] + v * a[k + m_n_channels]) + u * ((1. - v) * b[k] + v * b[k + m_n_channels]);
  }

private:
  std::size_t m_n_channels;
  std::vector<double> m_values;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGNMENT_SPHERE_IMAGE_H
