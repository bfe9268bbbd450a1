// Surfaces that are as extreme as a shape, a numbering or a placement can be, each with the default settings: all that
// are valid get a certified map, and no time or memory is quadratic in anything.

#include <CGAL/spherical_parameterization.h>

#include "independent_check.h"
#include "test_maps.h"
#include "test_meshes.h"
#include "test_runs.h"
#include "test_scale.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using test_meshes::Coordinates;
using test_meshes::pi;
using test_meshes::Triangle;
using test_meshes::Triangle_list;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

Coordinates operator+(const Coordinates& a, const Coordinates& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Coordinates operator-(const Coordinates& a, const Coordinates& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Coordinates operator*(double s, const Coordinates& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}

Coordinates cross(const Coordinates& a, const Coordinates& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A mesh of all triangles at once: adding them one by one takes a time that is quadratic in the degrees.
Mesh make_mesh(const Triangle_list& list)
{
  Mesh mesh;
  for(const Coordinates& p : list.points)
  {
    mesh.add_vertex(Point_3(p[0], p[1], p[2]));
  }
  std::vector<std::array<Mesh::Vertex_index, 3>> faces;
  for(const Triangle& t : list.triangles)
  {
    const auto vertex = [](std::size_t v) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(v)); };
    faces.push_back({vertex(t[0]), vertex(t[1]), vertex(t[2])});
  }
  CGAL::Euler::add_faces(faces, mesh);
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(mesh.number_of_vertices() + mesh.number_of_faces(), mesh.number_of_edges() + 2);
  return mesh;
}

// Runs the default method, which has to find a map; that it is sound is checked on the way.
test_runs::Result expect_mapped(const Triangle_list& list)
{
  const Mesh mesh = make_mesh(list);
  SP::Bijective_low_distortion_parameterizer_3<Mesh> parameterizer;
  const test_runs::Result result = test_runs::run<Point_3>(mesh, parameterizer, false);
  EXPECT_EQ(result.error, SP::OK) << SP::get_error_message(result.error);
  EXPECT_TRUE(independent_check::is_one_to_one(result.images, list.triangles));
  return result;
}

std::size_t largest_degree(const Triangle_list& list)
{
  std::vector<std::size_t> degrees(list.points.size(), 0);
  for(const Triangle& t : list.triangles)
  {
    for(const std::size_t v : t)
    {
      ++degrees[v];
    }
  }
  return *std::max_element(degrees.begin(), degrees.end());
}

// A ring of points around the z-axis.
struct Ring
{
  double radius, height;
  std::size_t size;
};

// The surface from the point (0, 0, bottom) through the rings, from the lowest to the highest, to the point (0, 0,
// top).
Triangle_list surface_of_revolution(double bottom, const std::vector<Ring>& rings, double top)
{
  Triangle_list list;
  std::vector<std::size_t> firsts;
  for(const Ring& ring : rings)
  {
    firsts.push_back(list.points.size());
    for(std::size_t i = 0; i < ring.size; ++i)
    {
      const double longitude = 2. * pi * static_cast<double>(i) / static_cast<double>(ring.size);
      list.points.push_back({ring.radius * std::cos(longitude), ring.radius * std::sin(longitude), ring.height});
    }
  }
  const std::size_t n = list.points.size();
  list.points.push_back({0., 0., bottom});
  list.points.push_back({0., 0., top});
  for(std::size_t i = 0; i < rings.front().size; ++i)
  {
    list.triangles.push_back({n, (i + 1) % rings.front().size, i});
  }
  for(std::size_t k = 0; k + 1 < rings.size(); ++k)
  {
    // Between two rings, the triangle with the smaller longitude comes first.
    const std::size_t size = rings[k].size, next_size = rings[k + 1].size, a = firsts[k], b = firsts[k + 1];
    for(std::size_t i = 0, j = 0; i < size || j < next_size;)
    {
      if(j == next_size || (i < size && (i + 1) * next_size <= (j + 1) * size))
      {
        list.triangles.push_back({a + i, a + (i + 1) % size, b + j % next_size});
        ++i;
      }
      else
      {
        list.triangles.push_back({a + i % size, b + (j + 1) % next_size, b + j});
        ++j;
      }
    }
  }
  for(std::size_t i = 0; i < rings.back().size; ++i)
  {
    list.triangles.push_back({n + 1, firsts.back() + i, firsts.back() + (i + 1) % rings.back().size});
  }
  return list;
}

// A tube around the curve c(0), ..., c(n - 1), with `size` corners in each ring, and a cap at each end. The curve must
// not be parallel to `up` anywhere.
template <class Curve>
Triangle_list tube(const Curve& c, std::size_t n, double radius, std::size_t size, const Coordinates& up)
{
  std::vector<Ring> rings(n, Ring{1., 0., size});
  Triangle_list list = surface_of_revolution(0., rings, 1.); // for its triangles
  for(std::size_t k = 0; k < n; ++k)
  {
    const Coordinates tangent = c((std::min)(k + 1, n - 1)) - c(k > 0 ? k - 1 : 0);
    const Coordinates x = test_meshes::normalized(cross(up, tangent)), y = test_meshes::normalized(cross(tangent, x));
    for(std::size_t i = 0; i < size; ++i)
    {
      const double angle = 2. * pi * static_cast<double>(i) / static_cast<double>(size);
      list.points[k * size + i] = c(k) + (radius * std::cos(angle)) * x + (radius * std::sin(angle)) * y;
    }
  }
  list.points[n * size] = c(0);
  list.points[n * size + 1] = c(n - 1);
  return list;
}

// Puts a tube of `n_rings` triangles with a pyramid on top in the place of the face, `length` long and getting thinner
// to the factor `taper`. Its last three faces are those of the pyramid.
void extrude(Triangle_list& list, std::size_t face, double length, std::size_t n_rings, double taper)
{
  const Triangle base = list.triangles[face];
  const std::array<Coordinates, 3> p = {list.points[base[0]], list.points[base[1]], list.points[base[2]]};
  const Coordinates center = (1. / 3.) * (p[0] + p[1] + p[2]);
  const Coordinates direction = test_meshes::normalized(cross(p[1] - p[0], p[2] - p[0]));

  Triangle previous = base;
  bool is_first = true;
  for(std::size_t k = 1; k <= n_rings; ++k)
  {
    const double t = static_cast<double>(k) / static_cast<double>(n_rings);
    Triangle ring;
    for(std::size_t i = 0; i < 3; ++i)
    {
      ring[i] = list.points.size();
      list.points.push_back(center + (length * t) * direction + (1. + (taper - 1.) * t) * (p[i] - center));
    }
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3;
      if(is_first)
      {
        list.triangles[face] = {previous[i], previous[j], ring[j]};
        is_first = false;
      }
      else
      {
        list.triangles.push_back({previous[i], previous[j], ring[j]});
      }
      list.triangles.push_back({previous[i], ring[j], ring[i]});
    }
    previous = ring;
  }
  const std::size_t apex = list.points.size();
  list.points.push_back(center + (length + 0.5 * taper * test_maps::distance(p[0], p[1])) * direction);
  for(std::size_t i = 0; i < 3; ++i)
  {
    list.triangles.push_back({previous[i], previous[(i + 1) % 3], apex});
  }
}

