// Progress and early ends, of every method: the calls of a visitor, what the report says, and that a run may end anywhere, by
// the visitor, the number of iterations or the clock, with a map to which the error code is true.

#include "engine.h"
#include "methods.h"
#include "random_meshes.h"
#include "test_scale.h"

using namespace test;

namespace {

constexpr std::size_t stop_stride = test_scale::is_slow ? 11 : 1;

// These have no sweeps over the finest mesh, or none at all.
bool has_iterations(const Method& method)
{
  return method.name() != "hierarchical" && method.name() != "stereographic" && method.name() != "schnyder";
}

bool has_levels(const Method& method)
{
  return method.name() == "hierarchical" || method.name() == "bijective" || method.name() == "as rigid as possible";
}

TEST(Visitor, is_called_in_order)
{
  const Mesh mesh = make(bumpy_sphere(1));
  for(const Method& method : all_methods())
  {
    SCOPED_TRACE(method.name());
    Recorder recorder;
    const Result result = method.run(mesh, Options().visitor(recorder));
    const SP::Parameterization_report& report = result.report;
    EXPECT_EQ(result.error, SP::OK);
    const auto& events = recorder.events;
    EXPECT_EQ(events.front().name, "initialization_begin");
    EXPECT_EQ(events.front().number, num_vertices(mesh));
    EXPECT_EQ(recorder.all("initialization_begin").size(), 1u);
    EXPECT_EQ(recorder.all("initialization_end").size(), 1u);
    EXPECT_EQ(recorder.all("optimization_end").size(), has_iterations(method) ? 1u : 0u);
    EXPECT_EQ(events.back().name, has_iterations(method) ? "optimization_end" : "initialization_end");

    // the levels, from the coarsest, and questions without the number of an iteration
    std::size_t k = 1, last_level = 3, n_levels = 0;
    for(; events[k].name != "initialization_end"; ++k)
      if(events[k].name == "level")
      {
        EXPECT_GT(events[k].number, last_level);
        EXPECT_TRUE(n_levels++ > 0 || events[k].number == 4);
        last_level = events[k].number;
      }
      else
      {
        ASSERT_EQ(events[k].name, "question");
        EXPECT_EQ(events[k].number, 0u);
      }
    EXPECT_EQ(n_levels, report.number_of_levels);
    EXPECT_EQ(n_levels > 0, has_levels(method));
    EXPECT_TRUE(n_levels == 0 || last_level == num_vertices(mesh));

    // then each iteration with its question
    std::size_t iteration = 0;
    double energy = 0., radius = report.radius;
    for(++k; k + 1 < events.size(); k += 2)
    {
      ASSERT_EQ(events[k].name, "iteration");
      ASSERT_EQ(events[k + 1].name, "question");
      EXPECT_EQ(events[k].number, ++iteration);
      EXPECT_EQ(events[k + 1].number, iteration);
      energy = events[k].energy;
      radius = events[k].radius;
      EXPECT_EQ(events[k + 1].energy, energy);
      EXPECT_GT(energy, 0.);
    }
    EXPECT_EQ(iteration, report.number_of_iterations());
    EXPECT_EQ(iteration >= 5, has_iterations(method));
    EXPECT_NEAR(radius / report.radius, 1., 0.1); // the last one is that of the flat areas of this coarse mesh
    EXPECT_EQ(report.stop_reason, SP::CONVERGED);
    if(has_iterations(method))
    {
      EXPECT_LT(report.average_energy, report.initial_energy);
      // with the sharpness of a schedule, the mean rises to the largest energy
      EXPECT_EQ(energy < recorder.all("iteration").front().energy, method.name() != "published");
    }
  }
}

// Without any tolerance, a run goes on for as long as it is let.
Method tireless()
{
  return Method("tireless", SP::Bijective_low_distortion_parameterizer_3().tolerances(0., 0.));
}

// Stops the method at each question from the first to the last, every `step`th of them; `n` is how many iterations, at most,
// are among them. Returns how many it was.
std::size_t stop_everywhere(const Method& method, const Triangle_list& list, std::size_t n, std::size_t step)
{
  const Mesh mesh = make(list);
  Recorder watcher; // how many questions there are before the iterations, and whether there are so many
  method.run(mesh, Options().visitor(watcher).iterations(static_cast<int>(n) + 1));
  const std::size_t n_watched = watcher.all("iteration").size();
  const std::size_t n_before = watcher.number_of_questions - n_watched, n_iterations = (std::min)(n_watched, n);
  for(std::size_t stop_at = 1; stop_at <= n_before + n_iterations; stop_at += step)
  {
    SCOPED_TRACE(stop_at);
    Recorder stopper(stop_at);
    const Result result = method.run(mesh, Options().visitor(stopper).iterations(100000));
    EXPECT_TRUE(result.error == SP::OK || (method.may_fold() && result.error == SP::ERROR_NO_1_TO_1_MAPPING))
        << SP::get_error_message(result.error);
    EXPECT_EQ(result.report.stop_reason, SP::STOPPED);
    EXPECT_EQ(stopper.number_of_questions, stop_at); // it is not asked again, but informed of the end
    EXPECT_EQ(stopper.all("initialization_end").size(), 1u);
    EXPECT_EQ(stopper.all("iteration").size(), result.report.number_of_iterations());
    EXPECT_EQ(stopper.all("level").size(), result.report.number_of_levels);
    if(stop_at <= n_before)
    {
      EXPECT_LE(result.report.number_of_iterations(), 1u);
      continue;
    }
    EXPECT_EQ(result.report.number_of_iterations(), stop_at - n_before);
    if(stop_at % 10 == 0)
    {
      // it is the run of so many iterations
      const Result limited = method.run(mesh, Options().iterations(static_cast<int>(stop_at - n_before)));
      EXPECT_EQ(limited.report.stop_reason, SP::ITERATION_LIMIT);
      EXPECT_TRUE(have_same_bits(result.images, limited.images));
      EXPECT_EQ(result.error, limited.error);
    }
  }
  return n_iterations;
}

TEST(Visitor, may_stop_anywhere)
{
  EXPECT_EQ(stop_everywhere(tireless(), bumpy_sphere(1), 100, stop_stride), 100u);
  stop_everywhere(tireless(), random_stacked_sphere(30, 1), 100, stop_stride);
  stop_everywhere(bijective_conformal(), with_tentacle(6, 3.), 60, 3 * stop_stride);
  stop_everywhere(hierarchical(), random_stacked_sphere(100, 1), 0, stop_stride);
  stop_everywhere(bijective(), bumpy_sphere(5), 2, 17 * stop_stride); // also within the descent over a level
  EXPECT_EQ(stop_everywhere(published(), bumpy_sphere(1), 120, 3 * stop_stride), 120u);
  for(const Method& method : {harmonic(), conformal(), arap()})
    for(const Triangle_list& list : {bumpy_sphere(1), random_stacked_sphere(60, 7), with_tentacle(5, 2.)})
      stop_everywhere(method, list, 100, stop_stride);
}

// A level needs one sweep, and gets no more if the visitor has stopped the run.
TEST(Visitor, may_stop_the_hierarchy_at_once)
{
  Recorder stopper(1);
  const Result result = hierarchical().run(bumpy_sphere(2), Options().visitor(stopper));
  EXPECT_EQ(result.error, SP::OK);
  EXPECT_EQ(result.report.number_of_level_iterations, result.report.number_of_levels);
}

TEST(Number_of_iterations, is_respected)
{
  const Mesh mesh = make(bumpy_sphere(2));
  for(const Method& method : all_methods())
  {
    if(!has_iterations(method) || method.may_fold())
      continue;
    SCOPED_TRACE(method.name());
    double last_average = HUGE_VAL, last_largest = HUGE_VAL;
    for(const int n : {0, 1, 7})
    {
      const Result result = method.run(mesh, Options().iterations(n));
      EXPECT_EQ(result.error, SP::OK);
      EXPECT_EQ(result.report.number_of_iterations(), static_cast<std::size_t>(n));
      EXPECT_EQ(result.report.stop_reason, SP::ITERATION_LIMIT);
      EXPECT_TRUE(result.report.average_energy < last_average || result.report.largest_energy < last_largest);
      last_average = result.report.average_energy;
      last_largest = result.report.largest_energy;
    }
  }
}

TEST(Number_of_iterations, has_its_defaults)
{
  EXPECT_EQ(SP::internal::default_number_of_sweeps(42), 250u * 47u); // as many times more for small meshes
  EXPECT_EQ(SP::internal::default_number_of_sweeps(5000), 250u);
  const Result few = tireless().run(bumpy_sphere(1), Options().iterations(50));
  EXPECT_EQ(few.report.stop_reason, SP::ITERATION_LIMIT);
  EXPECT_GT(tireless().run(with_tentacle(30, 6.)).report.number_of_iterations(), 250u);
}

TEST(Report, adds_up)
{
  Triangle_list list = octahedron(); // with isolated vertices and a face without area
  list.points.push_back({0.5, 0.5, 0.});
  list.triangles[0] = {0, 6, 4};
  list.triangles.push_back({6, 2, 4});
  list.triangles.push_back({0, 2, 6});
  list.points.push_back({5., 5., 5.});
  list.points.push_back({6., 6., 6.});
  for(const Method& method : all_methods())
  {
    SCOPED_TRACE(method.name());
    EXPECT_EQ(method.report().stop_reason, SP::NOT_RUN);
    EXPECT_EQ(method.report().number_of_vertices, 0u);
    const SP::Parameterization_report report = method.run(list).report;
    EXPECT_EQ(report.number_of_vertices, 7u);
    EXPECT_EQ(report.number_of_isolated_vertices, 2u);
    EXPECT_EQ(report.number_of_flat_faces, 1u);
    EXPECT_EQ(report.number_of_faces, 10u);
    EXPECT_EQ(report.number_of_average_iterations + report.number_of_sharp_iterations, report.number_of_iterations());
    for(const double seconds : {report.seconds_for_reading, report.seconds_for_hierarchy, report.seconds_for_embedding,
                                report.seconds_for_optimization, report.seconds_for_certificate})
      EXPECT_GE(seconds, 0.);
    EXPECT_EQ(report.seconds_for_hierarchy > 0., has_levels(method));
    EXPECT_GT(report.seconds_for_embedding, 0.);
    EXPECT_EQ(report.seconds_for_optimization > 0., has_iterations(method));
    EXPECT_GT(report.seconds_for_certificate, 0.);
    EXPECT_NEAR(report.seconds(),
                report.seconds_for_reading + report.seconds_for_hierarchy + report.seconds_for_embedding +
                    report.seconds_for_optimization + report.seconds_for_certificate,
                1e-12);
  }
}

TEST(Report, has_the_energies_of_the_map)
{
  const Result result = bijective().run(bumpy_sphere(2));
  const SP::Parameterization_report& report = result.report;
  EXPECT_EQ(report.number_of_attempts, 1u);
  EXPECT_GT(report.number_of_level_iterations, report.number_of_levels);
  EXPECT_GT(report.sharpness, 0.);
  EXPECT_GT(report.largest_energy, report.average_energy);
  EXPECT_GE(report.average_energy, 2.);
  // but for the d of the energy being less than that of the flat triangle
  EXPECT_NEAR(result.distortion.radius, report.radius, 1e-14 * report.radius);
  const double d = result.distortion.isometric.maximum;
  EXPECT_GT(report.largest_energy, 0.5 * d * d);
  EXPECT_LT(report.largest_energy, 2.1 * d * d);
}

TEST(Time_limit, is_a_stop_of_the_visitor)
{
  Random random(1);
  for(const auto& [method, list] : {std::pair<Method, Triangle_list>(bijective(), bumpy_sphere(3)),
                                    {bijective(), random_stacked_sphere(300, 7)},
                                    {published(), bumpy_sphere(1)},
                                    {hierarchical(), with_tentacle(100, 30.)},
                                    {harmonic(), bumpy_sphere(3)},
                                    {conformal(), random_stacked_sphere(300, 7)},
                                    {arap(), bumpy_sphere(3)},
                                    {bijective_from_stereographic(), bumpy_sphere(2)}})
  {
    SCOPED_TRACE(method.name());
    const Mesh mesh = make(list);
    Recorder watcher;
    const Result complete = method.run(mesh, Options().visitor(watcher).iterations(100));
    EXPECT_NE(complete.report.stop_reason, SP::TIME_LIMIT);
    for(std::size_t k = 0; k < (test_scale::is_slow ? 2 : 8); ++k)
    {
      // from hardly any time to a little more than is needed
      const double share = random.unit();
      const double max_seconds =
          k == 0 ? (std::numeric_limits<double>::min)() : 1.1 * share * share * complete.report.seconds();
      SCOPED_TRACE(max_seconds);
      Recorder recorder;
      const Result result = method.run(mesh, Options().visitor(recorder).iterations(100).seconds(max_seconds));
      EXPECT_EQ(result.error == SP::OK || method.may_fold(), true);
      if(result.report.stop_reason != SP::TIME_LIMIT) // nothing has been cut
      {
        EXPECT_GT(k, 0u);
        EXPECT_EQ(result.report.stop_reason, complete.report.stop_reason);
        EXPECT_TRUE(have_same_bits(result.images, complete.images));
        continue;
      }
      EXPECT_GE(result.report.seconds(), max_seconds);
      EXPECT_LE(recorder.number_of_questions, watcher.number_of_questions);
      EXPECT_EQ(result.report.number_of_iterations(), recorder.all("iteration").size());
    }
  }
}

TEST(Time_limit, is_none_unless_it_is_positive)
{
  const Mesh mesh = make(bumpy_sphere(1));
  const Result complete = bijective().run(mesh);
  for(const double seconds : {0., -0., -1., -HUGE_VAL, std::nan(""), HUGE_VAL, (std::numeric_limits<double>::max)()})
  {
    const Result result = bijective().run(mesh, Options().seconds(seconds));
    EXPECT_EQ(result.report.stop_reason, complete.report.stop_reason) << seconds;
    EXPECT_TRUE(have_same_bits(result.images, complete.images)) << seconds;
  }
  for(const double seconds : {std::numeric_limits<double>::denorm_min(), 1e-300, 1e-9})
  {
    const Result result = bijective().run(mesh, Options().seconds(seconds));
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_EQ(result.report.stop_reason, SP::TIME_LIMIT) << seconds;
    EXPECT_LE(result.report.number_of_iterations(), 1u);
  }
}

// Also between two questions to the visitor: an energy that takes its time during the first sweep over the first level ends that
// level with this sweep, and each finer level gets the one sweep that it needs.
TEST(Time_limit, is_met_on_the_levels)
{
  bool is_slow = true;
  const Method method("hooked", SP::Hierarchical_parameterizer_3().energy(Hooked_energy([&] {
    if(is_slow)
      std::this_thread::sleep_for(std::chrono::milliseconds(600));
    is_slow = false;
  })));
  const Result result = method.run(bumpy_sphere(2), Options().seconds(0.5).sequential());
  EXPECT_EQ(result.error, SP::OK);
  EXPECT_EQ(result.report.stop_reason, SP::TIME_LIMIT);
  EXPECT_EQ(result.report.number_of_level_iterations, result.report.number_of_levels);
}

} // namespace
