// The method as it was published: its step, its schedules, its stopping rule and its measure of a face's image, each by
// itself and on runs; and that all of it together is what Published_low_distortion_parameterizer_3 does.

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"
#include "test_runs.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace params = CGAL::parameters;

namespace {

using test_meshes::Coordinates;
using test_meshes::Triangle_list;
using test_runs::Result;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Default = CGAL::Default;
using Harmonic = SP::Harmonic_parameterizer_3<Mesh>;
using Published = SP::Published_low_distortion_parameterizer_3<Mesh>;
using Published_on_fixed_sphere =
    SP::Published_low_distortion_parameterizer_3<Mesh, Default, Default, SP::Fixed_radius_3>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The gradient step

// A vertex energy with this gradient that is lower only within `range` of the vertex.
struct Well
{
  std::array<double, 2> g;
  double edge, range;
  mutable std::vector<std::array<double, 2>> trials = {};

  double gradient(std::array<double, 2>& gradient) const
  {
    gradient = g;
    return 1.;
  }
  double operator()(double x, double y) const
  {
    trials.push_back({x, y});
    return std::hypot(x, y) < range ? 0.5 : 1.;
  }
  double shortest_edge() const { return edge; }
};

TEST(Gradient_update, is_as_long_as_the_shortest_edge_at_most)
{
  for(const double edge : {1., 0.1, 1e-6})
  {
    const Well well{{3., -4.}, edge, infinity};
    std::array<double, 2> step;
    ASSERT_TRUE(SP::Gradient_update_3()(well, step));
    // downhill; the tangential step of this length, projected to the unit sphere
    const double length = edge / std::sqrt(1. + edge * edge);
    EXPECT_NEAR(step[0], -0.6 * length, 1e-15);
    EXPECT_NEAR(step[1], 0.8 * length, 1e-15);
    EXPECT_EQ(well.trials.size(), 1u);
  }
}

TEST(Gradient_update, shortens_its_step_until_the_energy_falls)
{
  for(const double range : {0.2, 0.01, 1e-6, 1e-9})
  {
    const Well well{{0., 2.}, 0.3, range};
    std::array<double, 2> step;
    ASSERT_TRUE(SP::Gradient_update_3()(well, step));
    EXPECT_EQ(step, well.trials.back());
    EXPECT_LT(std::abs(step[1]), range);
    EXPECT_GT(std::abs(step[1]), 0.799 * range); // the first that does
    EXPECT_EQ(step[0], 0.);
    EXPECT_LT(step[1], 0.);
    double t = 0.3;
    for(const std::array<double, 2>& trial : well.trials)
    {
      EXPECT_NEAR(-trial[1], t / std::sqrt(1. + t * t), 1e-14 * t);
      t *= 0.8;
    }
  }
}

TEST(Gradient_update, stays_where_there_is_nothing_to_do)
{
  std::array<double, 2> step = {-7., -7.};
  const SP::Gradient_update_3 update;
  for(const double edge : {1., 1e-6}) // lower only by a shorter step than the shortest, which is relative to the edge
  {
    const Well steep{{1., 1.}, edge, 1e-11 * edge};
    EXPECT_FALSE(update(steep, step));
    EXPECT_EQ(steep.trials.size(), 104u); // 0.8^103 > 1e-10 > 0.8^104
  }
  EXPECT_FALSE(update(Well{{0., 0.}, 0.3, 1.}, step));
  EXPECT_FALSE(update(Well{{infinity, 0.}, 0.3, 1.}, step));
  EXPECT_FALSE(update(Well{{std::nan(""), 0.}, 0.3, 1.}, step));
  EXPECT_EQ(step, (std::array<double, 2>{-7., -7.}));
}

// The schedules

TEST(Average_sweeps, are_made_exactly_as_often_as_given)
{
  for(const std::size_t n : {0u, 1u, 3u, 100u})
  {
    SP::Absolute_sharpness_3 policy(0.1, 10., n);
    EXPECT_TRUE(policy.is_valid());
    for(std::size_t sweep = 0; sweep < n; ++sweep)
    {
      // whatever the energies do: fall, stay or rise
      EXPECT_EQ(policy(sweep, sweep % 2 == 0 ? 2. : 3., 50.), 0.);
      EXPECT_FALSE(policy.is_final());
    }
    EXPECT_EQ(policy(n, 2., 50.), 0.1);
    EXPECT_FALSE(policy.is_final());
    double last = policy(n + 1, 2., 40.); // the largest energy falls: it has to go on doing so
    EXPECT_EQ(last, 0.1);
    std::size_t sweep = n + 2;
    for(; !policy.is_final() && sweep < n + 100; ++sweep)
    {
      const double s = policy(sweep, 2., 40.);
      EXPECT_GT(s, last);
      EXPECT_LE(s, 10.);
      last = s;
    }
    EXPECT_EQ(last, 10.);
    EXPECT_EQ(policy(sweep, 2., 40.), 10.);
  }
}

TEST(Average_sweeps, go_before_a_fixed_sharpness)
{
  SP::Absolute_sharpness_3 at_once(5., 5., 0), after_one(5., 5., 1), without(5., 5.);
  EXPECT_TRUE(at_once.is_final());
  EXPECT_TRUE(without.is_final());
  EXPECT_FALSE(after_one.is_final());
  EXPECT_EQ(at_once(0, 3., 50.), 5.);
  EXPECT_EQ(without(0, 3., 50.), 5.);
  EXPECT_EQ(after_one(0, 3., 50.), 0.);
  EXPECT_EQ(after_one(1, 3., 50.), 5.);
  EXPECT_TRUE(after_one.is_final());
  for(std::size_t sweep = 1; sweep < 9; ++sweep)
  {
    EXPECT_EQ(at_once(sweep, 3., 50.), 5.);
    EXPECT_EQ(after_one(sweep + 1, 3., 50.), 5.);
  }
  EXPECT_FALSE(SP::Absolute_sharpness_3(10., 0.1, 100).is_valid());
  EXPECT_FALSE(SP::Absolute_sharpness_3(0., 0.1, 0).is_valid());
}

// AMIPS with a fixed s and no sweep of eq. 6, as in figure 6 of the paper, and with some.
TEST(Average_sweeps, of_a_run)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(1));
  struct Schedule
  {
    double first, last;
    unsigned int average_sweeps;
  };
  for(const Schedule& s : {Schedule{5., 5., 0}, {0.1, 0.1, 0}, {5., 5., 100}, {0.1, 10., 0}, {0.1, 10., 1}})
  {
    Published bld(Harmonic(), SP::Absolute_sharpness_3(s.first, s.last, s.average_sweeps));
    const Result result = test_runs::run<Point_3>(mesh, bld, false);
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
    EXPECT_EQ(result.report.number_of_average_iterations, s.average_sweeps);
    EXPECT_GT(result.report.number_of_sharp_iterations, 0u);
    EXPECT_EQ(result.report.sharpness, s.last);
  }
}

