// Spherical harmonics: their values against closed formulas, the transform, expansions of surfaces that are known, rotations and
// standard positions.

#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/expand_in_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Spherical_harmonic_transform.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Sphere_nodes.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/Harmonics/move_to_standard_position.h>
#include <CGAL/Spherical_parameterization/Harmonics/reconstruct_from_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Harmonics/rotate_spherical_harmonics.h>

#include "broken_maps.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

namespace {

using namespace test_meshes;
namespace SP = CGAL::Spherical_parameterization;
using SP::Harmonic_normalization;
using SP::Harmonic_weights;
using Harmonics = SP::Spherical_harmonics_3;
using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point_3>;
using Vertex_index = Surface::Vertex_index;
using Rotation = SP::Standard_position::Rotation;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Function>
void for_each_place(const Harmonics& harmonics, const Function& f)
{
  for(std::size_t k = 0; k < harmonics.number_of_functions(); ++k)
    for(std::size_t l = 0; l <= harmonics.degree(); ++l)
      for(std::ptrdiff_t m = -static_cast<std::ptrdiff_t>(l); m <= static_cast<std::ptrdiff_t>(l); ++m)
        f(k, l, m);
}

double largest_difference(const Harmonics& a, const Harmonics& b)
{
  double result = a.degree() == b.degree() && a.number_of_functions() == b.number_of_functions() ? 0. : infinity;
  if(result == 0.)
    for_each_place(a, [&](std::size_t k, std::size_t l, std::ptrdiff_t m) {
      result = (std::max)(result, std::abs(a.coefficient(k, l, m) - b.coefficient(k, l, m)));
    });
  return result;
}

// Of each degree l, the coefficients are up to 1 / (1 + l)^decay.
Harmonics random_harmonics(std::size_t degree, double decay, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Harmonics result(3, degree);
  for_each_place(result, [&](std::size_t k, std::size_t l, std::ptrdiff_t m) {
    result.set_coefficient(k, l, m, uniform(random) * std::pow(1. + static_cast<double>(l), -decay));
  });
  return result;
}

// The three functions x, y and z, times these factors.
Harmonics ellipsoid_of(double a, double b, double c, std::size_t degree)
{
  Harmonics result(3, degree);
  result.set_coefficient(0, 1, 1, a / std::sqrt(3.));
  result.set_coefficient(1, 1, -1, b / std::sqrt(3.));
  result.set_coefficient(2, 1, 0, c / std::sqrt(3.));
  return result;
}

Rotation rotation_about(double x, double y, double z, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle), d = 1. - c;
  return {d * x * x + c,     d * x * y - s * z, d * x * z + s * y, d * x * y + s * z, d * y * y + c,
          d * y * z - s * x, d * x * z - s * y, d * y * z + s * x, d * z * z + c};
}

std::vector<double> values_at(const Harmonics& harmonics, const std::vector<Point_3>& directions)
{
  std::vector<double> result;
  EXPECT_EQ(SP::evaluate_spherical_harmonics(harmonics, directions, result), SP::OK);
  return result;
}

// the value of a single harmonic
double value_of(std::size_t l, std::ptrdiff_t m, const Point_3& q)
{
  Harmonics harmonics(1, l);
  harmonics.set_coefficient(0, l, m, 1.);
  return values_at(harmonics, {q})[0];
}

const std::vector<Point_3>& some_directions()
{
  static const std::vector<Point_3> directions = {{0.48, -0.6, 0.64}, {-0.36, 0.48, -0.8}, {0.6, 0.8, 0.},
                                                  {0., 0., 1.},       {1e-9, 1e-9, -1.},   {1e-3, 0., 1.}};
  return directions;
}

