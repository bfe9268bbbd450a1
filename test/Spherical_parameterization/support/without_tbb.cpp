// Compiled without TBB, and linked to what is compiled with it.

#undef CGAL_LINKED_WITH_TBB

#include "without_tbb.h"

#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>

#include <atomic>
#include <cstddef>

namespace test {

std::size_t sum_without_tbb(const SP::internal::Execution& execution, std::size_t n)
{
  std::atomic<std::size_t> sum(0);
  SP::internal::Per_thread<std::size_t> scratch(execution, 7);
  SP::internal::for_each_block(execution, 0, n, 3, [&](std::size_t begin, std::size_t end) {
    std::size_t& local = scratch.local(); // 7 between two blocks
    for(std::size_t k = begin; k < end; ++k)
      local += k;
    sum += local - 7;
    local = 7;
  });
  return sum;
}

} // namespace test
