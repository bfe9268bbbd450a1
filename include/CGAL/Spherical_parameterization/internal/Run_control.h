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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_CONTROL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_CONTROL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Parameterization_report.h>

#include <chrono>
#include <cstddef>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// What goes along with a run from stage to stage: the caller's visitor, the time and the report.
template <class Visitor>
class Run_control
{
public:
  // `most_seconds` is not positive if there is no limit.
  Run_control(Visitor& visitor, double most_seconds, Parameterization_report& report)
    : m_visitor(visitor)
    , m_most_seconds(most_seconds)
    , m_report(report)
  {}

  Visitor& visitor() { return m_visitor; }
  Parameterization_report& report() { return m_report; }

  // returns the seconds since the last call, or since the beginning
  double lap()
  {
    const double now = seconds(), lap = now - m_last_lap;
    m_last_lap = now;
    return lap;
  }

  // Asks the visitor and the clock. Once either has said no, it stays so.
  bool go_further(std::size_t iteration, double energy)
  {
    if(m_stop_reason == NOT_RUN && !m_visitor.go_further(iteration, energy))
      m_stop_reason = STOPPED;
    if(m_stop_reason == NOT_RUN && m_most_seconds > 0. && seconds() > m_most_seconds)
      m_stop_reason = TIME_LIMIT;
    return m_stop_reason == NOT_RUN;
  }

  // STOPPED or TIME_LIMIT, or NOT_RUN if the run may go on
  Stop_reason stop_reason() const { return m_stop_reason; }

private:
  using Clock = std::chrono::steady_clock; // which nobody sets, other than that of Real_timer

  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  Visitor& m_visitor;
  double m_most_seconds;
  Parameterization_report& m_report;
  Clock::time_point m_start = Clock::now();
  double m_last_lap = 0.;
  Stop_reason m_stop_reason = NOT_RUN;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_CONTROL_H
