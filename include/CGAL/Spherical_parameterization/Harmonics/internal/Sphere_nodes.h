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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERE_NODES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERE_NODES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Nodes on parallels of the sphere. Nodes on the same parallel share its Legendre functions; a direction that is not on
// a grid is the only node of its parallel. Parallels form groups of four for vector registers, and nodes on the equator
// pad the last group. Each node has the values of three functions; the order of the values is
// [group][function][longitude][lane].
class Sphere_nodes
{
public:
  static constexpr std::size_t lanes = 4, n_functions = 3;

  // Nodes at the given directions, which must have length 1.
  explicit Sphere_nodes(const std::vector<Vector_3d>& directions)
    : Sphere_nodes(directions.size(), 1, false)
  {
    for(std::size_t k = 0; k < directions.size(); ++k)
    {
      const Vector_3d& q = directions[k];
      const double r = hypotenuse(q[0], q[1]);
      set_parallel(k, q[2], r);
      if(r > 0.)
        set_longitude(k, q[0] / r, q[1] / r);
    }
  }

  // A grid with the given parallels, each with `width` equally spaced nodes.
  Sphere_nodes(const std::vector<double>& cosines_of_parallels, std::size_t width)
    : Sphere_nodes(cosines_of_parallels.size(), width, true)
  {
    for(std::size_t k = 0; k < cosines_of_parallels.size(); ++k)
    {
      const double x = cosines_of_parallels[k];
      set_parallel(k, x, std::sqrt((1. - x) * (1. + x)));
    }
    for(std::size_t i = 0; i < width; ++i)
    {
      const double longitude = 2. * CGAL_PI * static_cast<double>(i) / static_cast<double>(width);
      for(std::size_t k = 0; k < lanes; ++k)
        set_longitude(i * lanes + k, cosine(longitude), sine(longitude));
    }
  }

  std::size_t number_of_groups() const { return cosines.size() / lanes; }
  std::size_t number_of_parallels() const { return m_n_parallels; }
  std::size_t width() const { return m_width; }
  std::size_t size_of_group() const { return n_functions * m_width * lanes; }
  std::size_t number_of_values() const { return number_of_groups() * size_of_group(); }

  // index of the value of a function at a node
  std::size_t place(std::size_t parallel, std::size_t i, std::size_t function) const
  {
    return ((parallel / lanes * n_functions + function) * m_width + i) * lanes + parallel % lanes;
  }

  // index of the first longitude of a group; all parallels of a grid share the same longitudes
  std::size_t first_longitude(std::size_t group) const { return m_is_grid ? 0 : group * lanes; }

  Vector_3d direction(std::size_t parallel, std::size_t i) const
  {
    const std::size_t k = m_is_grid ? i * lanes : parallel;
    return {sines[parallel] * cosines_of_longitudes[k], sines[parallel] * sines_of_longitudes[k], cosines[parallel]};
  }

  std::vector<double> cosines, sines; // of the angles between the parallels and the z-axis
  std::vector<double> cosines_of_longitudes, sines_of_longitudes;

private:
  Sphere_nodes(std::size_t n_parallels, std::size_t width, bool is_grid)
    : m_n_parallels(n_parallels)
    , m_width(width)
    , m_is_grid(is_grid)
  {
    const std::size_t n = (n_parallels + lanes - 1) / lanes * lanes;
    cosines.assign(n, 0.);
    sines.assign(n, 1.);
    cosines_of_longitudes.assign(is_grid ? width * lanes : n, 1.);
    sines_of_longitudes.assign(cosines_of_longitudes.size(), 0.);
  }

  void set_parallel(std::size_t k, double cosine, double sine)
  {
    cosines[k] = cosine;
    sines[k] = sine;
  }

  void set_longitude(std::size_t k, double cosine, double sine)
  {
    cosines_of_longitudes[k] = cosine;
    sines_of_longitudes[k] = sine;
  }

  std::size_t m_n_parallels, m_width;
  bool m_is_grid;
};

// A Gauss-Legendre grid, on which integrals of products of two functions with harmonics up to `degree` are exact:
// degree + 1 parallels at the zeros of the Legendre polynomial of degree + 1, and 2 degree + 2 longitudes.
struct Gauss_grid
{
  explicit Gauss_grid(std::size_t degree)
    : Gauss_grid(zeros_and_weights(degree + 1), 2 * degree + 2)
  {}

  Sphere_nodes nodes;
  std::vector<double> weights; // of a node of each parallel; the sum over all nodes is 1

private:
  using Rule = std::pair<std::vector<double>, std::vector<double>>; // zeros, weights

  Gauss_grid(Rule rule, std::size_t width)
    : nodes(rule.first, width)
    , weights(std::move(rule.second))
  {
    for(double& w : weights)
      w /= 2. * static_cast<double>(width);
  }

  // zeros from north to south, by Newton's method, and weights, whose sum is 2
  static Rule zeros_and_weights(std::size_t n)
  {
    Rule rule = {std::vector<double>(n), std::vector<double>(n)};
    const double size = static_cast<double>(n);
    for(std::size_t k = 0; k < n; ++k)
    {
      double x = cosine(CGAL_PI * (static_cast<double>(k) + 0.75) / (size + 0.5)), slope = 1.;
      constexpr int n_steps = 5; // Three are enough for all n; the initial value is off by less than 1 / n^2.
      for(int step = 0; step < n_steps; ++step)
      {
        double p = 1., before = 0.; // the polynomials of degree j and j - 1
        for(std::size_t j = 0; j < n; ++j)
        {
          const double d = static_cast<double>(j), next = ((2. * d + 1.) * x * p - d * before) / (d + 1.);
          before = p;
          p = next;
        }
        slope = size * (before - x * p) / ((1. - x) * (1. + x));
        x -= p / slope;
      }
      rule.first[k] = x;
      rule.second[k] = 2. / ((1. - x) * (1. + x) * slope * slope);
    }
    return rule;
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERE_NODES_H
