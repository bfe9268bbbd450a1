#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include "test_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using test_meshes::Coordinates;
using test_meshes::Triangle;
using test_meshes::Triangle_list;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The summary and the values of all faces, in the order of the faces.
struct Measurement
{
  SP::Distortion_summary summary;
  std::vector<SP::Face_distortion> faces;
};

template <class Mesh>
Measurement measure(const Triangle_list& list, const std::vector<Coordinates>& images, double bound = infinity)
{
  using Point =
      typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;

  const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
  const auto distortion = get(CGAL::dynamic_face_property_t<SP::Face_distortion>(), mesh);
  Measurement result;
  result.summary = SP::measure_distortion(mesh, test_meshes::make_vertex_map<Point>(mesh, images), distortion, bound);
  for(const auto f : faces(mesh))
  {
    result.faces.push_back(get(distortion, f));
  }
  return result;
}

using Surface_mesh = CGAL::Surface_mesh<Epick::Point_3>;

Measurement measure(const Triangle_list& list, const std::vector<Coordinates>& images, double bound = infinity)
{
  return measure<Surface_mesh>(list, images, bound);
}

// The distortions of a triangle by brute force, in extended precision where there is one: the matrix of the map in
// coordinates of the source's plane, and one rotation of its two columns (Jacobi) that makes them orthogonal. The
// longer one is the larger singular value then; the product of both is the ratio of the areas.
struct Reference
{
  using Vector = std::array<long double, 3>;

  long double isometric, area, angle;

