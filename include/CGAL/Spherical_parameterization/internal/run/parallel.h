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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_PARALLEL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_PARALLEL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Whether loops are parallel: a value, so that nothing below the parameterizers is compiled once for each tag.
enum class Execution
{
  SEQUENTIAL,
  PARALLEL
};

template <class ConcurrencyTag>
constexpr Execution execution_of()
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif
  return std::is_convertible<ConcurrencyTag, Parallel_tag>::value ? Execution::PARALLEL : Execution::SEQUENTIAL;
}

// Refers to a function f(begin, end) without owning it: the loop below is compiled once, whatever it calls.
class Block_function
{
public:
  template <class Function>
  explicit Block_function(const Function& f)
    : m_function(&f)
    , m_call([](const void* function, std::size_t begin, std::size_t end) {
      (*static_cast<const Function*>(function))(begin, end);
    })
  {}

  void operator()(std::size_t begin, std::size_t end) const { m_call(m_function, begin, end); }

private:
  const void* m_function;
  void (*m_call)(const void*, std::size_t, std::size_t);
};

inline void run_blocks(Execution execution, std::size_t first, std::size_t last, std::size_t block_size,
                       const Block_function& f)
{
  const std::size_t n_blocks = last > first ? (last - first + block_size - 1) / block_size : 0;
  const auto run = [&](std::size_t block) {
    const std::size_t begin = first + block * block_size;
    f(begin, (std::min)(begin + block_size, last));
  };
#ifdef CGAL_LINKED_WITH_TBB
  if(execution == Execution::PARALLEL && n_blocks > 1)
  {
    tbb::task_group_context context(tbb::task_group_context::isolated,
                                    tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, n_blocks),
          [&](const tbb::blocked_range<std::size_t>& blocks) {
            for(std::size_t block = blocks.begin(); block != blocks.end(); ++block)
              run(block);
          },
          context);
    });
    return;
  }
#else
  static_cast<void>(execution);
#endif
  for(std::size_t block = 0; block < n_blocks; ++block)
    run(block);
}

// Calls f(begin, end) for consecutive blocks that cover [first, last), in parallel if there is more than one. The blocks
// do not depend on the number of threads: block k starts at first + k * block_size. So whatever is reduced block by
// block and then over the blocks in order has the same bits however it was run.
//
// The call may come from within a task of the caller's. Two things keep that from showing: a task group context of its
// own, as one that is cancelled along with the caller's would skip blocks silently, and isolation, as a thread that waits
// for its blocks would otherwise take up another task of the caller's, long beyond any time limit. The blocks are run
// with the rounding mode of the caller.
template <class Function>
void for_each_block(Execution execution, std::size_t first, std::size_t last, std::size_t block_size, const Function& f)
{
  run_blocks(execution, first, last, block_size, Block_function(f));
}

// Calls f() and g(), in parallel or one after the other. Neither may see what the other one does. Loops within them are
// parallel as well; but a thread that runs one of the two does not help with the loops of the other, so g() should be
// the shorter one.
template <class Function, class OtherFunction>
void run_both(Execution execution, const Function& f, const OtherFunction& g)
{
  for_each_block(execution, 0, 2, 1, [&](std::size_t k, std::size_t) {
    if(k == 0)
      f();
    else
      g();
  });
}

// One copy of a scratch object for each thread that asks for it, or just one if the execution is sequential.
template <class T>
class Per_thread
{
public:
  Per_thread(Execution execution, const T& exemplar)
    : m_object(exemplar)
#ifdef CGAL_LINKED_WITH_TBB
    , m_is_parallel(execution == Execution::PARALLEL)
    , m_objects(exemplar)
#endif
  {
    static_cast<void>(execution);
  }

  T& local()
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(m_is_parallel)
      return m_objects.local();
#endif
    return m_object;
  }

private:
  T m_object;
#ifdef CGAL_LINKED_WITH_TBB
  bool m_is_parallel;
  tbb::enumerable_thread_specific<T> m_objects;
#endif
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_PARALLEL_H
