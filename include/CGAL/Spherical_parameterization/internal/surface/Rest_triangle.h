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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_REST_TRIANGLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_REST_TRIANGLE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The limits of flatness and size for the shape of a face in a Rest_triangle. A flatter shape would cause huge
// derivatives and block its neighbors; it gets the minimum height instead. A face without height or size has no
// meaningful shape, and gets one that does not affect its neighbors.
struct Rest_limits
{
  double min_height = 1e-4; // on the longest edge, in units of that edge
  double min_edge = 1e-12;  // the longest one; surfaces are scaled to the area of the unit sphere

  // Whether the surface is ignored: every face is the same equilateral triangle.
  bool is_uniform = false;

  double height_without_shape = 0.2; // of a face whose height is 0 up to rounding, in units of its longest edge
};

// The shape of a face on the surface, as used by the energies. With the squared lengths l of the edges of the image, I
// = opposite_0 l_12 + opposite_1 l_20 + opposite_2 l_01 and d = (doubled area of the image) * inverse_doubled_area.
// With a packed number type, it is the shape of a face in each lane.
template <class FT>
struct Basic_rest_triangle
{
  FT opposite_0, opposite_1, opposite_2; // cot(theta_i) / (2 A), where A is the area
  FT inverse_doubled_area;               // 1 / (2 A)

  // The height on the longest edge, in units of that edge.
  static double height(const Vector_3d& p0, const Vector_3d& p1, const Vector_3d& p2)
  {
    const Vector_3d e0 = p2 - p1, e1 = p0 - p2, e2 = p1 - p0;
    return length(cross(e1, e2)) / longest(squared_length(e0), squared_length(e1), squared_length(e2));
  }

  static bool is_too_flat(const Vector_3d& p0, const Vector_3d& p1, const Vector_3d& p2)
  {
    const Vector_3d e0 = p2 - p1, e1 = p0 - p2, e2 = p1 - p0;
    return is_too_flat(length(cross(e1, e2)), longest(squared_length(e0), squared_length(e1), squared_length(e2)),
                       Rest_limits());
  }

  static Basic_rest_triangle from_points(const Vector_3<FT>& p0, const Vector_3<FT>& p1, const Vector_3<FT>& p2,
                                         const Rest_limits& limits = Rest_limits())
  {
    if(limits.is_uniform)
      return equilateral(1.);
    const Vector_3<FT> e0 = p2 - p1, e1 = p0 - p2, e2 = p1 - p0;
    const FT l0 = squared_length(e0), l1 = squared_length(e1), l2 = squared_length(e2);
    const FT doubled_area = length<FT>(cross(e1, e2));
    const FT inverse = 1. / doubled_area;
    const FT scale = -inverse * inverse;
    const Basic_rest_triangle result = {scale * dot(e1, e2), scale * dot(e2, e0), scale * dot(e0, e1), inverse};
    const auto is_flat = is_too_flat(doubled_area, longest(l0, l1, l2), limits);
    if(!any(is_flat))
      return result;
    std::array<std::array<double, Lanes<FT>::width>, 4> lanes;
    for(std::size_t k = 0; k < Lanes<FT>::width; ++k)
    {
      const Basic_rest_triangle<double> shape =
          lane(is_flat, k)
              ? lifted(lane(l0, k), lane(l1, k), lane(l2, k), lane(doubled_area, k), limits)
              : Basic_rest_triangle<double>{lane(result.opposite_0, k), lane(result.opposite_1, k),
                                            lane(result.opposite_2, k), lane(result.inverse_doubled_area, k)};
      lanes[0][k] = shape.opposite_0;
      lanes[1][k] = shape.opposite_1;
      lanes[2][k] = shape.opposite_2;
      lanes[3][k] = shape.inverse_doubled_area;
    }
    const auto load = [&](std::size_t i) { return Lanes<FT>::load(lanes[i].data()); };
    return {load(0), load(1), load(2), load(3)};
  }

  // Multiplies the area by `factor` and preserves the angles.
  void scale_area(const FT& factor)
  {
    const FT inverse = 1. / factor;
    opposite_0 *= inverse;
    opposite_1 *= inverse;
    opposite_2 *= inverse;
    inverse_doubled_area *= inverse;
  }

private:
  static FT longest(const FT& a, const FT& b, const FT& c) { return maximum(maximum(a, b), c); }

  static auto is_too_flat(const FT& doubled_area, const FT& squared_longest_edge, const Rest_limits& limits)
  {
    return doubled_area < limits.min_height * squared_longest_edge ||
           squared_longest_edge < limits.min_edge * limits.min_edge;
  }

  static Basic_rest_triangle equilateral(double edge)
  {
    const double cotangent = 1. / std::sqrt(3.), inverse = 2. * cotangent / (edge * edge);
    return {cotangent * inverse, cotangent * inverse, cotangent * inverse, inverse};
  }

  // On the longest edge; a face below it has no shape, and measure_distortion() treats it as degenerate.
  static constexpr double min_height_of_shape = 1e-12;

  // The triangle with the longest edge of the given one, the same foot of the height on it, and the minimum height; or
  // an equilateral one of the minimum size.
  static Basic_rest_triangle<double> lifted(double l0, double l1, double l2, double doubled_area,
                                            const Rest_limits& limits)
  {
    const std::array<double, 3> squared = {l0, l1, l2};
    const auto base = static_cast<std::size_t>(std::max_element(squared.begin(), squared.end()) - squared.begin());
    // The base is the edge from corner 1 to corner 2 of the rotated triangle; its apex is corner 0.
    const double b2 = squared[base];
    if(b2 < limits.min_edge * limits.min_edge)
      return Basic_rest_triangle<double>::equilateral(limits.min_edge);
    const double h = doubled_area > min_height_of_shape * b2 ? limits.min_height : limits.height_without_shape;
    const double to_1 = squared[(base + 2) % 3], to_2 = squared[(base + 1) % 3];
    const double t = std::clamp(0.5 * (b2 + to_1 - to_2) / b2, 0., 1.); // the foot, in units of the base
    // cot(1) = t / h, cot(2) = (1 - t) / h and cot(0) = (h^2 - t (1 - t)) / h for a base of length 1, h = 2 A.
    const double inverse = 1. / (b2 * h);
    std::array<double, 3> cotangents;
    cotangents[base] = (h - t * (1. - t) / h);
    cotangents[(base + 1) % 3] = t / h;
    cotangents[(base + 2) % 3] = (1. - t) / h;
    return {cotangents[0] * inverse, cotangents[1] * inverse, cotangents[2] * inverse, inverse};
  }

  template <class FT2>
  friend struct Basic_rest_triangle;
};

using Rest_triangle = Basic_rest_triangle<double>;

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_REST_TRIANGLE_H