// Runs of all of it

// What the visitor is told after each sweep.
struct Recorder : SP::Default_visitor
{
  void after_iteration(std::size_t, double energy, double radius)
  {
    energies.push_back(energy);
    radii.push_back(radius);
  }
  std::vector<double> energies, radii;
};

TEST(Published_method, is_made_of_the_settings_of_the_paper)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
  Published published;
  const Result result = test_runs::run<Point_3>(mesh, published, false);
  EXPECT_EQ(result.error, SP::OK);
  EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
  EXPECT_EQ(result.report.number_of_average_iterations, 100u);
  EXPECT_GT(result.report.number_of_sharp_iterations, 21u); // 21 steps of a quarter from 0.1 to 10
  EXPECT_EQ(result.report.sharpness, 10.);
  EXPECT_EQ(result.report.number_of_levels, 0u); // it starts from a harmonic map

  // the same, put together by hand
  using Sharpness = SP::Absolute_sharpness_3;
  using Radius = SP::Two_phase_radius_3<SP::Area_preserving_radius_3, SP::Area_balancing_radius_3>;
  using Bld = SP::Bijective_low_distortion_parameterizer_3<Mesh, Harmonic, SP::Isometric_energy_3, Sharpness, Radius,
                                                           SP::Gradient_update_3, SP::Flat_area_barrier_3>;
  Bld bld(Harmonic(), SP::Isometric_energy_3(0.5), Sharpness(0.1, 10., 100),
          Radius(SP::Area_preserving_radius_3(), SP::Area_balancing_radius_3(), 0.));
  bld.set_number_of_iterations(2000);
  bld.set_tolerances(1e-5, 1e-3);
  bld.set_acceleration(false);
  EXPECT_TRUE(test_maps::have_same_bits(test_runs::run<Point_3>(mesh, bld, false).images, result.images));
  // and each of them matters
  bld.set_acceleration(true);
  EXPECT_FALSE(test_maps::have_same_bits(test_runs::run<Point_3>(mesh, bld, false).images, result.images));
  bld.set_acceleration(false);
  bld.set_number_of_iterations(150);
  EXPECT_FALSE(test_maps::have_same_bits(test_runs::run<Point_3>(mesh, bld, false).images, result.images));
  EXPECT_EQ(bld.report().number_of_iterations(), 150u);
}

