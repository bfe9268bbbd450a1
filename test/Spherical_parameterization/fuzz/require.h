#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_REQUIRE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_REQUIRE_H

#include "standard_library.h"

#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <gtest/gtest.h>

#include <cstdio>

// Ends the program if the condition does not hold: to a fuzzer, that is a crash to be reported.
inline void require(bool condition, const char* message)
{
  if(condition)
    return;
  std::fprintf(stderr, "A requirement does not hold: %s\n", message);
  std::abort();
}

// Makes a failed expectation of GoogleTest an exception, which ends the program as well.
inline void require_expectations()
{
  static const bool is_initialized = [] {
    ::testing::InitGoogleTest();
    return ::testing::GTEST_FLAG(throw_on_failure) = true;
  }();
  (void)is_initialized;
}

// what a terminal shows as it is, and not too much of it
inline bool is_message(const std::string& text)
{
  constexpr std::size_t max_size = 700;
  return !text.empty() && text.size() <= max_size &&
         std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
}

// calls f(), which may refuse the file
template <class F>
void require_message_or_nothing(const F& f)
{
  try
  {
    f();
  }
  catch(const CGAL::Spherical_parameterization::internal::File_error& error)
  {
    require(is_message(error.what()), error.what());
  }
}

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_REQUIRE_H
