// A run may end anywhere, by the visitor or by the clock: what has been reached by then is a certified bijection, or for
// the methods that may fold, a map of which the error code tells the truth.

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"
#include "test_runs.h"
#include "test_scale.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iterator>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>

namespace SP = CGAL::Spherical_parameterization;
namespace params = CGAL::parameters;

namespace {

using test_meshes::Triangle_list;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

using Bijective = SP::Bijective_low_distortion_parameterizer_3<Mesh>;
using Published = SP::Published_low_distortion_parameterizer_3<Mesh>;
using Hierarchical = SP::Hierarchical_parameterizer_3<Mesh>;
using Harmonic = SP::Harmonic_parameterizer_3<Mesh>;
using Conformal = SP::Conformal_parameterizer_3<Mesh>;
using ARAP = SP::ARAP_parameterizer_3<Mesh>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Stops when it is asked for the `stop_at`th time.
struct Stopper : SP::Default_visitor
{
  explicit Stopper(std::size_t n = 0)
    : stop_at(n)
  {}

  void after_iteration(std::size_t i, double, double) { last_iteration = i; }
  bool go_further(std::size_t, double) { return ++n_questions != stop_at; }

  std::size_t stop_at, n_questions = 0, last_iteration = 0;
};

// Never settled, so that it is the visitor or the clock that ends the run.
template <class Method>
Method tireless()
{
  Method method;
  method.set_tolerances(0., 0.);
  return method;
}

constexpr unsigned int many = 100000;

// ---------------------------------------------------------------------------------------------------------------------
// Stopped by the visitor.

// Stops the method at each question from the first to the last, every `stride`th of them; `n` is how many sweeps over the
// mesh itself, at most, are among them. Returns how many it was.
template <class Method>
std::size_t stop_everywhere(const Mesh& mesh, Method& method, bool may_fold, std::size_t n, std::size_t stride)
{
  // how many questions there are before the sweeps, and whether there are so many sweeps
  Stopper watcher;
  test_runs::run<Point_3>(mesh, method, may_fold,
                          params::visitor(std::ref(watcher)).number_of_iterations(static_cast<unsigned int>(n + 1)));
  const std::size_t n_before = watcher.n_questions - watcher.last_iteration;
  const std::size_t n_iterations = (std::min)(watcher.last_iteration, n);
  for(std::size_t stop_at = 1; stop_at <= n_before + n_iterations; stop_at += stride)
  {
    SCOPED_TRACE(stop_at);
    Stopper stopper(stop_at);
    const test_runs::Result result =
        test_runs::run<Point_3>(mesh, method, may_fold, params::visitor(std::ref(stopper)).number_of_iterations(many));
    EXPECT_TRUE(result.error == SP::OK || (may_fold && result.error == SP::ERROR_NO_1_TO_1_MAPPING))
        << SP::get_error_message(result.error);
    EXPECT_EQ(result.report.stop_reason, SP::STOPPED);
    EXPECT_EQ(stopper.n_questions, stop_at);
    EXPECT_EQ(stopper.last_iteration, result.report.number_of_iterations());
    if(stop_at > n_before)
    {
      EXPECT_EQ(result.report.number_of_iterations(), stop_at - n_before);
      if(stop_at % 10 != 0)
        continue;
      // it is the run of so many sweeps
      const test_runs::Result limited = test_runs::run<Point_3>(
          mesh, method, may_fold, params::number_of_iterations(static_cast<unsigned int>(stop_at - n_before)));
      EXPECT_TRUE(test_maps::have_same_bits(result.images, limited.images));
      EXPECT_EQ(result.error, limited.error);
    }
    else
      EXPECT_LE(result.report.number_of_iterations(), 1u);
  }
  return n_iterations;
}

constexpr std::size_t stride = test_scale::is_slow ? 11 : 1;

TEST(Stopped_at_every_iteration, of_the_default)
{
  std::size_t most_iterations = 0;
  for(const Triangle_list& list : {test_meshes::bumpy_sphere(1), test_meshes::random_stacked_sphere(30, 1)})
  {
    const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
    Bijective method = tireless<Bijective>();
    most_iterations = (std::max)(most_iterations, stop_everywhere(mesh, method, false, 200, stride));
  }
  EXPECT_EQ(most_iterations, 200u); // without any tolerance, a run ends when no bit of the energy changes any more
}

TEST(Stopped_at_every_iteration, of_the_published_method)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(1));
  Published method = tireless<Published>();
  EXPECT_EQ(stop_everywhere(mesh, method, false, 200, stride), 200u);
}

