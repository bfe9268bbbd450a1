// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENGINE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENGINE_H

// The part of the library that takes longest to compile, instantiated once (engine.cpp) for the energies that the tests, the
// examples and the benchmarks use most.

#include <CGAL/Spherical_parameterization/Conformal_energy_3.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/descent/Descent_loop.h>
#include <CGAL/Spherical_parameterization/internal/descent/Hierarchical_embedding.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace test {

// The symmetric Dirichlet energy, written for single numbers, which calls a function each time that it is evaluated, and
// whose best scale is what a test says.
class Hooked_energy
{
public:
  explicit Hooked_energy(const std::function<void()>& on_evaluation = nullptr, std::optional<double> scale = {})
    : m_on_evaluation(std::make_shared<std::function<void()>>(on_evaluation))
    , m_scale(scale)
  {}

  double operator()(double i, double d) const
  {
    if(*m_on_evaluation)
      (*m_on_evaluation)();
    return m_energy(i, d);
  }

  CGAL::Spherical_parameterization::Energy_derivatives_3<> derivatives(double i, double d) const
  {
    if(*m_on_evaluation)
      (*m_on_evaluation)();
    return m_energy.derivatives(i, d);
  }

  double optimal_scale(const CGAL::Spherical_parameterization::Face_range_3& faces) const
  {
    return m_scale ? *m_scale : m_energy.optimal_scale(faces);
  }

private:
  CGAL::Spherical_parameterization::Symmetric_Dirichlet_energy_3 m_energy;
  std::shared_ptr<std::function<void()>> m_on_evaluation;
  std::optional<double> m_scale;
};

} // namespace test

#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_LOOP(EXTERN, Energy, Step)                                                \
  EXTERN template class Descent_loop<Energy, Step>;
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENERGY(EXTERN, Energy)                                                    \
  EXTERN template bool embed_hierarchically(const Surface&, const Energy&, const Sharpness&, std::size_t, bool,        \
                                            std::vector<Vector_3d>&, Run_control&, Execution,                          \
                                            const std::vector<double>&);                                               \
  CGAL_SPHERICAL_PARAMETERIZATION_TEST_LOOP(EXTERN, Energy, Newton_step)
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENGINE(EXTERN)                                                            \
  CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENERGY(EXTERN, Symmetric_Dirichlet_energy_3)                                    \
  CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENERGY(EXTERN, Isometric_energy_3)                                              \
  CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENERGY(EXTERN, Conformal_energy_3)                                              \
  CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENERGY(EXTERN, test::Hooked_energy)                                             \
  CGAL_SPHERICAL_PARAMETERIZATION_TEST_LOOP(EXTERN, Isometric_energy_3, Gradient_step)

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {
CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENGINE(extern)
} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENGINE_H
