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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_STRAIN_SUMS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_STRAIN_SUMS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/internal/descent/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/descent/Measured_faces.h>
#include <CGAL/Spherical_parameterization/internal/descent/Sphere_cells.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

using Matrix_4 = std::array<std::array<double, 4>, 4>;

// The derivatives of the objective with respect to a deformation of the sphere: for each cell, the sums over its faces
// of the first two derivatives of psi(E(I, d)) with respect to the four entries of the derivative A of the deformation,
// at A = 1; and the derivatives with respect to the level R and the logarithm t of the radius.
//
// A deformation changes the invariant I of a face from tr M, where M is the sum of opposite_k e_k e_k^T over its edges,
// to tr(A M A^T), and d to d det A. The variable t multiplies both by exp(2 t).
template <class Space>
class Strain_sums
{
public:
  explicit Strain_sums(const Space& space)
    : m_space(space)
  {}

  // Computes the sums over the faces of the current map. Several parts are computed concurrently and added in a fixed
  // order.
  void sum_up(const Sphere_cells& grid, const Measured_faces& faces, const Star_packets& stars,
              const std::vector<Vector_3d>& positions, double radius, const Face_objective& objective,
              Execution execution)
  {
    constexpr std::size_t n_parts = 8;
    std::vector<std::vector<Sums>> parts(n_parts);
    for_each_block(execution, 0, n_parts, 1,
                   [&](std::size_t part, std::size_t) { parts[part].assign(grid.cells().size(), Sums()); });
    faces.template for_each_in_lanes<Space>(stars, positions, n_parts, execution,
                                            [&](std::size_t part, const auto& lanes, std::size_t n) {
                                              using FT = std::decay_t<decltype(lanes.inverse_doubled_area)>;
                                              add_faces<FT>(lanes, n, grid, radius * radius, objective, parts[part]);
                                            });
    m_cells = std::move(parts[0]);
    constexpr std::size_t cells_per_block = 64; // about five microseconds
    for_each_in_blocks(execution, 0, m_cells.size(), cells_per_block, [&](std::size_t cell) {
      for(std::size_t part = 1; part < n_parts; ++part)
        for(std::size_t k = 0; k < n_sums; ++k)
          m_cells[cell][k] += parts[part][cell][k];
    });
    m_shared = {};
    for(const Sums& sums : m_cells)
      for(std::size_t k = 0; k < m_shared.size(); ++k)
        m_shared[k] += sums[first_shared + k];
  }

  // The derivatives with respect to the entries 00, 01, 10 and 11 of A.
  std::array<double, 4> gradient(std::size_t cell) const { return entries(cell, 0); }
  std::array<double, 4> gradient_in_level(std::size_t cell) const { return entries(cell, 3); }
  std::array<double, 4> gradient_in_radius(std::size_t cell) const { return entries(cell, 6); }

  Matrix_4 hessian(std::size_t cell) const
  {
    const Sums& s = m_cells[cell];
    constexpr std::array<std::size_t, 4> entry = {0, 1, 1, 2};
    constexpr std::array<std::array<std::size_t, 3>, 3> product = {{{9, 10, 11}, {10, 12, 13}, {11, 13, 14}}};
    Matrix_4 h;
    for(std::size_t k = 0; k < 4; ++k)
      for(std::size_t l = 0; l < 4; ++l)
        h[k][l] = s[product[entry[k]][entry[l]]] + (k / 2 == l / 2 ? s[15 + entry[2 * (k % 2) + l % 2]] : 0.);
    h[0][3] += s[18];
    h[3][0] += s[18];
    h[1][2] -= s[18];
    h[2][1] -= s[18];
    return h;
  }

  // The derivatives with respect to R, t, R R, R t and t t.
  const std::array<double, 5>& of_level_and_radius() const { return m_shared; }

private:
  // At A = 1, the first derivatives are symmetric, so only 00, 01 and 11 are stored: the gradient from index 0, its
  // derivative with respect to R from 3, and that with respect to t from 6. The second derivatives consist of products
  // of first ones, from 9: 00 00, 00 01, 00 11, 01 01, 01 11 and 11 11; of the second derivatives of I, from 15, which
  // are those of 2 M in each row of A; and of those of the determinant, 18. From 19 on are the derivatives with respect
  // to R and t alone: R, t, R R, R t and t t.
  static constexpr std::size_t first_shared = 19, n_sums = 24;
  static_assert(n_sums % packet_width == 0, "They are added in lanes.");
  using Sums = std::array<double, n_sums>;

  std::array<double, 4> entries(std::size_t cell, std::size_t first) const
  {
    const Sums& s = m_cells[cell];
    return {s[first], s[first + 1], s[first + 1], s[first + 2]};
  }

