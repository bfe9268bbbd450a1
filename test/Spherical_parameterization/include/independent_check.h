// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_INDEPENDENT_CHECK_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_INDEPENDENT_CHECK_H

// Whether a map to the sphere is one-to-one, decided by another way than the package's certificate and without any of
// its code: the signs of determinants of rational numbers, and the sum of the solid angles of all faces instead of the
// number of faces around a point.

#include "test_meshes.h"

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace independent_check {

using test_meshes::Coordinates;
using test_meshes::Triangle;

// The determinant of three vectors, and the same sum without any cancellation.
template <class Number>
std::array<Number, 2> determinant_and_permanent(const std::array<std::array<Number, 3>, 3>& m)
{
  std::array<Number, 2> result = {Number(0), Number(0)};
  for(std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    for(const Number& term : {Number(m[0][i] * m[1][j] * m[2][k]), Number(-m[0][i] * m[1][k] * m[2][j])})
    {
      result[0] += term;
      result[1] += term < Number(0) ? Number(-term) : term;
    }
  }
  return result;
}

// The sign of the determinant of three points.
inline int sign_of_determinant(const Coordinates& a, const Coordinates& b, const Coordinates& c)
{
  // Doubles decide if they can. Nothing is rounded off below the bound but products that underflow.
  const std::array<double, 2> rounded = determinant_and_permanent<double>({a, b, c});
  if(std::isfinite(rounded[1]) && rounded[1] > 1e-250 && std::abs(rounded[0]) > 1e-14 * rounded[1])
    return rounded[0] > 0. ? 1 : -1;

  std::array<std::array<CGAL::Exact_rational, 3>, 3> rows;
  for(std::size_t i = 0; i < 3; ++i)
  {
    rows[0][i] = CGAL::Exact_rational(a[i]);
    rows[1][i] = CGAL::Exact_rational(b[i]);
    rows[2][i] = CGAL::Exact_rational(c[i]);
  }
  const CGAL::Exact_rational exact = determinant_and_permanent(rows)[0];
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

// The solid angle of a triangle that is known to be positive, in (0, 2 pi).
inline double solid_angle(const Coordinates& a, const Coordinates& b, const Coordinates& c)
{
  const Coordinates u = test_meshes::normalized(a), v = test_meshes::normalized(b), w = test_meshes::normalized(c);
  const auto dot = [](const Coordinates& p, const Coordinates& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; };
  // Rounding must not make a thin triangle that goes nearly half around the sphere negative.
  const double determinant = std::abs(determinant_and_permanent<double>({u, v, w})[0]);
  return 2. * std::atan2(determinant, 1. + dot(u, v) + dot(v, w) + dot(w, u));
}

// Whether the closed oriented mesh is mapped to the directions of these points one-to-one: all faces are positive, and
// cover the sphere once. The number of times they do so is an integer, so that a rough sum is enough.
inline ::testing::AssertionResult is_one_to_one(const std::vector<Coordinates>& images,
                                                const std::vector<Triangle>& triangles)
{
  double area = 0.;
  std::size_t n_folds = 0;
  for(const Triangle& t : triangles)
  {
    const Coordinates &a = images[t[0]], &b = images[t[1]], &c = images[t[2]];
    bool is_finite = true;
    for(const Coordinates& p : {a, b, c})
      is_finite = is_finite && std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    if(!is_finite)
      return ::testing::AssertionFailure() << "an image is not finite";
    if(sign_of_determinant(a, b, c) > 0)
      area += solid_angle(a, b, c);
    else
      ++n_folds;
  }
  if(n_folds > 0)
    return ::testing::AssertionFailure() << n_folds << " faces are not positive";
  const double degree = area / (4. * test_meshes::pi);
  if(!(std::abs(degree - 1.) < 0.25))
    return ::testing::AssertionFailure() << "the faces cover the sphere " << degree << " times";
  return ::testing::AssertionSuccess();
}

} // namespace independent_check

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_INDEPENDENT_CHECK_H
