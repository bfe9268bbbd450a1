// What the harmonic maps are made of: areas of images and their derivatives, cotangent weights, the linear system,
// Moebius transformations, the harmonic energy and its minimisation, and the way through the plane.

#include <CGAL/Spherical_parameterization/Default_visitor.h>
#include <CGAL/Spherical_parameterization/internal/Dirichlet_energy.h>
#include <CGAL/Spherical_parameterization/internal/Image_area.h>
#include <CGAL/Spherical_parameterization/internal/Laplacian_system.h>
#include <CGAL/Spherical_parameterization/internal/Moebius_transformation.h>
#include <CGAL/Spherical_parameterization/internal/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/Solver_traits.h>
#include <CGAL/Spherical_parameterization/internal/Spherical_harmonic_map.h>
#include <CGAL/Spherical_parameterization/internal/Stereographic_embedding.h>
#include <CGAL/Spherical_parameterization/internal/Tangent_frame.h>
#include <CGAL/Spherical_parameterization/internal/center_mass.h>
#include <CGAL/Spherical_parameterization/internal/central_vertex.h>
#include <CGAL/Spherical_parameterization/internal/cotangent_weights.h>
#include <CGAL/Spherical_parameterization/internal/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/vertex_areas.h>

#include "test_indexed_meshes.h"
#include "test_meshes.h"

#include <CGAL/Default.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using SP::internal::center_mass;
using SP::internal::center_of_mass;
using SP::internal::cotangent_weights;
using SP::internal::cross;
using SP::internal::Dirichlet_energy;
using SP::internal::dot;
using SP::internal::Image_area;
using SP::internal::Indexed_mesh;
using SP::internal::Laplacian_system;
using SP::internal::least_positive_weight;
using SP::internal::length;
using SP::internal::Moebius_transformation;
using SP::internal::normalized;
using SP::internal::Spherical_harmonic_map;
using SP::internal::squared_length;
using SP::internal::Stereographic_embedding;
using SP::internal::Tangent_frame;
using SP::internal::Vector_3d;
using SP::internal::vertex_masses;
using SP::internal::Vertex_rings;
using SP::internal::operator+;
using SP::internal::operator-;
using SP::internal::operator*;
using test_indexed_meshes::indexed_mesh;
using test_meshes::Triangle_list;

using Solver_traits = SP::internal::Solver_traits<CGAL::Default>::type;

constexpr double pi = test_meshes::pi;
constexpr double any_weight = std::numeric_limits<double>::lowest();

double uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * static_cast<double>(random()) / 0x1p32;
}

Vector_3d random_direction(std::mt19937& random)
{
  for(;;)
  {
    const Vector_3d p = {uniform(random, -1., 1.), uniform(random, -1., 1.), uniform(random, -1., 1.)};
    if(squared_length(p) < 1. && squared_length(p) > 0.01)
    {
      return normalized(p);
    }
  }
}

double largest_length(const std::vector<Vector_3d>& vectors)
{
  double result = 0.;
  for(const Vector_3d& p : vectors)
  {
    result = (std::max)(result, length(p));
  }
  return result;
}

// Areas of images

template <class Barrier>
class Image_area_test : public ::testing::Test
{};

