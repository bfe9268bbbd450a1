// Surfaces that are as extreme as a shape, a numbering or a placement can be, each with the default settings: all get a
// certified map, and no time or memory is quadratic in anything.

#include "methods.h"
#include "random_meshes.h"
#include "test_scale.h"

#include <CGAL/boost/graph/helpers.h>

using namespace test;

namespace {

// Runs the default method, which has to find a map; that it is sound is checked on the way.
Result expect_mapped(const Triangle_list& list)
{
  const Mesh mesh = make(list);
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(mesh.number_of_vertices() + mesh.number_of_faces(), mesh.number_of_edges() + 2);
  const Result result = bijective().run(mesh);
  EXPECT_EQ(result.error, SP::OK) << SP::get_error_message(result.error);
  return result;
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
    list.triangles.push_back({n, (i + 1) % rings.front().size, i});
  for(std::size_t k = 0; k + 1 < rings.size(); ++k)
  {
    // Between two rings, the triangle with the smaller longitude comes first.
    const std::size_t size = rings[k].size, next_size = rings[k + 1].size, a = firsts[k], b = firsts[k + 1];
    for(std::size_t i = 0, j = 0; i < size || j < next_size;)
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
  for(std::size_t i = 0; i < rings.back().size; ++i)
    list.triangles.push_back({n + 1, firsts.back() + i, firsts.back() + (i + 1) % rings.back().size});
  return list;
}

// Puts a tube of `n_rings` triangles with a pyramid on top instead of the face, `length` long and getting thinner
// to the factor `taper`. Its last three faces are those of the pyramid.
void extrude(Triangle_list& list, std::size_t face, double length, std::size_t n_rings, double taper)
{
  const Triangle base = list.triangles[face];
  const std::array<Coordinates, 3> p = {list.points[base[0]], list.points[base[1]], list.points[base[2]]};
  const Coordinates center = centroid(list, base);
  const Coordinates direction = normalized(cross(difference(p[1], p[0]), difference(p[2], p[0])));
  list.triangles[face] = list.triangles.back(); // the face goes
  list.triangles.pop_back();
  Triangle previous = base;
  for(std::size_t k = 1; k <= n_rings; ++k)
  {
    const double t = static_cast<double>(k) / static_cast<double>(n_rings);
    Triangle ring;
    for(std::size_t i = 0; i < 3; ++i)
    {
      ring[i] = list.points.size();
      const Coordinates shrunk = combination(1., center, 1. + (taper - 1.) * t, difference(p[i], center));
      list.points.push_back(combination(length * t, direction, 1., shrunk));
    }
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3;
      list.triangles.push_back({previous[i], previous[j], ring[j]});
      list.triangles.push_back({previous[i], ring[j], ring[i]});
    }
    previous = ring;
  }
  const std::size_t apex = list.points.size();
  list.points.push_back(combination(1., center, length + 0.5 * taper * distance(p[0], p[1]), direction));
  for(std::size_t i = 0; i < 3; ++i)
    list.triangles.push_back({previous[i], previous[(i + 1) % 3], apex});
}

// Faces like needles. A vertex that is inserted between two others off the middle, towards a pole, makes a spike that no
// sweep undoes; which hole is seen from a pole is a matter of the order of the vertices.
TEST(Extreme_degrees, two_vertices_of_all_faces)
{
  for(const std::size_t n : std::vector<std::size_t>{20000, 70000, 150000, 200000})
  {
    if(n > test_scale::number_of(70000, 200000))
      break;
    const Triangle_list poles_last = suspension(n);
    std::vector<std::size_t> number(n + 2);
    for(std::size_t v = 0; v < n + 2; ++v)
      number[v] = (v + 2) % (n + 2);
    for(const Triangle_list& list : {poles_last, renumbered(poles_last, number, 1)})
      EXPECT_LT(expect_mapped(list).distortion.isometric.maximum, 2.5) << n << " faces at each pole";
  }
  const Triangle_list tall = test_meshes::scaled(suspension(5000), 1., 1., 10.);
  EXPECT_LT(expect_mapped(tall).distortion.isometric.maximum, 3.5);
}

TEST(Extreme_degrees, one_hub_in_a_fine_mesh)
{
  // A hemisphere around the hub, then ever fewer vertices in a ring.
  std::vector<Ring> rings;
  for(std::size_t size = test_scale::number_of(20000, 100000); size > 5; size = (size + 1) / 2)
  {
    const double angle = 0.5 * pi * std::pow(0.8, static_cast<double>(rings.size()));
    rings.push_back({std::sin(angle), std::cos(angle), size});
  }
  EXPECT_LT(expect_mapped(surface_of_revolution(0., rings, 1.)).distortion.isometric.average, 6.);
}

// Each vertex is put into the middle of one of the newest faces, or into the origin along with all others: faces shrink to
// nothing, and each lies within the one before.
TEST(Extreme_connectivity, stacks_that_shrink_into_a_point)
{
  for(const double scale : {1., 0.})
    for(std::size_t rule = 0; rule < 3; ++rule)
      for(const std::size_t n : {std::size_t(300), test_scale::number_of(1000, 3000)})
      {
        SCOPED_TRACE(std::to_string(scale) + ", rule " + std::to_string(rule) + ", " + std::to_string(n) + " vertices");
        Triangle_list list = test_meshes::scaled(tetrahedron(), scale, scale, scale);
        for(std::size_t k = 0; k < n; ++k)
        {
          const Triangle t = list.triangles.back();
          const std::size_t v = list.points.size();
          split_face(list, list.triangles.size() - 1, centroid(list, t));
          if(rule == 0)
            std::swap(list.triangles.back(), *(list.triangles.end() - 2));
          if(rule == 2)
            list.triangles.back() = {v, t[2], t[0]};
        }
        expect_mapped(list);
      }
}

// At 1e8, doubles are 1.5e-8 apart, 1.5e-5 of what is 1e-3 large.
TEST(Extreme_coordinates, far_away)
{
  const Triangle_list list = bumpy_sphere(3);
  Triangle_list far = test_meshes::scaled(list, 1e-3, 1e-3, 1e-3);
  for(Coordinates& p : far.points)
    p = combination(1., p, 1e8, {1., -1., 1.});
  const Result original = expect_mapped(list), result = expect_mapped(far);
  EXPECT_NEAR(result.report.radius / 1e-3 / original.report.radius, 1., 1e-3);
  EXPECT_NEAR(result.distortion.isometric.average / original.distortion.isometric.average, 1., 1e-2);
}

// The sphere that has the area of such a surface is out of range; a smaller one is not.
TEST(Extreme_coordinates, at_the_ends_of_the_range)
{
  const double largest = (std::numeric_limits<double>::max)();
  Triangle_list list = tetrahedron();
  for(Coordinates& p : list.points)
    for(double& x : p)
      x = std::copysign(largest, x);
  expect_mapped(list);
  list.points = {{0., 0., -largest}, {1., 0., largest}, {0., 1., largest}, {0., 0., largest}};
  expect_mapped(list);
}

TEST(Extreme_coordinates, flat_self_intersecting_and_random)
{
  const Triangle_list list = bumpy_sphere(3);
  expect_mapped(test_meshes::scaled(list, 1., 1., 0.));
  expect_mapped(test_meshes::scaled(list, 1., 0., 0.));
  EXPECT_EQ(expect_mapped(test_meshes::scaled(list, 0., 0., 0.)).report.number_of_flat_faces, list.triangles.size());

  Triangle_list noisy = icosphere(4), all_random = noisy;
  Random random(5);
  for(std::size_t v = 0; v < noisy.points.size(); ++v)
  {
    all_random.points[v] = random.in_cube();
    noisy.points[v] = combination(1., noisy.points[v], 0.3, all_random.points[v]);
  }
  expect_mapped(noisy);
  expect_mapped(all_random);
}

TEST(Extreme_shapes, long_tubes)
{
  const std::size_t n = test_scale::reduced(2000);
  for(const std::size_t size : {3u, 6u})
  {
    std::vector<Ring> rings;
    for(std::size_t k = 0; k < n; ++k)
      rings.push_back({1., 0.5 * static_cast<double>(k), size});
    EXPECT_LT(
        expect_mapped(surface_of_revolution(-0.5, rings, 0.5 * static_cast<double>(n))).distortion.isometric.average,
        50.)
        << size;
  }
}

TEST(Extreme_shapes, geometric_grading)
{
  std::vector<Ring> rings; // around the pole (0, 0, -1), by their angles there
  for(int k = 0; k < 80; ++k)
  {
    const double angle = k <= 60 ? 1e-10 * std::pow(0.5e10, k / 60.) : 0.5 + (pi - 0.5) * (k - 60) / 20.;
    rings.push_back({std::sin(angle), -std::cos(angle), 16});
  }
  EXPECT_LT(expect_mapped(surface_of_revolution(-1., rings, 1.)).distortion.isometric.average, 1.1); // this is a sphere
}

TEST(Extreme_shapes, tree_of_tubes)
{
  Random random(1);
  Triangle_list list = tetrahedron();
  for(std::size_t i = 0; i < test_scale::reduced(300); ++i)
  {
    // the later faces are those at the ends of the branches
    const std::size_t n = list.triangles.size(), face = n - 1 - random.below((std::min)(n, std::size_t(40)));
    const double width = distance(list.points[list.triangles[face][0]], list.points[list.triangles[face][1]]);
    const double length = width * random.between(2., 20.);
    extrude(list, face, length, 4 + random.below(12), 0.8);
  }
  expect_mapped(list);
}

} // namespace
