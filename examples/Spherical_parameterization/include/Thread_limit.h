// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_THREAD_LIMIT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_THREAD_LIMIT_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>
#endif

#include <cstddef>

namespace Program {

/// As long as an object of this class lives, no more threads than given are used.
class Thread_limit
{
public:
  /// sets the limit; 0 stands for none.
  explicit Thread_limit(unsigned int most_threads)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(most_threads > 0)
      m_control.emplace(tbb::global_control::max_allowed_parallelism, most_threads);
#else
    static_cast<void>(most_threads); // there is one thread only
#endif
  }

  /// returns how many threads a loop may have now: one for each core that the program may use, or the limit.
  static std::size_t number_of_threads()
  {
#ifdef CGAL_LINKED_WITH_TBB
    return (std::min)(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism),
                      static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()));
#else
    return 1;
#endif
  }

#ifdef CGAL_LINKED_WITH_TBB
private:
  std::optional<tbb::global_control> m_control;
#endif
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_THREAD_LIMIT_H
