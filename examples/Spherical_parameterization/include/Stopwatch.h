// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_STOPWATCH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_STOPWATCH_H

#include <chrono>

namespace Program {

/// Seconds by a clock that nobody sets: one that tells the time of day may be set while a batch runs all night.
class Stopwatch
{
public:
  /// returns the seconds since the stopwatch was made, or since the last `lap()`.
  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  /// returns the same, and starts anew.
  double lap()
  {
    const double passed = seconds();
    m_start = Clock::now();
    return passed;
  }

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point m_start = Clock::now();
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_STOPWATCH_H
