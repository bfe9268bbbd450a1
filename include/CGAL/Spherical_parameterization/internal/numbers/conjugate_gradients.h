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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_CONJUGATE_GRADIENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_CONJUGATE_GRADIENTS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// One number for a system of equations, or one for each of N systems that have the same matrix and are interleaved in
// vectors.
inline double of_element(double x, std::size_t)
{
  return x;
}
template <std::size_t N>
double of_element(const std::array<double, N>& x, std::size_t k)
{
  return x[k % N];
}

// x / y, or 0 if y is not positive: a system that is solved, or not positive definite, does not change any more.
inline double ratio(double x, double y)
{
  return y > 0. ? x / y : 0.;
}
template <std::size_t N>
std::array<double, N> ratio(const std::array<double, N>& x, const std::array<double, N>& y)
{
  std::array<double, N> result;
  for(std::size_t k = 0; k < N; ++k)
    result[k] = ratio(x[k], y[k]);
  return result;
}

// Solves A x = b for a symmetric and positive definite A by conjugate gradients. `x` is the initial guess, and `r` is
// its residual b - A x. multiply(p, q) writes A p to q and returns the product of p and q; precondition(r, z) writes an
// approximation of A^-1 r to z and returns the product of r and z. After k steps, go_on(k, product, first, step)
// decides by this product, its initial value, and the length of the last step. Returns the number of steps.
template <class T, class Multiply, class Precondition, class GoOn>
std::size_t conjugate_gradients(std::vector<T>& x, std::vector<T>& r, const Multiply& multiply,
                                const Precondition& precondition, const GoOn& go_on, const Execution& execution = {})
{
  const auto for_each_element = [&](const auto& f) { for_each_in_blocks(execution, 0, x.size(), usual_block_size, f); };
  std::vector<T> z(x.size()), q(x.size());
  const auto first = precondition(r, z);
  std::vector<T> p = z;
  auto rz = first, step = ratio(first, first);
  std::size_t k = 0;
  for(; go_on(k, rz, first, step); ++k)
  {
    step = ratio(rz, multiply(p, q));
    for_each_element([&](std::size_t i) {
      x[i] = x[i] + of_element(step, i) * p[i];
      r[i] = r[i] - of_element(step, i) * q[i];
    });
    const auto last = std::exchange(rz, precondition(r, z)), turn = ratio(rz, last);
    for_each_element([&](std::size_t i) { p[i] = z[i] + of_element(turn, i) * p[i]; });
  }
  return k;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_CONJUGATE_GRADIENTS_H
