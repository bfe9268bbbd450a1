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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_LEAST_SQUARES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_LEAST_SQUARES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Harmonics/internal/Sphere_nodes.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Spherical_harmonic_transform.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/conjugate_gradients.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The sums over harmonics whose values at the nodes are nearest to given ones, by weighted least squares: conjugate gradients on the
// normal equations, whose matrix is never formed. One step costs two transforms, where a matrix of all products would cost as
// much as n steps for n coefficients. With the weights of a Gauss grid the matrix is the identity, and one step is enough; otherwise
// its condition is that of the ratio of weights and areas on the sphere. Where nodes leave directions in the space of coefficients
// nearly free, steps go on for little: the iteration ends where ten of them lower the sum of squares by less than a thousandth, or the
// residual has fallen to rounding.
class Least_squares
{
public:
  static constexpr std::size_t n_functions = Sphere_nodes::n_functions;

  // `weights` in the order of values, those of the nodes that fill up a group are 0
  Least_squares(const Spherical_harmonic_transform& transform, const Sphere_nodes& nodes,
                const std::vector<double>& weights, const Execution& execution)
    : m_transform(transform)
    , m_nodes(nodes)
    , m_weights(weights)
    , m_execution(execution)
  {}

  // Returns whether it was not stopped.
  bool solve(const std::vector<double>& values, std::vector<double>& coefficients, Run_control& control)
  {
    constexpr std::size_t max_steps = 1000, n_between = 10;
    constexpr double min_decrease = 1e-3, squared_rounding = 1e-26;
    using Values = std::vector<double>;
    using Numbers = std::array<double, n_functions>;
    Values residual, image, product = weighed(values);
    Numbers squares = dots_at_nodes(values, product); // the sums that are made least
    m_transform.project(m_nodes, product, residual, m_execution);
    coefficients.assign(residual.size(), 0.);
    Numbers last = {}; // the products before the last step
    double before = -1.;
    m_n_steps = conjugate_gradients(
        coefficients, residual,
        [&](const Values& p, Values& q) {
          m_transform.evaluate(m_nodes, p, image, m_execution);
          m_transform.project(m_nodes, weighed(image), q, m_execution);
          return dots(p, q);
        },
        [](const Values& r, Values& z) { return z = r, dots(r, r); },
        [&](std::size_t k, const Numbers& rho, const Numbers& first, const Numbers& step) {
          if(k == max_steps || !control.go_further(0, 0.))
            return false;
          bool is_done = true;
          for(std::size_t i = 0; i < n_functions; ++i)
          {
            squares[i] -= step[i] * last[i];
            is_done = is_done && rho[i] <= squared_rounding * first[i];
          }
          last = rho;
          if(k % n_between == 0)
          {
            const double sum = squares[0] + squares[1] + squares[2];
            is_done = is_done || (k > 0 && sum > (1. - min_decrease) * before);
            before = sum;
          }
          return !is_done;
        });
    return !control.is_stopped();
  }

  // The integrals of the values times harmonics, which is the same if the weights are those of a Gauss grid.
  void project(const std::vector<double>& values, std::vector<double>& coefficients) const
  {
    m_transform.project(m_nodes, weighed(values), coefficients, m_execution);
  }

  std::size_t number_of_steps() const { return m_n_steps; }

  // The weighted sum of the squared differences between values and what the coefficients make of them.
  double squared_error(const std::vector<double>& values, const std::vector<double>& coefficients) const
  {
    std::vector<double> differences;
    m_transform.evaluate(m_nodes, coefficients, differences, m_execution);
    for(std::size_t k = 0; k < differences.size(); ++k)
      differences[k] -= values[k];
    const std::array<double, n_functions> sums = dots_at_nodes(differences, weighed(differences));
    return sums[0] + sums[1] + sums[2];
  }

private:
  std::vector<double> weighed(std::vector<double> values) const
  {
    for(std::size_t k = 0; k < values.size(); ++k)
      values[k] *= m_weights[k];
    return values;
  }

  static std::array<double, n_functions> dots(const std::vector<double>& a, const std::vector<double>& b)
  {
    std::array<double, n_functions> sums = {0., 0., 0.};
    for(std::size_t k = 0; k < a.size(); k += n_functions)
      for(std::size_t i = 0; i < n_functions; ++i)
        sums[i] += a[k + i] * b[k + i];
    return sums;
  }

  std::array<double, n_functions> dots_at_nodes(const std::vector<double>& a, const std::vector<double>& b) const
  {
    std::array<double, n_functions> sums = {0., 0., 0.};
    const std::size_t size = m_nodes.size_of_group() / n_functions;
    for(std::size_t begin = 0; begin < a.size(); begin += m_nodes.size_of_group())
      for(std::size_t i = 0; i < n_functions; ++i)
        for(std::size_t k = begin + i * size; k < begin + (i + 1) * size; ++k)
          sums[i] += a[k] * b[k];
    return sums;
  }

  const Spherical_harmonic_transform& m_transform;
  const Sphere_nodes& m_nodes;
  const std::vector<double>& m_weights;
  Execution m_execution;
  std::size_t m_n_steps = 0;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_LEAST_SQUARES_H
