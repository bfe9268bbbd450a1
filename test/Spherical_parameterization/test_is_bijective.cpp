#include <CGAL/Spherical_parameterization/internal/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>

#include "test_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using test_meshes::Coordinates;
using test_meshes::Triangle_list;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Double = CGAL::Simple_cartesian<double>;
using Float = CGAL::Simple_cartesian<float>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class Mesh>
class Is_bijective : public ::testing::Test
{
protected:
  using Point_3 =
      typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;

  // whether the map from a mesh with these triangles to these points is bijective
  static bool is_bijective(const Triangle_list& list, const std::vector<Coordinates>& images)
  {
    const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
    return SP::is_bijective(mesh, test_meshes::make_vertex_map<Point_3>(mesh, images));
  }

  static bool is_bijective(const Triangle_list& list) { return is_bijective(list, list.points); }
};

using Meshes =
    ::testing::Types<CGAL::Surface_mesh<Epick::Point_3>, CGAL::Surface_mesh<Float::Point_3>, CGAL::Polyhedron_3<Double>,
                     CGAL::Surface_mesh<Epeck::Point_3>, CGAL::Polyhedron_3<Exact>>;
TYPED_TEST_SUITE(Is_bijective, Meshes, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Is_bijective, accepts_spheres)
{
  EXPECT_TRUE(this->is_bijective(test_meshes::tetrahedron()));
  EXPECT_TRUE(this->is_bijective(test_meshes::octahedron()));
  EXPECT_TRUE(this->is_bijective(test_meshes::icosphere(2)));
  EXPECT_TRUE(this->is_bijective(test_meshes::suspension(7)));
  EXPECT_TRUE(this->is_bijective(test_meshes::random_stacked_sphere(40, 1)));
}

TYPED_TEST(Is_bijective, depends_on_directions_only)
{
  Triangle_list list = test_meshes::icosphere(2);
  std::mt19937 random(2);
  for(Coordinates& p : list.points)
  {
    // Multiplication by a power of two leaves the direction as it is.
    const double factor = std::ldexp(1., static_cast<int>(random() % 40) - 20);
    p = {factor * p[0], factor * p[1], factor * p[2]};
  }
  EXPECT_TRUE(this->is_bijective(list));
  EXPECT_TRUE(this->is_bijective(test_meshes::ellipsoid(1e-3, 1., 1e3, 2)));
}

TYPED_TEST(Is_bijective, finds_a_vertex_beyond_its_star)
{
  const Triangle_list list = test_meshes::icosphere(2);
  std::mt19937 random(3);
  for(int i = 0; i < 30; ++i)
  {
    std::vector<Coordinates> images = list.points;
    Coordinates& p = images[random() % images.size()];
    p = {-p[0], -p[1], -p[2]};
    EXPECT_FALSE(this->is_bijective(list, images));
  }
}

TYPED_TEST(Is_bijective, finds_a_single_inverted_face)
{
  // The vertex in the middle of a face, moved across one of the edges: of all faces, this edge's one is inverted.
  Triangle_list list = test_meshes::tetrahedron();
  const std::size_t v = list.points.size();
  list.triangles[0] = {0, 1, v};
  list.triangles.push_back({1, 2, v});
  list.triangles.push_back({2, 0, v});
  const auto image = [&](double a, double b, double c) {
    std::vector<Coordinates> images = list.points;
    Coordinates p;
    for(std::size_t i = 0; i < 3; ++i)
    {
      p[i] = a * list.points[0][i] + b * list.points[1][i] + c * list.points[2][i];
    }
    images.push_back(p);
    return images;
  };
  list.points = image(1., 1., 1.);
  EXPECT_TRUE(this->is_bijective(list));
  list.points.pop_back();
  const std::vector<Coordinates> inside = image(1., 1., 0.0625), outside = image(1., 1., -0.0625);
  list.points.push_back({0, 0, 0});
  EXPECT_TRUE(this->is_bijective(list, inside));
  EXPECT_FALSE(this->is_bijective(list, outside));
}

TYPED_TEST(Is_bijective, finds_two_vertices_at_one_image)
{
  const Triangle_list list = test_meshes::icosphere(2);
  std::mt19937 random(4);
  for(int i = 0; i < 30; ++i)
  {
    std::vector<Coordinates> images = list.points;
    const test_meshes::Triangle& t = list.triangles[random() % list.triangles.size()];
    images[t[0]] = images[t[1]];
    EXPECT_FALSE(this->is_bijective(list, images));
  }
}

TYPED_TEST(Is_bijective, finds_a_vertex_at_the_origin)
{
  const Triangle_list list = test_meshes::icosphere(1);
  std::vector<Coordinates> images = list.points;
  images[17] = {0., 0., 0.};
  EXPECT_FALSE(this->is_bijective(list, images));
}