constexpr std::size_t huge_degree = test_scale::reduced(100000);

// Close to a sphere, with faces like needles. If the neighbours of a vertex fall into disorder on a coarse level, the
// average comes to ten and more.
TEST(Extreme_degrees, two_vertices_of_all_faces)
{
  const Triangle_list list = test_meshes::suspension(huge_degree);
  ASSERT_EQ(largest_degree(list), huge_degree);
  EXPECT_LT(expect_mapped(list).distortion.isometric.average, 1.7);
}

TEST(Extreme_degrees, two_vertices_of_many_faces)
{
  EXPECT_LT(expect_mapped(test_meshes::suspension(huge_degree / 5)).distortion.isometric.average, 1.05);
}

TEST(Extreme_degrees, one_hub_in_a_fine_mesh)
{
  // A hemisphere around the hub, then ever fewer vertices in a ring.
  std::vector<Ring> rings;
  for(std::size_t size = huge_degree; size > 5; size = (size + 1) / 2)
  {
    const double angle = 0.5 * pi * std::pow(0.8, static_cast<double>(rings.size()));
    rings.push_back({std::sin(angle), std::cos(angle), size});
  }
  const Triangle_list list = surface_of_revolution(0., rings, 1.);
  ASSERT_EQ(largest_degree(list), huge_degree);
  ASSERT_GT(list.points.size(), 2 * huge_degree - 100);
  EXPECT_LT(expect_mapped(list).distortion.isometric.average, 6.);
}