TEST(Harmonics, are_those_of_the_books)
{
  for(const Point_3& p : some_directions())
  {
    const double r = std::sqrt(CGAL::to_double((p - CGAL::ORIGIN).squared_length())), x = p.x() / r, y = p.y() / r,
                 z = p.z() / r;
    EXPECT_NEAR(value_of(0, 0, p), 1., 1e-15);
    EXPECT_NEAR(value_of(1, -1, p), std::sqrt(3.) * y, 1e-15);
    EXPECT_NEAR(value_of(1, 0, p), std::sqrt(3.) * z, 1e-15);
    EXPECT_NEAR(value_of(1, 1, p), std::sqrt(3.) * x, 1e-15);
    EXPECT_NEAR(value_of(2, -2, p), std::sqrt(15.) * x * y, 1e-14);
    EXPECT_NEAR(value_of(2, 0, p), std::sqrt(5.) * 0.5 * (3. * z * z - 1.), 1e-14);
    EXPECT_NEAR(value_of(2, 1, p), std::sqrt(15.) * x * z, 1e-14);
    EXPECT_NEAR(value_of(2, 2, p), std::sqrt(15.) * 0.5 * (x * x - y * y), 1e-14);
    EXPECT_NEAR(value_of(3, -3, p), std::sqrt(35. / 8.) * (3. * x * x - y * y) * y, 1e-14);
    EXPECT_NEAR(value_of(3, 2, p), std::sqrt(105.) * 0.5 * (x * x - y * y) * z, 1e-14);
    // sectors: the normalization by logarithms of factorials
    for(const int l : {40, 200})
    {
      const double logarithm =
          0.5 * (std::log(2. * (2. * l + 1.)) + std::lgamma(2. * l + 1.)) - l * std::log(2.) - std::lgamma(l + 1.);
      const double expected =
          std::exp(logarithm + l * std::log((std::max)(std::hypot(x, y), 1e-300))) * std::cos(l * std::atan2(y, x));
      EXPECT_NEAR(value_of(static_cast<std::size_t>(l), l, p), expected, 1e-10) << l;
    }
  }
}

// Squares of all harmonics of a degree l have the sum 2 l + 1 everywhere. The adjoint of the transform has all of them in one go.
TEST(Harmonics, obey_the_addition_theorem_up_to_the_largest_degree)
{
  using namespace SP::internal;
  for(const std::size_t degree : {2u, 30u, 200u, 1000u})
  {
    const Spherical_harmonic_transform transform(degree);
    for(const Point_3& q : some_directions())
    {
      const Sphere_nodes node({direction_of(q)});
      std::vector<double> one(node.number_of_values(), 0.), values;
      one[node.place(0, 0, 0)] = 1.;
      transform.project(node, one, values, Execution());
      double sum = 0.;
      for(std::size_t m = 0; m <= degree; ++m)
        for(const bool is_sine : {false, true})
          sum += std::pow(values[transform.place(degree, m, is_sine)], 2);
      EXPECT_NEAR(sum / (2. * static_cast<double>(degree) + 1.), 1., 1e-10) << degree;
    }
  }
}

TEST(Harmonics, are_converted)
{
  const Harmonics harmonics = random_harmonics(6, 0., 3);
  const std::vector<double> spectrum = harmonics.power_spectrum(), values = values_at(harmonics, some_directions());
  const double sqrt_four_pi = std::sqrt(4. * CGAL_PI);
  for(const auto normalization :
      {Harmonic_normalization::four_pi, Harmonic_normalization::orthonormal, Harmonic_normalization::schmidt})
    for(const bool has_phase : {false, true})
    {
      Harmonics converted = harmonics;
      converted.convert(normalization, has_phase);
      const double factor = normalization == Harmonic_normalization::four_pi       ? 1.
                            : normalization == Harmonic_normalization::orthonormal ? sqrt_four_pi
                                                                                   : std::sqrt(11.);
      EXPECT_NEAR(converted.coefficient(1, 5, 3), (has_phase ? -1. : 1.) * factor * harmonics.coefficient(1, 5, 3),
                  1e-14);
      EXPECT_NEAR(converted.coefficient(1, 5, -2), factor * harmonics.coefficient(1, 5, -2), 1e-14);
      for(std::size_t l = 0; l <= 6; ++l)
        EXPECT_NEAR(converted.power_spectrum()[l], spectrum[l], 1e-14);
      const std::vector<double> same = values_at(converted, some_directions());
      for(std::size_t k = 0; k < values.size(); ++k)
        EXPECT_NEAR(same[k], values[k], 1e-13);
      converted.convert(Harmonic_normalization::four_pi, false);
      EXPECT_LT(largest_difference(converted, harmonics), 1e-14);
    }
}