  // psi and its derivatives, see Objective: a S is a ((1 - 1/b) R + (R/b) exp(b (E/R - 1)))
  template <class FT>
  struct Weights
  {
    Weights(const FT& energy, const Face_objective& objective)
    {
      if(objective.is_average())
        return;
      const double s = objective.sharpness, level = objective.level, b = s * level;
      const FT weight = objective.share * clamped_exponential(s * (energy - level));
      first = (1. - objective.share) + weight;
      second = s * weight;
      if(!objective.has_level())
        return;
      const FT x = (1. / level) * energy;
      r = objective.share * (1. - 1. / b) + (1. / b - x) * weight;
      er = -(b / level) * x * weight;
      rr = (b / level) * x * x * weight;
    }

    void scale(const FT& factor)
    {
      for(FT* weight : {&first, &second, &r, &er, &rr})
        *weight *= factor;
    }

    FT first = 1., second = 0.;  // derivatives with respect to E
    FT r = 0., er = 0., rr = 0.; // with respect to R, and mixed
  };

  template <class FT>
  void add_faces(const Faces_in_lanes<FT>& faces, std::size_t n, const Sphere_cells& grid, double squared_radius,
                 const Face_objective& objective, std::vector<Sums>& sums_of_cells) const
  {
    constexpr std::size_t width = Lanes<FT>::width;
    const auto& [p, opposite, inverse_doubled_area] = faces;
    const FT doubled_area = 1. / inverse_doubled_area;
    const auto invariants =
        m_space.template invariants<FT>(p, opposite, inverse_doubled_area, doubled_area, squared_radius, objective);
    const FT i = invariants[0], d = invariants[1];
    const Energy_derivatives_3<FT> e = m_space.energy().derivatives(i, d);
    Weights<FT> weights(e.value, objective);
    if constexpr(Space::Energy::weighs_faces_by_area)
      weights.scale(doubled_area);

    const Vector_3<FT> center = p[0] + p[1] + p[2];
    const std::array<std::size_t, width> cells = grid.cells_at<FT>(center);
    const auto axis = [&](Vector_3d Sphere_cells::Cell::*member) {
      const auto coordinate = [&](std::size_t j) {
        return Lanes<FT>::generate([&](std::size_t k) { return (grid.cells()[cells[k]].*member)[j]; });
      };
      return Vector_3<FT>{coordinate(0), coordinate(1), coordinate(2)};
    };
    const Vector_3<FT> x_axis = axis(&Sphere_cells::Cell::x), y_axis = axis(&Sphere_cells::Cell::y);
    std::array<FT, 3> di = {FT(0.), FT(0.), FT(0.)}; // the derivatives of I, 2 M
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Vector_3<FT> edge = p[(k + 2) % 3] - p[(k + 1) % 3];
      const FT x = dot(edge, x_axis), y = dot(edge, y_axis);
      di[0] += opposite[k] * x * x;
      di[1] += opposite[k] * x * y;
      di[2] += opposite[k] * y * y;
    }
    const FT scale = 2. * i / (di[0] + di[2]); // the face is not exactly in the plane of the cell
    for(FT& entry : di)
      entry *= scale;
    const std::array<FT, 3> dd = {d, FT(0.), d};
    const std::array<FT, 3> de = {e.i * di[0] + e.d * d, e.i * di[1], e.i * di[2] + e.d * d};
    const FT ei_t = 2. * (e.ii * i + e.id * d), ed_t = 2. * (e.id * i + e.dd * d); // derivatives with respect to t
    const FT e_t = 2. * (e.i * i + e.d * d), e_tt = 2. * (e_t + ei_t * i + ed_t * d);

    std::array<std::array<double, width>, n_sums> terms;
    const auto set = [&](std::size_t k, const FT& value) { Lanes<FT>::store(value, terms[k].data()); };
    for(std::size_t k = 0; k < 3; ++k)
    {
      set(k, weights.first * de[k]);
      set(3 + k, weights.er * de[k]);
      set(6 + k, weights.first * (2. * de[k] + ei_t * di[k] + ed_t * dd[k]) + weights.second * e_t * de[k]);
      set(15 + k, weights.first * e.i * di[k]);
    }
    std::size_t term = 9;
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t l = k; l < 3; ++l)
        set(term++,
            weights.first * (e.ii * di[k] * di[l] + e.id * (di[k] * dd[l] + dd[k] * di[l]) + e.dd * dd[k] * dd[l]) +
                weights.second * de[k] * de[l]);
    set(18, weights.first * e.d * d);
    set(first_shared, weights.r);
    set(first_shared + 1, weights.first * e_t);
    set(first_shared + 2, weights.rr);
    set(first_shared + 3, weights.er * e_t);
    set(first_shared + 4, weights.first * e_tt + weights.second * e_t * e_t);
    for(std::size_t k = 0; k < n; ++k)
    {
      double* const sums = sums_of_cells[cells[k]].data();
      for(std::size_t j = 0; j < n_sums; j += width) // the terms of a face in lanes
      {
        const FT face_terms = Lanes<FT>::generate([&](std::size_t lane) { return terms[j + lane][k]; });
        Lanes<FT>::store(Lanes<FT>::load(sums + j) + face_terms, sums + j);
      }
    }
  }

  Space m_space;
  std::vector<Sums> m_cells;
  std::array<double, 5> m_shared = {};
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_STRAIN_SUMS_H
