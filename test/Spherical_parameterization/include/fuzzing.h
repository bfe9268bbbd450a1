// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_FUZZING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_FUZZING_H

// What the tests on random data have in common: random numbers, how many and which, runs that are checked twice and can
// be repeated from one number, and a table of what came out.
//
// Two environment variables make such a test longer or repeat a part of it:
// - SPHERICAL_PARAMETERIZATION_FUZZ_COUNT, how many data a file of tests runs on in all (its tests share them),
// - SPHERICAL_PARAMETERIZATION_FUZZ_SEED, the first seed of every test; the others follow by counting.

#include <CGAL/Spherical_parameterization/Error_code.h>

#include "independent_check.h"
#include "test_meshes.h"
#include "test_runs.h"
#include "test_scale.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace fuzzing {

using test_meshes::Coordinates;
using test_meshes::Triangle_list;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// Random numbers that are the same on every machine: the standard specifies the engine, but not the distributions. As
// it does not specify the order in which arguments are evaluated either, only one of them may draw a number.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : m_engine(seed)
  {}

  // one of 0, ..., n - 1
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(m_engine() % n); }

  // one of low, ..., high
  int integer(int low, int high) { return low + static_cast<int>(below(static_cast<std::size_t>(high - low + 1))); }

  bool one_in(std::size_t n) { return below(n) == 0; }

  // in [0, 1)
  double unit() { return std::ldexp(static_cast<double>(m_engine() >> 11), -53); }

  // in [low, high)
  double between(double low, double high) { return low + (high - low) * unit(); }

  // in [2^low, 2^high), each power of two as likely as the others
  double magnitude(int low, int high)
  {
    const double mantissa = 1. + unit();
    return std::ldexp(mantissa, integer(low, high - 1));
  }

  // in the unit ball
  Coordinates in_ball()
  {
    for(;;)
    {
      const Coordinates p = {between(-1., 1.), between(-1., 1.), between(-1., 1.)};
      if(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] <= 1.)
        return p;
    }
  }

  // on the unit sphere
  Coordinates direction()
  {
    for(;;)
    {
      const Coordinates p = in_ball();
      const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      if(length > 0.1)
        return {p[0] / length, p[1] / length, p[2] / length};
    }
  }

private:
  std::mt19937_64 m_engine;
};

// The seeds of one test.
class Seeds
{
public:
  // `share` is what the test gets of the data of all tests of a file, which are `total` unless the environment says
  // otherwise; `first` is the first seed, again unless the environment says otherwise.
  Seeds(std::size_t total, double share, std::uint64_t first)
    : m_first(number("SPHERICAL_PARAMETERIZATION_FUZZ_SEED", first))
    , m_size(static_cast<std::size_t>(std::llround(
          share * static_cast<double>(number("SPHERICAL_PARAMETERIZATION_FUZZ_COUNT", test_scale::reduced(total))))))
  {
    m_size = (std::max)(m_size, std::size_t(1));
  }

  std::size_t size() const { return m_size; }
  std::uint64_t operator[](std::size_t i) const { return m_first + i; }

private:
  static std::uint64_t number(const char* variable, std::uint64_t otherwise)
  {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
  }

  std::uint64_t m_first;
  std::size_t m_size;
};

// As long as it lives, a crash is reported with what was being done, and so is an end from outside, as of a run that
// hangs.
class Crash_reporter
{
public:
  explicit Crash_reporter(const std::string& what)
  {
    std::snprintf(text(), text_size, "%s", what.c_str());
    set_handlers(report);
  }

  ~Crash_reporter() { set_handlers(SIG_DFL); }

  Crash_reporter(const Crash_reporter&) = delete;
  Crash_reporter& operator=(const Crash_reporter&) = delete;

private:
  static constexpr std::size_t text_size = 500;

  static char* text()
  {
    static char buffer[text_size];
    return buffer;
  }

  static void set_handlers(void (*handler)(int))
  {
    for(const int number : {SIGFPE, SIGABRT, SIGTERM, SIGINT})
      std::signal(number, handler);
    if(!test_scale::is_slow) // a sanitizer has a better handler
      std::signal(SIGSEGV, handler);
  }

  static void report(int number)
  {
    std::fprintf(stderr, "Signal %d in: %s\n", number, text());
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
};

// A parameterizer, with one thread or several.
template <class Parameterizer, class ConcurrencyTag>
class With_threads
{
public:
  explicit With_threads(Parameterizer& parameterizer)
    : m_parameterizer(parameterizer)
  {}

  template <class VertexSphereMap, class NamedParameters>
  CGAL::Spherical_parameterization::Error_code parameterize(const Mesh& mesh, VertexSphereMap map,
                                                            const NamedParameters& np)
  {
    return m_parameterizer.template parameterize<ConcurrencyTag>(mesh, map, np);
  }