TEST(Extreme_connectivity, a_thousand_nested_separating_triangles)
{
  // Each new vertex goes into the last face.
  Triangle_list list = test_meshes::tetrahedron();
  for(std::size_t i = 0; i < 1000; ++i)
  {
    const Triangle t = list.triangles.back();
    const std::size_t v = list.points.size();
    list.points.push_back(((1. + 1e-3) / 3.) * (list.points[t[0]] + list.points[t[1]] + list.points[t[2]]));
    list.triangles.back() = {t[0], t[1], v};
    list.triangles.push_back({t[2], t[0], v});
    list.triangles.push_back({t[1], t[2], v});
  }
  expect_mapped(list);
}

// Each vertex is put into the middle of one of the newest faces, or into the origin along with all others: faces shrink to
// nothing, and each lies within the one before.
TEST(Extreme_connectivity, stacks_that_shrink_into_a_point)
{
  for(const double scale : {1., 0.})
  {
    for(std::size_t rule = 0; rule < 3; ++rule)
    {
      for(const std::size_t n : {std::size_t(60), std::size_t(300), test_scale::reduced(3000)})
      {
        SCOPED_TRACE(std::to_string(scale) + ", rule " + std::to_string(rule) + ", " + std::to_string(n) + " vertices");
        Triangle_list list = test_meshes::scaled(test_meshes::tetrahedron(), scale, scale, scale);
        for(std::size_t k = 0; k < n; ++k)
        {
          const Triangle t = list.triangles.back();
          const std::size_t v = list.points.size();
          list.points.push_back((1. / 3.) * (list.points[t[0]] + list.points[t[1]] + list.points[t[2]]));
          list.triangles.back() = {t[0], t[1], v};
          list.triangles.push_back(rule == 0 ? Triangle{t[2], t[0], v} : Triangle{t[1], t[2], v});
          list.triangles.push_back(rule == 0   ? Triangle{t[1], t[2], v}
                                   : rule == 1 ? Triangle{t[2], t[0], v}
                                               : Triangle{v, t[2], t[0]});
        }
        expect_mapped(list);
      }
    }
  }
}

TEST(Extreme_connectivity, shuffled_indices)
{
  const Triangle_list list = test_meshes::bumpy_sphere(5);
  const test_runs::Result original = expect_mapped(list);
  const test_runs::Result shuffled =
      expect_mapped(test_meshes::renumbered(list, test_meshes::random_permutation(list.points.size(), 11), 12));
  EXPECT_NEAR(shuffled.distortion.isometric.average / original.distortion.isometric.average, 1., 0.01);
}

// Moves and scales a sphere without symmetries: its map stays as it is, as long as doubles hold the surface.
TEST(Extreme_coordinates, tiny_huge_and_far_away)
{
  const Triangle_list list = test_meshes::bumpy_sphere(3);
  const test_runs::Result original = expect_mapped(list);
  for(const double factor : {1e-300, 1e-150, 1e150, 1e300})
  {
    SCOPED_TRACE(factor);
    const test_runs::Result result = expect_mapped(test_meshes::scaled(list, factor, factor, factor));
    EXPECT_NEAR(result.report.radius / factor / original.report.radius, 1., 1e-9);
    EXPECT_NEAR(result.distortion.isometric.maximum / original.distortion.isometric.maximum, 1., 1e-9);
    EXPECT_NEAR(result.distortion.isometric.average / original.distortion.isometric.average, 1., 1e-9);
  }

  // At 1e8, doubles are 1.5e-8 apart, 1.5e-5 of what is 1e-3 large.
  Triangle_list far = test_meshes::scaled(list, 1e-3, 1e-3, 1e-3);
  for(Coordinates& p : far.points)
  {
    p = p + Coordinates{1e8, -1e8, 1e8};
  }
  const test_runs::Result result = expect_mapped(far);
  EXPECT_NEAR(result.report.radius / 1e-3 / original.report.radius, 1., 1e-3);
  EXPECT_NEAR(result.distortion.isometric.average / original.distortion.isometric.average, 1., 1e-2);
}