TYPED_TEST(Is_bijective, finds_a_face_on_a_great_circle)
{
  // The faces next to vertex 0 of the octahedron collapse, one exactly, and one by the last bit of a coordinate.
  const Triangle_list list = test_meshes::octahedron();
  std::vector<Coordinates> images = list.points;
  images[0] = {0., 1., 1.};
  EXPECT_FALSE(this->is_bijective(list, images));
  images[0] = {0x1p-60, 1., -1.};
  EXPECT_TRUE(this->is_bijective(list, images));
  images[0] = {-0x1p-60, 1., -1.};
  EXPECT_FALSE(this->is_bijective(list, images));
}

TYPED_TEST(Is_bijective, finds_that_the_sphere_is_covered_several_times)
{
  for(std::size_t n = 5; n < 12; ++n)
  {
    const Triangle_list list = test_meshes::suspension(n);
    EXPECT_TRUE(this->is_bijective(list));
    EXPECT_FALSE(this->is_bijective(list, test_meshes::suspension(n, 2).points));
  }
  EXPECT_FALSE(this->is_bijective(test_meshes::suspension(11), test_meshes::suspension(11, 5).points));
}

TYPED_TEST(Is_bijective, rejects_the_mirror_image)
{
  const Triangle_list list = test_meshes::icosphere(1);
  EXPECT_FALSE(this->is_bijective(list, test_meshes::scaled(list, -1., 1., 1.).points));
  EXPECT_FALSE(this->is_bijective(list, test_meshes::scaled(list, -1., -1., -1.).points));
  EXPECT_TRUE(this->is_bijective(list, test_meshes::scaled(list, -1., -1., 1.).points));
}

TYPED_TEST(Is_bijective, rejects_permuted_images)
{
  const Triangle_list list = test_meshes::icosphere(1);
  std::mt19937 random(5);
  for(int i = 0; i < 30; ++i)
  {
    std::vector<Coordinates> images = list.points;
    const std::size_t a = random() % images.size();
    std::swap(images[a], images[(a + 1 + random() % (images.size() - 1)) % images.size()]);
    EXPECT_FALSE(this->is_bijective(list, images));
  }
  // A symmetry of the octahedron permutes its vertices as well, but it is a bijection.
  const Triangle_list octahedron = test_meshes::octahedron();
  EXPECT_TRUE(this->is_bijective(octahedron, {{0, 1, 0}, {0, -1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, -1}}));
}

TYPED_TEST(Is_bijective, accepts_topological_spheres_only)
{
  // A map that is positive and has degree one exists on a sphere alone, so there is no need for a test of the topology.
  // These come closest: two spheres of which one covers everything, and tori, inflated or projected.
  const Triangle_list sphere = test_meshes::icosphere(1);
  EXPECT_FALSE(this->is_bijective(test_meshes::disjoint_union(sphere, sphere)));
  Triangle_list mirrored = test_meshes::scaled(sphere, -1., 1., 1.);
  EXPECT_FALSE(this->is_bijective(test_meshes::disjoint_union(sphere, mirrored)));
  EXPECT_FALSE(this->is_bijective(test_meshes::torus(9, 6)));

  Triangle_list open = sphere;
  open.triangles.pop_back();
  EXPECT_FALSE(this->is_bijective(open));

  Triangle_list isolated = sphere;
  isolated.points.insert(isolated.points.end(), 3, Coordinates{1., 2., 3.});
  EXPECT_TRUE(this->is_bijective(isolated));

  EXPECT_FALSE(this->is_bijective(Triangle_list()));
}

TYPED_TEST(Is_bijective, rejects_faces_that_are_no_triangles)
{
  using Point = typename TestFixture::Point_3;
  TypeParam cube;
  CGAL::make_hexahedron(Point(-1, -1, -1), Point(1, -1, -1), Point(1, 1, -1), Point(-1, 1, -1), Point(-1, 1, 1),
                        Point(-1, -1, 1), Point(1, -1, 1), Point(1, 1, 1), cube);
  EXPECT_FALSE(SP::is_bijective(cube, get(CGAL::vertex_point, cube)));
}

// Coordinates that are not finite: of doubles, of floats, and of lazy numbers unless they are checked when they are
// made. Other exact numbers cannot hold them.
template <class Mesh>
class Is_bijective_not_finite : public Is_bijective<Mesh>
{};

using Meshes_not_finite = ::testing::Types<CGAL::Surface_mesh<Epick::Point_3>, CGAL::Surface_mesh<Float::Point_3>,
#ifdef NDEBUG
                                           CGAL::Surface_mesh<Epeck::Point_3>,