using Barriers = ::testing::Types<SP::Determinant_barrier_3, SP::Flat_area_barrier_3>;
TYPED_TEST_SUITE(Image_area_test, Barriers, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Image_area_test, has_the_derivatives_of_its_value)
{
  std::mt19937 random(1);
  for(int k = 0; k < 200; ++k)
  {
    const double size = k % 2 == 0 ? 0.5 : 1e-2;
    const auto offset = [&](double angle) {
      const double x = size * std::cos(angle), y = size * std::sin(angle);
      return Vector_3d{x, y, Tangent_frame::height_at(x, y)};
    };
    const double angle = uniform(random, 0., 2. * pi);
    const Vector_3d p = offset(angle), q = offset(angle + uniform(random, 0.5, 2.));
    const Image_area<TypeParam> area(p, q);
    const auto value_at = [&](double x, double y) {
      const Vector_3d u = {x, y, Tangent_frame::height_at(x, y)}, n = cross(p - u, q - u);
      return Image_area<TypeParam>::value(dot(u + Vector_3d{0., 0., 1.}, n), n);
    };
    const double h = 1e-4 * size, h2 = h * h, unit = size * size;
    const double f = value_at(0., 0.);
    EXPECT_NEAR(area.value(), f, 1e-14 * unit);
    EXPECT_NEAR(area.dx(), (value_at(h, 0.) - value_at(-h, 0.)) / (2. * h), 1e-6 * size);
    EXPECT_NEAR(area.dy(), (value_at(0., h) - value_at(0., -h)) / (2. * h), 1e-6 * size);
    EXPECT_NEAR(area.dxx(), (value_at(h, 0.) - 2. * f + value_at(-h, 0.)) / h2, 1e-5);
    EXPECT_NEAR(area.dyy(), (value_at(0., h) - 2. * f + value_at(0., -h)) / h2, 1e-5);
    const double mixed = value_at(h, h) - value_at(h, -h) - value_at(-h, h) + value_at(-h, -h);
    EXPECT_NEAR(area.dxy(), mixed / (4. * h2), 1e-5);
    EXPECT_TRUE(Image_area<TypeParam>::has_dxy || area.dxy() == 0.);
  }
}

// The determinant is the flat area times the distance of the plane from the centre; both agree for small faces.
TEST(Image_area, of_small_faces_does_not_depend_on_the_barrier)
{
  std::mt19937 random(2);
  for(const double size : {1., 0.1, 1e-2, 1e-3})
  {
    for(int k = 0; k < 50; ++k)
    {
      const auto offset = [&]() {
        const double angle = uniform(random, 0., pi), r = size * uniform(random, 0.3, 0.9);
        const double x = r * std::cos(angle), y = r * std::sin(angle);
        return Vector_3d{x, y, Tangent_frame::height_at(x, y)};
      };
      const Vector_3d p = offset(), q = offset();
      const double determinant = Image_area<SP::Determinant_barrier_3>(p, q).value();
      const double flat = Image_area<SP::Flat_area_barrier_3>(p, q).value();
      const Vector_3d normal = normalized(cross(p, q));
      EXPECT_NEAR(determinant, flat * normal[2], 1e-13 * size * size);
      const double a = length(p), b = length(q), c = length(p - q);
      const double circumradius = a * b * c / (2. * flat); // of the circle where the plane cuts the sphere
      EXPECT_NEAR(std::abs(determinant), flat * std::sqrt(1. - circumradius * circumradius), 1e-9 * size * size);
      EXPECT_GE(std::abs(determinant), flat * (1. - circumradius * circumradius));
    }
  }
}

TEST(Safely_positive, faces_of_a_sphere)
{
  const Triangle_list sphere = test_meshes::icosphere(2);
  const Indexed_mesh mesh = indexed_mesh(sphere);
  const std::vector<Vector_3d> positions = test_indexed_meshes::renumbered(mesh, sphere.points);
  EXPECT_TRUE(SP::internal::are_safely_positive(mesh.rings(), positions));
  std::vector<Vector_3d> mirrored = positions;
  for(Vector_3d& p : mirrored)
  {
    p[2] = -p[2];
  }
  EXPECT_FALSE(SP::internal::are_safely_positive(mesh.rings(), mirrored));
  // one vertex over the opposite edge of one of its faces, or just not yet
  for(const std::uint32_t v : {0u, 17u, 161u})
  {
    const Vertex_rings::Ring ring = mesh.rings().ring(v);
    const Vector_3d middle = 0.5 * (positions[ring[0]] + positions[ring[1]]);
    for(const double t : {0.9, 0.999, 1.001, 1.1})
    {
      std::vector<Vector_3d> moved = positions;
      moved[v] = normalized((1. - t) * positions[v] + t * middle);
      EXPECT_EQ(SP::internal::are_safely_positive(mesh.rings(), moved), t < 1.) << v << ' ' << t;
    }
  }
  std::vector<Vector_3d> unknown = positions;
  unknown[5][1] = std::nan("");
  EXPECT_FALSE(SP::internal::are_safely_positive(mesh.rings(), unknown));
}

