#ifndef PROGRAM_PROGRESS_VISITOR_H
#define PROGRAM_PROGRESS_VISITOR_H

#include "Interrupt_guard.h"

#include <CGAL/Spherical_parameterization/Default_visitor.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

namespace Program {

/// A visitor that records energy and radius of each sweep or global step, shows them in one line of the terminal, and stops after a
/// signal.
class Progress_visitor : public CGAL::Spherical_parameterization::Default_visitor
{
public:
  /// constructs the visitor; it shows progress if `is_shown` and the standard error stream is a terminal.
  explicit Progress_visitor(bool is_shown)
    : m_is_shown(is_shown && has_terminal())
  {}

  ~Progress_visitor() { erase(); }

  Progress_visitor(const Progress_visitor&) = delete;
  Progress_visitor& operator=(const Progress_visitor&) = delete;

  void on_initialization_begin(std::size_t number_of_vertices) { m_number_of_vertices = number_of_vertices; }

  void on_level(std::size_t number_of_vertices)
  {
    show("Initial map: ", number_of_vertices, " of ", m_number_of_vertices, " vertices");
  }

  void after_iteration(std::size_t iteration, double energy, double radius)
  {
    if((iteration - 1) % m_stride == 0)
      m_history.push_back({static_cast<double>(iteration), energy, radius});
    if(m_history.size() > max_history)
    {
      for(std::size_t k = 0; 2 * k < m_history.size(); ++k)
        m_history[k] = m_history[2 * k];
      m_history.resize((m_history.size() + 1) / 2);
      m_stride *= 2;
    }
    show("Sweep ", iteration, ": energy ", std::setprecision(6), energy, ", radius ", radius);
  }

  bool go_further(std::size_t, double) { return !Interrupt_guard::is_interrupted(); }

  void on_optimization_end() { erase(); }

  /// returns iteration, energy and radius of each sweep or step; if there are more than 2000, of every second, fourth, ...
  const std::vector<std::array<double, 3>>& history() const { return m_history; }

private:
  using Clock = std::chrono::steady_clock;

  static constexpr std::size_t max_history = 2000;

  template <class... Text>
  void show(const Text&... text)
  {
    constexpr std::chrono::milliseconds pause{50}; // a terminal may be slow
    const Clock::time_point now = Clock::now();
    if(!m_is_shown || now < m_next)
      return;
    m_next = now + pause;
    std::ostringstream line;
    (line << ... << text);
    const std::size_t length = line.str().size();
    if(length < m_length)
      line << std::string(m_length - length, ' ');
    m_length = length;
    std::cerr << '\r' << line.str() << std::flush;
  }

  void erase()
  {
    if(m_length > 0)
      std::cerr << '\r' << std::string(m_length, ' ') << '\r' << std::flush;
    m_length = 0;
  }

  bool m_is_shown;
  std::size_t m_number_of_vertices = 0;
  std::size_t m_length = 0;
  Clock::time_point m_next;
  std::vector<std::array<double, 3>> m_history;
  std::size_t m_stride = 1;
};

} // namespace Program

#endif // PROGRAM_PROGRESS_VISITOR_H
