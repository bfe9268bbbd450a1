// The maps of least harmonic energy and their start: of surfaces whose conformal map to the sphere is known, with the
// centre of mass where it belongs, and never with a fold where none is allowed.

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"
#include "test_runs.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <type_traits>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace params = CGAL::parameters;

namespace {

using test_meshes::Coordinates;
using test_meshes::Triangle_list;
using test_runs::Result;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Stereographic = SP::Stereographic_parameterizer_3<Mesh>;
using Harmonic = SP::Harmonic_parameterizer_3<Mesh>;
using Conformal = SP::Conformal_parameterizer_3<Mesh>;

template <class Method>
Result run(const Triangle_list& list)
{
  Method method;
  return test_runs::run<Point_3>(test_meshes::make_mesh<Mesh>(list), method, std::is_same<Method, Conformal>::value);
}

template <class Method>
Result run(const Triangle_list& list, std::size_t number_of_iterations)
{
  Method method;
  return test_runs::run<Point_3>(test_meshes::make_mesh<Mesh>(list), method, std::is_same<Method, Conformal>::value,
                                 params::number_of_iterations(number_of_iterations));
}

Coordinates difference(const Coordinates& a, const Coordinates& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Coordinates& a, const Coordinates& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Coordinates cross(const Coordinates& a, const Coordinates& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The distance of the centre of the area of the surface from the centre of the sphere.
double distance_of_center(const Triangle_list& list, const std::vector<Coordinates>& images)
{
  Coordinates sum = {0., 0., 0.};
  double mass = 0.;
  for(const test_meshes::Triangle& t : list.triangles)
  {
    const Coordinates &a = list.points[t[0]], &b = list.points[t[1]], &c = list.points[t[2]];
    const double area = test_maps::norm(cross(difference(b, a), difference(c, a)));
    for(const std::size_t v : t)
    {
      for(std::size_t i = 0; i < 3; ++i)
      {
        sum[i] += area * images[v][i];
      }
      mass += area;
    }
  }
  return test_maps::norm(sum) / mass;
}

// The sum of the cotangent over the squared edges, in the unit of the area of the sphere.
double harmonic_energy(const Triangle_list& list, const std::vector<Coordinates>& images)
{
  double sum = 0.;
  for(const test_meshes::Triangle& t : list.triangles)
  {
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      const Coordinates p = difference(list.points[b], list.points[a]), q = difference(list.points[c], list.points[a]);
      const double d = test_maps::distance(images[b], images[c]);
      sum += 0.25 * dot(p, q) / test_maps::norm(cross(p, q)) * d * d;
    }
  }
  return sum / (4. * test_meshes::pi);
}

// A mesh of the unit sphere with small faces on one side: the icosphere, moved by a Moebius transformation.
Triangle_list graded_sphere(unsigned int subdivisions)
{
  Triangle_list list = test_meshes::icosphere(subdivisions);
  const Coordinates c = {0.1, 0.2, 0.3};
  for(Coordinates& p : list.points)
  {
    const Coordinates s = {p[0] + c[0], p[1] + c[1], p[2] + c[2]};
    const double factor = (1. - dot(c, c)) / dot(s, s);
    p = test_meshes::normalized({factor * s[0] + c[0], factor * s[1] + c[1], factor * s[2] + c[2]});
  }
  return list;
}

TEST(Sphere, is_mapped_to_itself)
{
  for(const bool is_graded : {false, true})
  {
    double last_difference = 1.;
    for(const unsigned int subdivisions : {2u, 3u, 4u})
    {
      const Triangle_list sphere = is_graded ? graded_sphere(subdivisions) : test_meshes::icosphere(subdivisions);
      const auto difference_of = [&](const Result& result) {
        EXPECT_EQ(result.error, SP::OK);
        EXPECT_EQ(result.report.radius, 1.);
        EXPECT_LT(distance_of_center(sphere, result.images), 1e-8);
        return test_runs::largest_difference_up_to_rotation(result.images, sphere.points);
      };
      const double conformal = difference_of(run<Conformal>(sphere)), harmonic = difference_of(run<Harmonic>(sphere)),
                   stereographic = difference_of(run<Stereographic>(sphere));
      EXPECT_LT(conformal, (is_graded ? 0.8 : 0.025) / std::pow(4., subdivisions)); // the order of the method is 2
      EXPECT_LT(conformal, 0.3 * last_difference);
      EXPECT_NEAR(harmonic, conformal, 1e-6); // no angle is obtuse, so the weights are the same
      EXPECT_LT(stereographic, 0.1);
      last_difference = conformal;
    }
  }
}

// The conformal map of the ellipsoid with the half-axes 1, 1, c. On a surface of revolution, the integral of (length of
// the meridian) / (distance from the axis) and the longitude are conformal coordinates. On the unit sphere the integral
// is artanh(z), on the ellipsoid artanh(x) + J(x) with x = z / c and J(x) the integral of (c^2 - 1) / (1 + sqrt(t^2 +
// c^2 (1 - t^2))), which has no singularity at the poles. So the image has the height tanh(artanh(x) + J(x)) and the
// longitude stays.
Coordinates conformal_image(const Coordinates& p, double c)
{
  const double x = p[2] / c;
  const auto integrand = [&](double t) { return (c * c - 1.) / (1. + std::sqrt(t * t + c * c * (1. - t * t))); };
  const int n = 100; // Simpson's rule
  double integral = 0.;
  for(int k = 0; k < n; ++k)
  {
    const double t0 = x * k / n, t1 = x * (k + 1) / n;
    integral += (t1 - t0) / 6. * (integrand(t0) + 4. * integrand(0.5 * (t0 + t1)) + integrand(t1));
  }
  const double tanh = std::tanh(integral), height = (x + tanh) / (1. + x * tanh);
  const double r = std::hypot(p[0], p[1]), distance = std::sqrt((std::max)(1. - height * height, 0.));
  return {r > 0. ? distance * p[0] / r : 0., r > 0. ? distance * p[1] / r : 0., height};
}

// Images in the frame in which those of the vertices that are on the z-axis and the x-axis are there as well.
std::vector<Coordinates> in_frame_of_axes(const Triangle_list& list, const std::vector<Coordinates>& images)
{
  const auto extreme = [&](std::size_t axis) {
    const auto last = std::max_element(list.points.begin(), list.points.end(),
                                       [&](const auto& p, const auto& q) { return p[axis] < q[axis]; });
    return images[static_cast<std::size_t>(last - list.points.begin())];
  };
  const Coordinates z = extreme(2), y = test_meshes::normalized(cross(z, extreme(0))), x = cross(y, z);
  std::vector<Coordinates> result;
  for(const Coordinates& u : images)
  {
    result.push_back({dot(u, x), dot(u, y), dot(u, z)});
  }
  return result;
}

double error_of_ellipsoid(const Triangle_list& list, double c, const std::vector<Coordinates>& images)
{
  std::vector<Coordinates> exact;
  for(const Coordinates& p : list.points)
  {
    exact.push_back(conformal_image(p, c));
  }
  return test_maps::largest_distance(in_frame_of_axes(list, images), exact);
}

TEST(Ellipsoid, has_its_known_conformal_map)
{
  for(const double c : {3., 0.4})
  {
    SCOPED_TRACE(c);
    double last_error = 1.;
    for(const unsigned int subdivisions : {2u, 3u, 4u, 5u})
    {
      const Triangle_list list = test_meshes::ellipsoid(1., 1., c, subdivisions);
      const Result result = run<Conformal>(list);
      ASSERT_EQ(result.error, SP::OK);
      EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
      const double error = error_of_ellipsoid(list, c, result.images);
      EXPECT_LT(error, 0.4 * last_error); // the order of the method is 2, and no more than 1.3 to begin with
      last_error = error;
      EXPECT_LT(distance_of_center(list, result.images), 1e-8);
    }
  }
}

// Stretched to a third, angles are obtuse and weights raised, and yet harmonic maps are not far from conformal.
TEST(Ellipsoid, is_mapped_alike_by_the_other_methods)
{
  const Triangle_list list = test_meshes::ellipsoid(1., 1., 0.4, 4);
  const Result harmonic = run<Harmonic>(list), stereographic = run<Stereographic>(list);
  ASSERT_EQ(harmonic.error, SP::OK);
  ASSERT_EQ(stereographic.error, SP::OK);
  EXPECT_LT(error_of_ellipsoid(list, 0.4, harmonic.images), 0.1);
  EXPECT_LT(error_of_ellipsoid(list, 0.4, stereographic.images), 0.6);
}

// Far from any symmetry.
TEST(Bumpy_sphere, keeps_its_angles)
{
  const Triangle_list list = test_meshes::bumpy_sphere(4);
  const Result conformal = run<Conformal>(list), harmonic = run<Harmonic>(list),
               stereographic = run<Stereographic>(list);
  for(const Result* result : {&conformal, &harmonic, &stereographic})
  {
    ASSERT_EQ(result->error, SP::OK);
    EXPECT_EQ(result->report.radius, 1.);
    EXPECT_EQ(result->report.stop_reason, SP::CONVERGED);
    EXPECT_LT(distance_of_center(list, result->images), 1e-8);
    EXPECT_LT(result->distortion.angle.average, 2.03);
  }
  EXPECT_LT(conformal.distortion.angle.average, 2.016);
  EXPECT_LT(harmonic.distortion.angle.average, 2.024);
  EXPECT_LT(conformal.distortion.angle.average, harmonic.distortion.angle.average);
  EXPECT_LT(harmonic.distortion.angle.average, stereographic.distortion.angle.average);

  const double energy = harmonic_energy(list, conformal.images);
  EXPECT_NEAR(conformal.report.average_energy, energy, 1e-12);
  EXPECT_NEAR(energy, 1., 0.005);
  EXPECT_LT(energy, harmonic_energy(list, harmonic.images));
  EXPECT_LT(harmonic_energy(list, harmonic.images), harmonic_energy(list, stereographic.images));
  EXPECT_LT(harmonic.report.average_energy, harmonic.report.initial_energy);
  EXPECT_NEAR(conformal.report.initial_energy, harmonic_energy(list, stereographic.images), 1e-12);
}

TEST(Number_of_iterations, is_respected)
{
  const Triangle_list list = test_meshes::bumpy_sphere(3);
  const Result start = run<Stereographic>(list);
  const auto expect_respected = [&](const Result& none, const Result& three, const Result& all) {
    // without a step, the map is the one that the method starts from
    EXPECT_TRUE(test_maps::have_same_bits(none.images, start.images));
    EXPECT_EQ(none.report.number_of_iterations(), 0u);
    EXPECT_EQ(none.report.stop_reason, SP::ITERATION_LIMIT);
    EXPECT_EQ(none.report.average_energy, none.report.initial_energy);
    EXPECT_EQ(three.report.number_of_iterations(), 3u);
    EXPECT_EQ(three.report.stop_reason, SP::ITERATION_LIMIT);
    EXPECT_LT(three.report.average_energy, none.report.average_energy);
    EXPECT_EQ(all.report.stop_reason, SP::CONVERGED);
    EXPECT_GT(all.report.number_of_iterations(), 5u);
    EXPECT_LT(all.report.number_of_iterations(), 30u);
    EXPECT_LT(all.report.average_energy, 1.0001 * three.report.average_energy); // centring may cost a little
  };
  expect_respected(run<Harmonic>(list, 0), run<Harmonic>(list, 3), run<Harmonic>(list));
  expect_respected(run<Conformal>(list, 0), run<Conformal>(list, 3), run<Conformal>(list));
  Harmonic harmonic;
  const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
  EXPECT_EQ(test_runs::run<Point_3>(mesh, harmonic, false, params::number_of_iterations(-1)).error,
            SP::ERROR_WRONG_PARAMETER);
  Conformal conformal;
  EXPECT_EQ(test_runs::run<Point_3>(mesh, conformal, true, params::number_of_iterations(-1)).error,
            SP::ERROR_WRONG_PARAMETER);
}

// The classical map folds where the triangulation is coarse for its limbs; the harmonic one with positive weights does
// not.
TEST(Folds, are_told_of)
{
  for(const unsigned int subdivisions : {2u, 3u})
  {
    const Triangle_list list = test_meshes::bumpy_sphere(subdivisions);
    const Result conformal = run<Conformal>(list), harmonic = run<Harmonic>(list);
    EXPECT_EQ(conformal.error, SP::ERROR_NO_1_TO_1_MAPPING);
    EXPECT_GT(conformal.distortion.number_of_inverted_faces, 0u);
    EXPECT_EQ(conformal.report.stop_reason, SP::CONVERGED);
    EXPECT_EQ(conformal.report.radius, 1.);
    EXPECT_EQ(harmonic.error, SP::OK);
    EXPECT_EQ(harmonic.report.stop_reason, SP::CONVERGED);
  }
}

TEST(Folds, are_nothing_to_start_from)
{
  using Bld = SP::Bijective_low_distortion_parameterizer_3<Mesh, Conformal>;
  Bld bld;
  const Mesh folding = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2)),
             harmless = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(1));
  EXPECT_EQ(test_runs::run<Point_3>(folding, bld, false).error, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  EXPECT_EQ(bld.report().number_of_iterations(), 0u);
  EXPECT_EQ(test_runs::run<Point_3>(harmless, bld, false).error, SP::OK);
}