TEST(Safely_positive, face_is_positive_by_more_than_rounding)
{
  const Vector_3d a = {1., 0., 0.}, b = {0., 1., 0.};
  for(const double height : {1., 1e-3, 1e-12, 1e-16, -1e-12})
  {
    const Vector_3d c = normalized({1., 1., height});
    EXPECT_EQ(SP::internal::is_safely_positive(a, b, c), height >= 1e-12) << height;
    EXPECT_EQ(SP::internal::is_safely_positive(b, c, a), height >= 1e-12) << height;
    EXPECT_EQ(SP::internal::is_safely_positive(b, a, c), height <= -1e-12) << height;
  }
}

// Moebius transformations

TEST(Moebius_transformation, maps_the_sphere_to_itself_conformally)
{
  std::mt19937 random(3);
  for(int k = 0; k < 300; ++k)
  {
    const Vector_3d c = uniform(random, 0., 0.9) * random_direction(random), u = random_direction(random);
    const Moebius_transformation transformation(c);
    const Vector_3d image = transformation(u);
    EXPECT_NEAR(length(image), 1., 1e-15);

    // Two orthogonal tangents go to two that are orthogonal, equally long and oriented alike.
    const Tangent_frame frame(u);
    const double h = 1e-5;
    const auto derivative = [&](double x, double y) {
      return (0.5 / h) * (transformation(frame.point_at(x, y)) - transformation(frame.point_at(-x, -y)));
    };
    const Vector_3d dx = derivative(h, 0.), dy = derivative(0., h);
    const double factor = length(dx);
    EXPECT_NEAR(length(dy) / factor, 1., 1e-6);
    EXPECT_NEAR(dot(dx, dy) / (factor * factor), 0., 1e-6);
    EXPECT_NEAR(dot(cross(dx, dy), image) / (factor * factor), 1., 1e-6);
  }
}

TEST(Moebius_transformation, pushes_towards_a_point)
{
  std::mt19937 random(4);
  for(int k = 0; k < 100; ++k)
  {
    const Vector_3d direction = random_direction(random), u = random_direction(random);
    const Vector_3d c = uniform(random, 0.1, 0.9) * direction;
    const Moebius_transformation there(c), back(Vector_3d{-c[0], -c[1], -c[2]}), nothing({0., 0., 0.});
    EXPECT_LT(length(nothing(u) - u), 1e-15);
    EXPECT_LT(length(back(there(u)) - u), 1e-13);
    EXPECT_LT(length(there(direction) - direction), 1e-14);
    EXPECT_LT(length(there(-1. * direction) + direction), 1e-13);
    EXPECT_GT(dot(there(u), direction), dot(u, direction));
    // along the circle through the three points: in the plane of u and the direction
    EXPECT_NEAR(dot(there(u), normalized(cross(u, direction))), 0., 1e-13);
    // a weak push moves u by twice its tangential part
    const Vector_3d weak = Moebius_transformation(1e-6 * direction)(u) - u;
    EXPECT_LT(length(weak - 2e-6 * (direction - dot(u, direction) * u)), 1e-11);
  }
}

bool accept_all(const std::vector<Vector_3d>&)
{
  return true;
}

// Points all around and their masses, balanced.
struct Balanced_points
{
  Balanced_points(std::mt19937& random, std::size_t n)
  {
    for(std::size_t v = 0; v < n; ++v)
    {
      points.push_back(random_direction(random));
      masses.push_back(uniform(random, 0., 1.));
    }
    EXPECT_LT(center_mass(points, masses, accept_all), 1e-12);
  }

  std::vector<Vector_3d> points;
  std::vector<double> masses;
};

TEST(Center_mass, brings_the_center_to_the_origin)
{
  std::mt19937 random(5);
  for(const double strength : {0.1, 0.9, 0.99, 0.999, 0.9999})
  {
    for(const std::size_t n : {5u, 30u, 1000u})
    {
      SCOPED_TRACE(strength);
      const Balanced_points balanced(random, n);
      const Moebius_transformation push(strength * random_direction(random));
      std::vector<Vector_3d> points;
      for(const Vector_3d& u : balanced.points)
      {
        points.push_back(push(u));
      }
      EXPECT_GT(length(center_of_mass(points, balanced.masses)), 0.1 * strength);
      const double distance = center_mass(points, balanced.masses, accept_all);
      EXPECT_LT(distance, 1e-8);
      EXPECT_EQ(distance, length(center_of_mass(points, balanced.masses)));
      for(const Vector_3d& u : points)
      {
        EXPECT_NEAR(length(u), 1., 1e-15);
      }
      // There is only one such transformation: up to a rotation, the points are where they were.
      const double tolerance = 1e-10 / (1. - strength);
      for(std::size_t v = 1; v < n; ++v)
      {
        EXPECT_NEAR(length(points[v] - points[v - 1]), length(balanced.points[v] - balanced.points[v - 1]), tolerance);
      }
    }
  }
}

