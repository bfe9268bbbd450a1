// Progress and early ends: what a visitor is told, and that a run may end anywhere, with a bijection.

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace params = CGAL::parameters;

namespace {

using test_meshes::Coordinates;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Parameterizer = SP::Bijective_low_distortion_parameterizer_3<Mesh>;

// A visitor of its own, not derived from Default_visitor. It takes notes, and stops when it is asked the `stop_at`th
// time. The member functions are the concept's.
struct Recorder
{
  struct Event
  {
    std::string name;
    std::size_t number = 0;
    double energy = 0., radius = 0.;
  };

  void on_initialization_begin(std::size_t n) { add({"initialization_begin", n}); }
  void on_level(std::size_t n) { add({"level", n}); }
  void on_initialization_end() { add({"initialization_end"}); }
  void after_iteration(std::size_t i, double energy, double radius) { add({"iteration", i, energy, radius}); }
  bool go_further(std::size_t i, double energy)
  {
    add({"question", i, energy});
    return ++n_questions != stop_at;
  }
  void on_optimization_end() { add({"optimization_end"}); }

  void add(const Event& event)
  {
    events.push_back(event);
    if(events.size() == throw_at)
    {
      throw std::runtime_error("That is enough.");
    }
  }

  std::size_t count(const std::string& name) const
  {
    std::size_t n = 0;
    for(const Event& event : events)
    {
      n += event.name == name;
    }
    return n;
  }

  std::vector<Event> events;
  std::size_t n_questions = 0, stop_at = 0, throw_at = 0;
};

class Visitor : public ::testing::Test
{
protected:
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
  decltype(test_maps::make_sentinel_map<Point_3>(mesh)) map = test_maps::make_sentinel_map<Point_3>(mesh);
  const std::vector<Coordinates> untouched = test_maps::images(mesh, map);
  Parameterizer bld;
  Recorder recorder;

  std::vector<Coordinates> images() const { return test_maps::images(mesh, map); }
};

TEST_F(Visitor, is_called_in_order)
{
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::visitor(std::ref(recorder)).number_of_iterations(25u)), SP::OK);
  const std::vector<Recorder::Event>& events = recorder.events;
  EXPECT_EQ(events.front().name, "initialization_begin");
  EXPECT_EQ(events.front().number, num_vertices(mesh));
  EXPECT_EQ(events.back().name, "optimization_end");
  EXPECT_EQ(recorder.count("initialization_begin"), 1u);
  EXPECT_EQ(recorder.count("initialization_end"), 1u);
  EXPECT_EQ(recorder.count("optimization_end"), 1u);

  std::size_t k = 1, last_level = 0, n_levels = 0;
  for(; events[k].name != "initialization_end"; ++k)
  {
    if(events[k].name == "level")
    {
      EXPECT_GT(events[k].number, last_level);
      EXPECT_TRUE(n_levels > 0 || events[k].number == 4);
      last_level = events[k].number;
      ++n_levels;
    }
    else
    {
      ASSERT_EQ(events[k].name, "question");
      EXPECT_EQ(events[k].number, 0u);
      EXPECT_GE(events[k].energy, 2.);
    }
  }
  EXPECT_EQ(last_level, num_vertices(mesh));
  EXPECT_EQ(n_levels, bld.report().number_of_levels);
  EXPECT_GE(n_levels, 5u);

  std::size_t iteration = 0;
  for(++k; events[k].name != "optimization_end"; k += 2)
  {
    ASSERT_EQ(events[k].name, "iteration");
    ASSERT_EQ(events[k + 1].name, "question");
    EXPECT_EQ(events[k].number, ++iteration);
    EXPECT_EQ(events[k + 1].number, iteration);
    EXPECT_EQ(events[k + 1].energy, events[k].energy);
    EXPECT_GE(events[k].energy, 2.);
    EXPECT_GT(events[k].radius, 0.);
  }
  EXPECT_EQ(iteration, bld.report().number_of_iterations());
  EXPECT_NEAR(events[events.size() - 3].radius, bld.report().radius, 1e-2 * bld.report().radius);
}

TEST_F(Visitor, sees_the_energy_fall)
{
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::visitor(std::ref(recorder)).number_of_iterations(30u)), SP::OK);
  double first = 0., last = 0.;
  for(const Recorder::Event& event : recorder.events)
  {
    if(event.name == "iteration")
    {
      first = first > 0. ? first : event.energy;
      last = event.energy;
    }
  }
  EXPECT_LT(last, first);
  EXPECT_LE(last, bld.report().largest_energy); // a mean of the energies
  EXPECT_GE(last, bld.report().average_energy);
}

