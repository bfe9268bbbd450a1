#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_RECORDING_CONTROL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_RECORDING_CONTROL_H

// What accompanies a run of the package's inner parts: a visitor that stores what is reported to it, and may say no after a number
// of questions, no time limit, and a report.

#include "standard_library.h"

#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>

namespace test {

class Recording_control : public CGAL::Spherical_parameterization::internal::Run_control
{
public:
  Recording_control()
    : Run_control(0.)
  {}

  void on_initialization_begin(std::size_t) override {}
  void on_level(std::size_t n) override { levels.push_back(n); }
  void on_initialization_end() override {}
  void after_iteration(std::size_t, double energy, double radius) override
  {
    energies.push_back(energy);
    radii.push_back(radius);
  }
  void on_optimization_end() override {}

  std::vector<std::size_t> levels;
  std::vector<double> energies, radii;
  std::size_t number_of_questions = 0, max_questions = (std::numeric_limits<std::size_t>::max)();

private:
  bool visitor_goes_further(std::size_t, double) override { return number_of_questions++ < max_questions; }
};

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_RECORDING_CONTROL_H
