#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENGINE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENGINE_H

// An energy of the tests, by which the descent is compiled once (engine.cpp). In a CGAL tree, where there is no library, those
// by the energies of the package are as well.

#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/run/run_descent_impl.h>

#include <functional>
#include <memory>
#include <optional>

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

namespace CGAL::Spherical_parameterization::internal {
CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(extern, test::Hooked_energy)
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS(extern)
#endif
} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENGINE_H
