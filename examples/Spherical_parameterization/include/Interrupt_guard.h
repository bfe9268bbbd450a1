// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INTERRUPT_GUARD_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INTERRUPT_GUARD_H

#include <csignal>

namespace Program {

/// As long as an object of this class lives, Ctrl-C does not end the program but is noted. A second one ends it.
class Interrupt_guard
{
public:
  Interrupt_guard()
    : m_previous(std::signal(SIGINT, &note))
  {}

  ~Interrupt_guard() { std::signal(SIGINT, m_previous == SIG_ERR ? SIG_DFL : m_previous); }

  Interrupt_guard(const Interrupt_guard&) = delete;
  Interrupt_guard& operator=(const Interrupt_guard&) = delete;

  /// returns whether there has been a Ctrl-C.
  static bool is_interrupted() { return s_flag != 0; }

private:
  static void note(int)
  {
    s_flag = 1;
    std::signal(SIGINT, SIG_DFL);
  }

  inline static volatile std::sig_atomic_t s_flag = 0;

  void (*m_previous)(int);
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INTERRUPT_GUARD_H
