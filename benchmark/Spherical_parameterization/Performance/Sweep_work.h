// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_SWEEP_WORK_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_SWEEP_WORK_H

#include "Counting_update.h"
#include "Machine_rates.h"

#include <CGAL/Spherical_parameterization/internal/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace benchmarks {

// What a sweep over a mesh has to do at least: the bytes and operations on doubles that its formulas ask for, of which
// nothing is done twice and none is a factor 0, 1 or -1.
struct Sweep_work
{
  // Each array is read once, and the positions are written as well. That the positions of the neighbours are read again
  // and again is left to the caches.
  explicit Sweep_work(const Internal::Vertex_rings& rings)
  {
    const std::size_t per_corner = sizeof(std::uint32_t) + sizeof(Internal::Rest_triangle); // neighbour and rest shape
    const std::size_t per_vertex =
        2 * sizeof(std::uint32_t) + 2 * sizeof(Internal::Vector_3d); // its place and its number
    bytes = static_cast<double>(rings.number_of_corners() * per_corner + rings.number_of_vertices() * per_vertex);
  }

  // `counts` are those of one sweep over the mesh with `rings`.
  Sweep_work(const Internal::Vertex_rings& rings, const Evaluation_counts& counts)
    : Sweep_work(rings)
  {
    const double n = static_cast<double>(rings.number_of_vertices());
    const double corners = static_cast<double>(rings.number_of_corners());
    const double derivatives = static_cast<double>(counts.derivatives), values = static_cast<double>(counts.values);
    const double degree = corners / n;
    add(star, n);
    add(corner, corners);
    add(corner_of_derivatives, degree * derivatives);
    add(newton_step, derivatives);
    add(corner_of_value, degree * values);
    add(value, values);
    add(new_position, n);
  }

  // The seconds that a machine of these rates needs for the bytes alone ...
  double seconds_for_bytes(const Machine_rates& rates) const { return bytes / rates.bytes; }

  // ... and for the operations alone, if its divider, which takes the roots too, and its other units are never idle.
  double seconds_for_operations(const Machine_rates& rates) const
  {
    return (std::max)(sums_and_products / rates.sums_and_products + exponentials / rates.exponentials,
                      divisions / rates.divisions + square_roots / rates.square_roots);
  }

  double bytes = 0.;
  double sums_and_products = 0., divisions = 0., square_roots = 0., exponentials = 0.;

private:
  struct Operations
  {
    double sums_and_products, divisions, square_roots, exponentials;
  };

  // Counted in the formulas for the symmetric Dirichlet energy, the determinant and a positive sharpness.

  // the tangent frame, and the length of the shortest edge
  static constexpr Operations star = {9, 1, 1, 0};
  // The offset of the neighbour in the frame (18) and its squared length (5); the part of I that does not move (10),
  // the gradient of the determinant (13), I and d (7), and the energy (4).
  static constexpr Operations corner = {57, 1, 0, 0};
  // The derivatives of I and d (14), those of the energy in them (7, 1 / d^2 being known), the chain rule (28), the
  // exponential and its derivatives (16), and the sums (6).
  static constexpr Operations corner_of_derivatives = {71, 0, 0, 1};
  // the inverse of the modulus of the Hessian (15), the step (14), its slope and its squared length (7)
  static constexpr Operations newton_step = {36, 3, 1, 0};
  // The offset from the new place (3), the determinant (14), the squared length (5), I and d (7), the energy (4),
  // whether the face is safely positive (2), and its share of the objective (3).
  static constexpr Operations corner_of_value = {38, 1, 0, 1};
  // the height above the tangent plane
  static constexpr Operations value = {6, 1, 1, 0};
  // from the frame to space (18), and from nearly length 1 to it (10)
  static constexpr Operations new_position = {28, 0, 0, 0};

  void add(const Operations& operations, double times)
  {
    sums_and_products += times * operations.sums_and_products;
    divisions += times * operations.divisions;
    square_roots += times * operations.square_roots;
    exponentials += times * operations.exponentials;
  }
};

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_SWEEP_WORK_H
