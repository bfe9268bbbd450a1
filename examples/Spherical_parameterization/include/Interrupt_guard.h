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
#include <initializer_list>
#include <mutex>
#include <utility>
#include <vector>

namespace Program {

/// As long as an object of this class lives, Ctrl-C does not end the program but is noted. A second signal ends it.
///
/// Objects that are made meanwhile, by whatever thread, and do not live longer leave everything to the first one.
class Interrupt_guard
{
public:
  /// \param signals what is noted, two at most; by default, what Ctrl-C sends
  explicit Interrupt_guard(std::initializer_list<int> signals = {SIGINT})
  {
    const std::lock_guard<std::mutex> lock(s_mutex);
    if(s_number_of_guards++ > 0)
      return;
    int n = 0;
    for(const int signal : signals)
      s_signals[n++] = signal;
    s_number_of_signals = n;
    for(const int signal : signals)
      m_previous.emplace_back(signal, std::signal(signal, &note));
  }

  ~Interrupt_guard()
  {
    const std::lock_guard<std::mutex> lock(s_mutex);
    --s_number_of_guards;
    for(const auto& [signal, handler] : m_previous)
      std::signal(signal, handler == SIG_ERR ? SIG_DFL : handler);
  }

  Interrupt_guard(const Interrupt_guard&) = delete;
  Interrupt_guard& operator=(const Interrupt_guard&) = delete;

  /// returns whether there has been a Ctrl-C, or another of the signals.
  static bool is_interrupted() { return s_flag != 0; }

private:
  static void note(int)
  {
    s_flag = 1;
    for(int k = 0; k < s_number_of_signals; ++k)
      std::signal(s_signals[k], SIG_DFL);
  }

  static constexpr int most_signals = 2;

  inline static volatile std::sig_atomic_t s_flag = 0, s_number_of_signals = 0, s_signals[most_signals];
  inline static std::mutex s_mutex;
  inline static int s_number_of_guards = 0;

  std::vector<std::pair<int, void (*)(int)>> m_previous;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INTERRUPT_GUARD_H
