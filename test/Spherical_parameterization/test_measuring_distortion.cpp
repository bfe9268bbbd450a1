// The distortion of a map: against singular values in extended precision, for faces of every shape and size, and what is said
// of faces that have none.

#include "long_doubles.h"
#include "methods.h"
#include "random_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

using namespace test;

namespace {

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The summary and the values of all faces, in the order of the faces.
struct Measurement
{
  SP::Distortion_summary summary;
  std::vector<SP::Face_distortion> faces;
};

Measurement measure(const Triangle_list& list, const Images& images)
{
  const Mesh mesh = make(list);
  const auto distortion = get(CGAL::dynamic_face_property_t<SP::Face_distortion>(), mesh);
  Measurement result;
  result.summary = distortion_of(mesh, Point_map(mesh, images), distortion);
  for(const auto f : faces(mesh))
    result.faces.push_back(get(distortion, f));
  return result;
}

// the distortions of a triangle
struct Reference
{
  long double isometric, area, angle;

  static Reference of(const Triangle_list& list, const Images& images, const Triangle& t)
  {
    const auto [s1, s2] = singular_values({list.points[t[0]], list.points[t[1]], list.points[t[2]]},
                                          {images[t[0]], images[t[1]], images[t[2]]});
    return {(std::max)(s2, 1.L / s1), s1 * s2 + 1.L / (s1 * s2), s2 / s1 + s1 / s2};
  }
};

void expect_relative(double value, long double reference, double tolerance)
{
  EXPECT_NEAR(value, static_cast<double>(reference), tolerance * static_cast<double>(std::abs(reference)));
}

using Corners = std::array<Coordinates, 3>;

// A tetrahedron whose first face, number 0, has these corners; the fourth vertex is where it is in tetrahedron().
Triangle_list with_triangle(const Corners& corners)
{
  Triangle_list list = tetrahedron();
  std::copy(corners.begin(), corners.end(), list.points.begin());
  return list;
}

void expect_distortion(const SP::Face_distortion& f, const Reference& reference, double tolerance)
{
  expect_relative(f.isometric, reference.isometric, tolerance);
  expect_relative(f.area, reference.area, tolerance);
  expect_relative(f.angle, reference.angle, tolerance);
}

// of a triangle that is not inverted
void expect_distortion(const Corners& corners, const Corners& image, const Reference& reference, double tolerance)
{
  const SP::Face_distortion f = measure(with_triangle(corners), with_triangle(image).points).faces[0];
  expect_distortion(f, reference, tolerance);
  EXPECT_FALSE(f.is_inverted);
}

TEST(Distortion, of_a_similarity_is_its_factor)
{
  const Triangle_list list = random_stacked_sphere(30, 1);
  for(const double r : {1., 0.25, 3.})
  {
    const SP::Distortion_summary s = measure(list, scaled(list.points, r)).summary;
    const double iso = (std::max)(r, 1. / r), area = r * r + 1. / (r * r);
    EXPECT_NEAR(s.radius, r, 1e-14);
    EXPECT_NEAR(s.balanced_radius, 1., 1e-12);
    EXPECT_NEAR(s.isometric.maximum, iso, 1e-11);
    EXPECT_NEAR(s.isometric.average, iso, 1e-12);
    EXPECT_NEAR(s.isometric.deviation, 0., 1e-11);
    EXPECT_NEAR(s.area.maximum, area, 1e-10);
    EXPECT_NEAR(s.area.average, area, 1e-11);
    EXPECT_NEAR(s.angle.maximum, 2., 1e-11);
    EXPECT_EQ(s.number_of_faces, list.triangles.size());
    EXPECT_EQ(s.number_of_inverted_faces, 0u);
    EXPECT_EQ(s.number_of_degenerate_faces, 0u);
  }
}

TEST(Precise_distortion, of_stretched_faces)
{
  // by 4 along x and by 1/2 along y; the other way round, s1 = 1/4 decides
  const Corners corners = {{{0, 0, 1}, {1, 0, 1}, {0.25, 1, 1}}}, stretched = {{{0, 0, 1}, {4, 0, 1}, {1, 0.5, 1}}};
  expect_distortion(corners, stretched, {4.L, 2.5L, 8.125L}, 1e-15);
  expect_distortion(stretched, corners, {4.L, 2.5L, 8.125L}, 1e-15);
  // The edges are 2^-40, exactly, at a distance of 1; a formula on the points instead of their differences sees noise.
  const double h = 0x1p-40;
  expect_distortion({{{0, 0, 1}, {h, 0, 1}, {0, h, 1}}}, {{{0, 0, 1}, {3 * h, 0, 1}, {0, h, 1}}},
                    {3.L, 3.L + 1.L / 3.L, 3.L + 1.L / 3.L}, 1e-15);
  // s2 / s1 = 1e12: the difference of two sums of squares would leave nothing of s1.
  expect_distortion({{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}, {{{0, 0, 1}, {1e6, 0, 1}, {0, 1e-6, 1}}}, {1e6L, 2.L, 1e12L},
                    1e-14);
}

TEST(Distortion, is_that_of_the_singular_values_and_summed_up)
{
  const Triangle_list list = ellipsoid(1., 2., 0.3, 2);
  Images images = icosphere(2).points;
  images[5] = scaled({images[5]}, -1.)[0]; // a vertex of degree 5
  const Measurement m = measure(list, images);
  ASSERT_EQ(m.faces.size(), list.triangles.size());
  std::size_t n_inverted = 0;
  for(std::size_t i = 0; i < m.faces.size(); ++i)
  {
    expect_distortion(m.faces[i], Reference::of(list, images, list.triangles[i]), 1e-13);
    n_inverted += m.faces[i].is_inverted;
  }
  EXPECT_EQ(n_inverted, 5u);
  EXPECT_EQ(m.summary.number_of_inverted_faces, 5u);

  const double n = static_cast<double>(m.faces.size());
  const auto expect_statistics = [&](const SP::Distortion_statistics& statistics, double SP::Face_distortion::*value) {
    double maximum = 0., sum = 0., squares = 0.;
    for(const SP::Face_distortion& f : m.faces)
    {
      maximum = (std::max)(maximum, f.*value);
      sum += f.*value;
    }
    for(const SP::Face_distortion& f : m.faces)
      squares += (f.*value - sum / n) * (f.*value - sum / n);
    EXPECT_EQ(statistics.maximum, maximum);
    EXPECT_NEAR(statistics.average, sum / n, 1e-12 * sum / n);
    EXPECT_NEAR(statistics.deviation, std::sqrt(squares / n), 1e-12 * sum / n);
    EXPECT_GT(statistics.deviation, 0.);
  };
  expect_statistics(m.summary.isometric, &SP::Face_distortion::isometric);
  expect_statistics(m.summary.area, &SP::Face_distortion::area);
  expect_statistics(m.summary.angle, &SP::Face_distortion::angle);
}

TEST(Distortion, leaves_degenerate_faces_out)
{
  // A face of height 0, or next to the bound: twice its area is below, or above, 1e-12 times the square of its longest edge.
  for(const double height : {0., 0.9e-12, 1.1e-12})
  {
    const Triangle_list list = with_triangle({{{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}}});
    const Measurement m = measure(list, tetrahedron().points);
    const bool is_degenerate = height < 1e-12;
    EXPECT_EQ(m.summary.number_of_degenerate_faces, is_degenerate ? 1u : 0u);
    EXPECT_EQ(m.summary.number_of_inverted_faces, 0u);
    for(const double value : {m.faces[0].isometric, m.faces[0].area, m.faces[0].angle})
      EXPECT_EQ(std::isinf(value), is_degenerate);
    double maximum = is_degenerate ? 0. : m.faces[0].isometric;
    for(std::size_t f = 1; f < 4; ++f)
      maximum = (std::max)(maximum, m.faces[f].isometric);
    EXPECT_EQ(m.summary.isometric.maximum, maximum);
  }
}

TEST(Distortion, of_a_collapsed_image_is_infinite)
{
  const Triangle_list list = icosphere(1);
  Images images = list.points;
  images[list.triangles[7][0]] = images[list.triangles[7][1]];
  const Measurement m = measure(list, images);
  for(const double value : {m.faces[7].isometric, m.faces[7].area, m.faces[7].angle, m.summary.isometric.maximum,
                            m.summary.isometric.average, m.summary.isometric.deviation})
    EXPECT_EQ(value, infinity);
  EXPECT_TRUE(m.faces[7].is_inverted);
  EXPECT_EQ(m.summary.number_of_degenerate_faces, 0u);
  // all at one point
  const SP::Distortion_summary s = measure(list, Images(list.points.size(), Coordinates{0., 0., 1.})).summary;
  EXPECT_EQ(s.isometric.average, infinity);
  EXPECT_EQ(s.number_of_inverted_faces, list.triangles.size());
  EXPECT_EQ(s.radius, 1.);
}

TEST(Precise_distortion, of_random_triangles_of_every_shape)
{
  // Vertices with coordinates of 20 bits: the edges are exact, so the needles' heights are what the reference takes
  // them for.
  Random random(6);
  const auto coordinate = [&](int exponent) {
    return std::ldexp(static_cast<double>(random.below(1u << 20)), -20 - exponent);
  };
  for(int i = 0; i < 500; ++i)
  {
    const int e1 = static_cast<int>(random.below(24));
    const int e2 = static_cast<int>(random.below(24));
    const Coordinates far = {1. + coordinate(0), coordinate(0), coordinate(0)};
    const Coordinates near = {coordinate(e1), coordinate(e1), coordinate(e1)};
    const Triangle_list list = with_triangle({{{0., 0., 0.}, far, near}});
    Images images = list.points;
    images[0] = {0., 0., 1.};
    images[1] = {coordinate(e2), coordinate(e2), 1. + coordinate(e2)};
    images[2] = {coordinate(0), coordinate(0), 1. + coordinate(0)};
    // a short edge does not cost a digit; heights over all edges stay above 1e-4 here with few exceptions
    expect_distortion(measure(list, images).faces[0], Reference::of(list, images, list.triangles[0]), 1e-11);
  }
}

TEST(Precise_distortion, of_needles)
{
  // A face of height h over a base of 1 or with a short edge h, doubled in height: s1 = 1, s2 = 2.
  const auto expect_doubled = [](Corners corners, double tolerance) {
    Corners image = corners;
    for(Coordinates& p : image)
      p[1] *= 2.;
    expect_distortion(corners, image, {2.L, 2.5L, 2.5L}, tolerance);
  };
  for(const double h : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10})
  {
    expect_doubled({{{0, 0, 1}, {1, 0, 1}, {0.4375, h, 1}}}, 1e-15 / h);
    Corners needle = {{{0, 0, 1}, {1, 0, 1}, {0.25 * h, h, 1}}};
    for(int turn = 0; turn < 3; ++turn)
    {
      expect_doubled(needle, 1e-14);
      std::rotate(needle.begin(), needle.begin() + 1, needle.end());
    }
  }
}

TEST(Distortion, does_not_depend_on_the_unit)
{
  const Triangle_list list = ellipsoid(1., 2., 0.3, 1);
  const Images sphere = icosphere(1).points;
  const SP::Distortion_summary expected = measure(list, sphere).summary;
  for(const int exponent : {-1000, -500, 500, 1000})
  {
    const double s = std::ldexp(1., exponent);
    const SP::Distortion_summary summary = measure(test_meshes::scaled(list, s, s, s), scaled(sphere, s)).summary;
    EXPECT_EQ(summary.isometric.maximum, expected.isometric.maximum);
    EXPECT_EQ(summary.isometric.average, expected.isometric.average);
    EXPECT_EQ(summary.area.average, expected.area.average);
    EXPECT_EQ(summary.angle.average, expected.angle.average);
    EXPECT_EQ(summary.radius, s * expected.radius);
    EXPECT_EQ(summary.balanced_radius, s * expected.balanced_radius);
    EXPECT_EQ(summary.number_of_degenerate_faces, 0u);
    EXPECT_EQ(summary.number_of_inverted_faces, 0u);
  }
  // The factor itself: huge surfaces on the unit sphere, and tiny ones.
  for(const double s : {1e-150, 1e150})
  {
    const SP::Distortion_summary summary = measure(test_meshes::scaled(icosphere(1), s, s, s), sphere).summary;
    expect_relative(summary.isometric.average, 1e150L, 1e-13);
    expect_relative(summary.balanced_radius, s, 1e-13);
    expect_relative(summary.area.average, 1e300L, 1e-13);
    expect_relative(summary.angle.average, 2.L, 1e-13);
  }
}

TEST(Distortion, of_coordinates_that_are_not_finite)
{
  const Triangle_list list = icosphere(1);
  for(const double x : {infinity, -infinity, std::nan("")})
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

TEST(Distortion, is_measured_with_the_points_given)
{
  const Mesh mesh = make(ellipsoid(1., 2., 0.3, 1));
  const Point_map sphere(mesh, icosphere(1).points), half(mesh, scaled(points(mesh), 0.5));
  const auto distortion = get(CGAL::dynamic_face_property_t<SP::Face_distortion>(), mesh);
  const auto np = CGAL::parameters::vertex_point_map(half);
  const SP::Distortion_summary plain = distortion_of(mesh, sphere), of_half = distortion_of(mesh, sphere, np);
  EXPECT_NE(of_half.isometric.average, plain.isometric.average);
  EXPECT_EQ(distortion_of(mesh, sphere, distortion).isometric.average, plain.isometric.average);
  EXPECT_EQ(distortion_of(mesh, sphere, distortion, np).isometric.average, of_half.isometric.average);
}

// A mesh with exact points, and images of type float, which need not be closed.
TEST(Distortion, of_different_kernels_and_open_meshes)
{
  Triangle_list list = octahedron();
  list.triangles.pop_back();
  list.points.push_back({9., 9., 9.}); // isolated: neither its image nor its point matters
  const auto mesh = make_mesh<CGAL::Surface_mesh<Epeck::Point_3>>(list);
  const auto sphere = make_vertex_map<CGAL::Simple_cartesian<float>::Point_3>(mesh, list.points);
  const SP::Distortion_summary s = distortion_of(mesh, sphere);
  EXPECT_EQ(s.number_of_faces, 7u);
  EXPECT_EQ(s.number_of_inverted_faces, 0u);
  EXPECT_EQ(s.radius, 1.);
  EXPECT_NEAR(s.isometric.maximum, 1., 1e-15);
}

// 0 would be better than an isometry.
TEST(Distortion, of_a_surface_without_area_is_infinite)
{
  const Triangle_list list = icosphere(1);
  const SP::Distortion_summary s = measure(test_meshes::scaled(list, 0., 1., 0.), list.points).summary;
  EXPECT_EQ(s.number_of_degenerate_faces, list.triangles.size());
  EXPECT_EQ(s.radius, 1.);
  for(const SP::Distortion_statistics& statistics : {s.isometric, s.area, s.angle})
    for(const double value : {statistics.maximum, statistics.average, statistics.deviation})
      EXPECT_EQ(value, infinity);
}

// Faces that are not triangles are data, not a mistake of the caller's program.
TEST(Distortion, of_polygons_and_of_nothing_is_refused)
{
  for(const Mesh& mesh : {cube(), Mesh()})
  {
    const SP::Error_code expected = mesh.is_empty() ? SP::ERROR_EMPTY_MESH : SP::ERROR_NON_TRIANGULAR_MESH;
    const auto distortion = get(CGAL::dynamic_face_property_t<SP::Face_distortion>(), mesh);
    SP::Distortion_summary s;
    s.radius = 7.;
    EXPECT_EQ(SP::measure_distortion(mesh, mesh.points(), s), expected);
    EXPECT_EQ(SP::measure_distortion(mesh, mesh.points(), s, distortion), expected);
    EXPECT_EQ(s.radius, 7.);
  }
}

} // namespace
