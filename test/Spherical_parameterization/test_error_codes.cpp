// Each error code for what it is meant for, through the public functions; and that nothing is written then.

#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/internal/Solver_traits.h>

#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using test_meshes::Coordinates;
using test_meshes::Triangle_list;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex_index = Mesh::Vertex_index;
using Vertex_map = decltype(test_maps::make_sentinel_map<Point_3>(std::declval<const Mesh&>()));

Mesh make_mesh(const Triangle_list& list)
{
  return test_meshes::make_mesh<Mesh>(list);
}

// Runs the parameterizer and expects this error and an untouched map.
template <class Parameterizer>
void expect_error(const Mesh& mesh, Parameterizer& parameterizer, SP::Error_code error)
{
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
  const std::vector<Coordinates> before = test_maps::images(mesh, map);
  EXPECT_EQ(SP::parameterize(mesh, parameterizer, map), error);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, map), before));
  EXPECT_EQ(parameterizer.report().number_of_iterations(), 0u);
}

// The same with every method.
void expect_error(const Mesh& mesh, SP::Error_code error)
{
  const auto expect_error_of = [&](auto&& parameterizer) {
    expect_error(mesh, parameterizer, error);
    EXPECT_EQ(parameterizer.report().stop_reason, SP::NOT_RUN);
  };
  expect_error_of(SP::Bijective_low_distortion_parameterizer_3<Mesh>());
  expect_error_of(SP::Hierarchical_parameterizer_3<Mesh>());
  expect_error_of(SP::Stereographic_parameterizer_3<Mesh>());
  expect_error_of(SP::Harmonic_parameterizer_3<Mesh>());
  expect_error_of(SP::Conformal_parameterizer_3<Mesh>());
  expect_error_of(SP::ARAP_parameterizer_3<Mesh>());
  expect_error_of(SP::Published_low_distortion_parameterizer_3<Mesh>());
  const auto start = test_maps::make_sentinel_map<Point_3>(mesh);
  SP::Precomputed_parameterizer_3<Mesh, Vertex_map> precomputed(start);
  expect_error(mesh, precomputed, error);

  const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
  EXPECT_EQ(SP::parameterize(mesh, map), error);
  EXPECT_EQ(SP::find_defect(mesh).error, error);
}

TEST(Error_message, is_a_different_sentence_for_each_code)
{
  std::set<std::string> messages;
  for(int code = SP::OK; code <= SP::ERROR_WRONG_PARAMETER; ++code)
  {
    const char* message = SP::get_error_message(static_cast<SP::Error_code>(code));
    ASSERT_NE(message, nullptr);
    EXPECT_GT(std::string(message).size(), 20u);
    EXPECT_TRUE(messages.insert(message).second) << message;
  }
  EXPECT_TRUE(
      messages.insert(SP::get_error_message(static_cast<SP::Error_code>(SP::ERROR_WRONG_PARAMETER + 1))).second);
  std::set<std::string> reasons;
  for(int reason = SP::NOT_RUN; reason <= SP::STOPPED; ++reason)
  {
    EXPECT_TRUE(reasons.insert(SP::get_stop_message(static_cast<SP::Stop_reason>(reason))).second);
  }
}

TEST(Error_code, empty_mesh)
{
  expect_error(Mesh(), SP::ERROR_EMPTY_MESH);
  Mesh points;
  points.add_vertex(Point_3(1., 2., 3.));
  points.add_vertex(Point_3(3., 2., 1.));
  expect_error(points, SP::ERROR_EMPTY_MESH);
}

TEST(Error_code, too_few_vertices)
{
  Mesh pillow; // two triangles, back to back
  const Vertex_index a = pillow.add_vertex(Point_3(0., 0., 0.)), b = pillow.add_vertex(Point_3(1., 0., 0.)),
                     c = pillow.add_vertex(Point_3(0., 1., 0.));
  pillow.add_face(a, b, c);
  pillow.add_face(a, c, b);
  ASSERT_TRUE(CGAL::is_closed(pillow));
  expect_error(pillow, SP::ERROR_TOO_FEW_VERTICES);
  pillow.add_vertex(Point_3(0., 0., 1.)); // an isolated vertex does not count
  expect_error(pillow, SP::ERROR_TOO_FEW_VERTICES);
}