TEST(Harmonics, of_a_degree_are_kept_or_left_out)
{
  Harmonics harmonics = random_harmonics(5, 0., 1);
  const Harmonics before = harmonics;
  harmonics.set_degree(3);
  EXPECT_EQ(harmonics.coefficient(2, 3, -3), before.coefficient(2, 3, -3));
  harmonics.set_degree(5);
  EXPECT_EQ(harmonics.coefficient(2, 3, 3), before.coefficient(2, 3, 3));
  EXPECT_EQ(harmonics.coefficient(2, 4, 0), 0.);
  EXPECT_EQ(Harmonics(1, 5000).degree(), Harmonics::max_degree);
}

TEST(Spherical_harmonic_transform, returns_what_values_at_nodes_were_made_of)
{
  using namespace SP::internal;
  for(const std::size_t degree : {0u, 1u, 2u, 3u, 30u, 200u})
  {
    const Spherical_harmonic_transform transform(degree);
    const Gauss_grid grid(degree);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    std::vector<double> coefficients(transform.number_of_coefficients(), 0.), values, weighed, result;
    for(std::size_t m = 0; m <= degree; ++m)
      for(std::size_t l = m; l <= degree; ++l)
        for(std::size_t k = 0; k < 3; ++k)
          for(const bool is_sine : {false, true})
            if(!is_sine || m > 0)
              coefficients[transform.place(l, m, is_sine) + k] = uniform(random);
    transform.evaluate(grid.nodes, coefficients, values, Execution());
    weighed.assign(values.size(), 0.);
    double sum = 0.;
    for(std::size_t j = 0; j < grid.nodes.number_of_parallels(); ++j)
      for(std::size_t i = 0; i < grid.nodes.width(); ++i)
      {
        sum += grid.weights[j];
        for(std::size_t k = 0; k < 3; ++k)
          weighed[grid.nodes.place(j, i, k)] = grid.weights[j] * values[grid.nodes.place(j, i, k)];
      }
    EXPECT_NEAR(sum, 1., 1e-13);
    transform.project(grid.nodes, weighed, result, Execution());
    double error = 0.;
    for(std::size_t k = 0; k < result.size(); ++k)
      error = (std::max)(error, std::abs(result[k] - coefficients[k]));
    EXPECT_LT(error, degree <= 30 ? 1e-13 : 1e-11) << degree;
  }
}

// What a surface is expanded into; the mesh is one of the sphere.
struct Expanded
{
  Expanded(const Triangle_list& list, const std::vector<Coordinates>& images, const SP::Harmonic_expansion_3& expansion)
  {
    const Surface mesh = make_mesh<Surface>(list);
    error = SP::expand_in_spherical_harmonics(mesh, make_vertex_map<Point_3>(mesh, images), expansion, harmonics);
  }

  Harmonics harmonics;
  SP::Error_code error;
};

const Harmonic_weights all_weights[] = {Harmonic_weights::surface, Harmonic_weights::sphere,
                                        Harmonic_weights::vertices};

// Faces are below the round ellipsoid, by 0.1 percent at most.
TEST(Expansion, of_an_ellipsoid_is_of_degree_1)
{
  const Triangle_list sphere = icosphere(4);
  for(const Harmonic_weights weights : all_weights)
  {
    const Expanded e(scaled(sphere, 3., 2., 1.), sphere.points, SP::Harmonic_expansion_3(10).weights(weights));
    ASSERT_EQ(e.error, SP::OK);
    const SP::Harmonic_fit& fit = e.harmonics.fit;
    EXPECT_EQ(fit.weights, weights);
    EXPECT_LT(fit.error_over_surface, 4e-3);
    EXPECT_LT(fit.error_at_vertices, 4e-3);
    EXPECT_LT(fit.aliasing, 2e-4);
    EXPECT_EQ(fit.degree_of_vertices, 49u); // of 2562 vertices
    const double error = largest_difference(e.harmonics, ellipsoid_of(3., 2., 1., 10));
    EXPECT_LT(error, weights == Harmonic_weights::vertices ? 1e-10 : 3e-3);
  }
}