TEST(Stopped_at_every_iteration, of_conformal_maps_that_do_not_fold)
{
  using Method = SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, SP::Conformal_energy_3>;
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::with_tentacle(6, 3.));
  Method method = tireless<Method>();
  EXPECT_EQ(stop_everywhere(mesh, method, false, 200, 3 * stride), 200u);
}

TEST(Stopped_at_every_iteration, of_the_hierarchy)
{
  for(const Triangle_list& list :
      {test_meshes::bumpy_sphere(2), test_meshes::random_stacked_sphere(100, 1), test_meshes::with_tentacle(30, 10.)})
  {
    const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
    Hierarchical method;
    stop_everywhere(mesh, method, false, 0, stride);
  }
}

// These converge by themselves, or cannot go on, within fewer steps.
template <class Method>
class Stopped_at_every_step : public ::testing::Test
{};

using Methods = ::testing::Types<Harmonic, Conformal, ARAP>;
TYPED_TEST_SUITE(Stopped_at_every_step, Methods, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Stopped_at_every_step, of_easy_and_hard_meshes)
{
  const bool may_fold = !std::is_same<TypeParam, Harmonic>::value;
  std::size_t most_steps = 0;
  for(const Triangle_list& list : {test_meshes::bumpy_sphere(1), test_meshes::random_stacked_sphere(60, 7),
                                   test_meshes::ellipsoid(0.2, 1., 1., 1), test_meshes::with_tentacle(5, 2.)})
  {
    const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
    TypeParam method;
    most_steps = (std::max)(most_steps, stop_everywhere(mesh, method, may_fold, 200, stride));
  }
  EXPECT_GE(most_steps, 10u);
}

// ---------------------------------------------------------------------------------------------------------------------
// Stopped by the clock.

struct Timing
{
  double of_all = 0., of_first_map = 0., largest_excess = 0.;
  std::size_t n_runs = 0, n_cut = 0;
};

// Gives the method random times from very short ones to a little more than it needs.
template <class Method>
Timing limit_time(const Mesh& mesh, const Method& prototype, bool may_fold, unsigned int n_iterations,
                  std::size_t n_runs, std::mt19937& random)
{
  Timing timing;
  const auto run = [&](double most_seconds, Stopper& stopper) {
    Method method = prototype;
    CGAL::Real_timer timer;
    timer.start();
    const test_runs::Result result = test_runs::run<Point_3>(
        mesh, method, may_fold,
        params::maximum_running_time(most_seconds).visitor(std::ref(stopper)).number_of_iterations(n_iterations));
    EXPECT_TRUE(result.error == SP::OK || (may_fold && result.error == SP::ERROR_NO_1_TO_1_MAPPING))
        << SP::get_error_message(result.error);
    return result;
  };
  Stopper watcher;
  const test_runs::Result complete = run(0., watcher);
  timing.of_all = complete.report.seconds();
  EXPECT_NE(complete.report.stop_reason, SP::TIME_LIMIT);

  const auto expect_sound = [&](double most_seconds) {
    SCOPED_TRACE(most_seconds);
    Stopper stopper;
    const test_runs::Result result = run(most_seconds, stopper);
    const SP::Parameterization_report& report = result.report;
    ++timing.n_runs;
    if(report.stop_reason != SP::TIME_LIMIT)
    {
      // then nothing has been cut
      EXPECT_EQ(report.stop_reason, complete.report.stop_reason);
      EXPECT_EQ(report.number_of_iterations(), complete.report.number_of_iterations());
      EXPECT_TRUE(test_maps::have_same_bits(result.images, complete.images));
      return report.seconds();
    }
    ++timing.n_cut;
    EXPECT_GE(report.seconds(), most_seconds); // and not before
    timing.largest_excess = (std::max)(timing.largest_excess, report.seconds() - most_seconds);
    EXPECT_LE(stopper.n_questions, watcher.n_questions);
    EXPECT_EQ(report.number_of_iterations(), stopper.last_iteration);
    // it is the run that the visitor ends at the same question
    Stopper same(stopper.n_questions);
    const test_runs::Result stopped = run(0., same);
    EXPECT_EQ(stopped.report.stop_reason, SP::STOPPED);
    EXPECT_EQ(stopped.report.number_of_iterations(), report.number_of_iterations());
    EXPECT_EQ(stopped.error, result.error);
    EXPECT_TRUE(test_maps::have_same_bits(result.images, stopped.images));
    return report.seconds();
  };
  timing.of_first_map = expect_sound((std::numeric_limits<double>::min)());
  EXPECT_EQ(timing.n_cut, 1u);
  for(std::size_t k = 0; k < n_runs; ++k)
  {
    const double share = static_cast<double>(random()) * 0x1p-32; // of the time of the whole run
    expect_sound(1.1 * share * share * timing.of_all);
  }
  return timing;
}

