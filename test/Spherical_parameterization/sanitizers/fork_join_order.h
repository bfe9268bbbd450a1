// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_FORK_JOIN_ORDER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_FORK_JOIN_ORDER_H

// Informs the thread sanitizer of what TBB guarantees: that the tasks of a loop come after what was before the loop, and before
// what follows it. The library of TBB is not instrumented, so that the sanitizer does not see it, and would take every
// loop for a race with what is around it. Included ahead of every file.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cstddef>

namespace tbb {

// Preferred to the one of TBB, for any range, which it calls.
template <class Body>
void parallel_for(const blocked_range<std::size_t>& range, const Body& body, task_group_context& context)
{
  struct Order
  {
    Order() { fork.store(1, std::memory_order_release); }
    ~Order() { join.load(std::memory_order_acquire); }

    std::atomic<int> fork{0}, join{0};
  } order;
  struct Task
  {
    explicit Task(Order& o)
      : order(o)
    {
      order.fork.load(std::memory_order_acquire);
    }
    ~Task() { order.join.fetch_add(1, std::memory_order_release); }

    Order& order;
  };
  detail::d1::parallel_for(
      range,
      [&](const blocked_range<std::size_t>& blocks) {
        const Task task(order);
        body(blocks);
      },
      context);
}

} // namespace tbb

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_FORK_JOIN_ORDER_H
