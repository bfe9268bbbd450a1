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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_BLOCK_EQUATIONS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_BLOCK_EQUATIONS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Sparse_factorization.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

#ifdef CGAL_EIGEN3_ENABLED

// The equations of a step of all vertices: a symmetric matrix of 3 x 3 blocks, one for each vertex and for each edge,
// for two coordinates and a multiplier. The elimination order reduces fill-in.
class Block_equations
{
public:
  explicit Block_equations(const Vertex_rings& rings)
    : right_side(3 * rings.number_of_vertices())
    , m_factorization(pattern(rings))
  {}

  void set_zero()
  {
    std::fill(m_matrix.values.begin(), m_matrix.values.end(), 0.);
    std::fill(right_side.begin(), right_side.end(), 0.);
  }

  // The first of the three rows of a vertex.
  std::size_t row(std::size_t v) const { return 3 * std::size_t(m_order[v]); }

  // Row i >= j, column j of the block of a vertex.
  double& diagonal(std::size_t v, std::size_t i, std::size_t j) { return m_matrix.values[m_diagonals[v][j] + i]; }

  // The entry in row i of the first vertex of a corner (v, w) and column j of the second one, or its mirror image.
  double& entry(std::size_t corner, std::size_t i, std::size_t j)
  {
    const Pair& pair = m_pairs[corner]; // with the columns of the vertex that is eliminated first
    return m_matrix.values[pair.is_transposed ? pair.columns[j] + i : pair.columns[i] + j];
  }

  // Returns false if the matrix has no factorization, or if goes_on(), called every few milliseconds, returns false.
  template <class Goes_on>
  bool solve(std::vector<double>& solution, const Goes_on& goes_on)
  {
    if(!m_factorization.factorize(m_matrix, goes_on))
      return false;
    solution = right_side;
    m_factorization.solve(solution);
    return true;
  }

  std::vector<double> right_side;

private:
  struct Pair
  {
    std::array<std::size_t, 3> columns = {0, 0, 0}; // where the columns of a block begin in the values of the matrix
    bool is_transposed = false;
  };

  const Symmetric_matrix& pattern(const Vertex_rings& rings)
  {
    m_order = elimination_order(rings.number_of_vertices(), [&](const auto& add) {
      for(std::uint32_t v = 0; v < rings.number_of_vertices(); ++v)
      {
        add(v, v);
        for(const std::uint32_t w : rings.ring(v))
          add(w, v);
      }
    });

    // The columns of a block: those of its vertex, then those of its neighbors that are eliminated later, in increasing
    // order.
    std::vector<std::uint32_t> vertices(m_order.size());
    for(std::uint32_t v = 0; v < m_order.size(); ++v)
      vertices[m_order[v]] = v;
    m_pairs.assign(rings.number_of_corners(), Pair());
    std::vector<std::uint32_t> later; // positions in a ring
    std::vector<std::uint32_t>& rows = m_matrix.rows;
    rows.reserve(5 * rings.number_of_corners() + 6 * m_order.size());
    m_matrix.starts.reserve(3 * m_order.size() + 1);
    m_diagonals.resize(m_order.size());
    for(const std::uint32_t v : vertices)
    {
      const Vertex_rings::Ring ring = rings.ring(v);
      later.clear();
      for(std::uint32_t j = 0; j < ring.size(); ++j)
        if(m_order[ring[j]] > m_order[v])
          later.push_back(j);
      std::sort(later.begin(), later.end(),
                [&](std::uint32_t i, std::uint32_t j) { return m_order[ring[i]] < m_order[ring[j]]; });
      for(std::size_t column = 0; column < 3; ++column)
      {
        const std::size_t start = rows.size();
        m_diagonals[v][column] = start - column; // of row 0, which the lower triangle may not contain
        for(std::size_t i = column; i < 3; ++i)
          rows.push_back(static_cast<std::uint32_t>(row(v) + i));
        for(std::size_t k = 0; k < later.size(); ++k)
        {
          const std::uint32_t w = ring[later[k]];
          Pair& pair = m_pairs[rings.offset(v) + later[k]];
          pair.columns[column] = rows.size();
          pair.is_transposed = false;
          for(std::size_t i = 0; i < 3; ++i)
            rows.push_back(static_cast<std::uint32_t>(row(w) + i));
          if(column == 2)
          {
            Pair& other = m_pairs[rings.offset(w) + rings.ring(w).position_of(v)];
            other = pair;
            other.is_transposed = true;
          }
        }
        m_matrix.starts.push_back(rows.size());
      }
    }
    m_matrix.values.resize(rows.size());
    return m_matrix;
  }

  std::vector<std::uint32_t> m_order;                  // in which the vertices are eliminated
  std::vector<std::array<std::size_t, 3>> m_diagonals; // of each vertex, as in a Pair
  std::vector<Pair> m_pairs;                           // of each corner of the rings
  Symmetric_matrix m_matrix;
  Sparse_factorization m_factorization;
};

#endif // CGAL_EIGEN3_ENABLED

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_BLOCK_EQUATIONS_H
