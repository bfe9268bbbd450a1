// The distance between two surfaces: for those for which it is known, and of places to triangles, however flat, against
// the exact one.

#include <CGAL/Spherical_parameterization/Sampling/internal/Triangle_set.h>
#include <CGAL/Spherical_parameterization/Sampling/measure_distance.h>

#include "methods.h"
#include "random_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

using namespace test;

namespace {

using CGAL::parameters::number_of_points_on_faces;
using Vertex_index = Mesh::Vertex_index;

SP::Surface_distance distance(const Mesh& mesh1, const Mesh& mesh2)
{
  SP::Surface_distance result;
  EXPECT_EQ(SP::measure_distance(mesh1, mesh2, result), SP::OK);
  return result;
}

TEST(Distance, between_spheres_is_that_of_their_radii)
{
  const SP::Surface_distance d = distance(make(icosphere(5)), make(scaled(icosphere(5), 1.1, 1.1, 1.1)));
  EXPECT_NEAR(d.from_first.root_mean_square, 0.1, 1e-3);
  EXPECT_NEAR(d.from_second.maximum, 0.1, 1e-3);
  EXPECT_NEAR(d.diagonal, std::sqrt(12.), 1e-2);
  EXPECT_NEAR(d.psnr(), 20. * std::log10(std::sqrt(12.) / 0.1), 0.1);
  EXPECT_EQ(SP::Surface_distance().psnr(), std::numeric_limits<double>::infinity());
}

// Of the larger surface, only a part is near the smaller one: it takes both ways to see that.
TEST(Distance, is_measured_both_ways)
{
  const SP::Surface_distance d =
      distance(make(icosphere(2)), make(disjoint_union(icosphere(2), scaled(icosphere(2), 3., 3., 3.))));
  EXPECT_NEAR(d.from_first.maximum, 0., 1e-12);
  EXPECT_NEAR(d.from_second.maximum, 2., 0.1);
  EXPECT_NEAR(d.from_second.root_mean_square, 2. * std::sqrt(0.9), 0.1);
}

// Faces without an area have no places, unless there are no others: here all are on a line.
TEST(Distance, with_flat_faces)
{
  const Mesh sphere = make(icosphere(2)), line = make(scaled(icosphere(2), 2., 0., 0.));
  EXPECT_NEAR(distance(sphere, make(with_slivers(icosphere(2), 40, 0.))).from_first.maximum, 0., 1e-12);
  const SP::Surface_distance d = distance(line, sphere);
  EXPECT_DOUBLE_EQ(d.diagonal, 4.);
  EXPECT_NEAR(d.from_first.maximum, 1., 0.1);
  EXPECT_NEAR(d.from_second.maximum, 1., 0.1);
}

TEST(Distance, refuses_what_is_no_surface_of_triangles_and_may_be_stopped)
{
  const Mesh sphere = make(icosphere(1));
  SP::Surface_distance d;
  d.diagonal = 7.;
  Mesh nan = sphere, infinite = sphere;
  nan.point(Vertex_index(7)) = Point_3(0., std::nan(""), 0.);
  infinite.point(Vertex_index(7)) = Point_3(0., std::numeric_limits<double>::infinity(), 0.);
  for(const auto& [mesh, error] : {std::pair(cube(), SP::ERROR_NON_TRIANGULAR_MESH),
                                   {Mesh(), SP::ERROR_EMPTY_MESH},
                                   {nan, SP::ERROR_NON_FINITE_COORDINATE},
                                   {infinite, SP::ERROR_NON_FINITE_COORDINATE}})
  {
    EXPECT_EQ(SP::measure_distance(sphere, mesh, d), error);
    EXPECT_EQ(SP::measure_distance(mesh, sphere, d), error);
  }
  EXPECT_EQ(SP::measure_distance(sphere, sphere, d, number_of_points_on_faces(0)), SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(SP::measure_distance(sphere, sphere, d, CGAL::parameters::default_values(), number_of_points_on_faces(-1)),
            SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(SP::measure_distance(sphere, sphere, d, CGAL::parameters::maximum_running_time(1e-9)), SP::ERROR_STOPPED);
  EXPECT_EQ(d.diagonal, 7.);
}

TEST(Distance, does_not_depend_on_the_unit)
{
  const auto measure = [](double unit) {
    SP::Surface_distance d;
    EXPECT_EQ(SP::measure_distance(make(scaled(icosphere(1), unit, unit, unit)),
                                   make(scaled(icosphere(1), 1.5 * unit, 1.5 * unit, 1.5 * unit)), d,
                                   number_of_points_on_faces(100)),
              SP::OK);
    return d;
  };
  const SP::Surface_distance d = measure(1.);
  for(const int exponent : {-1060, -500, 500, 1022})
  {
    const double unit = std::scalbn(1., exponent), tolerance = exponent == -1060 ? 1e-3 : 1e-12;
    const SP::Surface_distance other = measure(unit);
    EXPECT_NEAR(other.from_first.root_mean_square / unit, d.from_first.root_mean_square, tolerance);
    EXPECT_NEAR(other.from_second.maximum / unit, d.from_second.maximum, tolerance);
    EXPECT_NEAR(other.psnr(), d.psnr(), 0.1);
  }
}

// Triangles of every shape: the third corner is anywhere, near the others, on their edge, or nearly so.
TEST(Triangles, have_the_exact_distance)
{
  using Exact_point_3 = CGAL::Epeck::Point_3;
  const auto exact = [](const Coordinates& p) { return Exact_point_3(p[0], p[1], p[2]); };
  Random random(1);
  const auto between = [](const Coordinates& p, const Coordinates& q, double s) {
    return combination(1., p, s, difference(q, p));
  };
  for(std::size_t k = 0; k < 2000; ++k)
  {
    const Coordinates a = random.in_cube(), b = random.in_cube(),
                      c = between(between(a, b, random.between(-1., 1.)), random.in_cube(),
                                  std::array<double, 5>{1., 1e-5, 1e-10, 1e-16, 0.}[k % 5]);
    const Coordinates p =
        k % 2 == 0 ? random.in_cube() : between(between(a, b, random.between(-1., 1.)), c, random.between(-1., 1.));
    const CGAL::Epeck::Triangle_3 triangle(exact(a), exact(b), exact(c));
    const CGAL::Epeck::Segment_3 edges[] = {{exact(a), exact(b)}, {exact(b), exact(c)}, {exact(c), exact(a)}};
    CGAL::Epeck::FT expected = triangle.is_degenerate() ? CGAL::squared_distance(exact(p), edges[0])
                                                        : CGAL::squared_distance(exact(p), triangle);
    for(const CGAL::Epeck::Segment_3& edge : edges)
      expected = (std::min)(expected, CGAL::squared_distance(exact(p), edge));
    const std::array<Coordinates, 3> corners = {a, b, c};
    EXPECT_NEAR(std::sqrt(SP::internal::squared_distance(p, corners.data())), std::sqrt(CGAL::to_double(expected)),
                1e-14);
  }
}

// All needles around a vertex reach from it to the rim, so that boxes in general have each place in common.
TEST(Triangles, around_a_vertex_of_high_degree_are_told_apart)
{
  const auto seconds = [](const Triangle_list& list) {
    const Mesh mesh = make(list), other = make(scaled(list, 1., 1., 1.01));
    SP::Surface_distance distance;
    const std::clock_t begin = std::clock(); // of the processor
    EXPECT_EQ(SP::measure_distance<CGAL::Sequential_tag>(mesh, other, distance), SP::OK);
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  // 20,480 faces each: 60 times as long were measured with upright boxes, and 1.7 times now.
  EXPECT_LT(seconds(tilted(suspension(10240))), 6. * seconds(icosphere(5)));
}

TEST(Triangles, have_a_tree_that_finds_the_nearest_one)
{
  std::vector<Triangle_list> lists = {suspension(2000), tilted(suspension(2000))};
  for(const std::size_t n : {4u, 5u, 7u, 100u, 3001u})
    lists.push_back(random_stacked_sphere(n, 1));
  for(const Triangle_list& list : lists)
  {
    const Mesh mesh = make(list);
    Images corners;
    ASSERT_EQ(SP::internal::append_corners(mesh, mesh.points(), corners), SP::OK);
    const SP::internal::Triangle_set set(corners.data(), corners.size());
    for(std::size_t k = 0; k < 100; ++k)
    {
      const Coordinates p = set.place(k, 100), q = {1.1 * p[0], 0.9 * p[1] - 0.1, p[2]};
      double expected = std::numeric_limits<double>::infinity();
      for(const auto f : mesh.faces())
      {
        std::array<Coordinates, 3> t;
        std::size_t i = 0;
        for(const Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
          t[i++] = {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
        expected = (std::min)(expected, SP::internal::squared_distance(q, t.data()));
      }
      EXPECT_NEAR(set.squared_distance_to(q), expected, 1e-15);
      EXPECT_NEAR(set.squared_distance_to(p), 0., 1e-30);
    }
  }
}

} // namespace
