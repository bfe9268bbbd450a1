// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRESS_LINE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRESS_LINE_H

#include "Interrupt_guard.h"

#include <CGAL/Spherical_parameterization/Default_visitor.h>

#include <chrono>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace Program {

/// A visitor that shows the progress in one line of the terminal and stops after a Ctrl-C.
class Progress_line : public CGAL::Spherical_parameterization::Default_visitor
{
public:
  /// constructs the visitor, which shows something if that is wanted and the standard error stream is a terminal.
  explicit Progress_line(bool is_wanted)
    : m_is_shown(is_wanted && is_terminal())
  {}

  ~Progress_line() { erase(); }

  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;

  void on_initialization_begin(std::size_t number_of_vertices) { m_number_of_vertices = number_of_vertices; }

  void on_level(std::size_t number_of_vertices)
  {
    show("Initial map: ", number_of_vertices, " of ", m_number_of_vertices, " vertices");
  }

  void after_iteration(std::size_t iteration, double energy, double radius)
  {
    show("Sweep ", iteration, ": energy ", std::setprecision(6), energy, ", radius ", radius);
  }

  bool go_further(std::size_t, double) { return !Interrupt_guard::is_interrupted(); }

  void on_optimization_end() { erase(); }

private:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::milliseconds pause{50}; // a terminal may be slow

  static bool is_terminal()
  {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
  }

  template <class... Text>
  void show(const Text&... text)
  {
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
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRESS_LINE_H
