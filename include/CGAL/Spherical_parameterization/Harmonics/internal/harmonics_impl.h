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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_HARMONICS_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_HARMONICS_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Harmonics/evaluate_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Harmonics/expand_in_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Expansion_samples.h>
#include <CGAL/Spherical_parameterization/Harmonics/move_to_standard_position.h>
#include <CGAL/Spherical_parameterization/Harmonics/rotate_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code evaluate_harmonics(const Spherical_harmonics_3& harmonics, const std::vector<Vector_3d>& directions,
                              std::vector<double>& values, Run_control& control, const Execution& execution)
{
  if(!are_finite(directions))
    return ERROR_INVALID_DIRECTION;
  constexpr std::size_t n_at_once = 1 << 14; // between calls of the control; takes 0.1 s at the degree 200
  const Spherical_harmonics_3 same = in_normalization_of_transform(harmonics);
  const std::size_t n_functions = same.number_of_functions();
  const Spherical_harmonic_transform transform(same.degree());
  std::vector<double> result(n_functions * directions.size(), 0.);
  std::vector<double> at_nodes;
  for(std::size_t first = 0; first < n_functions; first += Sphere_nodes::n_functions)
  {
    const std::vector<double> coefficients = read_coefficients(transform, same, first);
    const std::size_t n = (std::min)(Sphere_nodes::n_functions, n_functions - first);
    for(std::size_t begin = 0; begin < directions.size(); begin += n_at_once)
    {
      if(!control.go_further(0, 0.))
        return ERROR_STOPPED;
      const std::size_t end = (std::min)(begin + n_at_once, directions.size());
      const Sphere_nodes nodes(std::vector<Vector_3d>(directions.begin() + static_cast<std::ptrdiff_t>(begin),
                                                      directions.begin() + static_cast<std::ptrdiff_t>(end)));
      transform.evaluate(nodes, coefficients, at_nodes, execution);
      for(std::size_t k = begin; k < end; ++k)
        for(std::size_t i = 0; i < n; ++i)
          result[n_functions * k + first + i] = at_nodes[nodes.place(k - begin, 0, i)];
    }
  }
  if(!control.go_further(0, 0.))
    return ERROR_STOPPED;
  values = std::move(result);
  return OK;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code expand_functions(Expansion_surface surface, const std::vector<double>& values,
                            const Harmonic_expansion_3& expansion, Spherical_harmonics_3& harmonics,
                            Run_control& control, const Execution& execution)
{
  if(!std::all_of(values.begin(), values.end(), [](double x) { return is_finite(x); }))
    return ERROR_NON_FINITE_COORDINATE;
  if(!control.go_further(0, 0.))
    return ERROR_STOPPED;
  normalize(surface.points);
  const auto degree = static_cast<std::size_t>(expansion.degree());
  Expansion expander(surface, degree, expansion.weights(), execution);
  const std::size_t n_vertices = surface.points.size(), n_functions = values.size() / n_vertices;
  Spherical_harmonics_3 result(n_functions, degree);
  std::vector<double> coefficients;
  for(std::size_t first = 0; first < n_functions; first += Sphere_nodes::n_functions)
  {
    std::vector<Vector_3d> of_vertices(n_vertices, {0., 0., 0.});
    for(std::size_t v = 0; v < n_vertices; ++v)
      for(std::size_t k = first; k < (std::min)(first + Sphere_nodes::n_functions, n_functions); ++k)
        of_vertices[v][k - first] = values[n_functions * v + k];
    if(!expander.expand(of_vertices, coefficients, control))
      return ERROR_STOPPED;
    write_coefficients(expander.transform(), coefficients, first, result);
  }
  result.fit = expander.fit();
  harmonics = std::move(result);
  return OK;
}

// Replaces functions by functions whose value at R q is the old value at q. Rotation preserves the degree, and a
// Gauss-Legendre grid of this degree gives exact coefficients. So the values at the nodes of the rotated grid are
// sufficient.
inline Error_code rotate_harmonics(Spherical_harmonics_3& harmonics, const Rotation_matrix& r, Run_control& control,
                                   const Execution& execution)
{
  const Gauss_grid grid(harmonics.degree());
  const std::size_t width = grid.nodes.width(), n = grid.nodes.number_of_parallels() * width;
  const Rotation_matrix back = {Vector_3d{r[0][0], r[1][0], r[2][0]}, Vector_3d{r[0][1], r[1][1], r[2][1]},
                                Vector_3d{r[0][2], r[1][2], r[2][2]}};
  std::vector<Vector_3d> directions;
  directions.reserve(n);
  for(std::size_t k = 0; k < n; ++k)
    directions.push_back(normalized(rotated(back, grid.nodes.direction(k / width, k % width))));
  std::vector<double> values;
  if(const Error_code error = evaluate_harmonics(harmonics, directions, values, control, execution))
    return error;
  const Spherical_harmonic_transform transform(harmonics.degree());
  Spherical_harmonics_3 result(harmonics.number_of_functions(), harmonics.degree());
  std::vector<double> coefficients;
  for(std::size_t first = 0; first < result.number_of_functions(); first += Sphere_nodes::n_functions)
  {
    std::vector<double> at_nodes(grid.nodes.number_of_values(), 0.);
    const std::size_t end = (std::min)(first + Sphere_nodes::n_functions, result.number_of_functions());
    for(std::size_t k = 0; k < n; ++k)
      for(std::size_t i = first; i < end; ++i)
        at_nodes[grid.nodes.place(k / width, k % width, i - first)] =
            grid.weights[k / width] * values[result.number_of_functions() * k + i];
    transform.project(grid.nodes, at_nodes, coefficients, execution);
    write_coefficients(transform, coefficients, first, result);
  }
  result.convert(harmonics.normalization(), harmonics.has_phase());
  result.fit = harmonics.fit;
  harmonics = std::move(result);
  return OK;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code rotate_harmonics(Spherical_harmonics_3& harmonics,
                            const Aff_transformation_3<Exact_predicates_inexact_constructions_kernel>& rotation,
                            Run_control& control, const Execution& execution)
{
  constexpr double max_deviation = 1e-6; // so that a matrix from a file with seven digits is accepted
  Rotation_matrix matrix;
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 3; ++j)
      matrix[i][j] = rotation.m(static_cast<int>(i), static_cast<int>(j));
  double deviation = std::abs(dot(matrix[0], cross(matrix[1], matrix[2])) - 1.);
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 3; ++j)
      deviation = (std::max)(deviation, std::abs(dot(matrix[i], matrix[j]) - (i == j ? 1. : 0.)));
  return deviation <= max_deviation ? rotate_harmonics(harmonics, matrix, control, execution) : ERROR_WRONG_PARAMETER;
}

