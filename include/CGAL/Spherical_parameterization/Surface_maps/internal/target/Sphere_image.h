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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_SPHERE_IMAGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_SPHERE_IMAGE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Sphere_mesh.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Cube_location.h>

#include <cmath>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The bilinear interpolation between the corners (0, 0), (0, 1), (1, 0) and (1, 1) of a square, and its derivatives.
template <class T>
struct Bilinear
{
  Bilinear(const T& c00, const T& c01, const T& c10, const T& c11, const T& u, const T& v)
  {
    const T to_v = c01 - c00, twist = c11 - c10 - to_v;
    along_u = c10 - c00 + v * twist;
    along_v = to_v + u * twist;
    value = c00 + u * along_u + v * to_v;
  }

  T value, along_u, along_v;
};

// The directions of the nodes of an image on the faces of a cube.
inline std::vector<Vector_3d> nodes_of_cube(std::size_t n_steps)
{
  std::vector<Vector_3d> result;
  Cube_location::for_each_node(
      n_steps, [&](std::size_t side, double u, double v) { result.push_back(Cube_location::point(side, u, v)); });
  return result;
}

// An image on the sphere with several values for each direction, stored on the faces of a cube for fast access.
class Sphere_image
{
public:
  // Along an edge of the cube. Nodes are 1.9 degrees apart in the mean, less than half the distance of the vertices of a
  // Surface_descriptor.
  static constexpr std::size_t default_steps = 48;

  using Locations = std::vector<Sphere_mesh::Triangle_location>;

  // Locates the nodes of the cube in a triangulation of the sphere, which must have a grid.
  static Locations locate_nodes(const Sphere_mesh& sphere, const Execution& execution,
                                std::size_t n_steps = default_steps)
  {
    return sphere.locate(points_of(nodes_of_cube(n_steps)), execution);
  }

  // Interpolates channels, which have one value for each vertex of that triangulation.
  Sphere_image(const Locations& nodes, const std::vector<Linked_triangle>& triangles,
               const std::vector<std::vector<double>>& channels, std::size_t n_steps = default_steps)
    : m_n_steps(n_steps)
    , m_n_channels(channels.size())
    , m_row(row_size(channels.size()))
    , m_values(nodes.size() * m_row, 0.)
  {
    for(std::size_t i = 0; i < nodes.size(); ++i)
      for(std::size_t k = 0; k < m_n_channels; ++k)
        m_values[i * m_row + k] = interpolated(channels[k], triangles, nodes[i]);
  }

  std::size_t number_of_channels() const { return m_n_channels; }

  // The number of values that are stored per node, a multiple of the number of lanes. The additional values are 0.
  static std::size_t row_size(std::size_t n_channels) { return (n_channels + 3) / 4 * 4; }

  // For a direction in each lane, the values at the nearest node of the side of the cube that contains the direction.
  template <class FT>
  std::array<const double*, Lanes<FT>::width> nearest(const Vector_3<FT>& p) const
  {
    const Basic_cube_location<FT> location(p, m_n_steps);
    std::array<const double*, Lanes<FT>::width> result;
    for(std::size_t l = 0; l < result.size(); ++l)
      result[l] = at_node(location.nearest_node(l));
    return result;
  }

  void interpolate(const Vector_3d& p, double* result) const
  {
    const Cube_location location(p, m_n_steps);
    const auto c = corners(location, 0);
    const auto w = location.weights();
    for(std::size_t k = 0; k < m_n_channels; ++k)
      result[k] = w[0] * c[0][k] + w[1] * c[1][k] + w[2] * c[2][k] + w[3] * c[3][k];
  }