// Of what is no sum of harmonics, the least error of each kind is that of its weights.
TEST(Expansion, has_the_least_error_for_its_weights)
{
  const Triangle_list surface = bumpy_sphere(4);
  const std::vector<Coordinates> images = icosphere(4).points;
  SP::Harmonic_fit fits[3];
  for(std::size_t k = 0; k < 3; ++k)
  {
    const Expanded e(surface, images, SP::Harmonic_expansion_3(5).weights(all_weights[k]));
    ASSERT_EQ(e.error, SP::OK);
    fits[k] = e.harmonics.fit;
    double sum = 0.;
    for(const double power : e.harmonics.power_spectrum())
      sum += power;
    EXPECT_GT(sum, 0.5);
  }
  EXPECT_LT(fits[0].error_over_surface, fits[1].error_over_surface);
  EXPECT_LT(fits[0].error_over_surface, fits[2].error_over_surface);
  EXPECT_LT(fits[2].error_at_vertices, fits[0].error_at_vertices);
  EXPECT_LT(fits[2].error_at_vertices, fits[1].error_at_vertices);
  EXPECT_GT(fits[0].number_of_iterations, 0u);
  EXPECT_EQ(fits[1].number_of_iterations, 0u);
}

// Neither the unit nor the place of a surface matters, as far as numbers reach.
TEST(Expansion, does_not_depend_on_the_unit)
{
  const Triangle_list surface = bumpy_sphere(2);
  const std::vector<Coordinates> images = icosphere(2).points;
  const Harmonics expected = Expanded(surface, images, 4).harmonics;
  for(const double unit : {0x1p-900, 0x1p900})
  {
    const Expanded e(scaled(surface, unit, unit, unit), images, 4);
    ASSERT_EQ(e.error, SP::OK);
    for_each_place(expected, [&](std::size_t k, std::size_t l, std::ptrdiff_t m) {
      EXPECT_DOUBLE_EQ(e.harmonics.coefficient(k, l, m) / unit, expected.coefficient(k, l, m));
    });
  }
}

TEST(Expansion, has_the_same_bits_with_any_number_of_threads)
{
  const Surface mesh = make_mesh<Surface>(bumpy_sphere(3));
  const auto images = make_vertex_map<Point_3>(mesh, icosphere(3).points);
  for(const Harmonic_weights weights : all_weights)
  {
    const SP::Harmonic_expansion_3 expansion = SP::Harmonic_expansion_3(20).weights(weights);
    Harmonics by_one, by_many;
    ASSERT_EQ(SP::expand_in_spherical_harmonics<CGAL::Sequential_tag>(mesh, images, expansion, by_one), SP::OK);
    ASSERT_EQ(SP::expand_in_spherical_harmonics<CGAL::Parallel_if_available_tag>(mesh, images, expansion, by_many),
              SP::OK);
    EXPECT_EQ(largest_difference(by_one, by_many), 0.);
    const Rotation r = rotation_about(0.48, -0.6, 0.64, 2.);
    ASSERT_EQ(SP::rotate_spherical_harmonics<CGAL::Sequential_tag>(by_one, r), SP::OK);
    ASSERT_EQ(SP::rotate_spherical_harmonics<CGAL::Parallel_if_available_tag>(by_many, r), SP::OK);
    EXPECT_EQ(largest_difference(by_one, by_many), 0.);
  }
}