// The ellipsoid given by the harmonics of degree 1, which map a direction q to center + A q. With A = U S V^T, the
// columns of U are the axes of the ellipsoid, those of V are their directions on the sphere, and S holds half their
// lengths.
struct First_degree_ellipsoid
{
  Vector_3d center, lengths;
  Rotation_matrix axes_of_surface, axes_of_sphere; // as rows

  // `harmonics` must have the normalization of the transform, in which the harmonics of degree 1 are sqrt(3) times y, z
  // and x.
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
    constexpr int n_sweeps = 20; // About six are enough.
    for(int sweep = 0; sweep < n_sweeps; ++sweep)
      for(std::size_t i = 0; i < 3; ++i)
        for(std::size_t j = i + 1; j < 3; ++j)
        {
          const double product = dot(columns[i], columns[j]);
          if(product == 0.)
            continue;
          const double theta = (squared_length(columns[j]) - squared_length(columns[i])) / (2. * product);
          const double t = (theta < 0. ? -1. : 1.) / (std::abs(theta) + hypotenuse(theta, 1.));
          const double c = 1. / hypotenuse(t, 1.), s = t * c;
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

  // Rotates the axes by half-turns so that the third moments of the surface along the first two axes are positive.
  // Returns the moments, divided by the 3/2 power of the second moments.
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

  // Moves the center to the origin, and rotates the axes to the coordinate axes.
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
  // Computed on a grid that is exact for the third powers of the functions.
  Vector_3d skewness(const Spherical_harmonics_3& harmonics, const Execution& execution) const
  {
    const Gauss_grid grid(harmonics.degree() + (harmonics.degree() + 1) / 2);
    const Spherical_harmonic_transform transform(harmonics.degree());
    std::vector<double> coefficients = read_coefficients(transform, harmonics, 0), values;
    for(double& c : coefficients)
      c = std::ldexp(c, -m_exponent);
    for(std::size_t i = 0; i < 3; ++i)
      coefficients[i] = 0.; // the center
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

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code move_harmonics(Spherical_harmonics_3& harmonics, Standard_position& position, Run_control& control,
                          const Execution& execution)
{
  constexpr double same = 0.01;     // relative; about five times the variation between maps of a surface
  constexpr double nothing = 1e-10; // relative to the largest length
  if(harmonics.number_of_functions() != 3 || harmonics.degree() == 0)
    return ERROR_WRONG_PARAMETER;
  Spherical_harmonics_3 moved = in_normalization_of_transform(harmonics);
  for(std::size_t l = 0; l <= moved.degree(); ++l)
    for(std::ptrdiff_t m = -static_cast<std::ptrdiff_t>(l); m <= static_cast<std::ptrdiff_t>(l); ++m)
      for(std::size_t i = 0; i < 3; ++i)
        if(!is_finite(moved.coefficient(i, l, m)))
          return ERROR_NON_FINITE_COORDINATE;
  First_degree_ellipsoid ellipsoid(moved);
  if(!(ellipsoid.lengths[1] > nothing * ellipsoid.lengths[0]))
    return ERROR_UNDETERMINED_ROTATION;
  Standard_position result;
  result.center = ellipsoid.center;
  result.skewness = ellipsoid.orient(moved, execution);
  result.semi_axes = ellipsoid.lengths;
  result.rotation_of_surface = as_transformation(ellipsoid.axes_of_surface);
  result.rotation_of_sphere = as_transformation(ellipsoid.axes_of_sphere);
  result.axes_are_determined = result.semi_axes[1] < (1. - same) * result.semi_axes[0] &&
                               std::abs(result.semi_axes[2]) < (1. - same) * result.semi_axes[1];
  result.signs_are_determined = result.skewness[0] > same && result.skewness[1] > same;
  ellipsoid.move_surface(moved);
  if(const Error_code error = rotate_harmonics(moved, ellipsoid.axes_of_sphere, control, execution))
    return error;
  moved.convert(harmonics.normalization(), harmonics.has_phase());
  harmonics = std::move(moved);
  position = result;
  return OK;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_HARMONICS_IMPL_H
