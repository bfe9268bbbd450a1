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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FOR_EACH_BLOCK_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FOR_EACH_BLOCK_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Fork_join_order.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
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

// Calls f(begin, end) for consecutive blocks that cover [first, last), in parallel if `ConcurrencyTag` asks for it and
// there is enough to do. The blocks are independent of the number of threads: block k starts at first + k * block_size.
// So whatever is reduced block by block and then over the blocks in order has the same bits however it was run.
//
// The call may come from within a task of the caller's. Two things keep that from showing: a group of tasks of its own,
// as one that is cancelled along with the caller's would leave out blocks without a word, and isolation, as a thread
// that waits for its blocks would otherwise take up another task of the caller's, long beyond any time limit. The
// blocks are run with the rounding mode of the caller, as what is around them is.
template <class ConcurrencyTag, class Function>
void for_each_block(std::size_t first, std::size_t last, std::size_t block_size, const Function& f)
{
  const std::size_t n_blocks = last > first ? (last - first + block_size - 1) / block_size : 0;
  const auto run = [&](std::size_t block) {
    const std::size_t begin = first + block * block_size;
    f(begin, (std::min)(begin + block_size, last));
  };
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    if(n_blocks > 1)
    {
      const Fork_join_order order;
      tbb::task_group_context context(tbb::task_group_context::isolated,
                                      tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
      tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, n_blocks),
            [&](const tbb::blocked_range<std::size_t>& blocks) {
              const Fork_join_order::Task task(order);
              for(std::size_t block = blocks.begin(); block != blocks.end(); ++block)
                run(block);
            },
            context);
      });
      return;
    }
  }
#else
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif
  for(std::size_t block = 0; block < n_blocks; ++block)
    run(block);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FOR_EACH_BLOCK_H
