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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_ROTATE_HARMONICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_ROTATE_HARMONICS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Coefficient_layout.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Sphere_nodes.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Spherical_harmonic_transform.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/evaluate_harmonics.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

inline Rotation_matrix transposed(const Rotation_matrix& r)
{
  return {Vector_3d{r[0][0], r[1][0], r[2][0]}, Vector_3d{r[0][1], r[1][1], r[2][1]},
          Vector_3d{r[0][2], r[1][2], r[2][2]}};
}

// Replaces functions by those that have at R q what they had at q. Sums of harmonics up to a degree remain such, and a Gauss grid of
// the degree finds their coefficients exactly, so that the values at its nodes are all that is needed. Returns whether it
// was not stopped.
inline bool rotate_harmonics(Spherical_harmonics_3& harmonics, const Rotation_matrix& r, const Execution& execution,
                             Run_control& control)
{
  const Gauss_grid grid(harmonics.degree());
  const std::size_t width = grid.nodes.width(), n = grid.nodes.number_of_parallels() * width;
  const Rotation_matrix back = transposed(r);
  std::vector<Vector_3d> directions;
  directions.reserve(n);
  for(std::size_t k = 0; k < n; ++k)
    directions.push_back(normalized(rotated(back, grid.nodes.direction(k / width, k % width))));
  std::vector<double> values;
  if(!evaluate_harmonics(harmonics, directions, values, execution, control))
    return false;
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
  return true;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_ROTATE_HARMONICS_H