// Policies of other types are what they are by default.
TEST(Published_method, takes_policies_of_any_type)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(1));
  using Relative = SP::Relative_sharpness_3;
  using Fixed = SP::Fixed_radius_3;
  const auto expect_same = [&](auto&& a, auto&& b) {
    EXPECT_TRUE(test_maps::have_same_bits(test_runs::run<Point_3>(mesh, a, false).images,
                                          test_runs::run<Point_3>(mesh, b, false).images));
  };
  expect_same(Published(), SP::Published_low_distortion_parameterizer_3<Mesh, Harmonic, SP::Absolute_sharpness_3,
                                                                        SP::Two_phase_radius_3<>>());
  expect_same(
      Published(),
      SP::Published_low_distortion_parameterizer_3<
          Mesh, Default, Default, SP::Two_phase_radius_3<SP::Area_preserving_radius_3, SP::Area_balancing_radius_3>>());
  using Other = SP::Published_low_distortion_parameterizer_3<Mesh, Default, Relative, Fixed>;
  expect_same(Other(), Other(Harmonic(), Relative(), Fixed()));
}

// On a mesh where it does not settle.
TEST(Published_method, makes_2000_sweeps_at_most)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(1));
  Published published;
  published.set_tolerances(0., 0.);
  Result result = test_runs::run<Point_3>(mesh, published, false);
  EXPECT_EQ(result.error, SP::OK);
  EXPECT_EQ(result.report.stop_reason, SP::ITERATION_LIMIT);
  EXPECT_EQ(result.report.number_of_average_iterations, 100u);
  EXPECT_EQ(result.report.number_of_sharp_iterations, 1900u);
  // unless the caller gives a number, which goes first
  for(const unsigned int n : {0u, 5u})
  {
    result = test_runs::run<Point_3>(mesh, published, false, params::number_of_iterations(n));
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_EQ(result.report.number_of_iterations(), n);
  }
}