// Few points, far off, with masses that differ by orders of magnitude, one of them nearly half of all: where Newton's
// method alone would go astray.
TEST(Center_mass, of_uneven_masses)
{
  std::mt19937 random(6);
  for(int k = 0; k < 3000; ++k)
  {
    const Moebius_transformation push(0.999 * random_direction(random));
    std::vector<Vector_3d> points;
    std::vector<double> masses;
    double sum = 0.;
    for(std::size_t n = 5 + random() % 10; points.size() < n; sum += masses.back())
    {
      points.push_back(push(random_direction(random)));
      masses.push_back(std::exp(uniform(random, -8., 0.)));
    }
    if(k % 2 == 0)
    {
      points.push_back(push(random_direction(random)));
      masses.push_back(0.98 * sum);
      sum *= 1.98;
    }
    if(*std::max_element(masses.begin(), masses.end()) > 0.4999 * sum)
    {
      continue;
    }
    double last = length(center_of_mass(points, masses));
    const auto is_nearer = [&](const std::vector<Vector_3d>& p) {
      const double distance = length(center_of_mass(p, masses));
      EXPECT_LT(distance, last);
      last = distance;
      return true;
    };
    EXPECT_LT(center_mass(points, masses, is_nearer), 1e-8);
    EXPECT_LT(length(center_of_mass(points, masses)), 1e-8);
  }
}

TEST(Center_mass, goes_no_further_than_allowed)
{
  std::mt19937 random(7);
  const Balanced_points balanced(random, 100);
  const Moebius_transformation push({0.5, 0.3, 0.2});
  std::vector<Vector_3d> start;
  for(const Vector_3d& u : balanced.points)
  {
    start.push_back(push(u));
  }
  const double start_distance = length(center_of_mass(start, balanced.masses));

  std::vector<Vector_3d> points = start;
  EXPECT_EQ(center_mass(points, balanced.masses, [](const auto&) { return false; }), start_distance);
  EXPECT_EQ(points, start);

  // half of the way is allowed: it gets close to there, and every state was asked for
  std::set<std::vector<Vector_3d>> allowed;
  const double distance = center_mass(points, balanced.masses, [&](const std::vector<Vector_3d>& p) {
    const bool is_allowed = length(center_of_mass(p, balanced.masses)) > 0.5 * start_distance;
    if(is_allowed)
    {
      allowed.insert(p);
    }
    return is_allowed;
  });
  EXPECT_GT(distance, 0.5 * start_distance);
  EXPECT_LT(distance, 0.52 * start_distance);
  EXPECT_EQ(allowed.count(points), 1u);
}

TEST(Vertex_masses, are_there_without_an_area)
{
  const Indexed_mesh mesh = indexed_mesh(test_meshes::bumpy_sphere(1));
  const std::vector<double> areas = SP::internal::vertex_areas(mesh.rings(), mesh.points());
  double sum = 0.;
  for(const double area : areas)
  {
    EXPECT_GT(area, 0.);
    sum += area;
  }
  EXPECT_NEAR(sum, 4. * pi, 1e-12);
  EXPECT_EQ(vertex_masses(mesh.rings(), mesh.points()), areas);
  const std::vector<Vector_3d> one_point(mesh.number_of_vertices(), {1., 2., 3.});
  EXPECT_EQ(vertex_masses(mesh.rings(), one_point), std::vector<double>(one_point.size(), 1.));
}

// Weights

double cotangent(const Vector_3d& apex, const Vector_3d& p, const Vector_3d& q)
{
  return dot(p - apex, q - apex) / length(cross(p - apex, q - apex));
}

