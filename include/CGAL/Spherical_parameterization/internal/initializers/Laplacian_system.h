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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_LAPLACIAN_SYSTEM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_LAPLACIAN_SYSTEM_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Sparse_factorization.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Run.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <CGAL/Default.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

#ifdef CGAL_EIGEN3_ENABLED

// The default model of `SparseLinearAlgebraTraits_d`, for symmetric matrices whose entries are all set once. Eigen only
// chooses the elimination order; all arithmetic is done here, because other libraries may be compiled with contracted
// operations.
class Cholesky_solver_traits
{
public:
  using NT = double;

  class Matrix
  {
  public:
    explicit Matrix(std::size_t size)
      : m_size(size)
    {}

    void set_coef(std::uint32_t row, std::uint32_t column, double value, bool)
    {
      m_entries.push_back({row, column, value});
    }

  private:
    friend class Cholesky_solver_traits;

    struct Entry
    {
      std::uint32_t row, column;
      double value;
    };

    std::size_t m_size;
    std::vector<Entry> m_entries;
  };

  using Vector = std::vector<double>;

  bool factor(const Matrix& matrix, double& denominator)
  {
    denominator = 1.;
    m_order = elimination_order(matrix.m_size, [&](const auto& add) {
      for(const Matrix::Entry& entry : matrix.m_entries)
        add(entry.row, entry.column);
    });
    // The lower triangle in elimination order: of a pair of symmetric entries, the one in the lower triangle is stored.
    std::vector<Matrix::Entry> entries;
    for(const Matrix::Entry& entry : matrix.m_entries)
      if(entry.row >= entry.column)
      {
        const auto [column, row] = std::minmax(m_order[entry.row], m_order[entry.column]);
        entries.push_back({row, column, entry.value});
      }
    std::sort(entries.begin(), entries.end(), [](const Matrix::Entry& a, const Matrix::Entry& b) {
      return std::pair(a.column, a.row) < std::pair(b.column, b.row);
    });
    Symmetric_matrix triangle;
    triangle.starts.resize(matrix.m_size + 1);
    for(const Matrix::Entry& entry : entries)
    {
      triangle.rows.push_back(entry.row);
      triangle.values.push_back(entry.value);
      triangle.starts[entry.column + 1] = triangle.rows.size();
    }
    m_factorization.emplace(triangle);
    return m_factorization->factorize(triangle, [] { return true; });
  }

  bool linear_solver(const Vector& right_side, Vector& solution)
  {
    Vector x(right_side.size());
    for(std::size_t k = 0; k < x.size(); ++k)
      x[m_order[k]] = right_side[k];
    m_factorization->solve(x);
    for(std::size_t k = 0; k < x.size(); ++k)
      solution[k] = x[m_order[k]];
    return true;
  }

private:
  std::vector<std::uint32_t> m_order; // the position of each row in the elimination order
  std::optional<Sparse_factorization> m_factorization;
};

#endif // CGAL_EIGEN3_ENABLED

// The sparse solver of parameterizers that require one: the caller's, or by default the one above.
template <class SolverTraits>
struct Solver_traits
{
#ifdef CGAL_EIGEN3_ENABLED
  using type = typename Default::Get<SolverTraits, Cholesky_solver_traits>::type;
#else
  static_assert(!std::is_same<SolverTraits, Default>::value,
                "The parameter `SolverTraits` is required if Eigen is not enabled.");
  using type = SolverTraits;
#endif
};

// The linear system of a weighted Laplacian, factorized once and solved for many right-hand sides, three at a time.
// Some vertices are fixed at 0: otherwise the system would be singular, because constants are in the kernel of a
// Laplacian.
template <class SolverTraits>
class Laplacian_system
{
public:
  // `weights` are those of the edges in the order of the corners of `rings`; `is_fixed` marks the fixed vertices.
  // Returns false if the solver fails.
  template <class IsFixed>
  bool factor(const Vertex_rings& rings, const std::vector<double>& weights, const IsFixed& is_fixed)
  {
    const std::size_t n = rings.number_of_vertices();
    m_vertices.clear();
    std::vector<std::uint32_t> row(n, 0);
    for(std::uint32_t v = 0; v < n; ++v)
      if(!is_fixed(v))
      {
        row[v] = static_cast<std::uint32_t>(m_vertices.size());
        m_vertices.push_back(v);
      }
    Matrix& matrix = m_matrix.emplace(m_vertices.size());
    for(const std::uint32_t v : m_vertices)
    {
      const Vertex_rings::Ring ring = rings.ring(v);
      double sum = 0.;
      for(std::size_t j = 0; j < ring.size(); ++j)
      {
        const double weight = weights[rings.offset(v) + j];
        sum += weight;
        if(!is_fixed(ring[j]))
          matrix.set_coef(row[v], row[ring[j]], -weight, true);
      }
      matrix.set_coef(row[v], row[v], sum, true);
    }
    double denominator = 1.;
    return m_solver.factor(matrix, denominator);
  }