  static long double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  static Vector cross(const Vector& a, const Vector& b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  static Vector sum(long double s, const Vector& a, long double t, const Vector& b)
  {
    return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
  }

  static Vector vector(const Coordinates& from, const Coordinates& to)
  {
    return sum(-1.L, {from[0], from[1], from[2]}, 1.L, {to[0], to[1], to[2]});
  }

  static Reference of(const Triangle_list& list, const std::vector<Coordinates>& images, const Triangle& t)
  {
    const Vector e1 = vector(list.points[t[0]], list.points[t[1]]), e2 = vector(list.points[t[0]], list.points[t[2]]);
    const Vector f1 = vector(images[t[0]], images[t[1]]), f2 = vector(images[t[0]], images[t[2]]);
    // e1 is mapped to f1, and the height over it, which is e2 - foot e1, to f2 - foot f1.
    const long double foot = dot(e1, e2) / dot(e1, e1);
    const Vector height = sum(1.L, e2, -foot, e1);
    const Vector a = sum(1.L / std::sqrt(dot(e1, e1)), f1, 0.L, f1);
    const Vector b = sum(1.L / std::sqrt(dot(height, height)), f2, -foot / std::sqrt(dot(height, height)), f1);
    const long double angle = 0.5L * std::atan2(2.L * dot(a, b), dot(a, a) - dot(b, b));
    const Vector major = sum(std::cos(angle), a, std::sin(angle), b);
    const long double s2 = std::sqrt(dot(major, major));
    const Vector n = cross(e1, e2), m = cross(f1, f2);
    const long double s1 = std::sqrt(dot(m, m)) / std::sqrt(dot(n, n)) / s2;
    return {(std::max)(s2, 1.L / s1), s1 * s2 + 1.L / (s1 * s2), s2 / s1 + s1 / s2};
  }
};

void expect_relative(double value, long double reference, double tolerance)
{
  EXPECT_NEAR(value, static_cast<double>(reference), tolerance * static_cast<double>(std::abs(reference)));
}

// A tetrahedron whose first face, number 0, has these corners; the fourth vertex is where it is in tetrahedron().
Triangle_list with_triangle(const Coordinates& p0, const Coordinates& p1, const Coordinates& p2)
{
  Triangle_list list = test_meshes::tetrahedron();
  list.points[0] = p0;
  list.points[1] = p1;
  list.points[2] = p2;
  return list;
}

template <class Mesh>
class Measure_distortion : public ::testing::Test
{};

using Meshes = ::testing::Types<CGAL::Surface_mesh<Epick::Point_3>, CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>,
                                CGAL::Surface_mesh<Epeck::Point_3>>;
TYPED_TEST_SUITE(Measure_distortion, Meshes, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Measure_distortion, of_the_identity_is_none)
{
  const Triangle_list list = test_meshes::icosphere(2);
  const SP::Distortion_summary s = measure<TypeParam>(list, list.points, 1. + 1e-12).summary;
  EXPECT_NEAR(s.isometric.maximum, 1., 1e-13);
  EXPECT_NEAR(s.isometric.average, 1., 1e-13);
  EXPECT_NEAR(s.isometric.deviation, 0., 1e-13);
  EXPECT_NEAR(s.area.maximum, 2., 1e-13);
  EXPECT_NEAR(s.area.average, 2., 1e-13);
  EXPECT_NEAR(s.area.deviation, 0., 1e-13);
  EXPECT_NEAR(s.angle.maximum, 2., 1e-13);
  EXPECT_NEAR(s.angle.average, 2., 1e-13);
  EXPECT_NEAR(s.angle.deviation, 0., 1e-13);
  EXPECT_NEAR(s.radius, 1., 1e-15);
  EXPECT_EQ(s.number_of_faces, list.triangles.size());
  EXPECT_EQ(s.number_of_faces_above_bound, 0u);
  EXPECT_EQ(s.number_of_inverted_faces, 0u);
  EXPECT_EQ(s.number_of_degenerate_faces, 0u);
}

TYPED_TEST(Measure_distortion, of_a_similarity_is_its_factor)
{
  const Triangle_list list = test_meshes::random_stacked_sphere(30, 1);
  for(const double r : {0.25, 3.})
  {
    const SP::Distortion_summary s = measure<TypeParam>(list, test_meshes::scaled(list, r, r, r).points).summary;
    const double iso = (std::max)(r, 1. / r), area = r * r + 1. / (r * r);
    EXPECT_NEAR(s.radius, r, 1e-14);
    EXPECT_NEAR(s.isometric.maximum, iso, 1e-11);
    EXPECT_NEAR(s.isometric.average, iso, 1e-12);
    EXPECT_NEAR(s.area.maximum, area, 1e-10);
    EXPECT_NEAR(s.area.average, area, 1e-11);
    EXPECT_NEAR(s.angle.maximum, 2., 1e-11);
  }
}

TYPED_TEST(Measure_distortion, of_a_stretched_face)
{
  // The face in the plane z = 1 is stretched by 4 along x and by 1/2 along y.
  const Triangle_list list = with_triangle({0, 0, 1}, {1, 0, 1}, {0.25, 1, 1});
  std::vector<Coordinates> images = list.points;
  images[1] = {4, 0, 1};
  images[2] = {1, 0.5, 1};
  const Measurement m = measure<TypeParam>(list, images);
  EXPECT_DOUBLE_EQ(m.faces[0].isometric, 4.);
  EXPECT_DOUBLE_EQ(m.faces[0].area, 2.5);
  EXPECT_DOUBLE_EQ(m.faces[0].angle, 8.125);
  EXPECT_FALSE(m.faces[0].is_inverted);

  // The other way round, s1 = 1/4 decides.
  Triangle_list stretched = list;
  stretched.points = images;
  const Measurement inverse = measure<TypeParam>(stretched, list.points);
  EXPECT_DOUBLE_EQ(inverse.faces[0].isometric, 4.);
  EXPECT_DOUBLE_EQ(inverse.faces[0].area, 2.5);
  EXPECT_DOUBLE_EQ(inverse.faces[0].angle, 8.125);
}

TYPED_TEST(Measure_distortion, agrees_with_singular_values_computed_directly)
{
  const Triangle_list list = test_meshes::ellipsoid(1., 2., 0.3, 2);
  const std::vector<Coordinates> images = test_meshes::icosphere(2).points;
  const Measurement m = measure<TypeParam>(list, images);
  ASSERT_EQ(m.faces.size(), list.triangles.size());
  for(std::size_t i = 0; i < m.faces.size(); ++i)
  {
    const Reference reference = Reference::of(list, images, list.triangles[i]);
    expect_relative(m.faces[i].isometric, reference.isometric, 1e-13);
    expect_relative(m.faces[i].area, reference.area, 1e-13);
    expect_relative(m.faces[i].angle, reference.angle, 1e-13);
  }
}

TYPED_TEST(Measure_distortion, sums_up_the_faces)
{
  const Triangle_list list = test_meshes::ellipsoid(1., 2., 0.3, 2);
  std::vector<Coordinates> images = test_meshes::icosphere(2).points;
  images[5] = {-images[5][0], -images[5][1], -images[5][2]};
  const double bound = 2.5;
  const Measurement m = measure<TypeParam>(list, images, bound);
  const double n = static_cast<double>(m.faces.size());

  std::size_t above = 0, inverted = 0;
  for(const SP::Face_distortion& f : m.faces)
  {
    above += f.isometric > bound ? 1u : 0u;
    inverted += f.is_inverted ? 1u : 0u;
  }
  EXPECT_GT(above, 0u);
  EXPECT_LT(above, m.faces.size());
  EXPECT_EQ(m.summary.number_of_faces_above_bound, above);
  EXPECT_EQ(m.summary.number_of_inverted_faces, inverted);
  EXPECT_EQ(inverted, 5u); // the faces of a vertex of degree 5

  const auto expect_statistics = [&](const SP::Distortion_statistics& statistics, double SP::Face_distortion::*value) {
    double maximum = 0., sum = 0., squares = 0.;
    for(const SP::Face_distortion& f : m.faces)
    {
      maximum = (std::max)(maximum, f.*value);
      sum += f.*value;
    }
    for(const SP::Face_distortion& f : m.faces)
    {
      squares += (f.*value - sum / n) * (f.*value - sum / n);
    }
    EXPECT_EQ(statistics.maximum, maximum);
    EXPECT_NEAR(statistics.average, sum / n, 1e-12 * sum / n);
    EXPECT_NEAR(statistics.deviation, std::sqrt(squares / n), 1e-12 * sum / n);
    EXPECT_GT(statistics.deviation, 0.);
  };
  expect_statistics(m.summary.isometric, &SP::Face_distortion::isometric);
  expect_statistics(m.summary.area, &SP::Face_distortion::area);
  expect_statistics(m.summary.angle, &SP::Face_distortion::angle);
}

TYPED_TEST(Measure_distortion, reports_inverted_faces)
{
  const Triangle_list list = test_meshes::icosphere(1);
  const Measurement m = measure<TypeParam>(list, test_meshes::scaled(list, 1., 1., -1.).points);
  EXPECT_EQ(m.summary.number_of_inverted_faces, list.triangles.size());
  EXPECT_EQ(m.summary.number_of_degenerate_faces, 0u);
  EXPECT_TRUE(m.faces[0].is_inverted);
  EXPECT_NEAR(m.summary.isometric.maximum, 1., 1e-13); // a reflection keeps all lengths
}

TYPED_TEST(Measure_distortion, leaves_degenerate_faces_out)
{
  // A face of height 0, or next to the bound: twice its area is below, or above,
  // 1e-12 times the square of its longest edge.
  for(const double height : {0., 0.9e-12, 1.1e-12})
  {
    const Triangle_list list = with_triangle({0, 0, 0}, {1, 0, 0}, {0.5, height, 0});
    std::vector<Coordinates> images = test_meshes::tetrahedron().points;
    const Measurement m = measure<TypeParam>(list, images, 1.5);
    const bool is_degenerate = height < 1e-12;
    EXPECT_EQ(m.summary.number_of_faces, 4u);
    EXPECT_EQ(m.summary.number_of_degenerate_faces, is_degenerate ? 1u : 0u);
    EXPECT_EQ(m.summary.number_of_inverted_faces, 0u);
    EXPECT_EQ(std::isinf(m.faces[0].isometric), is_degenerate);
    EXPECT_EQ(std::isinf(m.faces[0].area), is_degenerate);
    EXPECT_EQ(std::isinf(m.faces[0].angle), is_degenerate);
    EXPECT_FALSE(m.faces[0].is_inverted);
    const double others = (std::max)({m.faces[1].isometric, m.faces[2].isometric, m.faces[3].isometric});
    const double all = is_degenerate ? others : (std::max)(others, m.faces[0].isometric);
    EXPECT_TRUE(std::isfinite(all));
    EXPECT_EQ(m.summary.isometric.maximum, all);
    std::size_t above = 0;
    for(const SP::Face_distortion& f : m.faces)
    {
      above += f.isometric > 1.5 && std::isfinite(f.isometric) ? 1u : 0u;
    }
    EXPECT_EQ(m.summary.number_of_faces_above_bound, above);
  }
}

TYPED_TEST(Measure_distortion, of_a_collapsed_image_is_infinite)
{
  const Triangle_list list = test_meshes::icosphere(1);
  std::vector<Coordinates> images = list.points;
  const Triangle& t = list.triangles[7];
  images[t[0]] = images[t[1]];
  const Measurement m = measure<TypeParam>(list, images, 1e300);
  EXPECT_EQ(m.faces[7].isometric, infinity);
  EXPECT_EQ(m.faces[7].area, infinity);
  EXPECT_EQ(m.faces[7].angle, infinity);
  EXPECT_TRUE(m.faces[7].is_inverted);
  EXPECT_EQ(m.summary.number_of_faces_above_bound, 2u); // the two faces of the edge
  EXPECT_EQ(m.summary.number_of_degenerate_faces, 0u);
  EXPECT_EQ(m.summary.isometric.maximum, infinity);
  EXPECT_EQ(m.summary.isometric.average, infinity);
  EXPECT_EQ(m.summary.isometric.deviation, infinity);
}

TYPED_TEST(Measure_distortion, of_all_images_at_one_point_is_infinite)
{
  const Triangle_list list = test_meshes::tetrahedron();
  const Measurement m = measure<TypeParam>(list, std::vector<Coordinates>(4, Coordinates{0., 0., 1.}));
  EXPECT_EQ(m.summary.isometric.average, infinity);
  EXPECT_EQ(m.summary.number_of_inverted_faces, 4u);
  EXPECT_EQ(m.summary.radius, 1.);
}

TEST(Measure_distortion_precision, of_random_triangles_of_every_shape)
{
  // Vertices with coordinates of 20 bits: the edges are exact, so the needles' heights are what the reference takes
  // them for.
  std::mt19937 random(6);
  const auto coordinate = [&](int exponent) {
    return std::ldexp(static_cast<double>(random() % (1u << 20)), -20 - exponent);
  };
  for(int i = 0; i < 500; ++i)
  {
    const int e1 = static_cast<int>(random() % 24);
    const int e2 = static_cast<int>(random() % 24);
    const Coordinates far = {1. + coordinate(0), coordinate(0), coordinate(0)};
    const Coordinates near = {coordinate(e1), coordinate(e1), coordinate(e1)};
    const Triangle_list list = with_triangle({0., 0., 0.}, far, near);
    std::vector<Coordinates> images = list.points;
    images[0] = {0., 0., 1.};
    images[1] = {coordinate(e2), coordinate(e2), 1. + coordinate(e2)};
    images[2] = {coordinate(0), coordinate(0), 1. + coordinate(0)};
    const Measurement m = measure(list, images);
    const Reference reference = Reference::of(list, images, list.triangles[0]);
    // a short edge does not cost a digit; heights over all edges stay above 1e-4 here with few exceptions
    expect_relative(m.faces[0].isometric, reference.isometric, 1e-11);
    expect_relative(m.faces[0].area, reference.area, 1e-11);
    expect_relative(m.faces[0].angle, reference.angle, 1e-11);
  }
}

TEST(Measure_distortion_precision, of_needles)
{
  // A face of height h over a base of 1 or with a short edge h, doubled in height: s1 = 1, s2 = 2.
  for(const double h : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10})
  {
    const Triangle_list cap = with_triangle({0, 0, 1}, {1, 0, 1}, {0.4375, h, 1});
    std::vector<Coordinates> images = cap.points;
    images[2][1] = 2 * h;
    const SP::Face_distortion of_cap = measure(cap, images).faces[0];
    EXPECT_NEAR(of_cap.isometric, 2., 1e-15 / h);
    EXPECT_NEAR(of_cap.area, 2.5, 1e-15 / h);
    EXPECT_NEAR(of_cap.angle, 2.5, 1e-15 / h);

    for(const int turn : {0, 1, 2})
    {
      std::array<Coordinates, 3> p = {Coordinates{0, 0, 1}, Coordinates{1, 0, 1}, Coordinates{0.25 * h, h, 1}};
      std::rotate(p.begin(), p.begin() + turn, p.end());
      const Triangle_list needle = with_triangle(p[0], p[1], p[2]);
      images = needle.points;
      for(std::size_t i = 0; i < 3; ++i)
      {
        images[i][1] *= 2;
      }
      const SP::Face_distortion of_needle = measure(needle, images).faces[0];
      EXPECT_NEAR(of_needle.isometric, 2., 1e-14);
      EXPECT_NEAR(of_needle.area, 2.5, 1e-14);
      EXPECT_NEAR(of_needle.angle, 2.5, 1e-14);
    }
  }
}