TEST(Cotangent_weights, of_platonic_solids)
{
  for(const Triangle_list& list : {test_meshes::tetrahedron(), test_meshes::octahedron(), test_meshes::icosphere(0)})
  {
    const Indexed_mesh mesh = indexed_mesh(list);
    for(const double weight : cotangent_weights(mesh.rings(), mesh.points(), any_weight))
    {
      EXPECT_NEAR(weight, 1. / std::sqrt(3.), 1e-14); // of 60 degrees
    }
  }
  // a double pyramid over a square: its edges are of two kinds
  const double height = 3.;
  const Indexed_mesh mesh = indexed_mesh(test_meshes::scaled(test_meshes::octahedron(), 1., 1., height));
  const double slope = std::sqrt(0.5 + height * height), half_base = std::sqrt(0.5);
  const double at_base = half_base / slope;
  const double at_tip = (1. - at_base * at_base) / (2. * at_base); // -cot(2 x) for cot(x) = at_base
  const std::vector<double> weights = cotangent_weights(mesh.rings(), mesh.points(), any_weight);
  for(std::uint32_t v = 0; v < 6; ++v)
  {
    for(std::size_t j = 0; j < 4; ++j)
    {
      const std::uint32_t w = mesh.rings().ring(v)[j];
      const bool is_steep = std::abs(mesh.points()[v][2] - mesh.points()[w][2]) > 1e-3;
      EXPECT_NEAR(weights[mesh.rings().offset(v) + j], is_steep ? at_base : at_tip, 1e-13);
    }
  }
}

TEST(Cotangent_weights, are_half_the_sums_of_the_cotangents)
{
  for(const Triangle_list& list : {test_meshes::bumpy_sphere(2), test_meshes::with_tentacle(20, 1.)})
  {
    const Indexed_mesh mesh = indexed_mesh(list);
    const Vertex_rings& rings = mesh.rings();
    const std::vector<Vector_3d>& points = mesh.points();
    const std::vector<double> weights = cotangent_weights(rings, points, any_weight),
                              positive = cotangent_weights(rings, points, least_positive_weight);
    ASSERT_EQ(weights.size(), rings.number_of_corners());
    std::size_t n_raised = 0;
    for(std::uint32_t v = 0; v < rings.number_of_vertices(); ++v)
    {
      const Vertex_rings::Ring ring = rings.ring(v);
      for(std::size_t j = 0; j < ring.size(); ++j)
      {
        const std::uint32_t w = ring[j], left = ring[(j + 1) % ring.size()],
                            right = ring[(j + ring.size() - 1) % ring.size()];
        const double expected =
            0.5 * (cotangent(points[left], points[v], points[w]) + cotangent(points[right], points[v], points[w]));
        const double weight = weights[rings.offset(v) + j];
        EXPECT_NEAR(weight, expected, 1e-10 * (1. + std::abs(expected)));

        // raised where too low, else the same; and both copies are equal
        const double raised = positive[rings.offset(v) + j];
        EXPECT_EQ(raised, (std::max)(weight, least_positive_weight));
        EXPECT_GT(raised, 0.);
        n_raised += raised > weight;
        const Vertex_rings::Ring other = rings.ring(w);
        const auto back = static_cast<std::size_t>(std::find(other.begin(), other.end(), v) - other.begin());
        EXPECT_EQ(std::memcmp(&weights[rings.offset(w) + back], &weight, sizeof(double)), 0);
        EXPECT_EQ(std::memcmp(&positive[rings.offset(w) + back], &raised, sizeof(double)), 0);
      }
    }
    EXPECT_GT(n_raised, 0u);
  }
}

TEST(Cotangent_weights, of_flat_faces_are_finite)
{
  for(const Triangle_list& list : {test_meshes::scaled(test_meshes::icosphere(1), 1., 1., 0.),
                                   test_meshes::scaled(test_meshes::icosphere(1), 1., 0., 0.),
                                   test_meshes::scaled(test_meshes::icosphere(1), 0., 0., 0.)})
  {
    const Indexed_mesh mesh = indexed_mesh(list);
    for(const double weight : cotangent_weights(mesh.rings(), mesh.points(), least_positive_weight))
    {
      EXPECT_TRUE(std::isfinite(weight));
      EXPECT_GE(weight, least_positive_weight);
    }
  }
}

