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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_FIRST_DEGREE_ELLIPSOID_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_FIRST_DEGREE_ELLIPSOID_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Sphere_nodes.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Spherical_harmonic_transform.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The ellipsoid that the harmonics of degree 1 make of a surface: a direction q leads to center + A q, and A = U S V^T, where the
// columns of U are the axes on the surface, those of V their directions on the sphere, and S has half their lengths.
struct First_degree_ellipsoid
{
  Vector_3d center, lengths;
  Rotation_matrix axes_of_surface, axes_of_sphere; // in rows

  // Reads coefficients in the normalization of the transform, where the harmonics of degree 1 are sqrt(3) times y, z and x.
  explicit First_degree_ellipsoid(const Spherical_harmonics_3& harmonics)
  {
    constexpr std::array<std::ptrdiff_t, 3> orders = {1, -1, 0}; // of x, y and z
    Rotation_matrix columns;                                     // of A V, scaled
    for(std::size_t i = 0; i < 3; ++i)
    {
      center[i] = harmonics.coefficient(i, 0, 0);
      for(std::size_t j = 0; j < 3; ++j)
        columns[j][i] = std::sqrt(3.) * harmonics.coefficient(i, 1, orders[j]);
    }
    double largest = 0.;
    for(const Vector_3d& c : columns)
      largest = (std::max)({largest, std::abs(c[0]), std::abs(c[1]), std::abs(c[2])});
    std::frexp(largest, &m_exponent);
    for(Vector_3d& c : columns)
      for(double& x : c)
        x = std::ldexp(x, -m_exponent);
    const Rotation_matrix columns_of_a = columns;

    // One-sided Jacobi rotations make the columns of A V orthogonal.
    Rotation_matrix v = {Vector_3d{1., 0., 0.}, Vector_3d{0., 1., 0.}, Vector_3d{0., 0., 1.}};
    constexpr int n_sweeps = 20; // Six or so are enough.
    for(int sweep = 0; sweep < n_sweeps; ++sweep)
      for(std::size_t i = 0; i < 3; ++i)
        for(std::size_t j = i + 1; j < 3; ++j)
        {
          const double product = dot(columns[i], columns[j]);
          if(product == 0.)
            continue;
          const double theta = (squared_length(columns[j]) - squared_length(columns[i])) / (2. * product);
          const double t = (theta < 0. ? -1. : 1.) / (std::abs(theta) + std::hypot(theta, 1.));
          const double c = 1. / std::hypot(t, 1.), s = t * c;
          for(Rotation_matrix* const m : {&columns, &v})
          {
            const Vector_3d x = (*m)[i], y = (*m)[j];
            (*m)[i] = c * x - s * y;
            (*m)[j] = s * x + c * y;
          }
        }
    std::array<std::size_t, 3> order = {0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return squared_length(columns[i]) > squared_length(columns[j]);
    });
    for(std::size_t k = 0; k < 2; ++k)
    {
      axes_of_sphere[k] = v[order[k]];
      axes_of_surface[k] = normalized_or_zero(columns[order[k]]);
    }
    axes_of_sphere[2] = cross(axes_of_sphere[0], axes_of_sphere[1]);
    axes_of_surface[2] = normalized_or_zero(cross(axes_of_surface[0], axes_of_surface[1]));
    for(std::size_t k = 0; k < 3; ++k) // the last one may be negative
    {
      const Vector_3d& q = axes_of_sphere[k];
      const Vector_3d image = q[0] * columns_of_a[0] + q[1] * columns_of_a[1] + q[2] * columns_of_a[2];
      lengths[k] = std::ldexp(dot(axes_of_surface[k], image), m_exponent);
    }
  }

  // Turns the axes by half a turn such that the third moments of the surface along the first two are positive. Returns the moments
  // over the powers 3/2 of the second ones.
  Vector_3d orient(const Spherical_harmonics_3& harmonics, const Execution& execution)
  {
    Vector_3d result = skewness(harmonics, execution);
    const std::array<double, 2> signs = {result[0] < 0. ? -1. : 1., result[1] < 0. ? -1. : 1.};
    const Vector_3d factors = {signs[0], signs[1], signs[0] * signs[1]};
    for(std::size_t k = 0; k < 3; ++k)
    {
      axes_of_surface[k] = factors[k] * axes_of_surface[k];
      axes_of_sphere[k] = factors[k] * axes_of_sphere[k];
      result[k] *= factors[k];
    }
    return result;
  }

  // Moves the centre to the origin and turns the axes into those of space.
  void move_surface(Spherical_harmonics_3& harmonics) const
  {
    const auto degree = static_cast<std::ptrdiff_t>(harmonics.degree());
    for(std::ptrdiff_t l = 0; l <= degree; ++l)
      for(std::ptrdiff_t m = -l; m <= l; ++m)
      {
        const auto k = static_cast<std::size_t>(l);
        const Vector_3d c = {harmonics.coefficient(0, k, m), harmonics.coefficient(1, k, m),
                             harmonics.coefficient(2, k, m)};
        for(std::size_t i = 0; i < 3; ++i)
          harmonics.set_coefficient(i, k, m, l == 0 ? 0. : dot(axes_of_surface[i], c));
      }
  }

private:
  static Vector_3d normalized_or_zero(const Vector_3d& v) { return length(v) > 0. ? normalized(v) : v; }

  // On a grid that is exact for the third powers of the functions.
  Vector_3d skewness(const Spherical_harmonics_3& harmonics, const Execution& execution) const
  {
    const Gauss_grid grid(harmonics.degree() + (harmonics.degree() + 1) / 2);
    const Spherical_harmonic_transform transform(harmonics.degree());
    std::vector<double> coefficients = read_coefficients(transform, harmonics, 0), values;
    for(double& c : coefficients)
      c = std::ldexp(c, -m_exponent);
    for(std::size_t i = 0; i < 3; ++i)
      coefficients[i] = 0.; // the centre
    transform.evaluate(grid.nodes, coefficients, values, execution);
    Vector_3d second = {0., 0., 0.}, third = {0., 0., 0.};
    for(std::size_t j = 0; j < grid.nodes.number_of_parallels(); ++j)
      for(std::size_t i = 0; i < grid.nodes.width(); ++i)
      {
        const Vector_3d p = {values[grid.nodes.place(j, i, 0)], values[grid.nodes.place(j, i, 1)],
                             values[grid.nodes.place(j, i, 2)]};
        for(std::size_t k = 0; k < 3; ++k)
        {
          const double x = dot(axes_of_surface[k], p);
          second[k] += grid.weights[j] * x * x;
          third[k] += grid.weights[j] * x * x * x;
        }
      }
    for(std::size_t k = 0; k < 3; ++k)
      third[k] /= second[k] > 0. ? second[k] * std::sqrt(second[k]) : 1.;
    return third;
  }

  int m_exponent = 0;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_FIRST_DEGREE_ELLIPSOID_H
