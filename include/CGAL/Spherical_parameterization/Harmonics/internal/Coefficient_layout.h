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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_COEFFICIENT_LAYOUT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_COEFFICIENT_LAYOUT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Spherical_harmonic_transform.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Calls f(place, l, m, function) for the coefficients of up to three functions, the first of them `first`, in the order of the
// transform.
template <class Function>
void for_each_coefficient(const Spherical_harmonic_transform& transform, std::size_t first, std::size_t n_functions,
                          const Function& f)
{
  const auto degree = static_cast<std::ptrdiff_t>(transform.degree());
  for(std::ptrdiff_t l = 0; l <= degree; ++l)
    for(std::ptrdiff_t m = -l; m <= l; ++m)
      for(std::size_t k = 0; k < Spherical_harmonic_transform::n_functions && first + k < n_functions; ++k)
        f(transform.place(static_cast<std::size_t>(l), static_cast<std::size_t>(m < 0 ? -m : m), m < 0) + k,
          static_cast<std::size_t>(l), m, first + k);
}

// Writes coefficients of the transform, whose normalization `harmonics` has to have.
inline void write_coefficients(const Spherical_harmonic_transform& transform, const std::vector<double>& coefficients,
                               std::size_t first, Spherical_harmonics_3& harmonics)
{
  for_each_coefficient(transform, first, harmonics.number_of_functions(),
                       [&](std::size_t place, std::size_t l, std::ptrdiff_t m, std::size_t function) {
                         harmonics.set_coefficient(function, l, m, coefficients[place]);
                       });
}

// Reads them again.
inline std::vector<double> read_coefficients(const Spherical_harmonic_transform& transform,
                                             const Spherical_harmonics_3& harmonics, std::size_t first)
{
  std::vector<double> result(transform.number_of_coefficients(), 0.);
  for_each_coefficient(transform, first, harmonics.number_of_functions(),
                       [&](std::size_t place, std::size_t l, std::ptrdiff_t m, std::size_t function) {
                         result[place] = harmonics.coefficient(function, l, m);
                       });
  return result;
}

// The same harmonics as those of the transform.
inline Spherical_harmonics_3 in_normalization_of_transform(Spherical_harmonics_3 harmonics)
{
  harmonics.convert(Harmonic_normalization::four_pi, false);
  return harmonics;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_COEFFICIENT_LAYOUT_H
