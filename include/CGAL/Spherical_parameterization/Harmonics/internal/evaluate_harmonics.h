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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_EVALUATE_HARMONICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_EVALUATE_HARMONICS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Coefficient_layout.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Sphere_nodes.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Spherical_harmonic_transform.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Writes the values of all functions at directions of length 1, those of a direction one after the other. Returns whether it was
// not stopped.
inline bool evaluate_harmonics(const Spherical_harmonics_3& harmonics, const std::vector<Vector_3d>& directions,
                               std::vector<double>& values, const Execution& execution, Run_control& control)
{
  constexpr std::size_t n_at_once =
      1 << 14; // between two questions to the control, a tenth of a second at the degree 200
  const Spherical_harmonics_3 same = in_normalization_of_transform(harmonics);
  const std::size_t n_functions = same.number_of_functions();
  const Spherical_harmonic_transform transform(same.degree());
  values.assign(n_functions * directions.size(), 0.);
  std::vector<double> at_nodes;
  for(std::size_t first = 0; first < n_functions; first += Sphere_nodes::n_functions)
  {
    const std::vector<double> coefficients = read_coefficients(transform, same, first);
    const std::size_t n = (std::min)(Sphere_nodes::n_functions, n_functions - first);
    for(std::size_t begin = 0; begin < directions.size(); begin += n_at_once)
    {
      if(!control.go_further(0, 0.))
        return false;
      const std::size_t end = (std::min)(begin + n_at_once, directions.size());
      const Sphere_nodes nodes(std::vector<Vector_3d>(directions.begin() + static_cast<std::ptrdiff_t>(begin),
                                                      directions.begin() + static_cast<std::ptrdiff_t>(end)));
      transform.evaluate(nodes, coefficients, at_nodes, execution);
      for(std::size_t k = begin; k < end; ++k)
        for(std::size_t i = 0; i < n; ++i)
          values[n_functions * k + first + i] = at_nodes[nodes.place(k - begin, 0, i)];
    }
  }
  return control.go_further(0, 0.);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_EVALUATE_HARMONICS_H