TEST(Error_code, non_triangular_mesh)
{
  Mesh cube;
  CGAL::make_hexahedron(Point_3(-1, -1, -1), Point_3(1, -1, -1), Point_3(1, 1, -1), Point_3(-1, 1, -1),
                        Point_3(-1, 1, 1), Point_3(-1, -1, 1), Point_3(1, -1, 1), Point_3(1, 1, 1), cube);
  expect_error(cube, SP::ERROR_NON_TRIANGULAR_MESH);

  Mesh one_quadrangle = make_mesh(test_meshes::icosphere(1));
  CGAL::Euler::join_face(*one_quadrangle.halfedges().begin(), one_quadrangle);
  expect_error(one_quadrangle, SP::ERROR_NON_TRIANGULAR_MESH);
}

TEST(Error_code, non_closed_mesh)
{
  Triangle_list list = test_meshes::icosphere(1);
  list.triangles.erase(list.triangles.begin() + 30);
  expect_error(make_mesh(list), SP::ERROR_NON_CLOSED_MESH);
  list.points.resize(3);
  list.triangles = {{0, 1, 2}};
  expect_error(make_mesh(list), SP::ERROR_NON_CLOSED_MESH);
}

TEST(Error_code, several_components)
{
  const Triangle_list sphere = test_meshes::icosphere(1), torus = test_meshes::torus(7, 5);
  expect_error(make_mesh(test_meshes::disjoint_union(sphere, sphere)), SP::ERROR_SEVERAL_COMPONENTS);
  // together they have the Euler number of a sphere
  expect_error(make_mesh(test_meshes::disjoint_union(sphere, torus)), SP::ERROR_SEVERAL_COMPONENTS);
  expect_error(make_mesh(test_meshes::disjoint_union(torus, sphere)), SP::ERROR_SEVERAL_COMPONENTS);
}

TEST(Error_code, no_topological_sphere)
{
  expect_error(make_mesh(test_meshes::torus(7, 5)), SP::ERROR_NO_TOPOLOGICAL_SPHERE);
}

TEST(Error_code, no_simplicial_complex_by_a_double_edge)
{
  // A double pyramid over a quadrangle becomes one over a triangle, two corners of which get a second edge instead of the
  // edge between a tip and the third corner.
  Mesh mesh = make_mesh(test_meshes::suspension(4));
  const Vertex_index corner =
      CGAL::Euler::collapse_edge(edge(mesh.halfedge(Vertex_index(0), Vertex_index(1)), mesh), mesh);
  CGAL::Euler::flip_edge(mesh.halfedge(corner, Vertex_index(4)), mesh);
  ASSERT_EQ(mesh.number_of_vertices(), 5u);
  ASSERT_EQ(mesh.number_of_faces(), 6u);
  ASSERT_TRUE(CGAL::is_closed(mesh) && CGAL::is_triangle_mesh(mesh) && mesh.is_valid());
  expect_error(mesh, SP::ERROR_NO_SIMPLICIAL_COMPLEX);

  // the same in a larger mesh: the corners of a face that another vertex has been put into
  Triangle_list list = test_meshes::icosphere(1);
  const test_meshes::Triangle t = list.triangles[17];
  const std::size_t v = list.points.size();
  list.points.push_back({0., 0., 2.});
  list.triangles[17] = {t[0], t[1], v};
  list.triangles.push_back({t[1], t[2], v});
  list.triangles.push_back({t[2], t[0], v});
  Mesh large = make_mesh(list);
  EXPECT_EQ(SP::parameterize(large, test_maps::make_sentinel_map<Point_3>(large)), SP::OK);
  const auto index = [](std::size_t i) { return Vertex_index(static_cast<Mesh::size_type>(i)); };
  CGAL::Euler::flip_edge(large.halfedge(index(t[0]), index(v)), large);
  ASSERT_TRUE(CGAL::is_closed(large) && CGAL::is_triangle_mesh(large) && large.is_valid());
  expect_error(large, SP::ERROR_NO_SIMPLICIAL_COMPLEX);
}