TEST(Published_method, lowers_the_sum_of_the_energies)
{
  for(const Triangle_list& list : {test_meshes::bumpy_sphere(2), test_meshes::ellipsoid(1., 1., 3., 2)})
  {
    // on a fixed sphere, every sweep does so
    const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
    Published_on_fixed_sphere fixed(Harmonic(), SP::Absolute_sharpness_3(0.1, 10., 100), SP::Fixed_radius_3(1.4));
    Recorder recorder;
    const Result result = test_runs::run<Point_3>(mesh, fixed, false, params::visitor(std::ref(recorder)));
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_EQ(result.report.radius, 1.4);
    ASSERT_GE(recorder.energies.size(), 100u);
    double last = result.report.initial_energy;
    for(std::size_t i = 0; i < 100; ++i)
    {
      EXPECT_LT(recorder.energies[i], (i < 30 ? 1. : 1. + 1e-14) * last) << i; // the end is a matter of rounding
      EXPECT_GT(recorder.energies[i], 2.);
      last = recorder.energies[i];
    }
    for(const double radius : recorder.radii)
    {
      EXPECT_EQ(radius, 1.4);
    }
    // and eq. 7 lowers the largest one
    const Result average = test_runs::run<Point_3>(mesh, fixed, false, params::number_of_iterations(100u));
    EXPECT_EQ(average.report.number_of_sharp_iterations, 0u);
    EXPECT_LT(result.report.largest_energy, average.report.largest_energy);
  }
}

// The stopping rule compares the sum of exp(s E) before and after a sweep, that is, exp(s mean).
TEST(Published_method, stops_when_the_sum_has_settled)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
  const double s = 5.;
  for(const double tolerance : {1e-2, 1e-4})
  {
    Published_on_fixed_sphere bld(Harmonic(), SP::Absolute_sharpness_3(s, s, 0), SP::Fixed_radius_3(1.4));
    bld.set_tolerances(tolerance, 1e-3);
    Recorder recorder;
    const Result result = test_runs::run<Point_3>(mesh, bld, false, params::visitor(std::ref(recorder)));
    EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
    const std::size_t n = recorder.energies.size();
    ASSERT_GT(n, 10u);
    for(std::size_t i = 1; i < n; ++i)
    {
      const double change = std::abs(std::exp(s * (recorder.energies[i] - recorder.energies[i - 1])) - 1.);
      EXPECT_EQ(change <= tolerance, i == n - 1) << i;
    }
  }
}

// Equation 9 until all has settled, then equation 11 until it has again.
TEST(Published_method, changes_the_radius_in_two_phases)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
  const SP::Absolute_sharpness_3 sharpness(2., 2., 0);
  Published two_phases(Harmonic(), sharpness);
  SP::Published_low_distortion_parameterizer_3<Mesh, Default, Default, SP::Area_preserving_radius_3> first(
      Harmonic(), sharpness, SP::Area_preserving_radius_3());
  Recorder of_two_phases, of_first;
  test_runs::run<Point_3>(mesh, two_phases, false, params::visitor(std::ref(of_two_phases)));
  test_runs::run<Point_3>(mesh, first, false, params::visitor(std::ref(of_first)));
  EXPECT_EQ(first.report().stop_reason, SP::CONVERGED);
  EXPECT_EQ(two_phases.report().stop_reason, SP::CONVERGED);
  // as long as eq. 9 alone has not settled, both are the same; after that, one goes on
  const std::size_t n = of_first.radii.size();
  ASSERT_GT(n, 10u);
  ASSERT_GT(of_two_phases.radii.size(), n + 1);
  for(std::size_t i = 0; i < n; ++i)
  {
    EXPECT_EQ(of_two_phases.radii[i], of_first.radii[i]);
    EXPECT_EQ(of_two_phases.energies[i], of_first.energies[i]);
  }
  EXPECT_GT(std::abs(of_two_phases.radii[n] / of_first.radii[n - 1] - 1.), 1e-2);

  // A run that ends early gets the last radius as well. By eq. 11, the sums of d and 1 / d are the same.
  for(const unsigned int n_sweeps : {0u, 3u, 500u})
  {
    const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
    ASSERT_EQ(two_phases.parameterize(mesh, map, params::number_of_iterations(n_sweeps)), SP::OK);
    const auto area = [](const Point_3& a, const Point_3& b, const Point_3& c) {
      return std::sqrt(CGAL::squared_area(a, b, c));
    };
    double sum = 0., sum_of_inverses = 0.;
    for(const auto f : faces(mesh))
    {
      const auto h = halfedge(f, mesh);
      const auto a = source(h, mesh), b = target(h, mesh), c = target(next(h, mesh), mesh);
      const double d = area(get(map, a), get(map, b), get(map, c)) / area(mesh.point(a), mesh.point(b), mesh.point(c));
      sum += d;
      sum_of_inverses += 1. / d;
    }
    EXPECT_NEAR(sum / sum_of_inverses, 1., 1e-12);
  }
}

