// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_RUN_CONTROL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_RUN_CONTROL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>

#include <algorithm>
#include <chrono>
#include <cstddef>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The context of a run across all stages: the caller's visitor, behind an interface, the clock and the report.
class Run_control
{
public:
  // There is no limit if `max_seconds` is not positive.
  Run_control(double max_seconds, Parameterization_report& report)
    : m_max_seconds(max_seconds)
    , m_report(report)
  {}

  // The same for a run without a visitor whose report is not returned, such as one that runs concurrently with others.
  explicit Run_control(double max_seconds = 0.)
    : m_max_seconds(max_seconds)
    , m_report(m_own_report)
  {}
  virtual ~Run_control() = default;
  Run_control(const Run_control&) = delete;
  Run_control& operator=(const Run_control&) = delete;

  // See SphericalParameterizationVisitor.
  virtual void on_initialization_begin(std::size_t /* number_of_vertices */) {}
  virtual void on_level(std::size_t /* number_of_vertices */) {}
  virtual void on_initialization_end() {}
  virtual void after_iteration(std::size_t /* iteration */, double /* energy */, double /* radius */) {}
  virtual void on_optimization_end() {}

  // Whether the visitor and the clock allow the run to continue. Once the result is false, it stays false.
  bool go_further(std::size_t iteration, double energy)
  {
    if(m_stop_reason == NOT_RUN && !visitor_goes_further(iteration, energy))
      m_stop_reason = STOPPED;
    return check_clock();
  }

  // Checks only the clock, which costs almost nothing.
  bool check_clock()
  {
    if(m_stop_reason == NOT_RUN && m_max_seconds > 0. && seconds() > m_max_seconds)
      m_stop_reason = TIME_LIMIT;
    return m_stop_reason == NOT_RUN;
  }

  // STOPPED or TIME_LIMIT, or NOT_RUN if the run may continue.
  Stop_reason stop_reason() const { return m_stop_reason; }
  bool is_stopped() const { return m_stop_reason != NOT_RUN; }

  Parameterization_report& report() { return m_report; }

  // Returns the seconds since the last call, or since the beginning.
  double lap()
  {
    const double now = seconds(), lap = now - m_last_lap;
    m_last_lap = now;
    return lap;
  }

private:
  using Clock = std::chrono::steady_clock; // monotonic, unlike the one of CGAL::Real_timer

  virtual bool visitor_goes_further(std::size_t /* iteration */, double /* energy */) { return true; }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  double m_max_seconds;
  Parameterization_report m_own_report;
  Parameterization_report& m_report;
  Clock::time_point m_start = Clock::now();
  double m_last_lap = 0.;
  Stop_reason m_stop_reason = NOT_RUN;
};

// Calls f(begin, end) for blocks like for_each_block(), and checks the control every few blocks, after some
// milliseconds of work. Returns whether all blocks have been processed.
template <class Function>
bool for_each_block_until_stopped(Run_control& control, const Execution& execution, std::size_t n,
                                  std::size_t block_size, const Function& f)
{
  const std::size_t step = 16 * block_size;
  for(std::size_t begin = 0; begin < n; begin += step)
  {
    if(!control.go_further(0, 0.))
      return false;
    for_each_block(execution, begin, (std::min)(begin + step, n), block_size, f);
  }
  return control.go_further(0, 0.);
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_RUN_CONTROL_H