// The linear system

// the Laplacian of a vertex
Vector_3d laplacian(const Vertex_rings& rings, const std::vector<double>& weights, const std::vector<Vector_3d>& x,
                    std::size_t v)
{
  Vector_3d sum = {0., 0., 0.};
  for(std::size_t j = 0; j < rings.degree(v); ++j)
  {
    sum = sum + weights[rings.offset(v) + j] * (x[v] - x[rings.ring(v)[j]]);
  }
  return sum;
}

TEST(Laplacian_system, is_solved)
{
  std::mt19937 random(8);
  const Indexed_mesh mesh = indexed_mesh(test_meshes::bumpy_sphere(3));
  const std::size_t n = mesh.number_of_vertices();
  const std::vector<double> weights = cotangent_weights(mesh.rings(), mesh.points(), least_positive_weight);
  const auto each_tenth = [](std::uint32_t v) { return v % 10 == 3; };
  Laplacian_system<Solver_traits> system; // one object for all, factored anew
  const auto expect_solved = [&](const auto& is_fixed) {
    ASSERT_TRUE(system.factor(mesh.rings(), weights, is_fixed));
    for(int k = 0; k < 3; ++k) // several right-hand sides
    {
      std::vector<Vector_3d> right(n), x;
      for(Vector_3d& b : right)
      {
        b = uniform(random, 0., 10.) * random_direction(random);
      }
      x = right;
      ASSERT_TRUE(system.solve(x));
      for(std::uint32_t v = 0; v < n; ++v)
      {
        if(is_fixed(v))
        {
          EXPECT_EQ(x[v], (Vector_3d{0., 0., 0.}));
        }
        else
        {
          const Vector_3d left = laplacian(mesh.rings(), weights, x, v);
          EXPECT_LT(length(left - right[v]), 1e-10 * largest_length(right));
        }
      }
    }
  };
  expect_solved(each_tenth);
  expect_solved([](std::uint32_t v) { return v == 0; });
}

TEST(Laplacian_system, says_that_it_cannot_be_solved)
{
  const Indexed_mesh mesh = indexed_mesh(test_meshes::icosphere(1));
  const std::vector<double> weights(mesh.rings().number_of_corners(), 0.);
  Laplacian_system<Solver_traits> system;
  const auto first = [](std::uint32_t v) { return v == 0; };
  EXPECT_FALSE(system.factor(mesh.rings(), weights, first));
  EXPECT_TRUE(system.factor(mesh.rings(), std::vector<double>(weights.size(), 1.), first));
}

// The harmonic energy

double image_area(const Vertex_rings& rings, const std::vector<Vector_3d>& u)
{
  double area = 0.;
  rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    area += 0.5 * length(cross(u[b] - u[a], u[c] - u[a]));
  });
  return area;
}

TEST(Dirichlet_energy, of_the_identity_of_a_sphere_tends_to_1)
{
  double last_error = 1.;
  for(const unsigned int subdivisions : {1u, 2u, 3u, 4u})
  {
    const Triangle_list list = test_meshes::icosphere(subdivisions);
    const Indexed_mesh mesh = indexed_mesh(list);
    const std::vector<Vector_3d> u = test_indexed_meshes::renumbered(mesh, list.points);
    const std::vector<double> weights = cotangent_weights(mesh.rings(), mesh.points(), any_weight);
    std::vector<double> shares(u.size());
    const double energy = Dirichlet_energy<CGAL::Sequential_tag>(mesh.rings(), weights)(u, shares);
    EXPECT_NEAR(energy, image_area(mesh.rings(), u) / (4. * pi), 1e-12); // it is conformal
    const double error = std::abs(energy - 1.);
    EXPECT_LT(error, 0.3 * last_error);
    last_error = error;
  }
  EXPECT_LT(last_error, 2e-3);
}

