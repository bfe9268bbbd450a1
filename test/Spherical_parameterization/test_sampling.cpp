// Each direction has the location that an exact brute force finds, whatever the mesh and the map, however it is asked for.

#include "Counting_kernel.h"
#include "broken_maps.h"
#include "judge.h"
#include "methods.h"
#include "random_meshes.h"
#include "test_scale.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

using namespace test;

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

using Rational = CGAL::Exact_rational;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Float = CGAL::Simple_cartesian<float>;

// A mesh with a map, in which the locations of directions are found by looking at all faces.
class Sphere_map
{
public:
  explicit Sphere_map(const Triangle_list& list) // that is mapped by its points
    : Sphere_map(make(list), list.points)
  {}

  Sphere_map(const Mesh& m, const Images& i)
    : mesh(m)
    , images(i)
    , triangles(test::triangles(mesh))
    , map(mesh, images)
  {}

  auto locator() const { return SP::Sphere_locator_3(mesh, map); }

  std::array<int, 3> sides(const Triangle& t, const Coordinates& q) const
  {
    std::array<int, 3> result;
    for(std::size_t k = 0; k < 3; ++k)
      result[k] = judge::sign_of_determinant(images[t[(k + 1) % 3]], images[t[(k + 2) % 3]], q);
    return result;
  }

  // the first face that contains the direction
  std::size_t face(const Coordinates& q) const
  {
    const auto contains = [&](const Triangle& t) {
      const std::array<int, 3> s = sides(t, q);
      return s[0] >= 0 && s[1] >= 0 && s[2] >= 0;
    };
    return static_cast<std::size_t>(std::find_if(triangles.begin(), triangles.end(), contains) - triangles.begin());
  }

  std::array<Rational, 3> coordinates(const Triangle& t, const Coordinates& q) const
  {
    const judge::Image<Rational> a = judge::exact(images[t[0]]), b = judge::exact(images[t[1]]),
                                 c = judge::exact(images[t[2]]), d = judge::exact(q);
    std::array<Rational, 3> result = {judge::determinant(d, b, c), judge::determinant(a, d, c),
                                      judge::determinant(a, b, d)};
    const Rational sum = result[0] + result[1] + result[2];
    for(Rational& x : result)
      x /= sum;
    return result;
  }

  Mesh mesh;
  Images images;
  std::vector<Triangle> triangles;
  Point_map map;
};

Point_3 point(const Coordinates& q)
{
  return Point_3(q[0], q[1], q[2]);
}

std::vector<Point_3> points_of(const Images& directions)
{
  std::vector<Point_3> result(directions.size());
  std::transform(directions.begin(), directions.end(), result.begin(), point);
  return result;
}

template <class Locator>
std::vector<typename Locator::Face_location> locate_all(const Locator& locator, const Images& directions)
{
  std::vector<typename Locator::Face_location> result;
  EXPECT_EQ(locator.locate(points_of(directions), std::back_inserter(result)), SP::OK);
  return result;
}

template <class Location>
void expect_no_face(const Location& location)
{
  EXPECT_EQ(location, Location(boost::graph_traits<Mesh>::null_face(), {0., 0., 0.}));
}

template <class Location>
void expect_right(const Sphere_map& map, const Coordinates& q, const Location& location)
{
  const std::size_t f = map.face(q);
  ASSERT_EQ(location.first, Mesh::Face_index(static_cast<Mesh::size_type>(f)));
  const std::array<int, 3> sides = map.sides(map.triangles[f], q);
  const std::array<Rational, 3> expected = map.coordinates(map.triangles[f], q);
  for(std::size_t k = 0; k < 3; ++k)
  {
    ASSERT_GE(location.second[k], 0.);
    ASSERT_LE(location.second[k], 1.);
    ASSERT_EQ(location.second[k] > 0., sides[k] > 0);
    ASSERT_LE(CGAL::abs(Rational(location.second[k]) - expected[k]), expected[k] * Rational(1e-6));
  }
  ASSERT_NEAR(location.second[0] + location.second[1] + location.second[2], 1., 1e-15);
}

// Checks the locations that a range of directions gets, and that each of them alone gets the same.
void expect_right(const Sphere_map& map, const Images& directions)
{
  const auto locator = map.locator();
  ASSERT_EQ(locator.error_code(), SP::OK);
  const auto locations = locate_all(locator, directions);
  ASSERT_EQ(locations.size(), directions.size());
  for(std::size_t k = 0; k < directions.size(); ++k)
  {
    SCOPED_TRACE("direction " + std::to_string(k));
    ASSERT_EQ(locator.locate(point(directions[k])), locations[k]);
    ASSERT_NO_FATAL_FAILURE(expect_right(map, directions[k], locations[k]));
  }
}