TEST(Start, of_bld_makes_no_difference_in_the_end)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(1));
  const auto distortion = [&](auto bld) {
    const Result result = test_runs::run<Point_3>(mesh, bld, false, params::number_of_iterations(500u));
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
    EXPECT_GT(result.report.seconds_for_embedding, 0.);
    return result.distortion.isometric;
  };
  const SP::Distortion_statistics hierarchical = distortion(SP::Bijective_low_distortion_parameterizer_3<Mesh>());
  for(const SP::Distortion_statistics& other :
      {distortion(SP::Bijective_low_distortion_parameterizer_3<Mesh, Stereographic>()),
       distortion(SP::Bijective_low_distortion_parameterizer_3<Mesh, Harmonic>()),
       distortion(SP::Bijective_low_distortion_parameterizer_3<Mesh, Conformal>())})
  {
    EXPECT_NEAR(other.average / hierarchical.average, 1., 0.03);
    EXPECT_NEAR(other.maximum / hierarchical.maximum, 1., 0.1);
  }
}

// The image of a tentacle shrinks like exp(-10 pi length); doubles end at 1e-16.
TEST(Tentacle, is_mapped_as_long_as_doubles_can_hold_it)
{
  for(const double length : {1., 2., 5., 20.})
  {
    SCOPED_TRACE(length);
    const Triangle_list list = test_meshes::with_tentacle(static_cast<std::size_t>(20. * length), length);
    const Result stereographic = run<Stereographic>(list), harmonic = run<Harmonic>(list),
                 conformal = run<Conformal>(list);
    if(length < 3.)
    {
      EXPECT_EQ(stereographic.error, SP::OK);
      EXPECT_EQ(harmonic.error, SP::OK);
      EXPECT_EQ(conformal.error, SP::OK);
      EXPECT_GT(conformal.distortion.area.maximum, 1e7);
      EXPECT_LT(conformal.distortion.angle.average, 2.15);
    }
    else if(length < 10.)
    {
      EXPECT_EQ(harmonic.error, SP::OK);
      EXPECT_EQ(harmonic.report.stop_reason, SP::OBSTRUCTED); // by faces that have no room left
      EXPECT_EQ(conformal.error, SP::ERROR_NO_1_TO_1_MAPPING);
    }
    else
    {
      EXPECT_EQ(stereographic.error, SP::ERROR_INSUFFICIENT_PRECISION);
      EXPECT_EQ(harmonic.error, SP::ERROR_INSUFFICIENT_PRECISION);
      EXPECT_EQ(conformal.error, SP::ERROR_NO_1_TO_1_MAPPING);
    }
  }
}

