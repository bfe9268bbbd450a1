// The geometric building blocks: the rest shape of a face, the frame at a point of the sphere, the kernel of a hole.

#include <CGAL/Spherical_parameterization/internal/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/Star_kernel.h>
#include <CGAL/Spherical_parameterization/internal/Tangent_frame.h>
#include <CGAL/Spherical_parameterization/internal/is_safely_positive.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using SP::internal::Rest_limits;
using SP::internal::Rest_triangle;
using SP::internal::Star_kernel;
using SP::internal::Tangent_frame;
using SP::internal::Vector_3d;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

constexpr double pi = 3.14159265358979323846;

double uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * static_cast<double>(random()) / 0x1p32;
}

Vector_3d random_vector(std::mt19937& random)
{
  return {uniform(random, -1., 1.), uniform(random, -1., 1.), uniform(random, -1., 1.)};
}

using Long_vector = std::array<long double, 3>;

Long_vector difference(const Vector_3d& a, const Vector_3d& b)
{
  return {static_cast<long double>(a[0]) - b[0], static_cast<long double>(a[1]) - b[1],
          static_cast<long double>(a[2]) - b[2]};
}

long double dot(const Long_vector& a, const Long_vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// whether (a, b, c) is positively oriented about the origin, by an exact predicate
bool is_positive(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c)
{
  return CGAL::orientation(Point_3(0., 0., 0.), Point_3(a[0], a[1], a[2]), Point_3(b[0], b[1], b[2]),
                           Point_3(c[0], c[1], c[2])) == CGAL::POSITIVE;
}

// A triangle in the plane as (base, foot of the height on the base, height), all in units of length.
struct Flat_triangle
{
  long double base, foot, height;

  static Flat_triangle of(const std::array<Vector_3d, 3>& p)
  {
    const Long_vector e = difference(p[1], p[0]), f = difference(p[2], p[0]);
    const long double base = std::sqrt(dot(e, e)), foot = dot(e, f) / base;
    const Long_vector h = {f[0] - foot / base * e[0], f[1] - foot / base * e[1], f[2] - foot / base * e[2]};
    return {base, foot, std::sqrt(dot(h, h))};
  }
};

// The sum of the squares of the singular values, and their product, of the linear map between two triangles: those of
// its matrix in orthonormal coordinates of both planes.
struct Reference
{
  long double i, d;

  static Reference of(const Flat_triangle& from, const Flat_triangle& to)
  {
    const long double xx = to.base / from.base;
    const long double yy = to.height / from.height;
    const long double xy = (to.foot - from.foot * xx) / from.height;
    // the singular values by a rotation, not from the trace and the determinant
    const long double angle = 0.5L * std::atan2(2.L * xx * xy, xx * xx - xy * xy - yy * yy);
    const long double c = std::cos(angle), s = std::sin(angle);
    const long double s1 = std::hypot(c * xx + s * xy, s * yy), s2 = std::hypot(-s * xx + c * xy, c * yy);
    return {s1 * s1 + s2 * s2, s1 * s2};
  }
};

void expect_invariants(const Rest_triangle& rest, const std::array<Vector_3d, 3>& image, const Reference& reference,
                       double tolerance)
{
  const Long_vector e0 = difference(image[2], image[1]), e1 = difference(image[0], image[2]),
                    e2 = difference(image[1], image[0]);
  const Long_vector n = {e1[1] * e2[2] - e1[2] * e2[1], e1[2] * e2[0] - e1[0] * e2[2], e1[0] * e2[1] - e1[1] * e2[0]};
  const long double i = rest.opposite_0 * dot(e0, e0) + rest.opposite_1 * dot(e1, e1) + rest.opposite_2 * dot(e2, e2);
  const long double d = std::sqrt(dot(n, n)) * rest.inverse_area;
  EXPECT_NEAR(static_cast<double>(i / reference.i), 1., tolerance);
  EXPECT_NEAR(static_cast<double>(d / reference.d), 1., tolerance);
}

TEST(Rest_triangle, gives_the_singular_values_of_the_linear_map)
{
  std::mt19937 random(1);
  for(int k = 0; k < 1000; ++k)
  {
    std::array<Vector_3d, 3> p, u;
    for(std::size_t j = 0; j < 3; ++j)
    {
      p[j] = random_vector(random);
      u[j] = random_vector(random);
    }
    if(k % 3 == 0) // thin, but not lifted
    {
      const double t = uniform(random, 0., 1.);
      for(std::size_t i = 0; i < 3; ++i)
      {
        p[2][i] = p[0][i] + t * (p[1][i] - p[0][i]) + 1e-3 * p[2][i];
      }
    }
    if(Rest_triangle::is_too_flat(p[0], p[1], p[2]))
    {
      continue;
    }
    Rest_triangle rest = Rest_triangle::from_points(p[0], p[1], p[2]);
    const Reference reference = Reference::of(Flat_triangle::of(p), Flat_triangle::of(u));
    expect_invariants(rest, u, reference, 1e-8);

    // a larger triangle of the same shape
    const double factor = uniform(random, 0.1, 10.);
    rest.scale_area(factor);
    expect_invariants(rest, u, {reference.i / factor, reference.d / factor}, 1e-8);
  }
}

TEST(Rest_triangle, of_an_isometry_gives_two_and_one)
{
  std::mt19937 random(2);
  for(int k = 0; k < 100; ++k)
  {
    const std::array<Vector_3d, 3> p = {random_vector(random), random_vector(random), random_vector(random)};
    if(!Rest_triangle::is_too_flat(p[0], p[1], p[2]))
    {
      expect_invariants(Rest_triangle::from_points(p[0], p[1], p[2]), p, {2.L, 1.L}, 1e-8);
    }
  }
}

// A face with a height below the least one counts as the triangle with this height: same longest edge, same foot.
TEST(Rest_triangle, lifts_a_flat_face_to_the_least_height)
{
  std::mt19937 random(3);
  for(int k = 0; k < 300; ++k)
  {
    const double size = std::pow(10., -static_cast<double>(k % 9)), foot = uniform(random, 0., 1.);
    const double heights[] = {0., 1e-12, 1e-6, 0.99 * Rest_limits().height};
    const std::array<Vector_3d, 3> flat = {Vector_3d{0., 0., 0.}, Vector_3d{size, 0., 0.},
                                           Vector_3d{foot * size, heights[k % 4] * size, 0.}};
    const std::array<Vector_3d, 3> lifted = {flat[0], flat[1], Vector_3d{foot * size, Rest_limits().height * size, 0.}};
    for(std::size_t j = 0; j < 3; ++j) // whichever corner comes first
    {
      const Vector_3d &a = flat[j], &b = flat[(j + 1) % 3], &c = flat[(j + 2) % 3];
      EXPECT_TRUE(Rest_triangle::is_too_flat(a, b, c));
      const std::array<Vector_3d, 3> same = {lifted[j], lifted[(j + 1) % 3], lifted[(j + 2) % 3]};
      expect_invariants(Rest_triangle::from_points(a, b, c), same, {2.L, 1.L}, 1e-6);
    }
  }
}

TEST(Rest_triangle, does_not_jump_at_the_least_height)
{
  for(const double foot : {0.1, 0.5, 0.9})
  {
    const double h = Rest_limits().height;
    const Vector_3d a = {0., 0., 0.}, b = {1., 0., 0.}, below = {foot, 0.9999 * h, 0.}, above = {foot, 1.0001 * h, 0.};
    EXPECT_TRUE(Rest_triangle::is_too_flat(a, b, below));
    EXPECT_FALSE(Rest_triangle::is_too_flat(a, b, above));
    const Rest_triangle r = Rest_triangle::from_points(a, b, below), s = Rest_triangle::from_points(a, b, above);
    EXPECT_NEAR(r.opposite_0 / s.opposite_0, 1., 1e-3);
    EXPECT_NEAR(r.opposite_1 / s.opposite_1, 1., 1e-3);
    EXPECT_NEAR(r.opposite_2 / s.opposite_2, 1., 1e-3);
    EXPECT_NEAR(r.inverse_area / s.inverse_area, 1., 1e-3);
  }
}

// The sums of cotangents that make I a positive definite function of the edges, for the worst of faces.
TEST(Rest_triangle, is_a_triangle_whatever_the_face)
{
  const Vector_3d a = {0.3, -0.2, 0.7}, b = {0.3, -0.2, 0.7 + 0x1p-45}, c = {1e-7, 2., -1.}, d = {2e-7, 4., -2.};
  const Vector_3d o = {0., 0., 0.};
  const std::array<std::array<Vector_3d, 3>, 8> faces = {
      {{a, a, a}, {a, a, c}, {c, a, a}, {a, b, c}, {o, c, d}, {d, o, c}, {a, b, a}, {o, {1e-200, 0., 0.}, o}}};
  for(const auto& p : faces)
  {
    EXPECT_TRUE(Rest_triangle::is_too_flat(p[0], p[1], p[2]));
    const Rest_triangle r = Rest_triangle::from_points(p[0], p[1], p[2]);
    ASSERT_TRUE(std::isfinite(r.opposite_0) && std::isfinite(r.opposite_1) && std::isfinite(r.opposite_2));
    ASSERT_TRUE(std::isfinite(r.inverse_area) && r.inverse_area > 0.);
    const long double area = 1.L / r.inverse_area;
    const long double x = r.opposite_0 * area, y = r.opposite_1 * area, z = r.opposite_2 * area; // the cotangents
    EXPECT_NEAR(static_cast<double>(x * y + y * z + z * x), 1., 1e-6);
    EXPECT_GT(x + y, 0.);
    EXPECT_GT(y + z, 0.);
    EXPECT_GT(z + x, 0.);
    if(p[0] == p[1] && p[1] == p[2]) // what has no shape asks for none
    {
      EXPECT_EQ(r.opposite_0, r.opposite_1);
      EXPECT_EQ(r.opposite_1, r.opposite_2);
    }
  }
}

// With other limits, what is below them counts as being at the limit, and what is above remains as it is.
TEST(Rest_triangle, keeps_to_the_limits_given)
{
  const Vector_3d a = {0., 0., 0.}, b = {1e-3, 0., 0.}, c = {0.4e-3, 0.2e-3, 0.}, lifted = {0.4e-3, 0.3e-3, 0.};
  const Rest_limits limits = {0.3, 1e-4, false};
  expect_invariants(Rest_triangle::from_points(a, b, c), {a, b, c}, {2.L, 1.L}, 1e-8);
  expect_invariants(Rest_triangle::from_points(a, b, c, limits), {a, b, lifted}, {2.L, 1.L}, 1e-8);
  const Vector_3d apex = {0.4e-3, 0.31e-3, 0.};
  expect_invariants(Rest_triangle::from_points(a, b, apex, limits), {a, b, apex}, {2.L, 1.L}, 1e-8);
  const double edge = 2e-3;
  const std::array<Vector_3d, 3> equilateral = {a, Vector_3d{edge, 0., 0.},
                                                Vector_3d{0.5 * edge, std::sqrt(0.75) * edge, 0.}};
  expect_invariants(Rest_triangle::from_points(a, b, c, {0.3, edge, false}), equilateral, {2.L, 1.L}, 1e-8);

  // without regard to the surface, all faces are the same
  const Rest_triangle uniform = Rest_triangle::from_points(a, b, c, {0., 0., true});
  const Rest_triangle of_another = Rest_triangle::from_points({3., 0., 0.}, a, a, {0., 0., true});
  EXPECT_EQ(uniform.inverse_area, of_another.inverse_area);
  EXPECT_EQ(uniform.opposite_0, of_another.opposite_1);
  EXPECT_EQ(uniform.opposite_0, uniform.opposite_2);
}

std::vector<Vector_3d> frame_origins()
{
  std::mt19937 random(4);
  std::vector<Vector_3d> result = {{0., 0., 1.},  {0., 0., -1.},  {1., 0., 0.},   {0., -1., 0.},
                                   {0., 1., -0.}, {-1., 0., -0.}, {0.6, 0.8, 0.}, {0.6, -0.8, -0.}};
  for(int k = 0; k < 200; ++k)
  {
    Vector_3d n = random_vector(random);
    if(k % 2 == 0) // near a pole or near the equator
    {
      const std::size_t axis = k % 4 == 0 ? 2 : 0;
      n[axis] *= 1e9;
      n[2] *= axis == 2 ? 1. : 1e-9;
    }
    result.push_back(SP::internal::normalized(n));
  }
  return result;
}

TEST(Tangent_frame, is_orthonormal_and_right_handed)
{
  for(const Vector_3d& n : frame_origins())
  {
    const Tangent_frame frame(n);
    // the axes, as differences of two points of the sphere that lie symmetric to the origin of the frame
    const Vector_3d x1 = frame.point_at(0.5, 0.), x0 = frame.point_at(-0.5, 0.);
    const Vector_3d y1 = frame.point_at(0., 0.5), y0 = frame.point_at(0., -0.5);
    const Long_vector x = difference(x1, x0), y = difference(y1, y0);
    EXPECT_NEAR(static_cast<double>(dot(x, x)), 1., 1e-15);
    EXPECT_NEAR(static_cast<double>(dot(y, y)), 1., 1e-15);
    EXPECT_NEAR(static_cast<double>(dot(x, y)), 0., 1e-15);
    EXPECT_NEAR(static_cast<double>(x[1] * y[2] - x[2] * y[1]), n[0], 2e-15);
    EXPECT_NEAR(static_cast<double>(x[2] * y[0] - x[0] * y[2]), n[1], 2e-15);
    EXPECT_NEAR(static_cast<double>(x[0] * y[1] - x[1] * y[0]), n[2], 2e-15);
  }
}

TEST(Tangent_frame, takes_a_point_to_its_offset_and_back)
{
  std::mt19937 random(5);
  for(const Vector_3d& n : frame_origins())
  {
    const Tangent_frame frame(n);
    for(const double size : {0.7, 1e-3, 1e-6, 1e-12})
    {
      const double x = size * uniform(random, -1., 1.), y = size * uniform(random, -1., 1.);
      const Vector_3d p = frame.point_at(x, y);
      EXPECT_NEAR(SP::internal::length(p), 1., 1e-15);
      const Vector_3d offset = frame.offset_of(p);
      EXPECT_NEAR(offset[0], x, 1e-15); // the rounding of p
      EXPECT_NEAR(offset[1], y, 1e-15);
      EXPECT_NEAR(offset[2], Tangent_frame::height_at(x, y), 1e-15);
    }
  }
}

// What makes tiny triangles work: the offset of a point that is near is as precise as the difference of the points.
TEST(Tangent_frame, keeps_the_relative_precision_of_small_offsets)
{
  std::mt19937 random(6);
  for(const Vector_3d& n : frame_origins())
  {
    const Tangent_frame frame(n);
    const double size = std::pow(10., -uniform(random, 2., 14.));
    const Vector_3d p = frame.point_at(size, -0.5 * size);
    const Long_vector difference_to_n = difference(p, n);
    const double length = static_cast<double>(std::sqrt(dot(difference_to_n, difference_to_n)));
    EXPECT_NEAR(SP::internal::length(frame.offset_of(p)) / length, 1., 2e-15);
  }
}

TEST(Tangent_frame, has_precise_heights)
{
  for(const double size : {0.9, 0.5, 1e-3, 1e-8, 1e-100})
  {
    const long double t = static_cast<long double>(size) * size;
    // -t / 2 - t^2 / 8 - t^3 / 16 where sqrt(1 - t) - 1 would cancel
    const long double reference = size > 0.01 ? std::sqrt(1.L - t) - 1.L : -t * (0.5L + t * (0.125L + t / 16.L));
    const double height = Tangent_frame::height_at(0.6 * size, -0.8 * size);
    EXPECT_NEAR(height, static_cast<double>(reference), 1e-15 * std::abs(height));
  }
}

// A hole whose faces, fanned out from its first vertex, are positive, and which is otherwise as irregular as can be.
std::vector<Vector_3d> random_hole(std::mt19937& random, double size)
{
  const Tangent_frame frame(SP::internal::normalized(random_vector(random)));
  const std::size_t n = 2 + random() % 9; // vertices other than the base
  std::vector<double> steps;
  double total = 0.;
  for(std::size_t j = 1; j < n; ++j)
  {
    steps.push_back(uniform(random, 0.1, 1.));
    total += steps.back();
  }
  // up to 340 degrees around the base, but less than 170 in one step
  const double largest = *std::max_element(steps.begin(), steps.end()) / total;
  const double turn = (std::min)(uniform(random, 0.2, 5.9), 2.9 / largest);
  double angle = uniform(random, 0., 2. * pi);
  std::vector<Vector_3d> hole = {frame.point_at(0., 0.)};
  for(std::size_t j = 0; j < n; ++j)
  {
    const double r = size * uniform(random, 0.1, 1.);
    hole.push_back(frame.point_at(r * std::cos(angle), r * std::sin(angle)));
    angle += j < steps.size() ? turn * steps[j] / total : 0.;
  }
  return hole;
}

TEST(Star_kernel, sees_all_edges_of_any_hole)
{
  std::mt19937 random(7);
  Star_kernel kernel; // one object for all holes, larger and smaller ones
  int n_holes = 0;
  for(int k = 0; k < 3000; ++k)
  {
    const double sizes[] = {0.9, 0.3, 1e-2, 1e-5, 1e-8};
    const std::vector<Vector_3d> hole = random_hole(random, sizes[k % 5]);
    bool is_fan = true; // on a sphere, a large triangle can be negative
    for(std::size_t j = 1; j + 1 < hole.size(); ++j)
    {
      is_fan = is_fan && is_positive(hole[0], hole[j], hole[j + 1]);
    }
    if(!is_fan)
    {
      continue;
    }
    ++n_holes;
    Vector_3d point;
    ASSERT_TRUE(kernel.find_point(hole, point)) << k;
    EXPECT_NEAR(SP::internal::length(point), 1., 1e-15);
    for(std::size_t j = 0; j < hole.size(); ++j)
    {
      ASSERT_TRUE(is_positive(point, hole[j], hole[(j + 1) % hole.size()])) << k;
    }
  }
  EXPECT_GT(n_holes, 2500);
}

TEST(Star_kernel, is_central_in_a_regular_hole)
{
  Star_kernel kernel;
  for(const double size : {0.1, 1e-3, 1e-7})
  {
    const Tangent_frame frame(SP::internal::normalized({1., -2., 0.5}));
    std::vector<Vector_3d> hole;
    for(int j = 0; j < 6; ++j)
    {
      hole.push_back(frame.point_at(size * std::cos(j * pi / 3.), size * std::sin(j * pi / 3.)));
    }
    Vector_3d point;
    ASSERT_TRUE(kernel.find_point(hole, point));
    EXPECT_LT(SP::internal::length(frame.offset_of(point)), 0.05 * size);
  }
}

TEST(Star_kernel, finds_nothing_where_there_is_nothing)
{
  Star_kernel kernel;
  const Tangent_frame frame({0., 0., 1.});
  const auto at = [&](double x, double y) { return frame.point_at(x, y); };
  Vector_3d point = {7., 7., 7.};
  // clockwise
  EXPECT_FALSE(kernel.find_point(std::vector<Vector_3d>{at(0., 0.), at(0., 0.1), at(0.1, 0.)}, point));
  // on one great circle
  EXPECT_FALSE(kernel.find_point(std::vector<Vector_3d>{at(0., 0.), at(0.1, 0.), at(0.2, 0.)}, point));
  // all at one place
  EXPECT_FALSE(kernel.find_point(std::vector<Vector_3d>(4, at(0.1, 0.2)), point));
  // a kernel that is there, but too narrow for doubles
  EXPECT_FALSE(kernel.find_point(std::vector<Vector_3d>{at(0., 0.), at(0.1, 0.), at(0.1, 1e-16)}, point));
  EXPECT_EQ(point, (Vector_3d{7., 7., 7.}));
}

// Faces that pass the test keep their orientation when their corners are scaled to any radius and rounded.
TEST(Is_safely_positive, is_safe_under_rounding)
{
  std::mt19937 random(8);
  int n_safe = 0, n_narrow = 0;
  for(int k = 0; k < 20000; ++k)
  {
    const Tangent_frame frame(SP::internal::normalized(random_vector(random)));
    const double size = std::pow(10., -uniform(random, 0.5, 8.)),
                 height = size * std::pow(10., -uniform(random, 0., 15.));
    const double t = uniform(random, 0., 1.);
    const Vector_3d a = frame.point_at(0., 0.), b = frame.point_at(size, 0.), c = frame.point_at(t * size, height);
    const Vector_3d p = frame.offset_of(b), q = frame.offset_of(c);
    const double determinant = p[0] * q[1] - p[1] * q[0]; // det(a, b, c) in the coordinates of the frame at a
    if(!SP::internal::is_safely_positive(determinant,
                                         SP::internal::squared_length(p) + SP::internal::squared_length(q)))
    {
      continue;
    }
    ++n_safe;
    n_narrow += height < 1e-12;
    const double radius = uniform(random, 0.1, 10.);
    EXPECT_TRUE(is_positive(a, b, c));
    EXPECT_TRUE(is_positive({radius * a[0], radius * a[1], radius * a[2]},
                            {radius * b[0], radius * b[1], radius * b[2]},
                            {radius * c[0], radius * c[1], radius * c[2]}));
  }
  EXPECT_GT(n_safe, 10000);
  EXPECT_GT(n_narrow, 500); // the test lets narrow faces pass as well
}

} // namespace