Images random_directions(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  Images result;
  while(result.size() < n)
    result.push_back(random.direction());
  return result;
}

// In and around faces: vertices, places on and next to edges, and places in faces, as near as rounding allows.
Images special_directions(const Sphere_map& map, std::size_t n)
{
  Images result;
  for(std::size_t k = 0; k < n; ++k)
  {
    const Triangle& t = map.triangles[k * map.triangles.size() / n];
    const Coordinates &a = map.images[t[0]], &b = map.images[t[1]], &c = map.images[t[2]];
    const Coordinates middle = combination(1., a, 1., b);
    result.push_back(a);
    result.push_back(middle);
    result.push_back(combination(1., middle, 1e-12, c));
    result.push_back(combination(1., middle, -1e-12, c));
    result.push_back(combination(1., a, 1e-14, c));
    result.push_back(combination(1., middle, 1., c));
  }
  return result;
}

// Checks directions anywhere, and those around the features of so many faces.
void expect_right(const Sphere_map& map, std::size_t n_random, std::uint64_t seed, std::size_t n_special)
{
  expect_right(map, random_directions(n_random, seed));
  expect_right(map, special_directions(map, n_special));
}

// With coordinates of single precision, sums of two points are exact, so that they are on edges.
Triangle_list rounded_to_float(Triangle_list list)
{
  for(Coordinates& p : list.points)
    for(double& x : p)
      x = static_cast<double>(static_cast<float>(x));
  return list;
}

// The same mesh with a new vertex in each of `n` faces, at this height over the first edge of the face.
Triangle_list with_needles(Triangle_list list, std::size_t n, double height)
{
  for(std::size_t k = 0; k < n; ++k)
  {
    const Triangle t = list.triangles[k];
    const Coordinates middle = combination(0.5, list.points[t[0]], 0.5, list.points[t[1]]);
    split_face(list, k, combination(1. - height, middle, height, list.points[t[2]]));
  }
  return list;
}

TEST(Locations, are_those_of_a_brute_force)
{
  const std::size_t n = test_scale::number_of(200, 5000);
  for(const Triangle_list& list :
      {tetrahedron(), octahedron(), icosphere(3), bumpy_sphere(3), rounded_to_float(icosphere(3)), suspension(3),
       suspension(300), random_stacked_sphere(1000, 1), with_slivers(icosphere(2), 20, 1e-9),
       with_needles(icosphere(2), 100, 1e-13)})
  {
    SCOPED_TRACE(list.points.size());
    const Sphere_map map(list);
    expect_right(map, n, 1, n);
  }
}

TEST(Locations, are_those_of_a_brute_force_in_maps_of_random_meshes)
{
  const std::size_t n = test_scale::number_of(20, 500);
  for(std::uint64_t seed = 0; seed < n; ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh mesh = make(random_mesh(seed).list);
    const Sphere_map map(mesh, hierarchical().run(mesh).images);
    expect_right(map, 100, seed, 50);
  }
}

TEST(Locations, at_a_vertex_or_edge_are_in_its_first_face)
{
  const Sphere_map map(octahedron());
  const auto locator = map.locator();
  // the face, and the coordinates of its vertices that are not 0
  using Weights = std::map<std::size_t, double>;
  const auto expect = [&](const Point_3& q, std::size_t face, const Weights& expected) {
    const auto location = locator.locate(q);
    EXPECT_EQ(location.first, Mesh::Face_index(static_cast<Mesh::size_type>(face)));
    Weights weights;
    for(std::size_t k = 0; k < 3; ++k)
      if(location.second[k] != 0.)
        weights[map.triangles[face][k]] = location.second[k];
    EXPECT_EQ(weights, expected);
  };
  expect(Point_3(0., 0., 7.), 0, {{4, 1.}});
  expect(Point_3(0., 0., -7.), 4, {{5, 1.}});
  expect(Point_3(-3., 1., 0.), 1, {{1, 0.75}, {2, 0.25}});
  expect(Point_3(0., -3., -1.), 6, {{3, 0.75}, {5, 0.25}});
}

// The mesh is so large that directions are sorted.
TEST(Locations, are_those_of_a_brute_force_around_a_vertex_of_high_degree)
{
  const Triangle_list list = suspension(test_scale::number_of(50000, 100000));
  const Sphere_map map(list);
  Images directions = random_directions(100, 1);
  for(const double z : {1., -1.})
  {
    directions.push_back({0., 0., z});
    for(const double x : {1e-3, 1e-9, 1e-200})
    {
      directions.push_back({x, 0., z});
      directions.push_back({-x, 0.7 * x, z});
    }
  }
  expect_right(map, directions);
}