TEST(Dirichlet_energy, is_the_sum_over_the_edges)
{
  std::mt19937 random(9);
  const Triangle_list list = test_meshes::icosphere(2);
  const Indexed_mesh mesh = indexed_mesh(test_meshes::scaled(list, 1., 1.5, 2.));
  const std::vector<Vector_3d> u = test_indexed_meshes::renumbered(mesh, list.points);
  const Vertex_rings& rings = mesh.rings();
  const std::vector<double> weights = cotangent_weights(rings, mesh.points(), any_weight);
  std::vector<double> shares(u.size());
  const double energy = Dirichlet_energy<CGAL::Sequential_tag>(rings, weights)(u, shares);
  double sum = 0., sum_of_shares = 0.;
  for(std::uint32_t v = 0; v < u.size(); ++v)
  {
    for(std::size_t j = 0; j < rings.degree(v); ++j)
    {
      const std::uint32_t w = rings.ring(v)[j];
      sum += v < w ? 0.5 * weights[rings.offset(v) + j] * squared_length(u[v] - u[w]) : 0.;
    }
    EXPECT_NEAR(shares[v], 0.5 * dot(laplacian(rings, weights, u, v), u[v]), 1e-12);
    sum_of_shares += shares[v];
  }
  EXPECT_NEAR(4. * pi * energy, sum, 1e-11);
  EXPECT_NEAR(sum_of_shares, sum, 1e-11);
  EXPECT_GT(energy, 1.01 * image_area(rings, u) / (4. * pi)); // the map is not conformal
}

// Its minimisation

struct Energies : SP::Default_visitor
{
  void after_iteration(std::size_t, double energy, double) { energies.push_back(energy); }
  std::vector<double> energies;
};

// How far the Laplacian is from being normal to the sphere, as a part of all of it. What a multiplier of the condition
// on the centre explains does not count: a vector for all vertices, in proportion to their shares in the energy.
double tangential_part(const Vertex_rings& rings, const std::vector<double>& weights, const std::vector<Vector_3d>& u)
{
  std::vector<Vector_3d> tangential;
  std::vector<double> shares;
  Vector_3d sum = {0., 0., 0.};
  double all = 0., unexplained = 0.;
  for(std::size_t v = 0; v < u.size(); ++v)
  {
    const Vector_3d l = laplacian(rings, weights, u, v);
    shares.push_back(0.5 * dot(l, u[v]));
    tangential.push_back(l - dot(l, u[v]) * u[v]);
    sum = sum + tangential[v];
    all += length(l);
  }
  const Vector_3d multiplier = SP::internal::solve_tangential(u, shares, sum);
  for(std::size_t v = 0; v < u.size(); ++v)
  {
    unexplained += length(tangential[v] - shares[v] * (multiplier - dot(multiplier, u[v]) * u[v]));
  }
  return unexplained / all;
}

TEST(Spherical_harmonic_map, is_a_critical_point_of_the_energy)
{
  std::array<double, 2> last_end = {1., 1.};
  for(const unsigned int subdivisions : {2u, 3u, 4u})
  {
    const Indexed_mesh mesh = indexed_mesh(test_meshes::bumpy_sphere(subdivisions));
    for(const bool is_guarded : {true, false})
    {
      SCOPED_TRACE(is_guarded);
      const std::vector<double> weights =
          cotangent_weights(mesh.rings(), mesh.points(), is_guarded ? least_positive_weight : any_weight);
      Stereographic_embedding<Solver_traits> embedding(mesh);
      std::vector<Vector_3d> u;
      ASSERT_TRUE(embedding.solve());
      ASSERT_TRUE(embedding.project_bijectively(u));
      const double start = tangential_part(mesh.rings(), weights, u);
      std::vector<double> shares(u.size());
      const Dirichlet_energy<CGAL::Sequential_tag> energy(mesh.rings(), weights);
      const double start_energy = energy(u, shares);

      Energies visitor;
      SP::Parameterization_report report;
      SP::internal::Run_control<Energies> control(visitor, 0., report);
      Spherical_harmonic_map<Solver_traits, CGAL::Sequential_tag> map(mesh, weights, is_guarded);
      ASSERT_TRUE(map.run(u, 100, control));
      EXPECT_EQ(report.stop_reason, SP::CONVERGED);
      EXPECT_EQ(report.initial_energy, start_energy);
      EXPECT_EQ(report.average_energy, energy(u, shares));
      ASSERT_FALSE(visitor.energies.empty());
      EXPECT_EQ(report.average_energy, visitor.energies.back());
      EXPECT_EQ(report.number_of_average_iterations, visitor.energies.size());
      EXPECT_LT(report.average_energy, start_energy);
      double lowest = start_energy;
      for(const double e : visitor.energies)
      {
        EXPECT_LT(e, (1. + 1e-4) * lowest); // a centring transformation may cost a little
        lowest = (std::min)(lowest, e);
      }
      EXPECT_LT(length(center_of_mass(u, vertex_masses(mesh.rings(), mesh.points()))), 1e-8);
      const double end = tangential_part(mesh.rings(), weights, u);
      EXPECT_LT(end, 0.01 * start);
      EXPECT_LT(end, 2e-3);
      EXPECT_LT(end, (is_guarded ? 1. : 0.4) * last_end[is_guarded ? 1 : 0]); // the more exact, the finer the mesh
      last_end[is_guarded ? 1 : 0] = end;
    }
  }
}