TEST(Expansion, of_values_is_that_of_each)
{
  const Triangle_list sphere = icosphere(3);
  const Surface mesh = make_mesh<Surface>(sphere);
  const auto images = make_vertex_map<Point_3>(mesh, sphere.points);
  Harmonics result;
  const auto expand = [&](const auto& value_of_vertex) {
    return SP::expand_in_spherical_harmonics(
        mesh, images, boost::make_function_property_map<Vertex_index>(value_of_vertex), 6, result);
  };
  const auto infinite = [](Vertex_index v) { return std::size_t(v) == 7 ? infinity : 0.; };
  const auto unequal = [](Vertex_index v) { return std::vector<double>(std::size_t(v) == 7 ? 1 : 2, 0.); };
  EXPECT_EQ(expand(infinite), SP::ERROR_NON_FINITE_COORDINATE);
  EXPECT_EQ(expand(unequal), SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(result.degree(), Harmonics().degree()); // as it was

  Harmonics of_points;
  ASSERT_EQ(SP::expand_in_spherical_harmonics(mesh, images, 6, of_points), SP::OK);
  ASSERT_EQ(expand([&](Vertex_index v) { return mesh.point(v).y(); }), SP::OK);
  ASSERT_EQ(result.number_of_functions(), 1u);
  const Harmonics of_one = result;
  ASSERT_EQ(expand([&](Vertex_index v) {
              const Point_3& p = mesh.point(v);
              return std::array<double, 4>{{p.z(), p.x(), 5., p.y()}};
            }),
            SP::OK);
  ASSERT_EQ(result.number_of_functions(), 4u);
  const std::array<std::size_t, 3> places = {1, 3, 0}; // of x, y and z
  for_each_place(of_points, [&](std::size_t k, std::size_t l, std::ptrdiff_t m) {
    EXPECT_NEAR(result.coefficient(places[k], l, m), of_points.coefficient(k, l, m), 1e-5);
    EXPECT_NEAR(of_one.coefficient(0, l, m), of_points.coefficient(1, l, m), 1e-5);
    EXPECT_NEAR(result.coefficient(2, l, m), l == 0 ? 5. : 0., 1e-12);
  });
}

TEST(Expansion, tells_what_the_vertices_hold)
{
  const Triangle_list sphere = icosphere(1); // 42 vertices
  const auto expand = [&](int degree, Harmonic_weights weights) {
    return Expanded(sphere, sphere.points, SP::Harmonic_expansion_3(degree).weights(weights));
  };
  EXPECT_EQ(expand(5, Harmonic_weights::vertices).error, SP::OK);
  EXPECT_EQ(expand(6, Harmonic_weights::vertices).error, SP::ERROR_TOO_HIGH_DEGREE);
  const Expanded e = expand(60, Harmonic_weights::surface);
  EXPECT_EQ(e.error, SP::OK);
  EXPECT_EQ(e.harmonics.fit.degree_of_vertices, 5u);
  EXPECT_LT(e.harmonics.fit.error_over_surface, 1e-3); // edges are found by the degrees above
  for(const int degree : {-1, 1001})
    EXPECT_EQ(expand(degree, Harmonic_weights::sphere).error, SP::ERROR_WRONG_PARAMETER);
}

TEST(Expansion, refuses_what_is_no_map)
{
  for(const auto& [list, error] : test::broken_maps())
    EXPECT_EQ(Expanded(list, list.points, 3).error, error);
  const Triangle_list infinite = scaled(icosphere(1), 1., infinity, 1.);
  EXPECT_EQ(Expanded(infinite, icosphere(1).points, 3).error, SP::ERROR_NON_FINITE_COORDINATE);
}

TEST(Expansion, is_as_it_was_once_it_is_stopped)
{
  const Triangle_list sphere = icosphere(1);
  const Surface mesh = make_mesh<Surface>(sphere);
  Harmonics harmonics(1, 7);
  const auto at_once = CGAL::parameters::maximum_running_time(1e-9);
  EXPECT_EQ(
      SP::expand_in_spherical_harmonics(mesh, make_vertex_map<Point_3>(mesh, sphere.points), 3, harmonics, at_once),
      SP::ERROR_STOPPED);
  SP::Standard_position position;
  harmonics = ellipsoid_of(3., 2., 1., 7);
  EXPECT_EQ(SP::move_to_standard_position(harmonics, position, at_once), SP::ERROR_STOPPED);
  EXPECT_EQ(SP::rotate_spherical_harmonics(harmonics, rotation_about(0., 0., 1., 1.), at_once), SP::ERROR_STOPPED);
  std::vector<double> values = {7.};
  EXPECT_EQ(SP::evaluate_spherical_harmonics(harmonics, some_directions(), values, at_once), SP::ERROR_STOPPED);
  EXPECT_EQ(values, std::vector<double>{7.});
  EXPECT_EQ(largest_difference(harmonics, ellipsoid_of(3., 2., 1., 7)), 0.);
}

TEST(Reconstruction, has_the_points_of_the_functions)
{
  const Harmonics harmonics = ellipsoid_of(3., 2., 1., 4);
  const SP::Sphere_domain_3 domain = SP::Sphere_domain_3::octahedron(4);
  Surface mesh;
  auto images = mesh.add_property_map<Vertex_index, Point_3>("v:image").first;
  ASSERT_EQ(SP::reconstruct_from_spherical_harmonics(harmonics, domain, mesh, images), SP::OK);
  ASSERT_EQ(mesh.number_of_faces(), domain.triangles().size());
  for(const Vertex_index v : mesh.vertices())
  {
    const Point_3 &p = mesh.point(v), &q = images[v];
    EXPECT_LT(CGAL::squared_distance(p, Point_3(3. * q.x(), 2. * q.y(), q.z())), 1e-28);
  }
  EXPECT_EQ(SP::reconstruct_from_spherical_harmonics(Harmonics(2, 3), domain, mesh, images), SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(SP::reconstruct_from_spherical_harmonics(harmonics, SP::Sphere_domain_3(), mesh, images),
            SP::ERROR_INVALID_DOMAIN);
  EXPECT_EQ(mesh.number_of_faces(), domain.triangles().size());
  std::vector<double> values;
  for(const Point_3& q : {Point_3(0., 0., 0.), Point_3(0., infinity, 0.), Point_3(std::nan(""), 0., 1.)})
    EXPECT_EQ(SP::evaluate_spherical_harmonics(harmonics, std::vector<Point_3>{q}, values),
              SP::ERROR_INVALID_DIRECTION);
}

TEST(Rotation_of_harmonics, carries_values_along)
{
  for(const std::size_t degree : {0u, 1u, 5u, 60u})
  {
    Harmonics harmonics = random_harmonics(degree, 1., 5);
    harmonics.convert(Harmonic_normalization::schmidt, true);
    const Harmonics before = harmonics;
    const Rotation r = rotation_about(0.48, -0.6, 0.64, 2.);
    ASSERT_EQ(SP::rotate_spherical_harmonics(harmonics, r), SP::OK);
    std::vector<Point_3> turned;
    for(const Point_3& q : some_directions())
      turned.push_back(r.transform(q));
    const std::vector<double> values = values_at(harmonics, turned), expected = values_at(before, some_directions());
    for(std::size_t k = 0; k < values.size(); ++k)
      EXPECT_NEAR(values[k], expected[k], 1e-10);
    for(std::size_t l = 0; l <= degree; ++l)
      EXPECT_NEAR(harmonics.power_spectrum()[l], before.power_spectrum()[l], 1e-12);
    ASSERT_EQ(SP::rotate_spherical_harmonics(harmonics, r.inverse()), SP::OK);
    EXPECT_LT(largest_difference(harmonics, before), 1e-11);
  }
  Harmonics harmonics = random_harmonics(3, 1., 5);
  for(const Rotation& r :
      {Rotation(1., 0., 0., 0., 1., 0., 0., 0., -1.), Rotation(2., 0., 0., 0., 2., 0., 0., 0., 2.),
       Rotation(1., 0.1, 0., 0., 1., 0., 0., 0., 1.), Rotation(std::nan(""), 0., 0., 0., 1., 0., 0., 0., 1.)})
    EXPECT_EQ(SP::rotate_spherical_harmonics(harmonics, r), SP::ERROR_WRONG_PARAMETER);
}

// A surface that is moved, and whose map is turned, comes to the same position, and to the one that is reported.
TEST(Position, does_not_depend_on_where_the_surface_was)
{
  Harmonics surface = random_harmonics(8, 4., 11);
  const Harmonics ellipsoid = ellipsoid_of(3., 2., 1., 8);
  for_each_place(surface, [&](std::size_t k, std::size_t l, std::ptrdiff_t m) {
    surface.set_coefficient(k, l, m, 5. * surface.coefficient(k, l, m) + ellipsoid.coefficient(k, l, m));
  });
  Harmonics expected = surface;
  SP::Standard_position position;
  ASSERT_EQ(SP::move_to_standard_position(expected, position), SP::OK);
  ASSERT_TRUE(position.axes_are_determined);
  ASSERT_TRUE(position.signs_are_determined);
  for(std::uint32_t seed = 0; seed < 10; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-4., 4.);
    const Rotation r = rotation_about(0.48, -0.6, 0.64, uniform(random)),
                   of_sphere = rotation_about(0., 0.6, -0.8, uniform(random));
    Harmonics moved = surface;
    for(std::size_t l = 0; l <= 8; ++l)
      for(std::ptrdiff_t m = -static_cast<std::ptrdiff_t>(l); m <= static_cast<std::ptrdiff_t>(l); ++m)
      {
        const Point_3 p = r.transform(
            Point_3(surface.coefficient(0, l, m), surface.coefficient(1, l, m), surface.coefficient(2, l, m)));
        for(std::size_t k = 0; k < 3; ++k)
          moved.set_coefficient(k, l, m, p[static_cast<int>(k)] + (l == 0 ? 7. : 0.));
      }
    moved.convert(Harmonic_normalization::orthonormal, true);
    ASSERT_EQ(SP::rotate_spherical_harmonics(moved, of_sphere), SP::OK);
    const Harmonics before = moved;
    ASSERT_EQ(SP::move_to_standard_position(moved, position), SP::OK);

    const Point_3 q = some_directions()[0], image = position.rotation_of_sphere.transform(q);
    const std::vector<double> p = values_at(before, {q}), at_image = values_at(moved, {image});
    const Point_3 expected_point = position.rotation_of_surface.transform(
        Point_3(p[0] - position.center[0], p[1] - position.center[1], p[2] - position.center[2]));
    for(std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(at_image[k], expected_point[static_cast<int>(k)], 1e-12);
    moved.convert(Harmonic_normalization::four_pi, false);
    EXPECT_LT(largest_difference(moved, expected), 1e-11);
  }
  EXPECT_GT(position.semi_axes[0], position.semi_axes[1]);
  EXPECT_GT(position.semi_axes[1], position.semi_axes[2]);
  EXPECT_GT(position.skewness[0], 0.01);
}

TEST(Position, tells_of_symmetries)
{
  struct Case
  {
    Harmonics surface;
    std::array<double, 3> semi_axes;
    bool axes_are_determined;
  };
  for(Case c :
      {Case{ellipsoid_of(1., 3., 2., 2), {3., 2., 1.}, true}, Case{ellipsoid_of(1., 1., 1., 1), {1., 1., 1.}, false},
       Case{ellipsoid_of(3., 1., 1., 1), {3., 1., 1.}, false}, Case{ellipsoid_of(3., 3., 1., 1), {3., 3., 1.}, false},
       Case{ellipsoid_of(3., 2., 0., 1), {3., 2., 0.}, true},
       Case{ellipsoid_of(3., 2., -1., 1), {3., 2., -1.}, true}}) // inside out
  {
    SP::Standard_position position;
    EXPECT_EQ(SP::move_to_standard_position(c.surface, position), SP::OK);
    EXPECT_EQ(position.axes_are_determined, c.axes_are_determined);
    EXPECT_FALSE(position.signs_are_determined);
    for(std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(position.semi_axes[k], c.semi_axes[k], 1e-14);
  }
}

TEST(Position, refuses_what_has_none)
{
  SP::Standard_position position;
  const auto expect = [&](Harmonics harmonics, SP::Error_code error) {
    EXPECT_EQ(SP::move_to_standard_position(harmonics, position), error);
  };
  expect(ellipsoid_of(3., 0., 0., 1), SP::ERROR_UNDETERMINED_ROTATION);
  expect(ellipsoid_of(0., 0., 0., 3), SP::ERROR_UNDETERMINED_ROTATION);
  expect(ellipsoid_of(3., 2., std::nan(""), 3), SP::ERROR_NON_FINITE_COORDINATE);
  expect(Harmonics(3, 0), SP::ERROR_WRONG_PARAMETER);
  expect(Harmonics(2, 4), SP::ERROR_WRONG_PARAMETER);
  for(const double unit : {1e-290, 1e290})
    expect(ellipsoid_of(3. * unit, 2. * unit, unit, 3), SP::OK);
}

} // namespace