#endif
                                           CGAL::Polyhedron_3<Double>>;
TYPED_TEST_SUITE(Is_bijective_not_finite, Meshes_not_finite, );

TYPED_TEST(Is_bijective_not_finite, rejects_coordinates_that_are_not_finite)
{
  const Triangle_list list = test_meshes::icosphere(1);
  for(const double x : {nan, infinity, -infinity})
  {
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      std::vector<Coordinates> images = list.points;
      images[axis * 7][axis] = x;
      EXPECT_FALSE(this->is_bijective(list, images));
      EXPECT_FALSE(this->is_bijective(list, std::vector<Coordinates>(list.points.size(), images[axis * 7])));
    }
  }
}

TYPED_TEST(Is_bijective_not_finite, ignores_images_of_isolated_vertices)
{
  Triangle_list list = test_meshes::icosphere(1);
  list.points.push_back({0., 0., 0.});
  std::vector<Coordinates> images = list.points;
  images.back() = {nan, infinity, 0.};
  EXPECT_TRUE(this->is_bijective(list, images));
}

// The filter in front of the predicate never contradicts exact arithmetic, however small, large or flat the triangle.
TEST(Is_bijective_filter, agrees_with_exact_arithmetic)
{
  const SP::internal::Orientation_about_origin_3<Epick> orientation;
  std::mt19937 random(7);
  const auto coordinate = [&](int bits) { return std::ldexp(static_cast<double>(random()) - 0x1p31, bits - 31); };
  std::size_t signs[3] = {0, 0, 0};
  for(int i = 0; i < 20000; ++i)
  {
    const int scales[] = {0, 0, 0, 300, -300, -340, 500, -1020};
    const int scale = scales[random() % 8];
    const int edge = -static_cast<int>(random() % 50);
    const int height = edge - static_cast<int>(random() % 60);
    Coordinates p[3];
    for(Coordinates& x : p)
    {
      x = {coordinate(0), coordinate(0), coordinate(0)};
    }
    // p1 is close to p0, and p2 on the line through both but for the height
    const double t = coordinate(0);
    for(std::size_t k = 0; k < 3; ++k)
    {
      const double direction = std::ldexp(p[1][k], edge);
      p[1][k] = p[0][k] + direction;
      p[2][k] = p[0][k] + t * direction + std::ldexp(p[2][k], height);
    }
    if(i % 8 == 0)
    {
      p[2] = {p[0][0] + p[1][0], p[0][1] + p[1][1], p[0][2] + p[1][2]}; // a plane through the origin, or nearly so
    }
    if(i % 16 == 0)
    {
      p[2] = {2. * p[1][0], 2. * p[1][1], 2. * p[1][2]}; // a line through the origin
    }
    Epick::Point_3 points[3];
    Exact::Point_3 exact_points[3];
    for(std::size_t j = 0; j < 3; ++j)
    {
      for(double& x : p[j])
      {
        x = std::ldexp(x, scale);
      }
      points[j] = Epick::Point_3(p[j][0], p[j][1], p[j][2]);
      exact_points[j] = Exact::Point_3(p[j][0], p[j][1], p[j][2]);
    }
    const CGAL::Sign sign =
        CGAL::orientation(Exact::Point_3(CGAL::ORIGIN), exact_points[0], exact_points[1], exact_points[2]);
    ASSERT_EQ(orientation(points[0], points[1], points[2]), sign);
    ASSERT_EQ(orientation(points[1], points[2], points[0]), sign);
    ASSERT_EQ(orientation(points[2], points[0], points[1]), sign);
    ASSERT_EQ(orientation(points[0], points[2], points[1]), -sign);
    ++signs[sign + 1];
  }
  EXPECT_GT(signs[0], 1000u);
  EXPECT_GT(signs[1], 1000u);
  EXPECT_GT(signs[2], 1000u);
}

