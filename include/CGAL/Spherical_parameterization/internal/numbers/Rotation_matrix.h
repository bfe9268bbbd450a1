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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_ROTATION_MATRIX_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_ROTATION_MATRIX_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A rotation matrix, row by row.
using Rotation_matrix = std::array<Vector_3d, 3>;

// The same in the caller's type.
inline Aff_transformation_3<Exact_predicates_inexact_constructions_kernel> as_transformation(const Rotation_matrix& r)
{
  return {r[0][0], r[0][1], r[0][2], r[1][0], r[1][1], r[1][2], r[2][0], r[2][1], r[2][2]};
}

template <class FT>
Vector_3<FT> rotated(const Rotation_matrix& r, const Vector_3<FT>& p)
{
  const auto row = [&](std::size_t i) { return r[i][0] * p[0] + r[i][1] * p[1] + r[i][2] * p[2]; };
  return {row(0), row(1), row(2)};
}

inline Rotation_matrix product(const Rotation_matrix& a, const Rotation_matrix& b)
{
  Rotation_matrix result;
  for(std::size_t i = 0; i < 3; ++i)
    result[i] = a[i][0] * b[0] + a[i][1] * b[1] + a[i][2] * b[2];
  return result;
}

// The inverse of a rotation.
inline Rotation_matrix transposed(const Rotation_matrix& r)
{
  return {Vector_3d{r[0][0], r[1][0], r[2][0]}, Vector_3d{r[0][1], r[1][1], r[2][1]},
          Vector_3d{r[0][2], r[1][2], r[2][2]}};
}

using Quaternion = std::array<double, 4>; // the scalar comes first

inline Rotation_matrix rotation_matrix(const Quaternion& q)
{
  const double s = 2. / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return {Vector_3d{1. - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
          Vector_3d{s * (x * y + w * z), 1. - s * (x * x + z * z), s * (y * z - w * x)},
          Vector_3d{s * (x * z - w * y), s * (y * z + w * x), 1. - s * (x * x + y * y)}};
}

// The cosine of the angle between two rotations.
inline double cosine_between(const Rotation_matrix& a, const Rotation_matrix& b)
{
  return 0.5 * (dot(a[0], b[0]) + dot(a[1], b[1]) + dot(a[2], b[2]) - 1.);
}

// The least-squares rotation of directions onto others: the eigenvector of Horn's symmetric matrix with the largest
// eigenvalue, by Jacobi rotations. There is none if several rotations are (nearly) equally good.
inline std::optional<Rotation_matrix> fitting_rotation(const std::vector<std::pair<Vector_3d, Vector_3d>>& pairs)
{
  std::array<Vector_3d, 3> s = {};
  for(const auto& [p, q] : pairs)
    for(std::size_t i = 0; i < 3; ++i)
      s[i] = s[i] + p[i] * q;
  std::array<Quaternion, 4> a = {
      Quaternion{s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]},
      Quaternion{s[1][2] - s[2][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]},
      Quaternion{s[2][0] - s[0][2], s[0][1] + s[1][0], s[1][1] - s[0][0] - s[2][2], s[1][2] + s[2][1]},
      Quaternion{s[0][1] - s[1][0], s[2][0] + s[0][2], s[1][2] + s[2][1], s[2][2] - s[0][0] - s[1][1]}};
  std::array<Quaternion, 4> v = {Quaternion{1., 0., 0., 0.}, Quaternion{0., 1., 0., 0.}, Quaternion{0., 0., 1., 0.},
                                 Quaternion{0., 0., 0., 1.}}; // columns: the eigenvectors
  constexpr int n_sweeps = 20;                                // Six or so are enough.
  for(int sweep = 0; sweep < n_sweeps; ++sweep)
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = i + 1; j < 4; ++j)
        if(a[i][j] != 0.)
        {
          const double theta = (a[j][j] - a[i][i]) / (2. * a[i][j]);
          const double t = (theta < 0. ? -1. : 1.) / (std::abs(theta) + hypotenuse(theta, 1.));
          const double c = 1. / hypotenuse(t, 1.), d = t * c;
          const auto turn = [&](double& x, double& y) { std::tie(x, y) = std::pair(c * x - d * y, d * x + c * y); };
          for(std::size_t k = 0; k < 4; ++k)
            turn(a[k][i], a[k][j]);
          for(std::size_t k = 0; k < 4; ++k)
            turn(a[i][k], a[j][k]);
          for(std::size_t k = 0; k < 4; ++k)
            turn(v[k][i], v[k][j]);
        }
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return a[i][i] > a[j][j]; });
  const std::size_t best = order[0];
  constexpr double min_gap = 1e-6; // per pair; rounding causes about 1e-16
  if(!(a[best][best] - a[order[1]][order[1]] > min_gap * static_cast<double>(pairs.size())))
    return std::nullopt;
  return rotation_matrix({v[0][best], v[1][best], v[2][best], v[3][best]});
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_ROTATION_MATRIX_H