TEST(Measure_distortion_precision, of_tiny_triangles_far_from_the_origin)
{
  // The edges are 2^-40, exactly, at a distance of 1; a formula on the points instead of their differences sees noise.
  const double h = 0x1p-40;
  const Triangle_list list = with_triangle({0, 0, 1}, {h, 0, 1}, {0, h, 1});
  std::vector<Coordinates> images = list.points;
  images[1][0] = 3 * h;
  const SP::Face_distortion f = measure(list, images).faces[0];
  EXPECT_DOUBLE_EQ(f.isometric, 3.);
  EXPECT_DOUBLE_EQ(f.area, 3. + 1. / 3.);
  EXPECT_DOUBLE_EQ(f.angle, 3. + 1. / 3.);
  EXPECT_FALSE(f.is_inverted);
}

TEST(Measure_distortion_precision, of_extreme_anisotropy)
{
  // s2 / s1 = 1e12: the difference of two sums of squares would leave nothing of s1.
  const Triangle_list list = with_triangle({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  std::vector<Coordinates> images = list.points;
  images[1][0] = 1e6;
  images[2][1] = 1e-6;
  const SP::Face_distortion f = measure(list, images).faces[0];
  expect_relative(f.isometric, 1e6L, 1e-14);
  expect_relative(f.area, 2.L, 1e-14);
  expect_relative(f.angle, 1e12L, 1e-14);
}

TEST(Measure_distortion_range, does_not_depend_on_the_unit)
{
  const Triangle_list list = test_meshes::ellipsoid(1., 2., 0.3, 1);
  const Triangle_list sphere = test_meshes::icosphere(1);
  const SP::Distortion_summary expected = measure(list, sphere.points).summary;
  for(const int exponent : {-1000, -500, 500, 1000})
  {
    const double s = std::ldexp(1., exponent);
    const SP::Distortion_summary summary =
        measure(test_meshes::scaled(list, s, s, s), test_meshes::scaled(sphere, s, s, s).points).summary;
    EXPECT_EQ(summary.isometric.maximum, expected.isometric.maximum);
    EXPECT_EQ(summary.isometric.average, expected.isometric.average);
    EXPECT_EQ(summary.area.average, expected.area.average);
    EXPECT_EQ(summary.angle.average, expected.angle.average);
    EXPECT_EQ(summary.radius, s * expected.radius);
    EXPECT_EQ(summary.number_of_degenerate_faces, 0u);
    EXPECT_EQ(summary.number_of_inverted_faces, 0u);
  }
  // The factor itself: huge surfaces on the unit sphere, and tiny ones.
  for(const double s : {1e-150, 1e150})
  {
    const SP::Distortion_summary summary = measure(test_meshes::scaled(sphere, s, s, s), sphere.points).summary;
    expect_relative(summary.isometric.average, 1e150L, 1e-13);
    expect_relative(summary.area.average, 1e300L, 1e-13);
    expect_relative(summary.angle.average, 2.L, 1e-13);
  }
}

TEST(Measure_distortion_range, of_coordinates_that_are_not_finite)
{
  const Triangle_list list = test_meshes::icosphere(1);
  for(const double x : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
  {
    Triangle_list broken = list;
    broken.points[0][1] = x;
    const SP::Distortion_summary of_mesh = measure(broken, list.points).summary;
    EXPECT_EQ(of_mesh.number_of_degenerate_faces, 5u);
    EXPECT_NEAR(of_mesh.isometric.maximum, 1., 1e-13);

    const SP::Distortion_summary of_images = measure(list, broken.points).summary;
    EXPECT_EQ(of_images.number_of_degenerate_faces, 0u);
    EXPECT_EQ(of_images.number_of_inverted_faces, 5u);
    EXPECT_EQ(of_images.isometric.maximum, infinity);
  }
}

TEST(Measure_distortion_interface, all_overloads_agree)
{
  const Triangle_list list = test_meshes::ellipsoid(1., 2., 0.3, 1);
  Surface_mesh mesh = test_meshes::make_mesh<Surface_mesh>(list);
  const auto sphere = test_meshes::make_vertex_map<Epick::Point_3>(mesh, test_meshes::icosphere(1).points);
  const auto distortion = mesh.add_property_map<Surface_mesh::Face_index, SP::Face_distortion>("f:distortion").first;
  // half as large as the points of the mesh
  const auto half = test_meshes::make_vertex_map<Epick::Point_3>(mesh, test_meshes::scaled(list, 0.5, 0.5, 0.5).points);
  const auto np = CGAL::parameters::vertex_point_map(half);

  const SP::Distortion_summary plain = SP::measure_distortion(mesh, sphere);
  const SP::Distortion_summary bounded = SP::measure_distortion(mesh, sphere, 2.);
  EXPECT_EQ(plain.number_of_faces_above_bound, 0u);
  EXPECT_GT(bounded.number_of_faces_above_bound, 0u);
  EXPECT_EQ(plain.isometric.average, bounded.isometric.average);
  // a bound is a number of any type
  EXPECT_EQ(SP::measure_distortion(mesh, sphere, 2).number_of_faces_above_bound, bounded.number_of_faces_above_bound);
  EXPECT_EQ(SP::measure_distortion(mesh, sphere, 2.f).number_of_faces_above_bound, bounded.number_of_faces_above_bound);

  EXPECT_EQ(SP::measure_distortion(mesh, sphere, distortion).isometric.average, plain.isometric.average);
  EXPECT_EQ(SP::measure_distortion(mesh, sphere, distortion, 2.).number_of_faces_above_bound,
            bounded.number_of_faces_above_bound);
  EXPECT_EQ(SP::measure_distortion(mesh, sphere, distortion, 2).number_of_faces_above_bound,
            bounded.number_of_faces_above_bound);

  const SP::Distortion_summary of_half = SP::measure_distortion(mesh, sphere, np);
  EXPECT_NE(of_half.isometric.average, plain.isometric.average);
  EXPECT_EQ(SP::measure_distortion(mesh, sphere, 2., np).isometric.average, of_half.isometric.average);
  EXPECT_EQ(SP::measure_distortion(mesh, sphere, 2, np).isometric.average, of_half.isometric.average);
  EXPECT_EQ(SP::measure_distortion(mesh, sphere, distortion, np).isometric.average, of_half.isometric.average);
  EXPECT_EQ(SP::measure_distortion(mesh, sphere, distortion, 2., np).isometric.average, of_half.isometric.average);
}

TEST(Measure_distortion_interface, works_for_different_kernels_and_open_meshes)
{
  // a mesh with exact points, and images of type float
  using Mesh = CGAL::Surface_mesh<Epeck::Point_3>;
  Triangle_list list = test_meshes::octahedron();
  list.triangles.pop_back();
  list.points.push_back({9., 9., 9.}); // isolated: neither its image nor its point matters
  const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
  const auto sphere = test_meshes::make_vertex_map<CGAL::Simple_cartesian<float>::Point_3>(mesh, list.points);
  const SP::Distortion_summary s = SP::measure_distortion(mesh, sphere);
  EXPECT_EQ(s.number_of_faces, 7u);
  EXPECT_EQ(s.number_of_inverted_faces, 0u);
  EXPECT_EQ(s.radius, 1.);
  EXPECT_NEAR(s.isometric.maximum, 1., 1e-15);
}

TEST(Measure_distortion_interface, of_an_empty_mesh)
{
  const Surface_mesh mesh;
  const SP::Distortion_summary s = SP::measure_distortion(mesh, mesh.points(), 1.);
  EXPECT_EQ(s.number_of_faces, 0u);
  EXPECT_EQ(s.isometric.maximum, 0.);
  EXPECT_EQ(s.isometric.average, 0.);
  EXPECT_EQ(s.isometric.deviation, 0.);
  EXPECT_EQ(s.radius, 0.);
}

} // namespace