// Nor does it in another rounding mode, where numbers that overflow need not become infinite.
TEST(Is_bijective_filter, agrees_with_exact_arithmetic_in_any_rounding_mode)
{
  const SP::internal::Orientation_about_origin_3<Epick> orientation;
  std::mt19937 random(8);
  const int former_mode = std::fegetround();
  for(const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
  {
    std::size_t n_positive = 0;
    for(int i = 0; i < 4000; ++i)
    {
      const int scales[] = {0, 500, -500, 1000, 340};
      SP::internal::Vector_3d p[3];
      Epick::Point_3 points[3];
      for(std::size_t j = 0; j < 3; ++j)
      {
        for(double& x : p[j])
          x = std::ldexp(static_cast<double>(random()) - 0x1p31, scales[i % 5] - 31);
        if(j == 2 && i % 2 == 0)
          for(std::size_t k = 0; k < 3; ++k)
            p[2][k] = 0.25 * p[0][k] + 0.5 * p[1][k]; // nearly a plane through the origin
        points[j] = Epick::Point_3(p[j][0], p[j][1], p[j][2]);
      }
      std::fesetround(mode);
      const CGAL::Sign sign = orientation(points[0], points[1], points[2]);
      std::fesetround(former_mode);
      ASSERT_EQ(sign, SP::internal::exact_determinant_sign(p[0], p[1], p[2])) << mode << ' ' << i;
      n_positive += sign == CGAL::POSITIVE;
    }
    EXPECT_GT(n_positive, 500u);
    EXPECT_LT(n_positive, 3500u);
  }
}

// What the certificate of a list says, which must not depend on who computes it, nor on the order of the triangles.
SP::internal::Bijectivity_certificate certificate_of(Triangle_list list)
{
  std::shuffle(list.triangles.begin(), list.triangles.end(), std::mt19937(3));
  std::vector<Epick::Point_3> points;
  for(const Coordinates& p : list.points)
    points.push_back(Epick::Point_3(p[0], p[1], p[2]));
  const auto result = SP::internal::certify_bijectivity<Epick>(points, list.triangles);
  SP::internal::Bijectivity_certificate in_parallel;
  const auto certify = [&] {
    in_parallel = SP::internal::certify_bijectivity<Epick, CGAL::Parallel_if_available_tag>(points, list.triangles);
  };
#ifdef CGAL_LINKED_WITH_TBB
  // more threads than the machine may have
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  tbb::task_arena(4).execute(certify);
#else
  certify();
#endif
  EXPECT_EQ(in_parallel.number_of_non_positive_faces, result.number_of_non_positive_faces);
  EXPECT_EQ(in_parallel.degree, result.degree);
  return result;
}

TEST(Is_bijective_certificate, is_the_same_in_parallel)
{
  Triangle_list list = test_meshes::icosphere(5); // enough faces for many blocks
  EXPECT_TRUE(certificate_of(list).is_bijective());
  EXPECT_EQ(certificate_of(test_meshes::suspension(5001, 2)).degree, 2u);
  EXPECT_EQ(certificate_of(test_meshes::suspension(5001, 1250)).degree, 1250u);

  // A vertex in the first direction that faces are counted around: it is on their boundaries, and another one is taken.
  const double x = 742913. * 0x1p-20;
  const Coordinates q = {1., x, x * x}, direction = test_meshes::normalized(q);
  const auto cosine = [&](const Coordinates& p) {
    return p[0] * direction[0] + p[1] * direction[1] + p[2] * direction[2];
  };
  *std::max_element(list.points.begin(), list.points.end(),
                    [&](const Coordinates& a, const Coordinates& b) { return cosine(a) < cosine(b); }) = q;
  EXPECT_TRUE(certificate_of(list).is_bijective());

  // Faces that are inverted here and there are all counted.
  std::size_t n_inverted = 0;
  for(std::size_t k = 5; k < list.triangles.size(); k += 997, ++n_inverted)
    std::swap(list.triangles[k][0], list.triangles[k][1]);
  EXPECT_EQ(certificate_of(list).number_of_non_positive_faces, n_inverted);
}

TEST(Is_bijective_index_map, uses_the_map_given)
{
  using Mesh = CGAL::Polyhedron_3<Double>;
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::icosphere(1));
  const auto index_map = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  std::size_t index = num_vertices(mesh);
  for(const auto v : vertices(mesh))
  {
    put(index_map, v, --index);
  }
  EXPECT_TRUE(SP::is_bijective(mesh, get(CGAL::vertex_point, mesh), CGAL::parameters::vertex_index_map(index_map)));
}

TEST(Is_bijective_garbage, skips_removed_vertices_and_faces)
{
  using Mesh = CGAL::Surface_mesh<Epick::Point_3>;
  Mesh mesh =
      test_meshes::make_mesh<Mesh>(test_meshes::disjoint_union(test_meshes::icosphere(1), test_meshes::icosphere(0)));
  EXPECT_FALSE(SP::is_bijective(mesh, mesh.points()));
  // the first of the two spheres goes, so that the indices left have gaps
  const std::size_t n = test_meshes::icosphere(1).triangles.size();
  for(std::size_t i = 0; i < n; ++i)
  {
    CGAL::Euler::remove_face(halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(i)), mesh), mesh);
  }
  ASSERT_TRUE(mesh.has_garbage());
  EXPECT_TRUE(SP::is_bijective(mesh, mesh.points()));
}

} // namespace
