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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASELINES_LAPLACIAN_SYSTEM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASELINES_LAPLACIAN_SYSTEM_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/Default.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/SparseCholesky>
#endif

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The sparse solver of those parameterizers that need one: the caller's, or by default Eigen's Cholesky factorisation.
template <class SolverTraits>
struct Solver_traits
{
#ifdef CGAL_EIGEN3_ENABLED
  using Default_traits = Eigen_solver_traits<Eigen::SimplicialLDLT<Eigen_sparse_symmetric_matrix<double>::EigenType>>;
  using type = typename Default::Get<SolverTraits, Default_traits>::type;
#else
  static_assert(!std::is_same<SolverTraits, Default>::value,
                "The parameter `SolverTraits` is required if Eigen is not enabled.");
  using type = SolverTraits;
#endif
};

// The linear system of a weighted Laplacian, factored once and solved for many right-hand sides, each of them three at
// a time. Some vertices are held at 0: without, the system would be singular, as constants are the kernel of a
// Laplacian.
template <class SolverTraits>
class Laplacian_system
{
public:
  // `weights` are those of the edges in the order of the corners of `rings`; `is_fixed` names the vertices that are
  // held. Returns false if the solver fails.
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

  // Replaces the right-hand sides, one for each vertex, by the solution. Returns false if the solver fails.
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
  using Index = std::ptrdiff_t;

  std::optional<Matrix> m_matrix; // the solver may refer to it
  Traits m_solver;
  std::vector<std::uint32_t> m_vertices; // of the rows
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASELINES_LAPLACIAN_SYSTEM_H