  const CGAL::Spherical_parameterization::Parameterization_report& report() const { return m_parameterizer.report(); }

private:
  Parameterizer& m_parameterizer;
};

// What came out of a run, and after how long.
struct Outcome
{
  CGAL::Spherical_parameterization::Error_code error = CGAL::Spherical_parameterization::OK;
  double seconds = 0.;
  double largest_distortion = 1.; // D_iso
  std::size_t number_of_attempts = 0;
};

// A description that one finds this datum with again.
inline std::string how_to_repeat(std::uint64_t seed, const std::string& kind)
{
  const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return kind + "; repeat it with SPHERICAL_PARAMETERIZATION_FUZZ_SEED=" + std::to_string(seed) +
         " SPHERICAL_PARAMETERIZATION_FUZZ_COUNT=1 and --gtest_filter=" + test->test_suite_name() + "." + test->name();
}

// Runs a parameterizer that promises a bijection on a valid mesh: no exception, and if OK is returned, the map is
// one-to-one, by the package's own certificate and by a check that has nothing to do with it. If not, the method has
// failed to find a map; there is nothing wrong with the mesh.
template <class ConcurrencyTag, class Parameterizer>
Outcome run(const Triangle_list& list, Parameterizer& parameterizer, unsigned int number_of_iterations,
            const std::string& description)
{
  const Crash_reporter reporter(description);
  SCOPED_TRACE(description);
  Outcome outcome;
  try
  {
    const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
    With_threads<Parameterizer, ConcurrencyTag> with_threads(parameterizer);
    const auto start = std::chrono::steady_clock::now();
    const test_runs::Result result = test_runs::run<Point_3>(
        mesh, with_threads, false, CGAL::parameters::number_of_iterations(number_of_iterations));
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    outcome.error = result.error;
    outcome.number_of_attempts = result.report.number_of_attempts;
    if(result.error == CGAL::Spherical_parameterization::OK)
    {
      EXPECT_TRUE(independent_check::is_one_to_one(result.images, list.triangles));
      outcome.largest_distortion = result.distortion.isometric.maximum;
    }
    else
    {
      EXPECT_TRUE(result.error == CGAL::Spherical_parameterization::ERROR_INSUFFICIENT_PRECISION ||
                  result.error == CGAL::Spherical_parameterization::ERROR_INVALID_INITIAL_PARAMETERIZATION ||
                  result.error == CGAL::Spherical_parameterization::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM)
          << CGAL::Spherical_parameterization::get_error_message(result.error);
    }
  }
  catch(const std::exception& e)
  {
    ADD_FAILURE() << e.what();
  }
  return outcome;
}

// The outcomes of many runs, by kinds: a run is counted under each kind that it is of, and under its error if it has
// one.
class Tally
{
public:
  void add(const std::vector<std::string>& kinds, const Outcome& outcome, std::uint64_t seed,
           const std::string& description)
  {
    for(const std::string& kind : kinds)
      m_rows[kind].add(outcome, seed);
    m_all.add(outcome, seed);
    if(outcome.error != CGAL::Spherical_parameterization::OK)
    {
      const std::string error = "error " + std::to_string(outcome.error);
      m_rows[error].add(outcome, seed);
      m_refusals.push_back(error + ": " + description + "\n");
    }
  }

  std::size_t size() const { return m_all.count; }
  std::size_t number_of_refusals() const { return m_all.refused; }

  // The first refusals, with what one repeats them by.
  std::string refusals() const
  {
    constexpr std::size_t most = 10;
    std::string result;
    for(std::size_t i = 0; i < (std::min)(most, m_refusals.size()); ++i)
      result += m_refusals[i];
    return m_refusals.size() > most ? result + "and so on\n" : result;
  }

  // One line for each kind, and one for all.
  void print() const
  {
    std::printf("%-22s %7s %7s %8s %9s %9s (%10s) %9s (%10s)\n", "kind", "runs", "refused", "repeated", "mean [ms]",
                "longest", "seed", "max D_iso", "seed");
    for(const auto& row : m_rows)
      row.second.print(row.first);
    m_all.print("all");
    std::fflush(stdout);
  }

private:
  struct Row
  {
    void add(const Outcome& outcome, std::uint64_t seed)
    {
      ++count;
      refused += outcome.error != CGAL::Spherical_parameterization::OK;
      repeated += outcome.number_of_attempts > 1;
      seconds += outcome.seconds;
      if(outcome.seconds >= longest)
      {
        longest = outcome.seconds;
        seed_of_longest = seed;
      }
      if(outcome.largest_distortion >= largest_distortion)
      {
        largest_distortion = outcome.largest_distortion;
        seed_of_largest_distortion = seed;
      }
    }

    void print(const std::string& kind) const
    {
      std::printf("%-22s %7zu %7zu %8zu %9.2f %9.1f (%10llu) %9.3g (%10llu)\n", kind.c_str(), count, refused, repeated,
                  1e3 * seconds / static_cast<double>((std::max)(count, std::size_t(1))), 1e3 * longest,
                  static_cast<unsigned long long>(seed_of_longest), largest_distortion,
                  static_cast<unsigned long long>(seed_of_largest_distortion));
    }

    std::size_t count = 0, refused = 0, repeated = 0; // repeated: the hierarchy was mapped more than once
    double seconds = 0., longest = 0., largest_distortion = 1.;
    std::uint64_t seed_of_longest = 0, seed_of_largest_distortion = 0;
  };

  std::map<std::string, Row> m_rows;
  Row m_all;
  std::vector<std::string> m_refusals;
};

} // namespace fuzzing

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_FUZZING_H
