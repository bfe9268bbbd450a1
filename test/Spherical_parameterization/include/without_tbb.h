#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_WITHOUT_TBB_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_WITHOUT_TBB_H

#include <cstddef>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {
struct Execution;
}
} // namespace Spherical_parameterization
} // namespace CGAL

namespace test {

namespace SP = CGAL::Spherical_parameterization;

// 0 + 1 + ... + n - 1, by a loop that is compiled without TBB and has scratch memory for each thread
std::size_t sum_without_tbb(const SP::internal::Execution& execution, std::size_t n);

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_WITHOUT_TBB_H