TEST(Error_code, no_simplicial_complex_by_two_fans_at_one_vertex)
{
  const Triangle_list sphere = test_meshes::icosphere(1);
  Mesh mesh = make_mesh(test_meshes::disjoint_union(sphere, sphere));
  const Vertex_index other(static_cast<Mesh::size_type>(sphere.points.size()));
  for(const auto h : CGAL::halfedges_around_target(mesh.halfedge(other), mesh))
  {
    mesh.set_target(h, Vertex_index(0));
  }
  mesh.remove_vertex(other);
  expect_error(mesh, SP::ERROR_NO_SIMPLICIAL_COMPLEX);
}

TEST(Error_code, non_finite_coordinate)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for(const double x : {infinity, -infinity, std::nan("")})
  {
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      Triangle_list list = test_meshes::icosphere(1);
      list.points[7 * axis][axis] = x;
      expect_error(make_mesh(list), SP::ERROR_NON_FINITE_COORDINATE);
    }
    // an isolated vertex may be anywhere
    Triangle_list list = test_meshes::icosphere(1);
    list.points.push_back({x, x, x});
    const Mesh mesh = make_mesh(list);
    EXPECT_EQ(SP::parameterize(mesh, test_maps::make_sentinel_map<Point_3>(mesh)), SP::OK);
  }
}

