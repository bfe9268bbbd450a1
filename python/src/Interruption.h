#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_INTERRUPTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_INTERRUPTION_H

#include <pybind11/pybind11.h>

#include <chrono>

namespace Module {

namespace py = pybind11;

/// Asks Python for its signals, such as that of Ctrl-C, in the thread of the caller, without the lock of the interpreter.
class Interruption
{
public:
  explicit Interruption(bool returns_on_interrupt)
    : m_returns_on_interrupt(returns_on_interrupt)
  {}

  bool is_stopped() const { return m_is_stopped; }
  void stop() { m_is_stopped = true; }

  /// throws what a signal has raised, unless it is an interrupt that is to stop the run.
  void check()
  {
    const py::gil_scoped_acquire lock;
    if(PyErr_CheckSignals() == 0)
      return;
    py::error_already_set error;
    stop_or_throw(error);
  }

  /// checks from time to time: other threads of Python may hold the lock for some milliseconds.
  void check_now_and_then()
  {
    constexpr std::chrono::milliseconds pause{20};
    if(Clock::now() < m_next)
      return;
    check();
    m_next = Clock::now() + pause;
  }

  /// Needs the lock.
  void stop_or_throw(py::error_already_set& error)
  {
    if(!m_returns_on_interrupt || !error.matches(PyExc_KeyboardInterrupt))
      throw error;
    stop();
  }

private:
  using Clock = std::chrono::steady_clock;

  bool m_returns_on_interrupt;
  bool m_is_stopped = false;
  Clock::time_point m_next = Clock::now();
};

} // namespace Module

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_INTERRUPTION_H
