// The surface as flat arrays: rings, numbering, areas and refusals of Surface, the rest shapes of faces, areas and
// weights.

#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include "indexed_meshes.h"
#include "long_doubles.h"
#include "random_meshes.h"

using namespace test;

namespace {

using namespace SP::internal;
using test::surface_of;

constexpr double any_weight = std::numeric_limits<double>::lowest();

TEST(Surface, keeps_the_triangles_and_their_orientation)
{
  for(const Triangle_list& list : spheres())
  {
    const Surface mesh = surface_of(list);
    ASSERT_EQ(mesh.number_of_vertices(), list.points.size());
    expect_simplicial_sphere(mesh.rings());
    EXPECT_EQ(sorted(mesh.callers_triangles()), sorted(index_triangles(list)));
  }
}

TEST(Surface, numbers_neighbors_close_to_each_other)
{
  // breadth first: a vertex is met from an earlier one, and the rings of earlier vertices come first
  const Surface mesh = surface_of(bumpy_sphere(3));
  std::uint32_t last_parent = 0;
  for(std::uint32_t v = 1; v < mesh.number_of_vertices(); ++v)
  {
    const Vertex_rings::Ring ring = mesh.rings().ring(v);
    const std::uint32_t parent = *std::min_element(ring.begin(), ring.end());
    EXPECT_LT(parent, v);
    EXPECT_GE(parent, last_parent);
    last_parent = parent;
  }
}

TEST(Surface, has_the_area_of_the_unit_sphere)
{
  for(const double size : {1., 1e-3, 1e7, 1e-200, 1e200, 1e-300, 3e307})
  {
    const Triangle_list list = scaled(octahedron(), size, size, size);
    const Surface mesh = surface_of(list);
    double sum = 0.;
    mesh.rings().for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      sum += area(mesh.points()[a], mesh.points()[b], mesh.points()[c]);
    });
    EXPECT_NEAR(sum, 4. * pi, 1e-13);
    // eight triangles of sides sqrt(2): area 4 sqrt(3) = 4 pi r^2
    const double radius = std::sqrt(std::sqrt(3.) / pi) * size;
    EXPECT_NEAR(mesh.equal_area_radius() / radius, 1., 1e-14);
    EXPECT_NEAR(mesh.unit().scaled_radius(radius), 1., 1e-14);
    EXPECT_NEAR(mesh.unit().scaled_radius(0.125 * radius), 0.125, 1e-15);
  }
}

TEST(Surface, counts_flat_faces)
{
  EXPECT_EQ(surface_of(icosphere(2)).number_of_flat_faces(), 0u);
  // A vertex in the middle of an edge of an octahedron: one face of the edge is split, and one without area joins the
  // other.
  Triangle_list list = octahedron();
  list.points.push_back({0.5, 0.5, 0.});
  list.triangles[0] = {0, 6, 4};
  list.triangles.push_back({6, 2, 4});
  list.triangles.push_back({0, 2, 6});
  EXPECT_EQ(surface_of(list).number_of_flat_faces(), 1u);
  // a surface without area
  const Triangle_list segment = scaled(icosphere(1), 1., 0., 0.);
  const Surface mesh = surface_of(segment);
  EXPECT_EQ(mesh.number_of_flat_faces(), segment.triangles.size());
  for(const Vector_3d& p : mesh.points())
    EXPECT_TRUE(std::isfinite(p[0] + p[1] + p[2]));
  const Triangle_list point = scaled(icosphere(1), 0., 0., 0.);
  EXPECT_EQ(surface_of(point).number_of_flat_faces(), point.triangles.size());
}

// the sum of the squares of the singular values, and their product
struct Reference
{
  long double i, d;

  static Reference of(const std::array<Vector_3d, 3>& from, const std::array<Vector_3d, 3>& to)
  {
    const auto [s1, s2] = singular_values(from, to);
    return {s1 * s1 + s2 * s2, s1 * s2};
  }
};

void expect_invariants(const Rest_triangle& rest, const std::array<Vector_3d, 3>& image, const Reference& reference,
                       double tolerance)
{
  const Long_vector e0 = long_difference(image[2], image[1]), e1 = long_difference(image[0], image[2]),
                    e2 = long_difference(image[1], image[0]);
  const long double i =
      rest.opposite_0 * long_dot(e0, e0) + rest.opposite_1 * long_dot(e1, e1) + rest.opposite_2 * long_dot(e2, e2);
  const long double d = long_norm_of_cross(e1, e2) * rest.inverse_doubled_area;
  EXPECT_NEAR(static_cast<double>(i / reference.i), 1., tolerance);
  EXPECT_NEAR(static_cast<double>(d / reference.d), 1., tolerance);
}

