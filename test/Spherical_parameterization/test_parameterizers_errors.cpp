// Each error code that is not that of a defect of the mesh for what it is meant for; and that nothing is written then, but for a
// map that stores other values than it was given.

#include <CGAL/Spherical_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Conformal_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Harmonic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Published_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Stereographic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Laplacian_system.h>

#include "methods.h"

#include <CGAL/boost/graph/generators.h>

using namespace test;

namespace {

using Bld = SP::Bijective_low_distortion_parameterizer_3<>;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Error_message, is_a_different_sentence_for_each_code)
{
  std::set<std::string> messages;
  for(int code = SP::OK; code <= SP::ERROR_STOPPED; ++code)
  {
    const char* message = SP::get_error_message(static_cast<SP::Error_code>(code));
    ASSERT_NE(message, nullptr);
    EXPECT_GT(std::string(message).size(), 20u);
    EXPECT_TRUE(messages.insert(message).second) << message;
  }
  // Not everything that succeeds is a map.
  EXPECT_EQ(std::string(SP::get_error_message(SP::OK)).find("one-to-one"), std::string::npos);
  std::set<std::string> reasons;
  for(int reason = SP::NOT_RUN; reason <= SP::NON_FINITE_ENERGY; ++reason)
    EXPECT_TRUE(reasons.insert(SP::get_stop_message(static_cast<SP::Stop_reason>(reason))).second);
}

