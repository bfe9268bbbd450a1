#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_INTERRUPTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_INTERRUPTION_H

#include <CGAL/Spherical_parameterization/Default_visitor.h>

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstddef>

namespace Module {

namespace py = pybind11;

/// What may end a run, asked in the thread of the caller, without the lock of the interpreter: the signals of Python, such as
/// that of Ctrl-C, and the caller's function.
class Interruption
{
public:
  /// \param callback the caller's function, or None
  Interruption(const py::object& callback, bool returns_on_interrupt)
    : m_callback(callback)
    , m_returns_on_interrupt(returns_on_interrupt)
  {}

  bool is_stopped() const { return m_is_stopped; }

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

  /// calls the caller's function, if there is one, which stops the run by a false value other than None, and throws what it
  /// raises.
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

/// A visitor of functions that nothing but signals can stop. It is made with the lock of the interpreter.
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