TEST(Rest_triangle, gives_the_singular_values_of_the_linear_map)
{
  Random random(1);
  for(int k = 0; k < 1000; ++k)
  {
    std::array<Vector_3d, 3> p, u;
    for(std::size_t j = 0; j < 3; ++j)
    {
      p[j] = random.in_cube();
      u[j] = random.in_cube();
    }
    if(k % 3 == 0) // thin, but not lifted
    {
      const double t = random.between(0., 1.);
      for(std::size_t i = 0; i < 3; ++i)
        p[2][i] = p[0][i] + t * (p[1][i] - p[0][i]) + 1e-3 * p[2][i];
    }
    if(Rest_triangle::is_too_flat(p[0], p[1], p[2]))
      continue;
    Rest_triangle rest = Rest_triangle::from_points(p[0], p[1], p[2]);
    const Reference reference = Reference::of(p, u);
    expect_invariants(rest, u, reference, 1e-8);

    // a larger triangle of the same shape
    const double factor = random.between(0.1, 10.);
    rest.scale_area(factor);
    expect_invariants(rest, u, {reference.i / factor, reference.d / factor}, 1e-8);
  }
}

// A face with a height below the minimum counts as the triangle with this height: same longest edge, same foot; one without height as
// one that is a fifth as high as its longest edge is long.
TEST(Rest_triangle, lifts_a_flat_face_to_the_minimum_height)
{
  Random random(3);
  for(int k = 0; k < 300; ++k)
  {
    const double size = std::pow(10., -static_cast<double>(k % 9)), foot = random.between(0., 1.);
    const double heights[] = {0., 2e-12, 1e-6, 0.99 * Rest_limits().min_height};
    const std::array<Vector_3d, 3> flat = {Vector_3d{0., 0., 0.}, Vector_3d{size, 0., 0.},
                                           Vector_3d{foot * size, heights[k % 4] * size, 0.}};
    const double height = k % 4 == 0 ? 0.2 : Rest_limits().min_height;
    const std::array<Vector_3d, 3> lifted = {flat[0], flat[1], Vector_3d{foot * size, height * size, 0.}};
    for(std::size_t j = 0; j < 3; ++j) // whichever corner comes first
    {
      const Vector_3d &a = flat[j], &b = flat[(j + 1) % 3], &c = flat[(j + 2) % 3];
      EXPECT_TRUE(Rest_triangle::is_too_flat(a, b, c));
      const std::array<Vector_3d, 3> same = {lifted[j], lifted[(j + 1) % 3], lifted[(j + 2) % 3]};
      expect_invariants(Rest_triangle::from_points(a, b, c), same, {2.L, 1.L}, 1e-6);
    }
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
    ASSERT_TRUE(std::isfinite(r.inverse_doubled_area) && r.inverse_doubled_area > 0.);
    const long double area = 1.L / r.inverse_doubled_area;
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
  const double h = Rest_limits().min_height;
  EXPECT_TRUE(Rest_triangle::is_too_flat({0., 0., 0.}, {1., 0., 0.}, {0.3, 0.9999 * h, 0.}));
  EXPECT_FALSE(Rest_triangle::is_too_flat({0., 0., 0.}, {1., 0., 0.}, {0.3, 1.0001 * h, 0.}));
  const Vector_3d apex = {0.4e-3, 0.31e-3, 0.};
  expect_invariants(Rest_triangle::from_points(a, b, apex, limits), {a, b, apex}, {2.L, 1.L}, 1e-8);
  const double edge = 2e-3;
  const std::array<Vector_3d, 3> equilateral = {a, Vector_3d{edge, 0., 0.},
                                                Vector_3d{0.5 * edge, std::sqrt(0.75) * edge, 0.}};
  expect_invariants(Rest_triangle::from_points(a, b, c, {0.3, edge, false}), equilateral, {2.L, 1.L}, 1e-8);

  // without regard to the surface, all faces are the same
  const Rest_triangle uniform = Rest_triangle::from_points(a, b, c, {0., 0., true});
  const Rest_triangle of_another = Rest_triangle::from_points({3., 0., 0.}, a, a, {0., 0., true});
  EXPECT_EQ(uniform.inverse_doubled_area, of_another.inverse_doubled_area);
  EXPECT_EQ(uniform.opposite_0, of_another.opposite_1);
  EXPECT_EQ(uniform.opposite_0, uniform.opposite_2);
}

TEST(Vertex_masses, are_there_without_an_area)
{
  const Surface mesh = surface_of(bumpy_sphere(1));
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

double cotangent(const Vector_3d& apex, const Vector_3d& p, const Vector_3d& q)
{
  return dot(difference(p, apex), difference(q, apex)) / norm(cross(difference(p, apex), difference(q, apex)));
}

TEST(Cotangent_weights, are_half_the_sums_of_the_cotangents)
{
  for(const Triangle_list& list : {bumpy_sphere(2), with_tentacle(20, 1.)})
  {
    const Surface mesh = surface_of(list);
    const Vertex_rings& rings = mesh.rings();
    const std::vector<Vector_3d>& points = mesh.points();
    const std::vector<double> weights = cotangent_weights(rings, points, any_weight),
                              positive = cotangent_weights(rings, points, min_positive_weight);
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
        EXPECT_EQ(raised, (std::max)(weight, min_positive_weight));
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
  for(const Triangle_list& list :
      {scaled(icosphere(1), 1., 1., 0.), scaled(icosphere(1), 1., 0., 0.), scaled(icosphere(1), 0., 0., 0.)})
  {
    const Surface mesh = surface_of(list);
    for(const double weight : cotangent_weights(mesh.rings(), mesh.points(), min_positive_weight))
    {
      EXPECT_TRUE(std::isfinite(weight));
      EXPECT_GE(weight, min_positive_weight);
    }
  }
}

} // namespace
