#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_THREADS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_THREADS_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>

namespace Module {

/// runs f in this thread, and its parallel parts with at most `max_threads` threads; 0 is no limit.
template <class Function>
auto run_with_threads([[maybe_unused]] std::size_t max_threads, const Function& f) -> decltype(f())
{
#ifdef CGAL_LINKED_WITH_TBB
  if(max_threads > 0)
  {
    const auto n_cores = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    return tbb::task_arena(static_cast<int>((std::min)(max_threads, n_cores))).execute(f);
  }
#endif
  return f();
}

} // namespace Module

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_THREADS_H