TEST(Error_code, invalid_initial_parameterization)
{
  const Mesh mesh = make(bumpy_sphere(1));
  const Images sphere = icosphere(1).points;
  const auto expect = [](const Mesh& surface, const Images& start, SP::Error_code error) {
    for(const Method& method : {precomputed(surface, start), bijective_from(surface, start)})
      if(error == SP::OK)
        EXPECT_EQ(method.run(surface).error, SP::OK);
      else
        expect_error(surface, method, error);
  };
  expect(mesh, sphere, SP::OK);
  expect(mesh, scaled(sphere, 1e200), SP::OK);
  expect(mesh, scaled(sphere, 1e-300), SP::OK);
  EXPECT_EQ(precomputed(mesh, sphere).run(mesh).report.stop_reason, SP::CONVERGED);
  std::vector<Images> invalid(5, sphere);
  invalid[0] = scaled(sphere, -1.);
  std::swap(invalid[1][3], invalid[1][20]);
  invalid[2][5] = {0., 0., 0.};
  invalid[3][5] = {nan, 0., 0.};
  invalid[4][5] = {inf, 0., 0.};
  for(const Images& start : invalid)
    expect(mesh, start, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  // all faces positive, but the sphere is covered twice
  expect(make(suspension(7)), suspension(7, 2).points, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
}

// A face that is positive by less than the sweeps can compute: a bijection, but nothing to start from.
TEST(Error_code, initial_map_that_is_one_to_one_only_just_so)
{
  const Triangle_list list = icosphere(0);
  const Mesh mesh = make(list);
  const Triangle t = list.triangles[0]; // its first corner goes to the middle of the opposite edge
  const Coordinates middle = normalized(combination(1., list.points[t[1]], 1., list.points[t[2]]));
  std::size_t number_of_maps = 0;
  for(int k = -8; k < 24; ++k)
  {
    Images points = list.points;
    points[t[0]] = combination(1., middle, k * std::numeric_limits<double>::epsilon() / 2., list.points[t[0]]);
    const Point_map map(mesh, sentinels(num_vertices(mesh)));
    if(precomputed(mesh, points).parameterize(mesh, map) != SP::OK)
      continue;
    ++number_of_maps;
    EXPECT_TRUE(is_bijective(mesh, images(mesh, map)));
    expect_error(mesh, bijective_from(mesh, points), SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  }
  EXPECT_GT(number_of_maps, 0u);
}

TEST(Error_code, insufficient_precision)
{
  // On a sphere of the radius of the smallest positive double, there are not enough points.
  const Method method("tiny", Bld().radius(SP::Fixed_radius_3(5e-324)));
  EXPECT_EQ(method.run(icosphere(1)).error, SP::ERROR_INSUFFICIENT_PRECISION);
}

TEST(Error_code, wrong_parameter)
{
  const Mesh mesh = make(icosphere(0));
  for(const Method& method : all_methods())
    if(method.name() != "hierarchical" && method.name() != "stereographic" &&
       method.name() != "schnyder") // without iterations
    {
      EXPECT_EQ(method.run(mesh, Options().iterations(-1)).error, SP::ERROR_WRONG_PARAMETER) << method.name();
    }
  const auto expect_wrong = [&](const auto& parameterizer) {
    EXPECT_FALSE(parameterizer.is_valid());
    expect_error(mesh, Method("wrong", parameterizer), SP::ERROR_WRONG_PARAMETER);
  };
  for(const double alpha : {0., -0.5, 2., inf, nan})
    expect_wrong(Bld().energy(SP::Isometric_energy_3(alpha)));
  for(const double r : {0., -1., inf, nan})
    expect_wrong(Bld().radius(SP::Fixed_radius_3(r)));
  using Radius = SP::Two_phase_radius_3<SP::Fixed_radius_3, SP::Area_balancing_radius_3>;
  expect_wrong(Bld().radius(Radius(SP::Fixed_radius_3(-1.)))); // a part of a policy
  expect_wrong(Bld().radius(Radius(SP::Fixed_radius_3(1.), {}, -1e-3)));
  for(const double tolerance : {-1., nan})
  {
    expect_wrong(Bld().tolerances(tolerance, 1e-3));
    expect_wrong(Bld().tolerances(1e-5, tolerance));
  }
  EXPECT_TRUE(Bld().tolerances(0., 0.).is_valid());
  for(const double beta : {-1e-9, inf, nan})
  {
    const SP::Sharpness sharpness = SP::Sharpness::relative(beta);
    expect_wrong(Bld().sharpness(sharpness));
    expect_wrong(SP::Published_low_distortion_parameterizer_3().sharpness(sharpness));
  }
  // parameters of the initial parameterizer
  const auto no_sweeps = SP::Hierarchical_parameterizer_3().sweeps_per_level(0);
  expect_wrong(no_sweeps);
  expect_wrong(Bld().initial_parameterizer(no_sweeps));
  expect_wrong(SP::ARAP_parameterizer_3(no_sweeps));
}

// Fails when it is called for the `fails_at`th time.
struct Failing_solver : SP::internal::Solver_traits<CGAL::Default>::type
{
  using Base = SP::internal::Solver_traits<CGAL::Default>::type;

  bool factor(const Base::Matrix& matrix, Base::NT& denominator)
  {
    return ++number_of_calls != fails_at && Base::factor(matrix, denominator);
  }
  bool linear_solver(const Base::Vector& right, Base::Vector& solution)
  {
    return ++number_of_calls != fails_at && Base::linear_solver(right, solution);
  }

  static inline int number_of_calls = 0, fails_at = 0;
};

TEST(Error_code, cannot_solve_linear_system)
{
  const Mesh mesh = make(bumpy_sphere(1));
  // Wherever the solver fails, the run ends, and nothing has been written.
  const auto expect_error_anywhere = [&](const Method& method, int min_number_of_calls) {
    Failing_solver::fails_at = Failing_solver::number_of_calls = 0;
    ASSERT_EQ(method.run(mesh).error, SP::OK);
    const int n_calls = Failing_solver::number_of_calls;
    EXPECT_GE(n_calls, min_number_of_calls);
    for(Failing_solver::fails_at = 1; Failing_solver::fails_at <= n_calls; ++Failing_solver::fails_at)
    {
      Failing_solver::number_of_calls = 0;
      EXPECT_EQ(method.run(mesh).error, SP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
      EXPECT_EQ(Failing_solver::number_of_calls, Failing_solver::fails_at);
    }
  };
  using Start = SP::Hierarchical_parameterizer_3<>;
  expect_error_anywhere(Method("stereographic", SP::Stereographic_parameterizer_3<Failing_solver>()), 3);
  expect_error_anywhere(Method("conformal", SP::Conformal_parameterizer_3<Failing_solver>(), true), 10);
  expect_error_anywhere(Method("arap", SP::ARAP_parameterizer_3<Start, Failing_solver>(), true), 10);
  // the code of the initial parameterizer is passed on
  expect_error_anywhere(Method("published", SP::Published_low_distortion_parameterizer_3().initial_parameterizer(
                                                SP::Harmonic_parameterizer_3<Failing_solver>())),
                        10);
}

double single(double x)
{
  return static_cast<double>(static_cast<float>(x));
}

Point_3 in_single_precision(const Point_3& p)
{
  return Point_3(single(p.x()), single(p.y()), single(p.z()));
}

// with a face of size 1e-12, whose corners cannot be distinguished in single precision
Triangle_list with_a_tiny_face()
{
  Triangle_list list = icosphere(1);
  const std::size_t n = list.points.size();
  const Triangle t = list.triangles[0];
  const Coordinates middle = centroid(list, t);
  for(const std::size_t v : t) // a tiny triangle in the middle of a face
    list.points.push_back(combination(1. - 1e-12, middle, 1e-12, list.points[v]));
  list.triangles[0] = {n, n + 1, n + 2};
  for(std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    list.triangles.push_back({t[i], t[j], n + i});
    list.triangles.push_back({t[j], n + j, n + i});
  }
  return list;
}

// What is read back is certified: it is another map, but one-to-one.
TEST(Map_that_rounds, is_certified_as_it_has_been_stored)
{
  const Mesh mesh = make(bumpy_sphere(2));
  const Images given = bijective().run(mesh).images;
  const Point_map map(mesh, given);
  map.stored() = in_single_precision;
  ASSERT_EQ(SP::parameterize(mesh, map), SP::OK);
  const Images stored = images(mesh, map);
  EXPECT_TRUE(is_bijective(mesh, stored));
  EXPECT_FALSE(have_same_bits(stored, given));
  for(std::size_t v = 0; v < stored.size(); ++v)
    for(std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(stored[v][i], single(given[v][i]));
}

// If it folds, the error says so, and the map has been overwritten.
TEST(Map_that_rounds, is_no_map_if_it_folds)
{
  const Mesh fine = make(with_a_tiny_face());
  EXPECT_EQ(bijective().run(fine).error, SP::OK);
  const Point_map map(fine, sentinels(num_vertices(fine)));
  map.stored() = in_single_precision;
  EXPECT_EQ(SP::parameterize(fine, map), SP::ERROR_INSUFFICIENT_PRECISION);
  const Images stored = images(fine, map);
  EXPECT_FALSE(is_bijective(fine, stored));
  for(const Coordinates& p : stored)
    EXPECT_LT(norm(p), 2.);

  // beyond the largest number that is stored
  const Mesh huge = make(test_meshes::scaled(bumpy_sphere(2), 1e200, 1e200, 1e200));
  const Point_map narrow(huge, sentinels(num_vertices(huge)));
  narrow.stored() = in_single_precision;
  EXPECT_EQ(SP::parameterize(huge, narrow), SP::ERROR_INSUFFICIENT_PRECISION);
  EXPECT_EQ(arap().parameterize(huge, narrow), SP::ERROR_NO_1_TO_1_MAPPING);
}

// A method that promises nothing says what the map is as it has been stored.
TEST(Map_that_rounds, may_fold_where_nothing_is_promised)
{
  const Mesh mesh = make(bumpy_sphere(2));
  const Point_map map(mesh, sentinels(num_vertices(mesh)));
  map.stored() = in_single_precision;
  EXPECT_EQ(arap().parameterize(mesh, map), SP::OK);
  map.stored() = [](const Point_3& p) { return Point_3(std::round(p.x()), std::round(p.y()), std::round(p.z())); };
  EXPECT_EQ(arap().parameterize(mesh, map), SP::ERROR_NO_1_TO_1_MAPPING);
}

// A map of single precision is certified as converted before anything is written, and so it stays as it was.
TEST(Map_of_single_precision, is_untouched_if_it_would_fold)
{
  using Float_point_3 = CGAL::Simple_cartesian<float>::Point_3;
  const Mesh mesh = make(bumpy_sphere(2));
  const auto map = make_sentinel_map<Float_point_3>(mesh);
  ASSERT_EQ(SP::parameterize(mesh, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  EXPECT_LT(largest_distance(images(mesh, map), bijective().run(mesh).images), 1e-6);

  const Mesh fine = make(with_a_tiny_face());
  const auto single_map = make_sentinel_map<Float_point_3>(fine);
  const Images before = images(fine, single_map);
  EXPECT_EQ(SP::parameterize(fine, single_map), SP::ERROR_INSUFFICIENT_PRECISION);
  EXPECT_TRUE(have_same_bits(images(fine, single_map), before));
}

} // namespace
