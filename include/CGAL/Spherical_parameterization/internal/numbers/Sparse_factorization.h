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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_SPARSE_FACTORIZATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_SPARSE_FACTORIZATION_H

#include <CGAL/license/Spherical_parameterization.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#endif

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The lower triangle of a sparse symmetric matrix, column by column; each starts with its diagonal entry, and rows
// increase.
struct Symmetric_matrix
{
  std::size_t size() const { return starts.size() - 1; }

  std::vector<std::size_t> starts = {0}; // of the columns, and the end
  std::vector<std::uint32_t> rows;
  std::vector<double> values;
};

#ifdef CGAL_EIGEN3_ENABLED

// The position of each row of a symmetric matrix in an elimination order with little fill-in: approximate minimum
// degree. for_each_entry(add) calls add(row, column) for all entries.
template <class For_each_entry>
std::vector<std::uint32_t> elimination_order(std::size_t size, const For_each_entry& for_each_entry)
{
  std::vector<Eigen::Triplet<double>> entries;
  for_each_entry([&](std::size_t row, std::size_t column) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), 1.);
  });
  const auto n = static_cast<Eigen::Index>(size);
  Eigen::SparseMatrix<double> graph(n, n);
  graph.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(graph, order);
  std::vector<std::uint32_t> result(size);
  for(Eigen::Index k = 0; k < n; ++k) // the k-th row to be eliminated
    result[static_cast<std::size_t>(order.indices()[k])] = static_cast<std::uint32_t>(k);
  return result;
}

#endif // CGAL_EIGEN3_ENABLED

// The factorization L D L^T of such a matrix, in the order of its rows, row by row (Davis, Direct Methods for Sparse
// Linear Systems, section 4.8). For a large mesh it takes seconds; unlike the factorizations of Eigen, it can be
// stopped.
class Sparse_factorization
{
public:
  // Computes the pattern of L, which depends only on the pattern of the matrix.
  explicit Sparse_factorization(const Symmetric_matrix& matrix)
    : m_parents(matrix.size(), none)
    , m_starts(matrix.size() + 1, 0)
    , m_diagonal(matrix.size())
    , m_marks(matrix.size())
    , m_pattern(matrix.size())
  {
    collect_rows(matrix);
    for(std::uint32_t k = 0; k < matrix.size(); ++k)
    {
      m_marks[k] = k;
      for(std::size_t e = m_row_starts[k]; e < m_row_starts[k + 1]; ++e)
        for(std::uint32_t i = m_entries[e].first; m_marks[i] != k; i = m_parents[i])
        {
          if(m_parents[i] == none)
            m_parents[i] = k;
          ++m_starts[i + 1];
          m_marks[i] = k;
        }
    }
    for(std::size_t k = 0; k < matrix.size(); ++k)
      m_starts[k + 1] += m_starts[k];
    // Uninitialized: filling the memory for a large mesh takes seconds.
    m_rows.reset(new std::uint32_t[m_starts.back()]);
    m_values.reset(new double[m_starts.back()]);
  }

  // Factorizes a matrix with this pattern. Returns false if there is no factorization, or if goes_on(), called every
  // few milliseconds, returns false.
  template <class Goes_on>
  bool factorize(const Symmetric_matrix& matrix, const Goes_on& goes_on)
  {
    constexpr std::size_t products_between_questions = std::size_t(1) << 22;
    std::size_t n_products = 0;
    std::vector<std::size_t> ends(m_starts.begin(), m_starts.end() - 1); // of the entries of each column so far
    std::vector<double> row(matrix.size(), 0.);
    for(std::uint32_t k = 0; k < matrix.size(); ++k)
    {
      // The entries of row k of L, each before those that it changes.
      std::size_t top = matrix.size();
      m_marks[k] = k;
      for(std::size_t e = m_row_starts[k]; e < m_row_starts[k + 1]; ++e)
      {
        const auto& [column, position] = m_entries[e];
        row[column] += matrix.values[position];
        std::size_t length = 0;
        for(std::uint32_t i = column; m_marks[i] != k; i = m_parents[i])
        {
          m_pattern[length++] = i;
          m_marks[i] = k;
        }
        while(length > 0)
          m_pattern[--top] = m_pattern[--length];
      }
      double d = matrix.values[matrix.starts[k]];
      for(; top < matrix.size(); ++top)
      {
        const std::uint32_t i = m_pattern[top];
        const double x = std::exchange(row[i], 0.), l = x / m_diagonal[i];
        std::size_t& end = ends[i];
        for(std::size_t p = m_starts[i]; p < end; ++p)
          row[m_rows[p]] -= m_values[p] * x;
        n_products += end - m_starts[i];
        d -= l * x;
        m_rows[end] = k;
        m_values[end++] = l;
      }
      m_diagonal[k] = d;
      if(d == 0.)
        return false;
      if(n_products > products_between_questions)
      {
        n_products = 0;
        if(!goes_on())
          return false;
      }
    }
    return true;
  }

  // Replaces the right-hand side of the equations by the solution.
  void solve(std::vector<double>& x) const
  {
    const std::size_t n = m_diagonal.size();
    for(std::size_t k = 0; k < n; ++k)
      for(std::size_t p = m_starts[k]; p < m_starts[k + 1]; ++p)
        x[m_rows[p]] -= m_values[p] * x[k];
    for(std::size_t k = 0; k < n; ++k)
      x[k] *= 1. / m_diagonal[k];
    for(std::size_t k = n; k-- > 0;)
      for(std::size_t p = m_starts[k]; p < m_starts[k + 1]; ++p)
        x[k] -= m_values[p] * x[m_rows[p]];
  }

private:
  static constexpr std::uint32_t none = ~std::uint32_t(0);

  // The entries of each row left of the diagonal: their columns, and their positions in the values.
  void collect_rows(const Symmetric_matrix& matrix)
  {
    m_row_starts.assign(matrix.size() + 1, 0);
    for(std::size_t k = 0; k < matrix.size(); ++k)
      for(std::size_t p = matrix.starts[k] + 1; p < matrix.starts[k + 1]; ++p)
        ++m_row_starts[matrix.rows[p] + 1];
    for(std::size_t k = 0; k < matrix.size(); ++k)
      m_row_starts[k + 1] += m_row_starts[k];
    m_entries.resize(m_row_starts.back());
    std::vector<std::size_t> ends(m_row_starts.begin(), m_row_starts.end() - 1);
    for(std::uint32_t k = 0; k < matrix.size(); ++k)
      for(std::size_t p = matrix.starts[k] + 1; p < matrix.starts[k + 1]; ++p)
        m_entries[ends[matrix.rows[p]]++] = {k, p};
  }

  std::vector<std::size_t> m_row_starts;
  std::vector<std::pair<std::uint32_t, std::size_t>> m_entries;
  std::vector<std::uint32_t> m_parents;    // in the elimination tree
  std::vector<std::size_t> m_starts;       // of the columns of L, without its unit diagonal
  std::unique_ptr<std::uint32_t[]> m_rows; // of the entries of L
  std::unique_ptr<double[]> m_values;      // of the entries of L
  std::vector<double> m_diagonal;          // D
  std::vector<std::uint32_t> m_marks;      // the last row in which a column was visited
  std::vector<std::uint32_t> m_pattern;    // of a row of L
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_NUMBERS_SPARSE_FACTORIZATION_H