  // Replaces the right-hand sides, one for each vertex, by the solution; returns false if the solver fails.
  bool solve(std::vector<Vector_3d>& x)
  {
    Vector right(m_vertices.size()), solution(m_vertices.size());
    for(std::size_t i = 0; i < 3; ++i)
    {
      for(std::size_t k = 0; k < m_vertices.size(); ++k)
        right[static_cast<Index>(k)] = x[m_vertices[k]][i];
      if(!m_solver.linear_solver(right, solution))
        return false;
      for(Vector_3d& p : x)
        p[i] = 0.;
      for(std::size_t k = 0; k < m_vertices.size(); ++k)
        x[m_vertices[k]][i] = solution[static_cast<Index>(k)];
    }
    return true;
  }

private:
  using Traits = typename Solver_traits<SolverTraits>::type;
  using Matrix = typename Traits::Matrix;
  using Vector = typename Traits::Vector;
  // Indices of a vector of the solver, which Eigen counts with signed integers.
  using Index = std::conditional_t<std::is_same_v<Vector, std::vector<double>>, std::size_t, std::ptrdiff_t>;

  std::optional<Matrix> m_matrix; // the solver may refer to it
  Traits m_solver;
  std::vector<std::uint32_t> m_vertices; // of the rows
};

// Decreases the energy of the map of a run by iterations that each solve a linear system. `method` has
//   weights()                            of the edges, which define the Laplacian of the system; vertex 0 is fixed
//   bool find_step(positions, system)    whether the system could be solved
//   bool move(positions, t, candidate)   whether the map after the fraction t of the step is admissible; if not, or if its
//                                        energy is too high, the step is halved
//   double energy_of(positions)          and radius(), the optimal radius for the last positions
template <class SolverTraits, class Method>
Error_code lower_energy(Method method, std::size_t max_rounds, Run& run)
{
  Laplacian_system<SolverTraits> system;
  if(!system.factor(run.surface.rings(), method.weights(), [](std::uint32_t v) { return v == 0; }))
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  std::vector<Vector_3d>& positions = run.positions;
  Parameterization_report& report = run.control.report();
  double energy = method.energy_of(positions), lowest_energy = energy;
  run.radius = method.radius();
  report.initial_energy = energy;
  report.stop_reason = ITERATION_LIMIT;
  std::vector<Vector_3d> candidate(positions.size());
  for(std::size_t i = 0; i < max_rounds; ++i)
  {
    if(!method.find_step(positions, system))
      return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    double t = 1., next_energy = 0.;
    bool is_found = false;
    for(int halving = 0; halving < Method::max_halvings && !is_found; ++halving, t *= 0.5)
    {
      const bool is_allowed = method.move(positions, t, candidate);
      next_energy = is_allowed ? method.energy_of(candidate) : std::numeric_limits<double>::infinity();
      is_found = next_energy < (1. + Method::max_increase) * lowest_energy;
    }
    if(!is_found)
    {
      report.stop_reason = next_energy - energy <= Method::tolerance * energy ? CONVERGED : OBSTRUCTED;
      break;
    }
    const bool has_settled = std::abs(next_energy - energy) < Method::tolerance * energy;
    positions.swap(candidate);
    energy = next_energy;
    lowest_energy = (std::min)(lowest_energy, energy);
    run.radius = method.radius();
    ++report.number_of_average_iterations;
    run.control.after_iteration(i + 1, energy, run.radius);
    if(!run.control.go_further(i + 1, energy))
      break;
    if(has_settled)
    {
      report.stop_reason = CONVERGED;
      break;
    }
  }
  report.average_energy = energy;
  report.seconds_for_optimization = run.control.lap();
  run.control.on_optimization_end();
  return OK;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_LAPLACIAN_SYSTEM_H
