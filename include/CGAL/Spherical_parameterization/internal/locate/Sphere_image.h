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
#include <CGAL/Spherical_parameterization/internal/locate/Cube_place.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// An image on the sphere with several values for each direction, on the faces of a cube: fast to look up.
class Sphere_image
{
public:
  // Where the nodes of the cube are in a triangulation of the sphere, which has a grid.
  template <class K>
  static std::vector<typename Sphere_triangulation<K>::Place> places_of_nodes(const Sphere_triangulation<K>& sphere,
                                                                              const Execution& execution)
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
               const std::vector<std::vector<double>>& channels)
    : m_n_channels(channels.size())
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
  const double* nearest(const Vector_3d& p) const { return at_node(Cube_place(p, n_steps).nearest_node()); }

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
    const auto w = square.place.weights(), w1 = square.place.change_of_weights(t1),
               w2 = square.place.change_of_weights(t2);
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
  // along an edge of the cube: 1.9 degrees at most, half as far as the vertices of a Sphere_grid are from each other
  static constexpr std::size_t n_steps = 48;

  const double* at_node(std::size_t node) const { return &m_values[node * m_n_channels]; }

  // The values around a direction.
  struct Square
  {
    Square(const Sphere_image& image, const Vector_3d& p)
      : place(p, n_steps)
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

  std::size_t m_n_channels;
  std::vector<double> m_values;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_SPHERE_IMAGE_H
