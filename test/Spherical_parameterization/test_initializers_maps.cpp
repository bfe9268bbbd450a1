// The maps that BLD is compared with, as whole runs: of surfaces whose conformal map to the sphere is known, or whose map that
// is as rigid as possible is, with the center of mass where it belongs, and never with a fold where none is allowed. The
// method as it was published, and conformal maps by BLD.

#include "methods.h"
#include "random_meshes.h"

#include <CGAL/Spherical_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Conformal_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Harmonic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Published_low_distortion_parameterizer_3.h>

using namespace test;

namespace {

// A mesh of the unit sphere with small faces on one side: the icosphere, moved by a Moebius transformation.
Triangle_list graded_sphere(unsigned int subdivisions)
{
  Triangle_list list = icosphere(subdivisions);
  const Coordinates c = {0.1, 0.2, 0.3};
  for(Coordinates& p : list.points)
  {
    const Coordinates s = combination(1., p, 1., c);
    p = normalized(combination((1. - dot(c, c)) / dot(s, s), s, 1., c));
  }
  return list;
}

TEST(Conformal_map, of_a_sphere_is_the_identity)
{
  for(const bool is_graded : {false, true})
  {
    double last_difference = 1.;
    for(const unsigned int subdivisions : {2u, 3u, 4u})
    {
      const Triangle_list sphere = is_graded ? graded_sphere(subdivisions) : icosphere(subdivisions);
      const auto difference_of = [&](const Method& method) {
        const Result result = method.run(sphere);
        EXPECT_EQ(result.error, SP::OK);
        EXPECT_EQ(result.report.radius, 1.);
        return largest_difference_up_to_rotation(result.images, sphere.points);
      };
      const double of_conformal = difference_of(conformal());
      EXPECT_LT(of_conformal, (is_graded ? 0.8 : 0.025) / std::pow(4., subdivisions)); // the order of the method is 2
      EXPECT_LT(of_conformal, 0.3 * last_difference);
      EXPECT_NEAR(difference_of(harmonic()), of_conformal, 1e-6); // no angle is obtuse, so the weights are the same
      EXPECT_LT(difference_of(stereographic()), 0.1);
      last_difference = of_conformal;
    }
  }
}

// Far from any symmetry.
TEST(Conformal_map, of_a_bumpy_sphere_keeps_its_angles)
{
  const Triangle_list list = bumpy_sphere(4);
  const Result of_conformal = conformal().run(list), of_harmonic = harmonic().run(list),
               of_stereographic = stereographic().run(list);
  for(const Result* result : {&of_conformal, &of_harmonic, &of_stereographic})
  {
    ASSERT_EQ(result->error, SP::OK);
    EXPECT_EQ(result->report.radius, 1.);
    EXPECT_EQ(result->report.stop_reason, SP::CONVERGED);
  }
  EXPECT_LT(of_conformal.distortion.angle.average, 2.016);
  EXPECT_LT(of_harmonic.distortion.angle.average, 2.024);
  EXPECT_LT(of_stereographic.distortion.angle.average, 2.03);
  EXPECT_LT(of_conformal.distortion.angle.average, of_harmonic.distortion.angle.average);
  EXPECT_LT(of_harmonic.distortion.angle.average, of_stereographic.distortion.angle.average);

  EXPECT_NEAR(of_conformal.report.average_energy, 1., 0.005);
  EXPECT_LT(of_conformal.report.average_energy, of_harmonic.report.average_energy);
  EXPECT_LT(of_harmonic.report.average_energy, of_harmonic.report.initial_energy);
  EXPECT_TRUE(have_same_bits(harmonic().run(list, Options().iterations(0)).images, of_stereographic.images));
}

// The classical map folds where the triangulation is coarse for its extremities; the harmonic one with positive weights does
// not.
TEST(Conformal_map, tells_of_folds)
{
  for(const unsigned int subdivisions : {2u, 3u})
  {
    const Mesh mesh = make(bumpy_sphere(subdivisions));
    const Result result = conformal().run(mesh);
    EXPECT_EQ(result.error, SP::ERROR_NO_1_TO_1_MAPPING);
    EXPECT_GT(result.distortion.number_of_inverted_faces, 0u);
    EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
    EXPECT_EQ(harmonic().run(mesh).error, SP::OK);
  }
  // A fold is nothing to start from.
  const Method method("from conformal", SP::Bijective_low_distortion_parameterizer_3().initial_parameterizer(
                                            SP::Conformal_parameterizer_3()));
  EXPECT_EQ(method.run(bumpy_sphere(2)).error, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  EXPECT_EQ(method.run(bumpy_sphere(1)).error, SP::OK);
}

// The image of a tentacle shrinks like exp(-10 pi length); doubles end at 1e-16.
TEST(Conformal_map, of_a_tentacle_goes_as_far_as_doubles)
{
  for(const double length : {1., 2., 5., 20.})
  {
    SCOPED_TRACE(length);
    const Mesh mesh = make(with_tentacle(static_cast<std::size_t>(20. * length), length));
    const Result of_harmonic = harmonic().run(mesh), of_conformal = conformal().run(mesh);
    EXPECT_EQ(of_conformal.error, length < 3. ? SP::OK : SP::ERROR_NO_1_TO_1_MAPPING);
    EXPECT_EQ(of_harmonic.error, length < 10. ? SP::OK : SP::ERROR_INSUFFICIENT_PRECISION);
    if(length > 10.)
    {
      EXPECT_EQ(stereographic().run(mesh).error, SP::ERROR_INSUFFICIENT_PRECISION);
    }
    else if(length > 3.)
    {
      EXPECT_EQ(of_harmonic.report.stop_reason, SP::OBSTRUCTED); // by faces that have no room left
    }
    else
    {
      EXPECT_GT(of_conformal.distortion.area.maximum, 1e7);
      EXPECT_LT(of_conformal.distortion.angle.average, 2.15);
    }
    // what never folds comes as near to it as it can
    const Result of_bijective = bijective_conformal().run(mesh, Options().iterations(50));
    EXPECT_EQ(of_bijective.error, SP::OK);
    EXPECT_LT(of_bijective.distortion.angle.average, length < 1.5 ? 2.2 : 8.);
  }
}

// Small meshes of any shape, with slivers and spikes: always a bijection where one is promised, and an energy that falls, but
// for the little that the centring may cost.
TEST(Harmonic_map, of_small_meshes_is_one_to_one)
{
  Random random(1);
  std::size_t n_folds = 0;
  for(int k = 0; k < 100; ++k)
  {
    Triangle_list list = k % 3 == 0 ? icosphere(1) : k % 3 == 1 ? suspension(3 + random.below(20)) : icosphere(0);
    for(Coordinates& p : list.points)
    {
      const double factor = std::exp(random.between(-2., 2.));
      p = combination(factor, p, 0.5, random.in_cube());
    }
    const auto seed = static_cast<std::uint32_t>(k);
    const Mesh mesh = make(renumbered(list, random_permutation(list.points.size(), seed), seed));
    SCOPED_TRACE(k);
    EXPECT_EQ(stereographic().run(mesh).error, SP::OK);
    for(const Method& method : {harmonic(), conformal()})
    {
      Recorder recorder;
      const Result result = method.run(mesh, Options().visitor(recorder));
      double lowest = result.report.initial_energy;
      for(const Recorder::Event& iteration : recorder.all("iteration"))
      {
        EXPECT_LT(iteration.energy, (1. + 1e-4) * lowest);
        lowest = (std::min)(lowest, iteration.energy);
      }
      EXPECT_TRUE(result.error == SP::OK || method.may_fold());
      n_folds += result.error == SP::ERROR_NO_1_TO_1_MAPPING;
    }
  }
  EXPECT_GT(n_folds, 10u);
  EXPECT_LT(n_folds, 90u);
}

// Surfaces that lie in a plane, on a line, or in one point.
TEST(Flat_surface, is_mapped)
{
  for(const double y : {1., 0.})
    for(const double x : {1., 0.})
    {
      const Mesh mesh = make(test_meshes::scaled(icosphere(1), x, x * y, 0.));
      EXPECT_EQ(stereographic().run(mesh).error, SP::OK);
      EXPECT_EQ(harmonic().run(mesh).error, SP::OK);
      for(const Method& method : {conformal(), arap()})
      {
        const SP::Error_code error = method.run(mesh).error;
        EXPECT_TRUE(error == SP::OK || error == SP::ERROR_NO_1_TO_1_MAPPING);
      }
    }
}

// BLD with the conformal energy.
TEST(Bijective_conformal_map, keeps_the_angles)
{
  EXPECT_LT(bijective_conformal().run(icosphere(3)).distortion.angle.maximum, 2.005);
  const Mesh mesh = make(bumpy_sphere(4));
  const Result of_conformal = bijective_conformal().run(mesh, Options().iterations(200)),
               of_default = bijective().run(mesh);
  ASSERT_EQ(of_conformal.error, SP::OK);
  EXPECT_EQ(of_conformal.report.radius, 1.);
  EXPECT_LT(of_conformal.distortion.angle.maximum, 2.5);
  EXPECT_LT(of_conformal.distortion.angle.average, 2.015);
  // the default energy trades angles for areas
  EXPECT_GT(of_default.distortion.angle.average, 1.05 * of_conformal.distortion.angle.average);
  EXPECT_LT(of_default.distortion.area.maximum, 0.5 * of_conformal.distortion.area.maximum);
}

// Faces may be inverted, but not those of a sphere with smooth bumps; what never inverts any does not on these either.
TEST(ARAP_map, has_an_energy_that_never_rises_and_tells_of_folds)
{
  std::vector<Triangle_list> lists = {bumpy_sphere(3), with_tentacle(20, 1.), with_tentacle(40, 2.),
                                      test_meshes::scaled(suspension(12), 1., 1., 10.), icosphere(1)};
  for(std::size_t v = 0; v < 12; ++v) // a star
    lists.back().points[v] = scaled({lists.back().points[v]}, 8.)[0];
  std::size_t n_obstructed = 0;
  for(const Triangle_list& list : lists)
  {
    Recorder recorder;
    const Result result = arap().run(list, Options().visitor(recorder));
    const SP::Parameterization_report& report = result.report;
    EXPECT_EQ(result.error, &list == &lists[0] ? SP::OK : SP::ERROR_NO_1_TO_1_MAPPING);
    const std::vector<Recorder::Event> iterations = recorder.all("iteration");
    ASSERT_GE(iterations.size(), 5u);
    double last = report.initial_energy;
    for(const Recorder::Event& iteration : iterations)
    {
      EXPECT_LT(iteration.energy, last);
      last = iteration.energy;
    }
    EXPECT_EQ(report.average_energy, last);
    EXPECT_EQ(report.radius, iterations.back().radius);
    // The energy has settled, or, where it is not smooth because a face folds, no step lowers it.
    EXPECT_TRUE(report.stop_reason == SP::CONVERGED || report.stop_reason == SP::OBSTRUCTED);
    n_obstructed += report.stop_reason == SP::OBSTRUCTED;
    EXPECT_EQ(bijective().run(list).error, SP::OK);
  }
  EXPECT_GT(n_obstructed, 0u); // a fold is where no step helps, and that is not called convergence
}

TEST(ARAP_map, of_a_sphere_is_the_identity)
{
  for(const double scale : {1., 5.})
  {
    const Triangle_list list = test_meshes::scaled(icosphere(2), scale, scale, scale);
    const Result result = arap().run(list);
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_LT(result.report.average_energy, 1e-12);
    EXPECT_NEAR(result.report.radius, scale, 1e-6 * scale);
    EXPECT_LT(largest_difference_up_to_rotation(result.images, list.points), 1e-5 * scale);
    EXPECT_LT(result.distortion.isometric.maximum, 1.00001);
  }
}

TEST(ARAP_map, starts_from_any_map)
{
  const Mesh mesh = make(bumpy_sphere(2));
  const Method from_harmonic("from harmonic", SP::ARAP_parameterizer_3(SP::Harmonic_parameterizer_3()), true);
  const Result one = arap().run(mesh), other = from_harmonic.run(mesh);
  EXPECT_EQ(one.error, SP::OK);
  EXPECT_EQ(other.error, SP::OK);
  EXPECT_GT(std::abs(other.report.initial_energy / one.report.initial_energy - 1.), 0.1);
  EXPECT_NEAR(other.report.average_energy / one.report.average_energy, 1., 1e-2);
  EXPECT_NEAR(other.report.radius / one.report.radius, 1., 1e-2);
  // Being stopped while the start is made counts, even if there is nothing left to do then.
  Recorder stopper(1);
  const Result stopped = arap().run(mesh, Options().visitor(stopper).iterations(0));
  EXPECT_EQ(stopped.report.stop_reason, SP::STOPPED);
  EXPECT_EQ(stopped.report.number_of_iterations(), 0u);
}

TEST(Published_method, follows_its_schedule)
{
  const Mesh mesh = make(bumpy_sphere(1));
  const Result result = published().run(mesh);
  EXPECT_EQ(result.error, SP::OK);
  EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
  EXPECT_EQ(result.report.number_of_average_iterations, 100u);
  EXPECT_GT(result.report.number_of_sharp_iterations, 21u); // 21 steps of a quarter from 0.1 to 10
  EXPECT_EQ(result.report.sharpness, 10.);
  EXPECT_EQ(result.report.number_of_levels, 0u); // it starts from a harmonic map
  // AMIPS with a fixed s and no sweep of eq. 6, as in figure 6 of the paper, and a schedule with one
  const SP::Published_low_distortion_parameterizer_3 method;
  const Result fixed = Method("fixed", method.sharpness(SP::Sharpness::fixed(5.))).run(mesh);
  EXPECT_EQ(fixed.report.number_of_average_iterations, 0u);
  EXPECT_EQ(fixed.report.sharpness, 5.);
  const Result one = Method("one", method.sharpness(SP::Sharpness::schedule(0.1, 10., 1))).run(mesh);
  EXPECT_EQ(one.report.number_of_average_iterations, 1u);
  EXPECT_EQ(one.report.sharpness, 10.);
}

// The energies of the sweeps of a run, and their radii, after those before the first one.
std::vector<Recorder::Event> sweeps_of(const Method& method, const Options& options)
{
  Recorder recorder;
  const SP::Parameterization_report report = method.run(bumpy_sphere(2), Options(options).visitor(recorder)).report;
  std::vector<Recorder::Event> result = recorder.all("iteration");
  result.insert(result.begin(), {"start", 0, report.initial_energy});
  return result;
}

// Equation 9 until all has settled, then equation 11 until it has again; in full steps.
TEST(Published_method, changes_the_radius_in_two_phases)
{
  const Mesh mesh = make(bumpy_sphere(2));
  const auto method = SP::Published_low_distortion_parameterizer_3().sharpness(SP::Sharpness::fixed(2.));
  const Method two_phases("two phases", method), first("first", method.radius(SP::Area_preserving_radius_3()));
  // as long as eq. 9 alone has not settled, both are the same; after that, one goes on
  const std::vector<Recorder::Event> a = sweeps_of(two_phases, Options()), b = sweeps_of(first, Options());
  ASSERT_GT(b.size(), 10u);
  ASSERT_GT(a.size(), b.size() + 1);
  for(std::size_t i = 0; i < b.size(); ++i)
  {
    EXPECT_EQ(a[i].radius, b[i].radius);
    EXPECT_EQ(a[i].energy, b[i].energy);
  }
  EXPECT_GT(std::abs(a[b.size()].radius / b.back().radius - 1.), 1e-2);

  // A run that ends early gets the last radius as well. By eq. 11, the sums of d and 1 / d are the same.
  const Images surface = points(mesh);
  for(const int n_sweeps : {0, 3, 500})
  {
    const Images result = two_phases.run(mesh, Options().iterations(n_sweeps)).images;
    double sum = 0., sum_of_inverses = 0.;
    for(const Triangle& t : triangles(mesh))
    {
      const double d =
          area(result[t[0]], result[t[1]], result[t[2]]) / area(surface[t[0]], surface[t[1]], surface[t[2]]);
      sum += d;
      sum_of_inverses += 1. / d;
    }
    EXPECT_NEAR(sum / sum_of_inverses, 1., 1e-12);
  }
}

TEST(Published_method, lowers_the_sum_of_the_energies)
{
  const Method method("fixed radius", SP::Published_low_distortion_parameterizer_3().radius(SP::Fixed_radius_3(1.4)));
  const std::vector<Recorder::Event> sweeps = sweeps_of(method, Options().iterations(100));
  ASSERT_EQ(sweeps.size(), 101u);
  for(std::size_t i = 1; i < sweeps.size(); ++i)
  {
    EXPECT_LT(sweeps[i].energy, (i < 31 ? 1. : 1. + 1e-14) * sweeps[i - 1].energy)
        << i; // the end is a matter of rounding
    EXPECT_GT(sweeps[i].energy, 2.);
    EXPECT_EQ(sweeps[i].radius, 1.4);
  }
}

// The stopping rule compares the sum of exp(s E) before and after a sweep, that is, exp(s mean), and the radii.
TEST(Published_method, stops_when_the_sum_and_the_radius_have_settled)
{
  const auto method = SP::Published_low_distortion_parameterizer_3().radius(SP::Area_preserving_radius_3());
  for(const double s : {5., 0.5})
  {
    const std::vector<Recorder::Event> sweeps =
        sweeps_of(Method("fixed sharpness", method.sharpness(SP::Sharpness::fixed(s))), Options());
    ASSERT_GT(sweeps.size(), 10u);
    for(std::size_t i = 2; i < sweeps.size(); ++i)
    {
      const bool has_settled = std::abs(std::exp(s * (sweeps[i].energy - sweeps[i - 1].energy)) - 1.) <= 1e-5 &&
                               std::abs(sweeps[i].radius / sweeps[i - 1].radius - 1.) <= 1e-3;
      EXPECT_EQ(has_settled, i + 1 == sweeps.size()) << i;
    }
  }
}

TEST(Published_method, is_certified_on_small_meshes)
{
  for(const Triangle_list& list : {tetrahedron(), octahedron(), icosphere(1), suspension(9), bumpy_sphere(1),
                                   ellipsoid(1., 0.3, 3., 2), with_tentacle(20, 1.)})
  {
    const Result result = published().run(list, Options().iterations(400));
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_LE(result.report.average_energy, result.report.initial_energy);
    // The energy is the mean of angle and area distortion as they are measured, with flat areas.
    EXPECT_NEAR(result.report.average_energy /
                    (0.5 * (result.distortion.angle.average + result.distortion.area.average)),
                1., 1e-9);
  }
  // the round ones get the map without distortion
  const Triangle_list sphere = test_meshes::scaled(icosphere(2), 3., 3., 3.);
  const Result result = published().run(sphere);
  EXPECT_NEAR(result.report.average_energy, 2., 1e-9);
  EXPECT_NEAR(result.report.radius, 3., 1e-4);
  EXPECT_LT(largest_difference_up_to_rotation(result.images, sphere.points), 1e-3);
}

} // namespace