// The radius goes all the way at once, while the accelerated descent takes its time.
TEST(Published_method, makes_full_steps_of_the_radius)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(1));
  using Radius = SP::Two_phase_radius_3<SP::Fixed_radius_3, SP::Fixed_radius_3>;
  SP::Published_low_distortion_parameterizer_3<Mesh, Default, Default, Radius> bld(
      Harmonic(), SP::Absolute_sharpness_3(1., 1., 0), Radius(SP::Fixed_radius_3(1.2), SP::Fixed_radius_3(1.5), 0.));
  for(const bool is_accelerated : {false, true})
  {
    bld.set_acceleration(is_accelerated);
    Recorder recorder;
    test_runs::run<Point_3>(mesh, bld, false, params::visitor(std::ref(recorder)));
    EXPECT_EQ(bld.report().stop_reason, SP::CONVERGED);
    std::size_t n_first = 0, n_second = 0;
    for(const double radius : recorder.radii)
    {
      n_first += radius == 1.2;
      n_second += radius == 1.5;
    }
    EXPECT_GT(n_first, 10u);
    EXPECT_EQ(n_second > 10, !is_accelerated);
    EXPECT_EQ(n_first + n_second == recorder.radii.size(), !is_accelerated);
    EXPECT_EQ(bld.report().radius, 1.5);
  }
}

// The gradient step, counted.
struct Counting_update
{
  template <class VertexEnergy>
  bool operator()(const VertexEnergy& energy, std::array<double, 2>& step) const
  {
    ++number_of_calls();
    return SP::Gradient_update_3()(energy, step);
  }

  static std::atomic<std::size_t>& number_of_calls()
  {
    static std::atomic<std::size_t> n(0);
    return n;
  }
};

// Every vertex is moved once in a sweep; the accelerated descent moves some of them more often.
TEST(Published_method, treats_all_vertices_alike)
{
  Triangle_list list = test_meshes::icosphere(3); // with one spike
  list.points[0] = {3. * list.points[0][0], 3. * list.points[0][1], 3. * list.points[0][2]};
  const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
  SP::Bijective_low_distortion_parameterizer_3<Mesh, Harmonic, SP::Symmetric_Dirichlet_energy_3,
                                               SP::Absolute_sharpness_3, Default, Counting_update,
                                               SP::Flat_area_barrier_3>
      bld(SP::Symmetric_Dirichlet_energy_3(), SP::Absolute_sharpness_3(0.1, 10., 5));
  for(const bool is_accelerated : {false, true})
  {
    bld.set_acceleration(is_accelerated);
    Counting_update::number_of_calls() = 0;
    const Result result = test_runs::run<Point_3>(mesh, bld, false, params::number_of_iterations(20u));
    EXPECT_EQ(result.report.number_of_sharp_iterations, 15u);
    EXPECT_EQ(Counting_update::number_of_calls() == 20 * num_vertices(mesh), !is_accelerated);
    EXPECT_GE(Counting_update::number_of_calls(), 20 * num_vertices(mesh));
  }
}