TEST_F(Visitor, is_taken_by_reference_or_by_value)
{
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::visitor(std::ref(recorder))), SP::OK);
  EXPECT_GT(recorder.events.size(), 0u);
  Recorder other;
  other.stop_at = 3;
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::visitor(other)), SP::OK);
  EXPECT_EQ(bld.report().stop_reason, SP::STOPPED);
}

TEST_F(Visitor, has_no_influence_by_watching)
{
  ASSERT_EQ(SP::parameterize(mesh, bld, map), SP::OK);
  const std::vector<Coordinates> alone = images();
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::visitor(std::ref(recorder))), SP::OK);
  EXPECT_TRUE(test_maps::have_same_bits(images(), alone));
}

TEST_F(Visitor, may_stop_anywhere)
{
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::visitor(std::ref(recorder)).number_of_iterations(20u)), SP::OK);
  const std::size_t n_questions = recorder.n_questions, n_on_levels = n_questions - bld.report().number_of_iterations();
  ASSERT_GT(n_on_levels, 10u);
  const std::size_t n_level_iterations = bld.report().number_of_level_iterations;
  for(std::size_t stop_at = 1; stop_at < n_questions; ++stop_at)
  {
    SCOPED_TRACE(stop_at);
    Recorder stopper;
    stopper.stop_at = stop_at;
    const auto other = test_maps::make_sentinel_map<Point_3>(mesh);
    ASSERT_EQ(SP::parameterize(mesh, bld, other, params::visitor(std::ref(stopper))), SP::OK);
    ASSERT_TRUE(SP::is_bijective(mesh, other));
    EXPECT_EQ(bld.report().stop_reason, SP::STOPPED);
    // It is not asked again, but told how things end.
    EXPECT_EQ(stopper.n_questions, stop_at);
    EXPECT_EQ(stopper.events.back().name, "optimization_end");
    EXPECT_EQ(stopper.count("level"), bld.report().number_of_levels);
    if(stop_at <= n_on_levels)
    {
      EXPECT_LE(bld.report().number_of_iterations(), 1u);
      EXPECT_LT(bld.report().number_of_level_iterations, n_level_iterations);
    }
    else
    {
      EXPECT_EQ(bld.report().number_of_iterations(), stop_at - n_on_levels);
      EXPECT_EQ(bld.report().number_of_level_iterations, n_level_iterations);
    }
  }
}

// A run that the visitor stops after k sweeps is the run with k sweeps at most.
TEST_F(Visitor, stops_where_the_iteration_limit_would)
{
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::visitor(std::ref(recorder)).number_of_iterations(7u)), SP::OK);
  EXPECT_EQ(bld.report().number_of_iterations(), 7u);
  EXPECT_EQ(bld.report().stop_reason, SP::ITERATION_LIMIT);
  const std::vector<Coordinates> limited = images();
  Recorder stopper;
  stopper.stop_at = recorder.n_questions;
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::visitor(std::ref(stopper))), SP::OK);
  EXPECT_EQ(bld.report().number_of_iterations(), 7u);
  EXPECT_TRUE(test_maps::have_same_bits(images(), limited));
}

TEST_F(Visitor, may_stop_the_hierarchy_alone)
{
  for(const std::size_t stop_at : {1u, 2u, 10u, 30u})
  {
    Recorder stopper;
    stopper.stop_at = stop_at;
    SP::Hierarchical_parameterizer_3<Mesh> hierarchical;
    ASSERT_EQ(SP::parameterize(mesh, hierarchical, map, params::visitor(std::ref(stopper))), SP::OK);
    EXPECT_TRUE(SP::is_bijective(mesh, map));
    EXPECT_EQ(hierarchical.report().stop_reason, SP::STOPPED);
    EXPECT_EQ(hierarchical.report().radius, 1.);
    EXPECT_EQ(stopper.n_questions, stop_at);
    EXPECT_EQ(stopper.count("iteration"), 0u);
    if(stop_at == 1) // each level needs one sweep, and gets no more
    {
      EXPECT_EQ(hierarchical.report().number_of_level_iterations, hierarchical.report().number_of_levels);
    }
  }
}