// The sphere that has the area of such a surface is out of range; a smaller one is not.
TEST(Extreme_coordinates, at_the_ends_of_the_range)
{
  const double largest = (std::numeric_limits<double>::max)();
  Triangle_list list = test_meshes::tetrahedron();
  for(Coordinates& p : list.points)
  {
    for(double& x : p)
    {
      x = std::copysign(largest, x);
    }
  }
  expect_mapped(list);
  list.points = {{0., 0., -largest}, {1., 0., largest}, {0., 1., largest}, {0., 0., largest}};
  expect_mapped(list);
}

TEST(Extreme_coordinates, all_coplanar_collinear_or_in_one_point)
{
  const Triangle_list list = test_meshes::bumpy_sphere(3);
  expect_mapped(test_meshes::scaled(list, 1., 1., 0.));
  expect_mapped(test_meshes::scaled(list, 1., 0., 0.));
  EXPECT_EQ(expect_mapped(test_meshes::scaled(list, 0., 0., 0.)).report.number_of_flat_faces, list.triangles.size());
}

TEST(Extreme_coordinates, self_intersecting_and_random)
{
  Triangle_list noisy = test_meshes::icosphere(4), random = noisy;
  std::mt19937 engine(5);
  const auto uniform = [&] { return 2. * static_cast<double>(engine()) / 4294967296. - 1.; };
  for(std::size_t v = 0; v < noisy.points.size(); ++v)
  {
    const double x = uniform(), y = uniform(), z = uniform();
    noisy.points[v] = noisy.points[v] + 0.3 * Coordinates{x, y, z};
    random.points[v] = {x, y, z};
  }
  expect_mapped(noisy);
  expect_mapped(random);
}

// The images are oriented as the caller's faces are, also if those look inwards: is_bijective(), which is part of every
// run here, asks for just that.
TEST(Extreme_coordinates, inside_out)
{
  Triangle_list list = test_meshes::bumpy_sphere(4);
  const test_runs::Result original = expect_mapped(list);
  for(Triangle& t : list.triangles)
  {
    std::swap(t[1], t[2]);
  }
  const test_runs::Result mirrored = expect_mapped(list);
  EXPECT_NEAR(mirrored.report.radius / original.report.radius, 1., 0.01);
  EXPECT_NEAR(mirrored.distortion.isometric.average / original.distortion.isometric.average, 1., 0.02);
}

TEST(Extreme_shapes, long_tubes)
{
  for(const std::size_t size : {3u, 6u})
  {
    SCOPED_TRACE(size);
    std::vector<Ring> rings;
    for(std::size_t k = 0; k < 2000; ++k)
    {
      rings.push_back({1., 0.5 * static_cast<double>(k), size});
    }
    const test_runs::Result result = expect_mapped(surface_of_revolution(-0.5, rings, 1000.));
    EXPECT_LT(result.distortion.isometric.average, 50.);
  }
}

TEST(Extreme_shapes, geometric_grading)
{
  std::vector<Ring> rings; // around the pole (0, 0, -1), by their angles there
  for(int k = 0; k <= 60; ++k)
  {
    const double angle = 1e-10 * std::pow(0.5e10, k / 60.);
    rings.push_back({std::sin(angle), -std::cos(angle), 16});
  }
  for(int k = 1; k < 20; ++k)
  {
    const double angle = 0.5 + (pi - 0.5) * k / 20.;
    rings.push_back({std::sin(angle), -std::cos(angle), 16});
  }
  const test_runs::Result result = expect_mapped(surface_of_revolution(-1., rings, 1.));
  EXPECT_LT(result.distortion.isometric.average, 1.1); // this is a sphere
}

TEST(Extreme_shapes, spiral)
{
  const std::size_t n = 1500;
  const auto curve = [&](std::size_t k) {
    const double t = static_cast<double>(k) / static_cast<double>(n);
    const double angle = 2. * pi * 15. * t, r = 1. + 15. * t;
    return Coordinates{r * std::cos(angle), r * std::sin(angle), 0.};
  };
  expect_mapped(tube(curve, n, 0.3, 8, {0., 0., 1.}));
}

