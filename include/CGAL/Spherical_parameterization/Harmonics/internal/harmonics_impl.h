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
#include <CGAL/Spherical_parameterization/Harmonics/internal/First_degree_ellipsoid.h>
#include <CGAL/Spherical_parameterization/Harmonics/move_to_standard_position.h>
#include <CGAL/Spherical_parameterization/Harmonics/rotate_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code evaluate_harmonics(const Spherical_harmonics_3& harmonics, const std::vector<Vector_3d>& directions,
                              std::vector<double>& values, Run_control& control, const Execution& execution)
{
  if(!are_finite(directions))
    return ERROR_INVALID_DIRECTION;
  constexpr std::size_t n_at_once =
      1 << 14; // between two questions to the control, a tenth of a second at the degree 200
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

// Replaces functions by those that have at R q what they had at q. Sums of harmonics up to a degree remain such, and a Gauss grid of
// the degree finds their coefficients exactly, so that the values at its nodes are all that is needed.
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
  constexpr double max_deviation = 1e-6; // of a matrix that was written to a file with seven digits
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

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code move_harmonics(Spherical_harmonics_3& harmonics, Standard_position& position, Run_control& control,
                          const Execution& execution)
{
  constexpr double same =
      0.01; // of lengths and skewness: some five times what another map of the same surface makes of them
  constexpr double nothing = 1e-10; // of lengths
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

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_HARMONICS_IMPL_H
