#ifndef PROGRAM_THREAD_LIMIT_H
#define PROGRAM_THREAD_LIMIT_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <future>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>
#endif

#include <cstddef>

namespace Program {

/// As long as an object of this class lives, no more threads than given are used, nor more than can be had: where a process
/// may not have them all, the thread pool would end it. With one thread, none is made, unless the object ends.
class Thread_limit
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  /// sets the limit; 0 stands for none.
  explicit Thread_limit(std::size_t max_threads)
  {
    const std::size_t n_wanted = max_threads > 0 ? (std::min)(max_threads, number_of_threads()) : number_of_threads();
    const std::size_t n_had = 1 + number_of_other_threads(n_wanted - 1);
    if(n_had < n_wanted)
      max_threads = n_had;
    if(max_threads > 0)
      m_control.emplace(tbb::global_control::max_allowed_parallelism, max_threads);
  }

  /// returns how many threads a loop may have now: one for each core that the program may use, or the limit.
  static std::size_t number_of_threads()
  {
    return (std::min)(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism),
                      static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()));
  }

private:
  // returns how many threads can be had at once, at most `max`
  static std::size_t number_of_other_threads(std::size_t max)
  {
    std::promise<void> end;
    const std::shared_future<void> has_ended = end.get_future().share();
    std::vector<std::thread> threads;
    threads.reserve(max);
    try
    {
      while(threads.size() < max)
        threads.emplace_back([has_ended] { has_ended.wait(); });
    }
    catch(const std::system_error&)
    {}
    end.set_value();
    for(std::thread& thread : threads)
      thread.join();
    return threads.size();
  }

  std::optional<tbb::global_control> m_control;
#else
  explicit Thread_limit(std::size_t) {} // there is one thread only
#endif
};

} // namespace Program

#endif // PROGRAM_THREAD_LIMIT_H
