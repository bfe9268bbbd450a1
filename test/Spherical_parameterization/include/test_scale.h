#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_SCALE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_SCALE_H

#include "standard_library.h"

// How much a test that repeats itself does: all of it in an optimized build, a tenth where assertions or sanitizers
// make each run ten times slower.

namespace test_scale {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_IS_SLOW
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_IS_SLOW
#endif

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_TEST_IS_SLOW
constexpr bool is_slow = true;
#else
constexpr bool is_slow = false;
#endif

// `n` repetitions, or a tenth of them, but at least one
constexpr std::size_t reduced(std::size_t n)
{
  return is_slow ? (std::max)(n / 10, std::size_t(1)) : n;
}

// Whether this is a run of scripts/test_long.sh.
inline bool is_long()
{
  return std::getenv("SPHERICAL_PARAMETERIZATION_LONG_TESTS") != nullptr;
}

inline std::size_t number_of(std::size_t usual, std::size_t in_long_tests)
{
  return reduced(is_long() ? in_long_tests : usual);
}

} // namespace test_scale

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_SCALE_H