TEST(Error_code, invalid_initial_parameterization)
{
  const Triangle_list list = test_meshes::bumpy_sphere(1);
  const Mesh mesh = make_mesh(list);
  const std::vector<Coordinates> sphere = test_meshes::icosphere(1).points;
  using Start = SP::Precomputed_parameterizer_3<Mesh, Vertex_map>;
  using Bld = SP::Bijective_low_distortion_parameterizer_3<Mesh, Start>;
  const auto expect = [&](const std::vector<Coordinates>& points, SP::Error_code error) {
    const Vertex_map start = test_meshes::make_vertex_map<Point_3>(mesh, points);
    Start alone(start);
    Bld bld(alone);
    if(error != SP::OK)
    {
      expect_error(mesh, alone, error);
      EXPECT_EQ(alone.report().stop_reason, SP::NOT_RUN);
      expect_error(mesh, bld, error);
    }
    else
    {
      const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
      EXPECT_EQ(SP::parameterize(mesh, alone, map), SP::OK);
      EXPECT_EQ(alone.report().stop_reason, SP::CONVERGED);
      EXPECT_TRUE(SP::is_bijective(mesh, map));
      EXPECT_EQ(SP::parameterize(mesh, bld, map), SP::OK);
      EXPECT_TRUE(SP::is_bijective(mesh, map));
    }
  };
  expect(sphere, SP::OK);
  std::vector<Coordinates> points = sphere;
  std::swap(points[3], points[20]);
  expect(points, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  expect(test_meshes::scaled(test_meshes::icosphere(1), -1., 1., 1.).points,
         SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  points = sphere;
  points[5] = {0., 0., 0.};
  expect(points, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  points[5] = {std::nan(""), 0., 0.};
  expect(points, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  points[5] = {std::numeric_limits<double>::infinity(), 0., 0.};
  expect(points, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  expect(test_meshes::scaled(test_meshes::icosphere(1), 1e200, 1e200, 1e200).points, SP::OK);
  expect(test_meshes::scaled(test_meshes::icosphere(1), 1e-300, 1e-300, 1e-300).points, SP::OK);

  // all faces positive, but the sphere is covered twice
  const Mesh pyramid = make_mesh(test_meshes::suspension(7));
  const Vertex_map twice = test_meshes::make_vertex_map<Point_3>(pyramid, test_meshes::suspension(7, 2).points);
  Start start(twice);
  Bld bld(start);
  expect_error(pyramid, start, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  expect_error(pyramid, bld, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
}

// A face that is positive by less than the sweeps can compute: a bijection, but nothing to start from.
TEST(Error_code, initial_map_that_is_one_to_one_only_just_so)
{
  const Triangle_list list = test_meshes::icosphere(0);
  const Mesh mesh = make_mesh(list);
  const test_meshes::Triangle t = list.triangles[0]; // its first corner goes to the middle of the opposite edge
  const Coordinates &a = list.points[t[1]], &b = list.points[t[2]];
  const Coordinates middle = test_meshes::normalized({a[0] + b[0], a[1] + b[1], a[2] + b[2]});
  const Coordinates apex = list.points[t[0]];
  std::size_t number_of_maps = 0;
  for(int k = -8; k < 24; ++k)
  {
    const double s = k * std::numeric_limits<double>::epsilon() / 2.;
    std::vector<Coordinates> points = list.points;
    points[t[0]] = {middle[0] + s * apex[0], middle[1] + s * apex[1], middle[2] + s * apex[2]};
    SP::Precomputed_parameterizer_3<Mesh, Vertex_map> start(test_meshes::make_vertex_map<Point_3>(mesh, points));
    const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
    if(SP::parameterize(mesh, start, map) != SP::OK)
      continue;
    ++number_of_maps;
    EXPECT_TRUE(SP::is_bijective(mesh, map));
    SP::Bijective_low_distortion_parameterizer_3<Mesh, SP::Precomputed_parameterizer_3<Mesh, Vertex_map>> bld(start);
    expect_error(mesh, bld, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  }
  EXPECT_GT(number_of_maps, 0u);
}

TEST(Error_code, negative_number_of_iterations)
{
  const Mesh mesh = make_mesh(test_meshes::icosphere(0));
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
  EXPECT_EQ(SP::parameterize(mesh, map, CGAL::parameters::number_of_iterations(-1)), SP::ERROR_WRONG_PARAMETER);
}

// Whatever a radius policy returns, the map is sound.
struct Mad_radius
{
  double initial_radius(double) const { return std::nan(""); }
  template <class Energy, class FaceRange>
  double operator()(const Energy&, const FaceRange&, double)
  {
    ++calls;
    return calls % 3 == 0 ? std::nan("") : calls % 3 == 1 ? -1. : std::numeric_limits<double>::infinity();
  }
  int calls = 0;
};

TEST(Error_code, radius_policy_may_return_anything)
{
  const Mesh mesh = make_mesh(test_meshes::icosphere(1));
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
  SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, CGAL::Default, CGAL::Default, Mad_radius> bld;
  EXPECT_EQ(SP::parameterize(mesh, bld, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  EXPECT_NEAR(bld.report().radius, 1., 0.2);
}

TEST(Error_code, insufficient_precision)
{
  // On a sphere of the radius of the smallest positive double, there are not enough points.
  const Mesh mesh = make_mesh(test_meshes::icosphere(1));
  SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, CGAL::Default, CGAL::Default, SP::Fixed_radius_3>
      bld(SP::Symmetric_Dirichlet_energy_3(), SP::Relative_sharpness_3(), SP::Fixed_radius_3(5e-324));
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
  const std::vector<Coordinates> before = test_maps::images(mesh, map);
  EXPECT_EQ(SP::parameterize(mesh, bld, map), SP::ERROR_INSUFFICIENT_PRECISION);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, map), before));
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
  const Mesh mesh = make_mesh(test_meshes::bumpy_sphere(1));
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
  const std::vector<Coordinates> untouched = test_maps::images(mesh, map);
  // Wherever the solver fails, the run ends, and nothing has been written.
  const auto expect_error_anywhere = [&](auto&& parameterizer, int least_number_of_calls) {
    Failing_solver::fails_at = Failing_solver::number_of_calls = 0;
    ASSERT_EQ(SP::parameterize(mesh, parameterizer, test_maps::make_sentinel_map<Point_3>(mesh)), SP::OK);
    const int n_calls = Failing_solver::number_of_calls;
    EXPECT_GE(n_calls, least_number_of_calls);
    for(Failing_solver::fails_at = 1; Failing_solver::fails_at <= n_calls; ++Failing_solver::fails_at)
    {
      Failing_solver::number_of_calls = 0;
      EXPECT_EQ(SP::parameterize(mesh, parameterizer, map), SP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
      EXPECT_EQ(Failing_solver::number_of_calls, Failing_solver::fails_at);
    }
    EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, map), untouched));
  };
  using Default = CGAL::Default;
  expect_error_anywhere(SP::Stereographic_parameterizer_3<Mesh, Failing_solver>(), 3);
  expect_error_anywhere(SP::Harmonic_parameterizer_3<Mesh, Failing_solver>(), 10);
  expect_error_anywhere(SP::Conformal_parameterizer_3<Mesh, Failing_solver>(), 10);
  expect_error_anywhere(SP::ARAP_parameterizer_3<Mesh, Default, Failing_solver>(), 10);
  // the code of the initial parameterizer is passed on
  using Harmonic = SP::Harmonic_parameterizer_3<Mesh, Failing_solver>;
  expect_error_anywhere(SP::Published_low_distortion_parameterizer_3<Mesh, Harmonic>(), 10);
}

template <class Energy, class Sharpness, class Radius, class Update>
void expect_wrong_parameter(const Energy& energy, const Sharpness& sharpness, const Radius& radius,
                            const Update& update)
{
  SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, Energy, Sharpness, Radius, Update> bld(
      energy, sharpness, radius, update);
  EXPECT_FALSE(bld.is_valid());
  expect_error(make_mesh(test_meshes::icosphere(0)), bld, SP::ERROR_WRONG_PARAMETER);
}

TEST(Error_code, wrong_parameter)
{
  const SP::Isometric_energy_3 energy;
  const SP::Absolute_sharpness_3 sharpness;
  const SP::Fixed_radius_3 radius;
  const SP::Newton_update_3 update;
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for(const double alpha : {0., -0.5, 2., infinity, nan})
  {
    expect_wrong_parameter(SP::Isometric_energy_3(alpha), sharpness, radius, update);
  }
  expect_wrong_parameter(energy, SP::Absolute_sharpness_3(10., 0.1), radius, update);
  for(const double s : {0., -1., infinity, nan})
  {
    expect_wrong_parameter(energy, SP::Absolute_sharpness_3(s, 10.), radius, update);
    expect_wrong_parameter(energy, SP::Absolute_sharpness_3(0.1, s), radius, update);
  }
  for(const double r : {0., -1., infinity, nan})
  {
    expect_wrong_parameter(energy, sharpness, SP::Fixed_radius_3(r), update);
  }
  for(const double factor : {0.5, 2., -1.9, infinity, nan})
  {
    expect_wrong_parameter(energy, sharpness, radius, SP::Newton_update_3(factor));
  }
}

TEST(Error_code, wrong_parameter_of_the_other_policies)
{
  const Mesh mesh = make_mesh(test_meshes::icosphere(0));
  for(const double beta : {-1., -1e-9, std::numeric_limits<double>::infinity(), std::nan("")})
  {
    SP::Bijective_low_distortion_parameterizer_3<Mesh> bld(SP::Symmetric_Dirichlet_energy_3(),
                                                           SP::Relative_sharpness_3{beta});
    EXPECT_FALSE(bld.is_valid());
    expect_error(mesh, bld, SP::ERROR_WRONG_PARAMETER);
    SP::Hierarchical_parameterizer_3<Mesh> hierarchical(SP::Isometric_energy_3(), SP::Relative_sharpness_3{beta});
    expect_error(mesh, hierarchical, SP::ERROR_WRONG_PARAMETER);
  }
  // parameters of the initial parameterizer
  using Hierarchical = SP::Hierarchical_parameterizer_3<Mesh>;
  Hierarchical hierarchical(SP::Isometric_energy_3(), SP::Relative_sharpness_3(), SP::Newton_update_3(), 0);
  EXPECT_FALSE(hierarchical.is_valid());
  expect_error(mesh, hierarchical, SP::ERROR_WRONG_PARAMETER);
  SP::Bijective_low_distortion_parameterizer_3<Mesh, Hierarchical> from_hierarchical(hierarchical);
  expect_error(mesh, from_hierarchical, SP::ERROR_WRONG_PARAMETER);
  // a part of a policy, and its own parameter
  using Radius = SP::Two_phase_radius_3<SP::Fixed_radius_3, SP::Area_balancing_radius_3>;
  for(const Radius& radius : {Radius(SP::Fixed_radius_3(-1.)), Radius(SP::Fixed_radius_3(1.), {}, -1e-3)})
  {
    EXPECT_FALSE(radius.is_valid());
  }
  // tolerances
  SP::Bijective_low_distortion_parameterizer_3<Mesh> bld;
  EXPECT_TRUE(bld.is_valid());
  for(const double tolerance : {-1., std::nan("")})
  {
    bld.set_tolerances(tolerance, 1e-3);
    expect_error(mesh, bld, SP::ERROR_WRONG_PARAMETER);
    bld.set_tolerances(1e-5, tolerance);
    expect_error(mesh, bld, SP::ERROR_WRONG_PARAMETER);
  }
  bld.set_tolerances(0., 0.);
  EXPECT_TRUE(bld.is_valid());
}

// After a refusal the same object works on another mesh, and the report is that of the last run.
TEST(Error_code, does_not_stick)
{
  const Mesh torus = make_mesh(test_meshes::torus(7, 5)), sphere = make_mesh(test_meshes::icosphere(1));
  SP::Bijective_low_distortion_parameterizer_3<Mesh> bld;
  const auto map = test_maps::make_sentinel_map<Point_3>(sphere);
  EXPECT_EQ(SP::parameterize(sphere, bld, map), SP::OK);
  EXPECT_GT(bld.report().number_of_iterations(), 0u);
  expect_error(torus, bld, SP::ERROR_NO_TOPOLOGICAL_SPHERE);
  EXPECT_EQ(SP::parameterize(sphere, bld, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(sphere, map));
  EXPECT_EQ(bld.report().number_of_vertices, num_vertices(sphere));
  bld.set_tolerances(-1., 1e-3);
  expect_error(sphere, bld, SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(bld.report().stop_reason, SP::NOT_RUN);
}

// What is wrong is found before any work is done: the visitor is not called.
struct Failing_visitor : SP::Default_visitor
{
  void on_initialization_begin(std::size_t) { ADD_FAILURE(); }
  void on_level(std::size_t) { ADD_FAILURE(); }
  bool go_further(std::size_t, double)
  {
    ADD_FAILURE();
    return true;
  }
};

TEST(Error_code, is_found_before_any_work)
{
  for(const Triangle_list& list :
      {test_meshes::torus(7, 5), test_meshes::disjoint_union(test_meshes::icosphere(0), test_meshes::icosphere(0)),
       test_meshes::scaled(test_meshes::icosphere(1), 1., std::nan(""), 1.), Triangle_list()})
  {
    const Mesh mesh = make_mesh(list);
    const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
    const auto np = CGAL::parameters::visitor(Failing_visitor());
    EXPECT_NE(SP::parameterize(mesh, map, np), SP::OK);
    EXPECT_NE(SP::Stereographic_parameterizer_3<Mesh>().parameterize(mesh, map, np), SP::OK);
    EXPECT_NE(SP::Harmonic_parameterizer_3<Mesh>().parameterize(mesh, map, np), SP::OK);
    EXPECT_NE(SP::Conformal_parameterizer_3<Mesh>().parameterize(mesh, map, np), SP::OK);
    EXPECT_NE(SP::ARAP_parameterizer_3<Mesh>().parameterize(mesh, map, np), SP::OK);
  }
}

} // namespace
