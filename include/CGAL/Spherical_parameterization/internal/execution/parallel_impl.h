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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_PARALLEL_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_PARALLEL_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <cstddef>
#include <memory>

namespace CGAL::Spherical_parameterization::internal {

// The loop may be called from within a task of the caller. Two measures make this safe: a task group context of its
// own, because one that is cancelled along with the caller's would silently skip blocks, and isolation, because a
// thread that waits for its blocks could otherwise start another task of the caller, far beyond any time limit. The
// blocks are run with the rounding mode of the caller.
inline void run_in_thread_pool(std::size_t n, const Block_function& f)
{
  tbb::task_group_context context(tbb::task_group_context::isolated,
                                  tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, n),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for(std::size_t k = range.begin(); k != range.end(); ++k)
            f(k, k + 1);
        },
        context);
  });
}

class Thread_pool_pointers : public Thread_pointers
{
public:
  void*& local() override { return m_pointers.local(); }

private:
  tbb::enumerable_thread_specific<void*> m_pointers{nullptr};
};

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Execution parallel_execution()
{
  return {&run_in_thread_pool, [] { return std::unique_ptr<Thread_pointers>(new Thread_pool_pointers); }};
}

} // namespace CGAL::Spherical_parameterization::internal
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_PARALLEL_IMPL_H