// A query takes as many steps in any mesh, as the grid has a cell for each few triangles.
TEST(Locations, take_as_many_side_tests_in_a_large_mesh_as_in_a_small_one)
{
  const auto n_side_tests = [](unsigned int subdivisions) {
    auto triangulation = triangulation_of<Counting_kernel>(icosphere(subdivisions));
    EXPECT_TRUE(triangulation.make_grid());
    Counting_kernel::n_orientations = 0;
    for(const Point_3& q : points_of(random_directions(1000, 8)))
    {
      decltype(triangulation)::Hint none;
      triangulation.locate(q, none);
    }
    return static_cast<double>(Counting_kernel::n_orientations);
  };
  EXPECT_LT(n_side_tests(5), 1.1 * n_side_tests(2));
}

TEST(Locations, do_not_depend_on_the_length_of_a_direction_and_the_size_of_the_map)
{
  const Triangle_list list = random_stacked_sphere(300, 2);
  const Sphere_map map(list);
  Images directions = random_directions(50, 3);
  const Images special = special_directions(map, 10);
  directions.insert(directions.end(), special.begin(), special.end());
  const auto expected = locate_all(map.locator(), directions);
  for(const auto& [of_map, of_directions] :
      {std::pair(0, -996), {0, -500}, {0, 30}, {0, 500}, {0, 1020}, {-900, 0}, {-100, 0}, {100, 0}, {900, 0}})
  {
    SCOPED_TRACE(std::to_string(of_map) + ' ' + std::to_string(of_directions));
    const double factor = std::ldexp(1., of_map);
    const auto locations = locate_all(Sphere_map(scaled(list, factor, factor, factor)).locator(),
                                      scaled(directions, std::ldexp(1., of_directions)));
    for(std::size_t k = 0; k < locations.size(); ++k)
    {
      EXPECT_EQ(locations[k].first, expected[k].first);
      for(std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(locations[k].second[i], expected[k].second[i], 1e-6 * expected[k].second[i]);
    }
  }
  expect_right(map, {{1e300, 1e-5, 0.}, {1e-300, 0., 2e-300}, {5e-324, -5e-324, 5e-324}, {1., 1e-300, -1e-200}});
}

TEST(Locations, do_not_depend_on_order_hints_and_threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
#endif
  const Sphere_map map(icosphere(3));
  const Images directions = random_directions(10000, 4);
  const auto locator = map.locator();
  const auto locations = locate_all(locator, directions);
  auto reversed = locate_all(locator, Images(directions.rbegin(), directions.rend()));
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_EQ(reversed, locations);
  const SP::Sphere_locator_3<Mesh, Point_map, CGAL::Sequential_tag> sequential(map.mesh, map.map, true);
  EXPECT_EQ(locate_all(sequential, directions), locations);
  decltype(locator)::Hint hint;
  for(std::size_t k = 0; k < directions.size(); ++k)
  {
    ASSERT_EQ(locator.locate(point(directions[k]), hint), locations[k]);
    const Coordinates next = combination(1., directions[k], 1e-3, directions[0]);
    ASSERT_EQ(locator.locate(point(next), hint), locator.locate(point(next)));
  }
}

TEST(Locations, of_invalid_directions_have_no_face)
{
  const auto locator = Sphere_map(icosphere(1)).locator();
  EXPECT_TRUE(locate_all(locator, {}).empty());
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  Images directions = {{1., 2., 3.},  {0., 0., 0.},       {0., -0., 0.},        {nan, 1., 1.},
                       {1., nan, 0.}, {0., 0., infinity}, {-infinity, 1., nan}, {-1., 2., -3.}};
  std::vector<decltype(locator)::Face_location> locations;
  EXPECT_EQ(locator.locate(points_of(directions), std::back_inserter(locations)), SP::ERROR_INVALID_DIRECTION);
  ASSERT_EQ(locations.size(), directions.size());
  for(std::size_t k = 1; k + 1 < directions.size(); ++k)
  {
    expect_no_face(locations[k]);
    expect_no_face(locator.locate(point(directions[k])));
  }
  EXPECT_EQ(locations.front(), locator.locate(point(directions.front())));
  EXPECT_EQ(locations.back(), locator.locate(point(directions.back())));
  EXPECT_NE(locations.back().first, Mesh::null_face());
}

// The point of the surface is that of the face, by the coordinates in the order of CGAL, whatever the types.
template <class Any_mesh>
void expect_consistent_points()
{
  const Any_mesh mesh = make_mesh<Any_mesh>(bumpy_sphere(1));
  const auto map = get(CGAL::vertex_point, mesh);
  using Image_3 = typename boost::property_traits<std::decay_t<decltype(map)>>::value_type;
  using FT = typename CGAL::Kernel_traits<Image_3>::Kernel::FT;
  const double epsilon = CGAL::to_double(std::numeric_limits<FT>::epsilon()); // 0 for exact numbers
  const SP::Sphere_locator_3 locator(mesh, map);
  ASSERT_EQ(locator.error_code(), SP::OK);
  for(const Coordinates& q : random_directions(20, 5))
  {
    const Image_3 direction{FT(q[0]), FT(q[1]), FT(q[2])};
    const auto p = PMP::construct_point(locator.locate(direction), mesh, CGAL::parameters::vertex_point_map(map));
    const auto difference = CGAL::cross_product(p - CGAL::ORIGIN, direction - CGAL::ORIGIN);
    EXPECT_LE(CGAL::to_double(difference.squared_length()), 64. * epsilon * epsilon);
    EXPECT_GT(CGAL::scalar_product(p - CGAL::ORIGIN, direction - CGAL::ORIGIN), FT(0));
  }
}

TEST(Locator, of_any_mesh_and_kernel)
{
  expect_consistent_points<Mesh>();
  expect_consistent_points<CGAL::Polyhedron_3<Kernel>>();
  expect_consistent_points<CGAL::Surface_mesh<Float::Point_3>>();
  expect_consistent_points<CGAL::Surface_mesh<Epeck::Point_3>>();
  expect_consistent_points<CGAL::Surface_mesh<CGAL::Simple_cartesian<Rational>::Point_3>>();
}

// Directions of double are located in a map of float as they are, not rounded.
TEST(Locator, of_a_map_of_float_takes_directions_of_double)
{
  const Triangle_list list = rounded_to_float(icosphere(2));
  const auto mesh = make_mesh<CGAL::Surface_mesh<Float::Point_3>>(list);
  const SP::Sphere_locator_3 locator(mesh, mesh.points());
  const SP::Sphere_locator_3<Mesh, Point_map> expected = Sphere_map(list).locator();
  for(const Coordinates& q : random_directions(100, 6))
  {
    const auto location = locator.locate(point(q)), other = expected.locate(point(q));
    EXPECT_EQ(std::size_t(location.first), std::size_t(other.first));
    EXPECT_EQ(location.second, other.second);
  }
}

TEST(Locator, leaves_out_vertices_without_faces)
{
  Triangle_list list = icosphere(1);
  list.points.insert(list.points.begin(), Coordinates{9., 9., 9.});
  for(Triangle& t : list.triangles)
    for(std::size_t& v : t)
      ++v;
  const Sphere_map map(list);
  expect_right(map, special_directions(map, 80));
}

void expect_refusal(const Triangle_list& list, SP::Error_code error, bool is_known_to_be_bijective)
{
  const Mesh mesh = make(list);
  const SP::Sphere_locator_3 locator(mesh, mesh.points(), is_known_to_be_bijective);
  EXPECT_EQ(locator.error_code(), error);
  expect_no_face(locator.locate(Point_3(1., 2., 3.)));
  std::vector<decltype(locator)::Face_location> locations;
  EXPECT_EQ(locator.locate(std::vector<Point_3>(3, Point_3(1., 2., 3.)), std::back_inserter(locations)), error);
  EXPECT_TRUE(locations.empty());
}

TEST(Locator, refuses_what_is_no_bijection)
{
  for(const auto& [list, error] : broken_maps())
  {
    expect_refusal(list, error, false);
    if(error == SP::ERROR_EMPTY_MESH || error == SP::ERROR_NON_CLOSED_MESH)
      expect_refusal(list, error, true);
  }
}

// A map of which it is said that it is a bijection may be any: walks go round in circles, and a search has to end them.
TEST(Locator, ends_if_it_is_told_that_any_map_is_a_bijection)
{
  Triangle_list far = icosphere(3);
  for(Coordinates& p : far.points)
    p[2] += 5.;
  expect_refusal(far, SP::ERROR_NO_1_TO_1_MAPPING, true);

  // Directions that are in no face of the one sphere are in one of the other, which no walk leads to.
  const Sphere_map map(disjoint_union(far, icosphere(1)));
  const SP::Sphere_locator_3 locator(map.mesh, map.map, true);
  ASSERT_EQ(locator.error_code(), SP::OK);
  for(const Coordinates& q : random_directions(1000, 7))
    if(std::abs(q[2]) < 0.9)
      expect_right(map, q, locator.locate(point(q)));
}

#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
TEST(Locator, keeps_at_most_48_bytes_a_face)
{
  const auto allocated = [] {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
  };
  const Sphere_map map(icosphere(6));
  const std::size_t before = allocated();
  const SP::Sphere_locator_3<Mesh, Point_map, CGAL::Sequential_tag> locator(map.mesh, map.map);
  ASSERT_EQ(locator.error_code(), SP::OK);
  EXPECT_LE(allocated() - before, 48 * map.triangles.size());
}
#endif

} // namespace
