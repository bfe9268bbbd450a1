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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SOLVER_TRAITS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SOLVER_TRAITS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Default.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/SparseCholesky>
#endif

#include <type_traits>

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
                "The parameter `SolverTraits_` is required if Eigen is not enabled.");
  using type = SolverTraits;
#endif
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SOLVER_TRAITS_H