TEST(Published_method, is_certified_on_small_meshes)
{
  std::vector<Triangle_list> lists = {test_meshes::tetrahedron(),        test_meshes::octahedron(),
                                      test_meshes::icosphere(1),         test_meshes::suspension(9),
                                      test_meshes::bumpy_sphere(1),      test_meshes::ellipsoid(1., 0.3, 3., 2),
                                      test_meshes::with_tentacle(20, 1.)};
  for(const Triangle_list& list : lists)
  {
    Published published;
    const Result result = test_runs::run<Point_3>(test_meshes::make_mesh<Mesh>(list), published, false,
                                                  params::number_of_iterations(400u));
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_EQ(result.report.number_of_average_iterations, 100u);
    EXPECT_GE(result.report.sharpness, 0.1);
    EXPECT_LE(result.report.sharpness, 10.);
    EXPECT_LE(result.report.average_energy, result.report.initial_energy);
    // The energy is the mean of angle and area distortion as they are measured, with flat areas.
    const SP::Distortion_summary& distortion = result.distortion;
    EXPECT_NEAR(result.report.average_energy / (0.5 * (distortion.angle.average + distortion.area.average)), 1., 1e-9);
  }
  // the round ones get the map without distortion
  Published published;
  const Triangle_list sphere = test_meshes::scaled(test_meshes::icosphere(2), 3., 3., 3.);
  const Result result = test_runs::run<Point_3>(test_meshes::make_mesh<Mesh>(sphere), published, false);
  EXPECT_NEAR(result.report.average_energy, 2., 1e-9);
  EXPECT_NEAR(result.report.radius, 3., 1e-4);
  EXPECT_LT(test_runs::largest_difference_up_to_rotation(result.images, sphere.points), 1e-3);
}

// The barrier

template <class Barrier, class VertexUpdate>
Result run_with_barrier(const Mesh& mesh, unsigned int iterations)
{
  SP::Bijective_low_distortion_parameterizer_3<Mesh, Harmonic, SP::Isometric_energy_3, SP::Relative_sharpness_3,
                                               SP::Fixed_radius_3, VertexUpdate, Barrier>
      bld(Harmonic(), SP::Isometric_energy_3(), SP::Relative_sharpness_3(0.), SP::Fixed_radius_3(1.4));
  const Result result = test_runs::run<Point_3>(mesh, bld, false, params::number_of_iterations(iterations));
  EXPECT_EQ(result.error, SP::OK);
  return result;
}

TEST(Barrier, matters_the_less_the_finer_the_mesh)
{
  double last_difference = HUGE_VAL;
  for(const unsigned int subdivisions : {1u, 2u, 3u})
  {
    const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(subdivisions));
    const Result flat = run_with_barrier<SP::Flat_area_barrier_3, SP::Newton_update_3>(mesh, 0),
                 determinant = run_with_barrier<SP::Determinant_barrier_3, SP::Newton_update_3>(mesh, 0);
    EXPECT_TRUE(test_maps::have_same_bits(flat.images, determinant.images));
    const double difference = determinant.report.average_energy / flat.report.average_energy - 1.;
    EXPECT_GT(difference, 0.); // the determinant is less than the flat area
    EXPECT_LT(difference, 0.5 * last_difference);
    last_difference = difference;
  }
  EXPECT_LT(last_difference, 0.01);
}

TEST(Barrier, is_what_the_energy_is_made_of)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
  const Result newton = run_with_barrier<SP::Flat_area_barrier_3, SP::Newton_update_3>(mesh, 100),
               gradient = run_with_barrier<SP::Flat_area_barrier_3, SP::Gradient_update_3>(mesh, 300),
               determinant = run_with_barrier<SP::Determinant_barrier_3, SP::Newton_update_3>(mesh, 100);
  const auto measured = [](const Result& r) { return 0.5 * (r.distortion.angle.average + r.distortion.area.average); };
  EXPECT_NEAR(newton.report.average_energy, measured(newton), 1e-10);
  EXPECT_NEAR(gradient.report.average_energy, measured(gradient), 1e-10);
  EXPECT_GT(determinant.report.average_energy, measured(determinant) + 1e-4);
  // Each of them lowers what it is about; both updates find the same minimum.
  EXPECT_LT(measured(newton), measured(determinant));
  EXPECT_NEAR(measured(gradient), measured(newton), 1e-3);
}

} // namespace
