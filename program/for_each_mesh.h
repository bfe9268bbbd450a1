#ifndef PROGRAM_FOR_EACH_MESH_H
#define PROGRAM_FOR_EACH_MESH_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <future>
#include <optional>
#include <system_error>
#include <thread>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace Program {

/// Limits the number of threads during its lifetime, to the given number and to the number of threads that the process can create: the
/// thread pool would end the process if it could not create them. With a limit of one, no thread is created, unless the object ends.
class Thread_limit
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  /// sets the limit; 0: no limit.
  explicit Thread_limit(std::size_t max_threads)
  {
    const std::size_t n_wanted = max_threads > 0 ? (std::min)(max_threads, number_of_threads()) : number_of_threads();
    const std::size_t n_had = 1 + number_of_other_threads(n_wanted - 1);
    if(n_had < n_wanted)
      max_threads = n_had;
    if(max_threads > 0)
      m_control.emplace(tbb::global_control::max_allowed_parallelism, max_threads);
  }

  /// returns the number of threads that a loop may use: one for each core available to the program, or the limit.
  static std::size_t number_of_threads()
  {
    return (std::min)(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism),
                      static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()));
  }

private:
  // returns the number of threads that can be created at once, at most `max`
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
  explicit Thread_limit(std::size_t) {} // there is only one thread
#endif
};

/// The minimum file size of a large mesh: 150 to 400 thousand vertices, depending on the format. Smaller meshes need less than half
/// a gigabyte each, which is available for each core.
constexpr std::uintmax_t large = std::uintmax_t(16) << 20;

/// calls `run(i)` once for each index of `sizes`, the file sizes. `run` must not throw.
///
/// Small meshes run in parallel, one per core. This is fastest, because sequential parts of a run, such as reading, also run in parallel.
/// It needs the memory of as many meshes at once, so large meshes run one after the other, each on all cores. Meshes run in the order
/// of decreasing size, because small meshes at the end keep all cores busy.
template <class Run>
void for_each_mesh(const std::vector<std::uintmax_t>& sizes, const Run& run)
{
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return sizes[i] > sizes[j]; });
  const auto first_small = std::find_if(order.begin(), order.end(), [&](std::size_t i) { return sizes[i] < large; });
  std::for_each(order.begin(), first_small, run);
  order.erase(order.begin(), first_small);
#ifdef CGAL_LINKED_WITH_TBB
  const std::size_t n = order.size(), n_runners = (std::min)(n, Thread_limit::number_of_threads());
  std::atomic<std::size_t> next(0);
  const auto run_all = [&](std::size_t) {
    tbb::task_arena one_thread(1);
    for(std::size_t i = next++; i < n; i = next++)
      if(n - i > n_runners)
        one_thread.execute([&] { run(order[i]); });
      else // no mesh is left for the next idle thread, which helps with this one
        run(order[i]);
  };
  tbb::parallel_for(std::size_t(0), n_runners, run_all, tbb::simple_partitioner());
#else
  std::for_each(order.begin(), order.end(), run);
#endif
}

} // namespace Program

#endif // PROGRAM_FOR_EACH_MESH_H