TEST(Extreme_shapes, comb)
{
  std::vector<Ring> rings;
  for(std::size_t k = 0; k < 202; ++k)
  {
    rings.push_back({1., 2. * static_cast<double>(k), 3});
  }
  Triangle_list list = surface_of_revolution(-1., rings, 403.);
  const std::size_t n = list.triangles.size();
  for(std::size_t f = 3; f + 3 < n; f += 6) // one tooth for each segment of the back
  {
    extrude(list, f, 40., 20, 0.5);
  }
  ASSERT_GT(list.points.size(), 200 * 60u);
  expect_mapped(list);
}

TEST(Extreme_shapes, tree_of_tubes)
{
  for(std::uint32_t seed = 1; seed <= 3; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Triangle_list list = test_meshes::tetrahedron();
    std::vector<std::size_t> ends = {0, 1, 2, 3}; // faces that a branch may grow from
    for(int i = 0; i < 300; ++i)
    {
      const std::size_t k = random() % ends.size(), face = ends[k];
      const Triangle t = list.triangles[face];
      const double width = test_maps::distance(list.points[t[0]], list.points[t[1]]);
      const double length = static_cast<double>(2 + random() % 20) * width;
      extrude(list, face, length, 4 + random() % 12, 0.8);
      ends[k] = ends.back();
      ends.pop_back();
      for(std::size_t j = 1; j <= 3; ++j)
      {
        ends.push_back(list.triangles.size() - j);
      }
    }
    expect_mapped(list);
  }
}

// Runs the default method on what is closed but no simplicial complex.
template <class Any_mesh>
void expect_no_simplicial_complex(const Any_mesh& mesh)
{
  ASSERT_TRUE(CGAL::is_closed(mesh) && CGAL::is_triangle_mesh(mesh) && CGAL::is_valid_polygon_mesh(mesh));
  ASSERT_EQ(num_vertices(mesh) + num_faces(mesh), num_edges(mesh) + 2);
  SP::Bijective_low_distortion_parameterizer_3<Any_mesh> parameterizer;
  EXPECT_EQ(test_runs::run<Point_3>(mesh, parameterizer, false).error, SP::ERROR_NO_SIMPLICIAL_COMPLEX);
}

template <class Any_mesh>
class Multiple_edges : public ::testing::Test
{};

using Mesh_types = ::testing::Types<Mesh, CGAL::Polyhedron_3<Kernel>>;
TYPED_TEST_SUITE(Multiple_edges, Mesh_types, ); // without the last comma, Clang is pedantic about the macro

// Puts a vertex into the face of `h`; returns a halfedge to it.
template <class Any_mesh>
auto add_center(typename boost::graph_traits<Any_mesh>::halfedge_descriptor h, Any_mesh& mesh)
{
  const auto center = CGAL::Euler::add_center_vertex(h, mesh);
  put(CGAL::vertex_point, mesh, target(center, mesh), Point_3(0., 0., 0.));
  return center;
}

TYPED_TEST(Multiple_edges, with_two_faces_on_the_same_vertices)
{
  TypeParam mesh = test_meshes::make_mesh<TypeParam>(test_meshes::icosphere(2));
  const auto h = add_center(*halfedges(mesh).begin(), mesh);
  const auto center = target(h, mesh);
  EXPECT_EQ(SP::parameterize(mesh, test_maps::make_sentinel_map<Point_3>(mesh)), SP::OK);
  CGAL::Euler::flip_edge(h, mesh); // the ends of the new edge are joined already
  ASSERT_EQ(degree(center, mesh), 2u);
  expect_no_simplicial_complex(mesh);
}

TYPED_TEST(Multiple_edges, with_different_faces)
{
  TypeParam mesh = test_meshes::make_mesh<TypeParam>(test_meshes::icosphere(2));
  const auto h = add_center(*halfedges(mesh).begin(), mesh);
  const auto center = target(h, mesh);
  add_center(h, mesh);
  EXPECT_EQ(SP::parameterize(mesh, test_maps::make_sentinel_map<Point_3>(mesh)), SP::OK);
  ASSERT_EQ(degree(center, mesh), 4u);
  CGAL::Euler::flip_edge(prev(opposite(h, mesh), mesh), mesh); // an edge that has no face with the second new vertex
  ASSERT_EQ(degree(center, mesh), 3u);
  expect_no_simplicial_complex(mesh);
}

} // namespace