TEST_F(Visitor, may_throw_and_the_map_stays)
{
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::visitor(std::ref(recorder)).number_of_iterations(5u)), SP::OK);
  const std::size_t n_events = recorder.events.size();
  std::vector<std::size_t> throws = {1, 2, 3, 10, n_events / 2};
  for(std::size_t k = n_events - 14; k <= n_events; ++k)
  {
    throws.push_back(k);
  }
  for(const std::size_t throw_at : throws)
  {
    Recorder thrower;
    thrower.throw_at = throw_at;
    const auto other = test_maps::make_sentinel_map<Point_3>(mesh);
    EXPECT_THROW(SP::parameterize(mesh, bld, other, params::visitor(std::ref(thrower)).number_of_iterations(5u)),
                 std::runtime_error);
    EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, other), untouched));
  }
  // the object is as good as new
  const auto other = test_maps::make_sentinel_map<Point_3>(mesh);
  EXPECT_EQ(SP::parameterize(mesh, bld, other, params::number_of_iterations(5u)), SP::OK);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, other), images()));
}

TEST_F(Visitor, number_of_iterations_is_respected)
{
  std::vector<double> largest_energies;
  for(const unsigned int n : {0u, 1u, 2u, 3u, 10u})
  {
    ASSERT_EQ(SP::parameterize(mesh, bld, map, params::number_of_iterations(n)), SP::OK);
    EXPECT_TRUE(SP::is_bijective(mesh, map));
    EXPECT_EQ(bld.report().number_of_iterations(), n);
    EXPECT_EQ(bld.report().stop_reason, SP::ITERATION_LIMIT);
    largest_energies.push_back(bld.report().largest_energy);
  }
  EXPECT_LT(largest_energies[1], largest_energies[0]);
  EXPECT_LT(largest_energies[4], largest_energies[1]);
}

TEST_F(Visitor, maximum_running_time_leaves_a_bijection)
{
  for(const double seconds : {1e-12, 1e-6})
  {
    ASSERT_EQ(SP::parameterize(mesh, bld, map, params::maximum_running_time(seconds)), SP::OK);
    EXPECT_TRUE(SP::is_bijective(mesh, map));
    EXPECT_EQ(bld.report().stop_reason, SP::TIME_LIMIT);
    EXPECT_LE(bld.report().number_of_iterations(), 1u);
    SP::Hierarchical_parameterizer_3<Mesh> hierarchical;
    ASSERT_EQ(SP::parameterize(mesh, hierarchical, map, params::maximum_running_time(seconds)), SP::OK);
    EXPECT_TRUE(SP::is_bijective(mesh, map));
    EXPECT_EQ(hierarchical.report().stop_reason, SP::TIME_LIMIT);
  }
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::maximum_running_time(1e6)), SP::OK);
  EXPECT_NE(bld.report().stop_reason, SP::TIME_LIMIT);
}

TEST_F(Visitor, coarse_levels_get_at_most_ten_times_the_sweeps)
{
  SP::Hierarchical_parameterizer_3<Mesh> hierarchical(SP::Isometric_energy_3(), SP::Relative_sharpness_3(0.),
                                                      SP::Newton_update_3(), 1);
  ASSERT_EQ(SP::parameterize(mesh, hierarchical, map), SP::OK);
  EXPECT_GT(hierarchical.report().number_of_level_iterations, hierarchical.report().number_of_levels);
  EXPECT_LE(hierarchical.report().number_of_level_iterations, 10 * hierarchical.report().number_of_levels);
}

// A small mesh is swept until it has settled, as the coarse levels are; a larger one as often as was asked for.
TEST(Report, tells_why_the_sweeps_over_the_levels_ended)
{
  for(const unsigned int n_subdivisions : {1u, 3u}) // 42 and 642 vertices
  {
    const Mesh ball = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(n_subdivisions));
    const auto ball_map = test_maps::make_sentinel_map<Point_3>(ball);
    SP::Hierarchical_parameterizer_3<Mesh> hierarchical;
    ASSERT_EQ(SP::parameterize(ball, hierarchical, ball_map), SP::OK);
    EXPECT_EQ(hierarchical.report().stop_reason, n_subdivisions == 1 ? SP::CONVERGED : SP::ITERATION_LIMIT);
  }
}

// Newton's update, which counts on which levels it is asked.
struct Counting_update
{
  std::atomic<std::size_t>*n_coarse, *n_fine;
  bool is_coarse;