// The way through the plane

TEST(Central_vertex, of_distances)
{
  const Indexed_mesh mesh = indexed_mesh(test_meshes::with_tentacle(40, 4.));
  const Vertex_rings& rings = mesh.rings();
  for(const std::uint32_t source : {0u, 50u, 200u})
  {
    const std::vector<std::uint32_t> distance = SP::internal::edge_distances(rings, source);
    for(std::uint32_t v = 0; v < rings.number_of_vertices(); ++v)
    {
      std::uint32_t nearest = distance[rings.ring(v)[0]];
      for(const std::uint32_t w : rings.ring(v))
      {
        nearest = (std::min)(nearest, distance[w]);
      }
      EXPECT_EQ(distance[v], v == source ? 0 : nearest + 1);
    }
  }
}

TEST(Central_vertex, is_as_near_to_all_as_any)
{
  for(const Triangle_list& list : {test_meshes::with_tentacle(40, 4.), test_meshes::icosphere(3),
                                   test_meshes::suspension(12), test_meshes::tetrahedron()})
  {
    const Indexed_mesh mesh = indexed_mesh(list);
    const auto eccentricity = [&](std::uint32_t v) {
      const std::vector<std::uint32_t> distance = SP::internal::edge_distances(mesh.rings(), v);
      return *std::max_element(distance.begin(), distance.end());
    };
    std::uint32_t least = eccentricity(0), largest = least;
    for(std::uint32_t v = 1; v < mesh.number_of_vertices(); ++v)
    {
      least = (std::min)(least, eccentricity(v));
      largest = (std::max)(largest, eccentricity(v));
    }
    const std::uint32_t central = eccentricity(SP::internal::central_vertex(mesh.rings()));
    EXPECT_LE(central, 1.15 * least);
    EXPECT_TRUE(central < largest || least == largest);
  }
}

TEST(Stereographic_embedding, is_positive_and_centred)
{
  std::vector<Triangle_list> lists = {test_meshes::tetrahedron(),        test_meshes::octahedron(),
                                      test_meshes::icosphere(0),         test_meshes::icosphere(3),
                                      test_meshes::bumpy_sphere(1),      test_meshes::bumpy_sphere(3),
                                      test_meshes::with_tentacle(20, 1.)};
  for(const std::size_t n : {3u, 4u, 5u, 6u, 7u, 10u, 20u, 50u})
  {
    lists.push_back(test_meshes::suspension(n));
    lists.push_back(test_meshes::scaled(test_meshes::suspension(n), 1., 1., 0.05));
    lists.push_back(test_meshes::scaled(test_meshes::suspension(n), 1., 0.2, 5.));
  }
  for(const Triangle_list& list : lists)
  {
    const Indexed_mesh mesh = indexed_mesh(list);
    Stereographic_embedding<Solver_traits> embedding(mesh);
    std::vector<Vector_3d> u;
    ASSERT_TRUE(embedding.solve());
    EXPECT_TRUE(embedding.project_bijectively(u));
    EXPECT_TRUE(SP::internal::are_safely_positive(mesh.rings(), u));
    EXPECT_LT(length(center_of_mass(u, vertex_masses(mesh.rings(), mesh.points()))), 1e-8);
    for(const Vector_3d& p : u)
    {
      EXPECT_NEAR(length(p), 1., 1e-15);
    }
  }
}

} // namespace