  // For a direction in each lane, the sum of the squared differences from given values, which are rows of row_size() numbers.
  template <class FT>
  FT squared_difference(const Vector_3<FT>& p, const std::array<const double*, Lanes<FT>::width>& values) const
  {
    const Basic_cube_location<FT> location(p, m_n_steps);
    const auto weights = location.weights();
    return Lanes<FT>::generate([&](std::size_t l) {
      const auto c = corners(location, l);
      const std::array<Channels, 4> w = {lane(weights[0], l), lane(weights[1], l), lane(weights[2], l),
                                         lane(weights[3], l)};
      Channels sum = 0.;
      for(std::size_t k = 0; k < m_row; k += Lanes<Channels>::width)
      {
        const auto at = [&](const double* row) { return Lanes<Channels>::load(row + k); };
        const Channels difference =
            w[0] * at(c[0]) + w[1] * at(c[1]) + w[2] * at(c[2]) + w[3] * at(c[3]) - at(values[l]);
        sum += difference * difference;
      }
      return sum_of_lanes(sum);
    });
  }

  // The same sum, with half of its first and second derivatives in two tangential directions. Second derivatives are those of the
  // Gauss-Newton method, without the second derivatives of the image.
  template <class FT>
  FT squared_difference(const Vector_3<FT>& p, const std::array<const double*, Lanes<FT>::width>& values,
                        const Vector_3<FT>& t1, const Vector_3<FT>& t2, std::array<FT, 2>& gradient,
                        std::array<FT, 3>& hessian) const
  {
    constexpr std::size_t width = Lanes<FT>::width;
    const Basic_cube_location<FT> location(p, m_n_steps);
    // Sums of products of the difference and its derivatives, for each lane.
    std::array<std::array<double, width>, 6> sums;
    for(std::size_t l = 0; l < width; ++l)
    {
      const auto c = corners(location, l);
      const Channels u = lane(location.u(), l), v = lane(location.v(), l);
      std::array<Channels, 6> sum = {0., 0., 0., 0., 0., 0.};
      for(std::size_t k = 0; k < m_row; k += Lanes<Channels>::width)
      {
        const auto at = [&](const double* row) { return Lanes<Channels>::load(row + k); };
        const Bilinear<Channels> image(at(c[0]), at(c[1]), at(c[2]), at(c[3]), u, v);
        const Channels difference = image.value - at(values[l]);
        sum[0] += difference * difference;
        sum[1] += difference * image.along_u;
        sum[2] += difference * image.along_v;
        sum[3] += image.along_u * image.along_u;
        sum[4] += image.along_u * image.along_v;
        sum[5] += image.along_v * image.along_v;
      }
      for(std::size_t i = 0; i < 6; ++i)
        sums[i][l] = sum_of_lanes(sum[i]);
    }
    const auto in_lanes = [&](std::size_t i) { return Lanes<FT>::load(sums[i].data()); };
    const FT du = in_lanes(1), dv = in_lanes(2), uu = in_lanes(3), uv = in_lanes(4), vv = in_lanes(5);
    const auto x = location.change(location.flattened(t1)), y = location.change(location.flattened(t2));
    gradient = {du * x[0] + dv * x[1], du * y[0] + dv * y[1]};
    const std::array<FT, 2> to_x = {uu * x[0] + uv * x[1], uv * x[0] + vv * x[1]};
    hessian = {x[0] * to_x[0] + x[1] * to_x[1], y[0] * to_x[0] + y[1] * to_x[1],
               y[0] * (uu * y[0] + uv * y[1]) + y[1] * (uv * y[0] + vv * y[1])};
    return in_lanes(0);
  }

private:
  using Channels = Four_lanes; // several channels at once

  const double* at_node(std::size_t node) const { return m_values.data() + node * m_row; }

  // The rows of the nodes around a location.
  template <class FT>
  std::array<const double*, 4> corners(const Basic_cube_location<FT>& location, std::size_t lane) const
  {
    const auto nodes = location.nodes(lane);
    return {at_node(nodes[0]), at_node(nodes[1]), at_node(nodes[2]), at_node(nodes[3])};
  }

  std::size_t m_n_steps, m_n_channels, m_row;
  std::vector<double> m_values;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_SPHERE_IMAGE_H