  template <class VertexEnergy>
  bool operator()(const VertexEnergy& energy, std::array<double, 2>& step) const
  {
    ++*(is_coarse ? n_coarse : n_fine);
    return SP::Newton_update_3()(energy, step);
  }
  Counting_update on_coarse_levels() const { return {n_coarse, n_fine, true}; }
};

TEST_F(Visitor, coarse_levels_get_the_update_for_them)
{
  std::atomic<std::size_t> n_coarse(0), n_fine(0);
  SP::Hierarchical_parameterizer_3<Mesh, CGAL::Default, CGAL::Default, Counting_update> hierarchical(
      SP::Isometric_energy_3(), SP::Relative_sharpness_3(0.), {&n_coarse, &n_fine, false}, 4);
  ASSERT_EQ(SP::parameterize(mesh, hierarchical, map), SP::OK);
  EXPECT_GT(n_coarse, 0u);
  EXPECT_GT(n_fine, 0u);
  EXPECT_EQ(n_fine % num_vertices(mesh), 0u); // so many sweeps over the mesh itself
}

TEST_F(Visitor, report_adds_up)
{
  EXPECT_EQ(bld.report().stop_reason, SP::NOT_RUN);
  EXPECT_EQ(bld.report().number_of_vertices, 0u);
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::visitor(std::ref(recorder))), SP::OK);
  const SP::Parameterization_report& report = bld.report();
  EXPECT_EQ(report.number_of_vertices, num_vertices(mesh));
  EXPECT_EQ(report.number_of_faces, num_faces(mesh));
  EXPECT_EQ(report.number_of_isolated_vertices, 0u);
  EXPECT_EQ(report.number_of_flat_faces, 0u);
  EXPECT_EQ(report.number_of_attempts, 1u);
  EXPECT_EQ(report.number_of_levels, recorder.count("level"));
  EXPECT_EQ(report.number_of_iterations(), recorder.count("iteration"));
  EXPECT_EQ(report.number_of_average_iterations + report.number_of_sharp_iterations, report.number_of_iterations());
  EXPECT_GT(report.number_of_level_iterations, report.number_of_levels);
  EXPECT_EQ(report.stop_reason, SP::CONVERGED);
  EXPECT_GT(report.sharpness, 0.);
  EXPECT_GT(report.largest_energy, report.average_energy);
  EXPECT_GE(report.average_energy, 2.);
  EXPECT_GE(report.initial_energy, 2.);
  EXPECT_GE(report.seconds_for_reading, 0.);
  EXPECT_GT(report.seconds_for_hierarchy, 0.);
  EXPECT_GT(report.seconds_for_embedding, 0.);
  EXPECT_GT(report.seconds_for_optimization, 0.);
  EXPECT_GT(report.seconds_for_certificate, 0.);
  EXPECT_NEAR(report.seconds(),
              report.seconds_for_reading + report.seconds_for_hierarchy + report.seconds_for_embedding +
                  report.seconds_for_optimization + report.seconds_for_certificate,
              1e-12);
  // the energies are those of the map, but for the d of the energy being less than that of the flat triangle
  const SP::Distortion_summary distortion = SP::measure_distortion(mesh, map);
  EXPECT_NEAR(distortion.radius, report.radius, 1e-14 * report.radius);
  const double d = distortion.isometric.maximum;
  EXPECT_GT(report.largest_energy, 0.5 * d * d);
  EXPECT_LT(report.largest_energy, 2.1 * d * d);
}

TEST_F(Visitor, report_counts_isolated_vertices_and_flat_faces)
{
  test_meshes::Triangle_list list = test_meshes::octahedron();
  list.points.push_back({0.5, 0.5, 0.});
  list.triangles[0] = {0, 6, 4};
  list.triangles.push_back({6, 2, 4});
  list.triangles.push_back({0, 2, 6}); // without area
  list.points.push_back({5., 5., 5.});
  list.points.push_back({6., 6., 6.});
  const Mesh other = test_meshes::make_mesh<Mesh>(list);
  const auto other_map = test_maps::make_sentinel_map<Point_3>(other);
  ASSERT_EQ(SP::parameterize(other, bld, other_map), SP::OK);
  EXPECT_EQ(bld.report().number_of_vertices, 7u);
  EXPECT_EQ(bld.report().number_of_isolated_vertices, 2u);
  EXPECT_EQ(bld.report().number_of_flat_faces, 1u);
  EXPECT_EQ(bld.report().number_of_faces, 10u);
}