struct Energies : SP::Default_visitor
{
  void after_iteration(std::size_t, double energy, double) { energies.push_back(energy); }
  std::vector<double> energies;
};

// Expects that the energy falls, but for the little that the centring may cost.
template <class Method>
Result run_and_watch(const Triangle_list& list)
{
  Method method;
  Energies visitor;
  const Result result =
      test_runs::run<Point_3>(test_meshes::make_mesh<Mesh>(list), method, std::is_same<Method, Conformal>::value,
                              params::visitor(std::ref(visitor)));
  double lowest = result.report.initial_energy;
  for(const double energy : visitor.energies)
  {
    EXPECT_LT(energy, (1. + 1e-4) * lowest);
    lowest = (std::min)(lowest, energy);
  }
  EXPECT_EQ(visitor.energies.size(), result.report.number_of_iterations());
  return result;
}

// Small meshes of any shape, with slivers and spikes: always a bijection where one is promised.
TEST(Small_meshes, are_mapped_one_to_one)
{
  std::mt19937 random(1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 0x1p32;
  };
  std::size_t n_folds = 0;
  for(int k = 0; k < 150; ++k)
  {
    Triangle_list list = k % 3 == 0   ? test_meshes::icosphere(1)
                         : k % 3 == 1 ? test_meshes::suspension(3 + random() % 20)
                                      : test_meshes::icosphere(0);
    for(Coordinates& p : list.points)
    {
      const double factor = std::exp(uniform(-2., 2.));
      for(double& x : p)
      {
        x = factor * x + uniform(-0.5, 0.5);
      }
    }
    const auto seed = static_cast<std::uint32_t>(k);
    list = test_meshes::renumbered(list, test_meshes::random_permutation(list.points.size(), seed), seed);
    SCOPED_TRACE(k);
    EXPECT_EQ(run<Stereographic>(list).error, SP::OK);
    EXPECT_EQ(run_and_watch<Harmonic>(list).error, SP::OK);
    n_folds += run_and_watch<Conformal>(list).error == SP::ERROR_NO_1_TO_1_MAPPING;
  }
  EXPECT_GT(n_folds, 20u);
  EXPECT_LT(n_folds, 130u);
}

// Surfaces that lie in a plane, on a line, or in one point.
TEST(Flat_surface, is_mapped_one_to_one)
{
  for(const double y : {1., 0.})
  {
    for(const double x : {1., 0.})
    {
      const Triangle_list list = test_meshes::scaled(test_meshes::icosphere(1), x, x * y, 0.);
      EXPECT_EQ(run<Stereographic>(list).error, SP::OK);
      EXPECT_EQ(run<Harmonic>(list).error, SP::OK);
      run<Conformal>(list);
    }
  }
}

// The unit of length is no matter.
TEST(Scale, is_no_matter)
{
  const Triangle_list list = test_meshes::bumpy_sphere(2), large = test_meshes::scaled(list, 1024., 1024., 1024.);
  EXPECT_TRUE(test_maps::have_same_bits(run<Stereographic>(list).images, run<Stereographic>(large).images));
  EXPECT_TRUE(test_maps::have_same_bits(run<Harmonic>(list).images, run<Harmonic>(large).images));
  EXPECT_TRUE(test_maps::have_same_bits(run<Conformal>(list).images, run<Conformal>(large).images));
}

} // namespace