void print(const std::string& name, std::size_t n_vertices, const Timing& timing)
{
  std::printf("  %-24s %6zu vertices: all %7.4f s, first map %7.4f s, at most %7.4f s over the limit; cut %zu of %zu\n",
              name.c_str(), n_vertices, timing.of_all, timing.of_first_map, timing.largest_excess, timing.n_cut,
              timing.n_runs);
}

class Stopped_by_the_clock : public ::testing::Test
{
protected:
  template <class Method>
  void limit(const std::string& name, const Triangle_list& list, bool may_fold, unsigned int n_iterations,
             std::size_t n_runs)
  {
    SCOPED_TRACE(name);
    const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
    const Timing timing = limit_time(mesh, Method(), may_fold, n_iterations, n_runs, m_random);
    print(name, mesh.num_vertices(), timing);
  }

private:
  std::mt19937 m_random{1};
};

TEST_F(Stopped_by_the_clock, at_random_times)
{
  const std::size_t n_runs = test_scale::reduced(20);
  const Triangle_list bumpy = test_meshes::bumpy_sphere(3), spiky = test_meshes::random_stacked_sphere(300, 7);
  limit<Bijective>("default", test_meshes::bumpy_sphere(1), false, 100, n_runs);
  limit<Bijective>("default", bumpy, false, 100, n_runs);
  limit<Bijective>("default", spiky, false, 100, n_runs);
  limit<Bijective>("default", test_meshes::with_tentacle(100, 30.), false, 100, n_runs);
  limit<Published>("published", test_meshes::bumpy_sphere(2), false, 200, n_runs);
  limit<Hierarchical>("hierarchical", bumpy, false, 100, n_runs);
  limit<Harmonic>("harmonic", bumpy, false, 100, n_runs);
  limit<Conformal>("conformal", spiky, true, 100, n_runs);
  limit<ARAP>("as rigid as possible", bumpy, true, 100, n_runs);
  limit<SP::Bijective_low_distortion_parameterizer_3<Mesh, Harmonic>>("default from harmonic", bumpy, false, 100,
                                                                      n_runs);
}

TEST_F(Stopped_by_the_clock, at_random_times_on_large_meshes)
{
  for(const unsigned int subdivisions : {4u, 5u, 6u})
    if(subdivisions == 4 || !test_scale::is_slow)
      limit<Bijective>("default", test_meshes::bumpy_sphere(subdivisions), false, 10, subdivisions == 6 ? 2 : 6);
  if(!test_scale::is_slow)
    limit<Bijective>("default, stacked", test_meshes::random_stacked_sphere(50000, 1), false, 5, 2);
}

