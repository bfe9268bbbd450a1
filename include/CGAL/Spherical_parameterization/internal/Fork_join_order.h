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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FORK_JOIN_ORDER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FORK_JOIN_ORDER_H

#include <CGAL/license/Spherical_parameterization.h>

#if defined(__SANITIZE_THREAD__)
#define CGAL_SPHERICAL_PARAMETERIZATION_HAS_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CGAL_SPHERICAL_PARAMETERIZATION_HAS_THREAD_SANITIZER
#endif
#endif

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_THREAD_SANITIZER
#include <atomic>
#endif

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Tells a thread sanitizer what TBB guarantees: that the tasks of a loop come after what was before the loop, and
// before what follows it. The library of TBB is not instrumented, so that the sanitizer does not see it, and would take
// every loop for a race with what is around it. In all other builds this is nothing.
class Fork_join_order
{
public:
  // what a task has as long as it runs
  class Task
  {
  public:
    explicit Task(const Fork_join_order& order)
      : m_order(order)
    {
      m_order.begin_task();
    }
    ~Task() { m_order.end_task(); }
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;

  private:
    const Fork_join_order& m_order;
  };

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_THREAD_SANITIZER
  Fork_join_order()
  {
    m_fork.store(1, std::memory_order_release);
  }
  ~Fork_join_order()
  {
    m_join.load(std::memory_order_acquire);
  }

private:
  void begin_task() const
  {
    m_fork.load(std::memory_order_acquire);
  }
  void end_task() const
  {
    m_join.fetch_add(1, std::memory_order_release);
  }

  std::atomic<int> m_fork{0};
  mutable std::atomic<int> m_join{0};
#else
private:
  void begin_task() const {}
  void end_task() const {}
#endif
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FORK_JOIN_ORDER_H
