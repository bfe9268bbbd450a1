#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_INTERRUPTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_INTERRUPTION_H

#include <CGAL/Spherical_parameterization/Default_visitor.h>

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstddef>

namespace Module {

namespace py = pybind11;

/// Checks whether a run has to end: because of a Python signal, such as that of Ctrl-C, or because of the caller's function.
/// The functions are called in the thread of the caller, without the interpreter lock.
class Interruption
{
public:
  /// \param callback the caller's function, or None
  Interruption(const py::object& callback, bool returns_on_interrupt)
    : m_callback(callback)
    , m_returns_on_interrupt(returns_on_interrupt)
  {}

  bool is_stopped() const { return m_is_stopped; }

  /// throws the exception that a signal handler raises, unless it is an interrupt that stops the run.
  void check()
  {
    const py::gil_scoped_acquire lock;
    if(PyErr_CheckSignals() == 0)
      return;
    py::error_already_set error;
    stop_or_throw(error);
  }

  /// checks every 20 milliseconds at most, because other Python threads may hold the lock for some milliseconds.
  void check_now_and_then()
  {
    constexpr std::chrono::milliseconds pause{20};
    if(Clock::now() < m_next)
      return;
    check();
    m_next = Clock::now() + pause;
  }

  /// calls the caller's function, if any. A false value other than None stops the run; exceptions are thrown.
  template <class... Arguments>
  void call(Arguments... arguments)
  {
    if(m_callback.is_none())
      return;
    const py::gil_scoped_acquire lock;
    try
    {
      const py::object answer = m_callback(arguments...);
      const int is_true = answer.is_none() ? 1 : PyObject_IsTrue(answer.ptr());
      if(is_true < 0)
        throw py::error_already_set();
      if(is_true == 0)
        m_is_stopped = true;
    }
    catch(py::error_already_set& error)
    {
      stop_or_throw(error);
    }
  }

private:
  using Clock = std::chrono::steady_clock;

  // Needs the lock.
  void stop_or_throw(py::error_already_set& error)
  {
    if(!m_returns_on_interrupt || !error.matches(PyExc_KeyboardInterrupt))
      throw error;
    m_is_stopped = true;
  }

  const py::object& m_callback;
  bool m_returns_on_interrupt;
  bool m_is_stopped = false;
  Clock::time_point m_next = Clock::now();
};

/// A visitor for functions that only signals can stop. Its constructor needs the interpreter lock.
class Signal_visitor : public CGAL::Spherical_parameterization::Default_visitor
{
public:
  bool go_further(std::size_t, double)
  {
    m_interruption.check_now_and_then();
    return true;
  }

private:
  const py::none m_no_callback;
  Interruption m_interruption{m_no_callback, false};
};

} // namespace Module

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_INTERRUPTION_H