// What is no time limit is none.
TEST_F(Stopped_by_the_clock, only_by_times_that_are_positive)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(1));
  Bijective method;
  const test_runs::Result complete = test_runs::run<Point_3>(mesh, method, false);
  for(const double most_seconds : {0., -0., -1., -infinity, -std::numeric_limits<double>::denorm_min(), nan, infinity,
                                   (std::numeric_limits<double>::max)()})
  {
    SCOPED_TRACE(most_seconds);
    const test_runs::Result result =
        test_runs::run<Point_3>(mesh, method, false, params::maximum_running_time(most_seconds));
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_EQ(result.report.stop_reason, complete.report.stop_reason);
    EXPECT_TRUE(test_maps::have_same_bits(result.images, complete.images));
  }
  for(const double most_seconds :
      {std::numeric_limits<double>::denorm_min(), (std::numeric_limits<double>::min)(), 1e-300, 1e-9})
  {
    SCOPED_TRACE(most_seconds);
    const test_runs::Result result =
        test_runs::run<Point_3>(mesh, method, false, params::maximum_running_time(most_seconds));
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_EQ(result.report.stop_reason, SP::TIME_LIMIT);
    EXPECT_LE(result.report.number_of_iterations(), 1u);
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// The same through the command line.

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM
TEST_F(Stopped_by_the_clock, in_the_program)
{
  const Triangle_list list = test_meshes::bumpy_sphere(4);
  const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
  {
    std::ofstream out("surface.off");
    ASSERT_TRUE(CGAL::IO::write_OFF(out, mesh, params::stream_precision(17)));
  }
  const auto run = [](const std::string& arguments) {
    std::remove("sphere.off");
    const std::string command = "'" SPHERICAL_PARAMETERIZATION_PROGRAM
                                "' surface.off -o sphere.off --json report.json " +
                                arguments + " > stdout.txt 2> stderr.txt < /dev/null";
    return std::system(command.c_str());
  };
  const auto content = [](const char* name) {
    std::ifstream in(name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string cut = "\"time limit\"";

  ASSERT_EQ(run(""), 0);
  EXPECT_EQ(content("report.json").find(cut), std::string::npos);
  const std::string complete = content("sphere.off");
  std::mt19937 random(2);
  std::size_t n_cut = 0;
  const std::size_t n_runs = test_scale::reduced(20);
  for(std::size_t k = 0; k < n_runs; ++k)
  {
    // from a second to nothing
    const int exponent = -static_cast<int>((k + 1) * 20 / n_runs);
    const double most_seconds = std::ldexp(1. + static_cast<double>(random()) * 0x1p-32, exponent);
    std::ostringstream arguments;
    arguments << "--time-limit " << std::setprecision(17) << most_seconds;
    SCOPED_TRACE(arguments.str());
    ASSERT_EQ(run(arguments.str()), 0) << content("stderr.txt");
    std::ifstream in("sphere.off");
    Mesh sphere;
    ASSERT_TRUE(CGAL::IO::read_OFF(in, sphere));
    ASSERT_EQ(sphere.num_faces(), mesh.num_faces());
    EXPECT_TRUE(SP::is_bijective(sphere, sphere.points()));
    const bool is_cut = content("report.json").find(cut) != std::string::npos;
    EXPECT_TRUE(is_cut || content("sphere.off") == complete);
    n_cut += is_cut;
  }
  EXPECT_GT(n_cut, 0u);

  // the shortest and the longest that can be written, and what is no time
  for(const char* seconds : {"1e-9", "2.3e-308", "1.7e308"})
    EXPECT_EQ(run(std::string("--time-limit ") + seconds), 0) << seconds;
  EXPECT_EQ(content("sphere.off"), complete);
  for(const char* seconds : {"0", "-1", "nan", "inf", "soon", "1s"})
  {
    EXPECT_NE(run(std::string("--time-limit ") + seconds), 0) << seconds;
    EXPECT_FALSE(std::ifstream("sphere.off").is_open()) << seconds;
  }
}
#endif

} // namespace