// The other methods that iterate.
template <class Method>
class Visitor_of_method : public ::testing::Test
{
protected:
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(1));
  decltype(test_maps::make_sentinel_map<Point_3>(mesh)) map = test_maps::make_sentinel_map<Point_3>(mesh);
  const std::vector<Coordinates> untouched = test_maps::images(mesh, map);
  Method method;
  Recorder recorder;

  std::vector<Coordinates> images() const { return test_maps::images(mesh, map); }
};

using Methods = ::testing::Types<SP::Harmonic_parameterizer_3<Mesh>, SP::Conformal_parameterizer_3<Mesh>,
                                 SP::ARAP_parameterizer_3<Mesh>, SP::Published_low_distortion_parameterizer_3<Mesh>>;
template <class Method>
constexpr bool may_fold = std::is_same<Method, SP::Conformal_parameterizer_3<Mesh>>::value ||
                          std::is_same<Method, SP::ARAP_parameterizer_3<Mesh>>::value;
TYPED_TEST_SUITE(Visitor_of_method, Methods, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Visitor_of_method, is_called_in_order)
{
  ASSERT_EQ(SP::parameterize(this->mesh, this->method, this->map, params::visitor(std::ref(this->recorder))), SP::OK);
  const SP::Parameterization_report& report = this->method.report();
  const std::vector<Recorder::Event>& events = this->recorder.events;
  EXPECT_EQ(events.front().name, "initialization_begin");
  EXPECT_EQ(events.front().number, num_vertices(this->mesh));
  EXPECT_EQ(events.back().name, "optimization_end");
  EXPECT_EQ(this->recorder.count("initialization_begin"), 1u);
  EXPECT_EQ(this->recorder.count("initialization_end"), 1u);
  EXPECT_EQ(this->recorder.count("optimization_end"), 1u);

  std::size_t k = 1, iteration = 0;
  for(; events[k].name != "initialization_end"; ++k)
  {
    EXPECT_TRUE(events[k].name == "level" || (events[k].name == "question" && events[k].number == 0));
  }
  double energy = 0., radius = 0.;
  for(++k; events[k].name != "optimization_end"; ++k)
  {
    ASSERT_EQ(events[k].name, "iteration");
    EXPECT_EQ(events[k].number, ++iteration);
    energy = events[k].energy;
    radius = events[k].radius;
    EXPECT_GT(energy, 0.);
    EXPECT_GT(radius, 0.);
    ASSERT_EQ(events[++k].name, "question");
    EXPECT_EQ(events[k].number, iteration);
    EXPECT_EQ(events[k].energy, energy);
  }
  EXPECT_GE(iteration, 5u);
  EXPECT_EQ(iteration, report.number_of_iterations());
  EXPECT_EQ(report.stop_reason, SP::CONVERGED);
  EXPECT_NEAR(radius / report.radius, 1., 1e-3);
  EXPECT_EQ(report.number_of_vertices, num_vertices(this->mesh));
  EXPECT_EQ(report.number_of_faces, num_faces(this->mesh));
  EXPECT_GT(report.initial_energy, report.average_energy);
  EXPECT_GT(report.average_energy, 0.);
  EXPECT_GT(report.seconds_for_embedding, 0.);
  EXPECT_GT(report.seconds_for_optimization, 0.);
  EXPECT_GT(report.seconds_for_certificate, 0.);

  // watching has no influence
  const std::vector<Coordinates> watched = this->images();
  ASSERT_EQ(SP::parameterize(this->mesh, this->method, this->map), SP::OK);
  EXPECT_TRUE(test_maps::have_same_bits(this->images(), watched));
}

TYPED_TEST(Visitor_of_method, may_stop_anywhere)
{
  const auto np = params::visitor(std::ref(this->recorder)).number_of_iterations(6u);
  ASSERT_EQ(SP::parameterize(this->mesh, this->method, this->map, np), SP::OK);
  const std::size_t n_questions = this->recorder.n_questions;
  const std::size_t n_before = n_questions - this->method.report().number_of_iterations();
  ASSERT_EQ(this->method.report().number_of_iterations(), 6u);
  for(std::size_t stop_at = 1; stop_at < n_questions; ++stop_at)
  {
    SCOPED_TRACE(stop_at);
    Recorder stopper;
    stopper.stop_at = stop_at;
    // What promises no bijection may have folded in the one step that it makes of a start that was stopped.
    const SP::Error_code error =
        SP::parameterize(this->mesh, this->method, this->map, params::visitor(std::ref(stopper)));
    ASSERT_TRUE(error == SP::OK || (may_fold<TypeParam> && error == SP::ERROR_NO_1_TO_1_MAPPING));
    EXPECT_EQ(SP::is_bijective(this->mesh, this->map), error == SP::OK);
    const SP::Parameterization_report& report = this->method.report();
    EXPECT_EQ(report.stop_reason, SP::STOPPED);
    EXPECT_EQ(stopper.n_questions, stop_at); // it is not asked again
    EXPECT_EQ(stopper.events.back().name, "optimization_end");
    EXPECT_EQ(stopper.count("iteration"), report.number_of_iterations());
    EXPECT_EQ(report.number_of_iterations(), stop_at <= n_before ? 1 : stop_at - n_before);
    if(stop_at > n_before)
    {
      // it is the run with so many iterations at most
      const std::vector<Coordinates> stopped = this->images();
      ASSERT_EQ(SP::parameterize(this->mesh, this->method, this->map,
                                 params::number_of_iterations(report.number_of_iterations())),
                SP::OK);
      EXPECT_TRUE(test_maps::have_same_bits(this->images(), stopped));
      EXPECT_EQ(report.stop_reason, SP::ITERATION_LIMIT);
    }
  }
}

TYPED_TEST(Visitor_of_method, may_throw_and_the_map_stays)
{
  ASSERT_EQ(SP::parameterize(this->mesh, this->method, test_maps::make_sentinel_map<Point_3>(this->mesh),
                             params::visitor(std::ref(this->recorder)).number_of_iterations(3u)),
            SP::OK);
  for(std::size_t throw_at = 1; throw_at <= this->recorder.events.size(); ++throw_at)
  {
    Recorder thrower;
    thrower.throw_at = throw_at;
    EXPECT_THROW(SP::parameterize(this->mesh, this->method, this->map,
                                  params::visitor(std::ref(thrower)).number_of_iterations(3u)),
                 std::runtime_error);
  }
  EXPECT_TRUE(test_maps::have_same_bits(this->images(), this->untouched));
}

TYPED_TEST(Visitor_of_method, maximum_running_time_leaves_a_bijection)
{
  ASSERT_EQ(SP::parameterize(this->mesh, this->method, this->map, params::maximum_running_time(1e-12)), SP::OK);
  EXPECT_TRUE(SP::is_bijective(this->mesh, this->map));
  EXPECT_EQ(this->method.report().stop_reason, SP::TIME_LIMIT);
  EXPECT_EQ(this->method.report().number_of_iterations(), 1u);
  ASSERT_EQ(SP::parameterize(this->mesh, this->method, this->map, params::maximum_running_time(1e6)), SP::OK);
  EXPECT_EQ(this->method.report().stop_reason, SP::CONVERGED);
}

TEST_F(Visitor, sees_a_method_without_iterations_as_well)
{
  SP::Stereographic_parameterizer_3<Mesh> stereographic;
  ASSERT_EQ(SP::parameterize(mesh, stereographic, map, params::visitor(std::ref(recorder))), SP::OK);
  ASSERT_EQ(recorder.events.size(), 2u);
  EXPECT_EQ(recorder.events[0].name, "initialization_begin");
  EXPECT_EQ(recorder.events[0].number, num_vertices(mesh));
  EXPECT_EQ(recorder.events[1].name, "initialization_end");
  EXPECT_EQ(stereographic.report().stop_reason, SP::CONVERGED);
  EXPECT_EQ(stereographic.report().number_of_iterations(), 0u);
  EXPECT_GT(stereographic.report().seconds_for_embedding, 0.);
}

// A start that has been told to stop tells the method that goes on from it.
TEST_F(Visitor, stops_the_initial_parameterizer)
{
  SP::Published_low_distortion_parameterizer_3<Mesh> published;
  recorder.stop_at = 4;
  ASSERT_EQ(SP::parameterize(mesh, published, map, params::visitor(std::ref(recorder))), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  EXPECT_EQ(published.report().stop_reason, SP::STOPPED);
  EXPECT_EQ(published.report().number_of_iterations(), 1u);
  EXPECT_EQ(recorder.n_questions, 4u);
}

} // namespace
