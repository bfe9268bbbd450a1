// The common refinement of two meshes of the sphere is closed, covers each face of both exactly, and has the crossings that
// a rational brute force finds, whatever coincides.

#include "judge.h"
#include "methods.h"
#include "random_meshes.h"
#include "surfaces.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Spherical_parameterization/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/measure_distortion_between.h>
#include <CGAL/Spherical_parameterization/overlay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace test;

namespace {

using Overlay = SP::Surface_overlay_3<Mesh, Mesh>;
using Triangulation = SP::internal::Sphere_triangulation<Kernel>;

Triangulation triangulation_of(const Triangle_list& list)
{
  std::vector<Point_3> points;
  for(const Coordinates& p : list.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for(const Triangle& t : list.triangles)
    triangles.push_back(
        {static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
  Triangulation result;
  result.assign(points, SP::internal::link_triangles(triangles, points.size()));
  return result;
}

Triangle_list turned(Triangle_list list, double angle)
{
  for(Coordinates& p : list.points)
    p = {std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1], p[2]};
  return list;
}

// turned about another axis, so that nothing coincides
Triangle_list tilted(Triangle_list list)
{
  list = turned(list, 0.1);
  for(Coordinates& p : list.points)
    p = {p[2], p[0], p[1]};
  return turned(list, 0.2);
}

const std::vector<std::pair<std::string, Triangle_list>>& lists()
{
  static const std::vector<std::pair<std::string, Triangle_list>> result = {
      {"tetrahedron", tetrahedron()},
      {"octahedron", octahedron()},
      {"octahedron, turned by an eighth", turned(octahedron(), pi / 4.)},
      {"cube", list_of(SP::Sphere_domain_3::cube(1))},
      {"cube of 3", list_of(SP::Sphere_domain_3::cube(3))},
      {"octahedron of 4", list_of(SP::Sphere_domain_3::octahedron(4))},
      {"icosphere", icosphere(1)},
      {"bumpy", bumpy_sphere(2)},
      {"stacked", random_stacked_sphere(60, 1)},
      {"stacked, again", random_stacked_sphere(90, 1)}, // shares most of its vertices with the one before
      {"slivers", with_slivers(icosphere(1), 10, 1e-9)},
      {"suspension", suspension(50)}};
  return result;
}

Mesh surface_of(const Triangle_list& list, double x)
{
  return make(scaled(list, x, 1., 2.));
}

Overlay overlay_of(const Mesh& mesh1, const Triangle_list& sphere1, const Mesh& mesh2, const Triangle_list& sphere2)
{
  Overlay result;
  EXPECT_EQ(SP::overlay(mesh1, Point_map(mesh1, sphere1.points), mesh2, Point_map(mesh2, sphere2.points), result),
            SP::OK);
  return result;
}

double area_of(const Overlay& overlay, std::size_t k, std::size_t surface)
{
  const auto p = [&](std::size_t i) -> Coordinates {
    const auto& q = overlay.points[overlay.triangles[k][i]][surface];
    return {q.x(), q.y(), q.z()};
  };
  return area(p(0), p(1), p(2));
}

// The triangles of each face have its area in total, on both surfaces; nothing but ties and rounding is turned over.
TEST(Overlay, covers_each_face_of_both_surfaces)
{
  for(const auto& [name1, list1] : lists())
    for(const auto& [name2, list2] : lists())
    {
      SCOPED_TRACE(name1 + " and " + name2);
      const Mesh mesh1 = surface_of(list1, 1.), mesh2 = surface_of(list2, 3.);
      const Overlay overlay = overlay_of(mesh1, list1, mesh2, list2);
      ASSERT_EQ(overlay.faces.size(), overlay.triangles.size());
      ASSERT_EQ(overlay.triangles.size(), 2 * overlay.points.size() - 4); // Euler's formula
      std::set<std::array<std::uint32_t, 2>> edges;
      for(const auto& t : overlay.triangles)
        for(std::size_t i = 0; i < 3; ++i)
          ASSERT_TRUE(edges.insert({t[i], t[(i + 1) % 3]}).second);
      for(const auto& [a, b] : edges)
        ASSERT_TRUE(edges.count({b, a}) > 0); // closed, and oriented

      std::vector<double> areas1(mesh1.number_of_faces(), 0.), areas2(mesh2.number_of_faces(), 0.);
      for(std::size_t k = 0; k < overlay.triangles.size(); ++k)
      {
        areas1[overlay.faces[k].first] += area_of(overlay, k, 0);
        areas2[overlay.faces[k].second] += area_of(overlay, k, 1);
      }
      const auto expect_areas = [](const Mesh& mesh, const std::vector<double>& areas) {
        const test::Images p = points(mesh);
        const std::vector<Triangle> t = triangles(mesh);
        for(std::size_t f = 0; f < t.size(); ++f)
          ASSERT_NEAR(areas[f], area(p[t[f][0]], p[t[f][1]], p[t[f][2]]), 1e-7) << f;
      };
      expect_areas(mesh1, areas1);
      expect_areas(mesh2, areas2);
    }
}

// For meshes in general position, the crossings are those of the pairs of edges whose ends are on different sides.
TEST(Overlay, has_the_crossings_of_a_brute_force)
{
  const auto exact = [](const Coordinates& p) { return judge::exact(p); };
  const auto edges_of = [](const Triangle_list& list) {
    std::set<std::array<std::size_t, 2>> result;
    for(const Triangle& t : list.triangles)
      for(std::size_t i = 0; i < 3; ++i)
        result.insert({(std::min)(t[i], t[(i + 1) % 3]), (std::max)(t[i], t[(i + 1) % 3])});
    return result;
  };
  for(const auto& [name, list1] : lists())
  {
    SCOPED_TRACE(name);
    const Triangle_list list2 = tilted(random_stacked_sphere(30, 7));
    std::size_t n = 0;
    for(const auto& [a, b] : edges_of(list1))
      for(const auto& [c, d] : edges_of(list2))
      {
        const auto p = exact(list1.points[a]), q = exact(list1.points[b]), r = exact(list2.points[c]),
                   s = exact(list2.points[d]);
        const int pqr = CGAL::sign(judge::determinant(p, q, r)), pqs = CGAL::sign(judge::determinant(p, q, s)),
                  rsp = CGAL::sign(judge::determinant(r, s, p)), rsq = CGAL::sign(judge::determinant(r, s, q));
        ASSERT_NE(pqr * pqs * rsp * rsq, 0);
        n += pqr != pqs && rsp != rsq && pqr == rsq; // or they would cross on the other side of the sphere
      }
    const Triangulation first = triangulation_of(list1), second = triangulation_of(list2);
    SP::internal::Sphere_overlay<Kernel> overlay;
    ASSERT_EQ(overlay.assign(first, second, {}), SP::OK);
    EXPECT_EQ(overlay.crossings().size(), n);
  }
}

// The time is linear in the crossings, which are many where two such vertices coincide.
TEST(Overlay, around_vertices_of_high_degree)
{
  SP::internal::Sphere_overlay<Kernel> overlay;
  const Triangulation hub = triangulation_of(suspension(10000)), other = triangulation_of(tilted(icosphere(3)));
  EXPECT_EQ(overlay.assign(hub, other, {}), SP::OK);
  EXPECT_EQ(overlay.assign(other, hub, {}), SP::OK);
  const Triangulation small_hub = triangulation_of(suspension(300));
  EXPECT_EQ(overlay.assign(small_hub, small_hub, {}), SP::OK);
  // What is too large for the numbers of vertices is told.
  const std::size_t n = overlay.number_of_vertices();
  SP::internal::Sphere_overlay<Kernel> large(n - 1), fitting(n);
  EXPECT_EQ(large.assign(small_hub, small_hub, {}), SP::ERROR_TOO_LARGE_MESH);
  EXPECT_EQ(fitting.assign(small_hub, small_hub, {}), SP::OK);
}

TEST(Overlay, is_the_same_in_any_number_of_threads)
{
  const Triangle_list list1 = icosphere(4), list2 = turned(icosphere(4), 0.2);
  const Mesh mesh1 = make(list1), mesh2 = make(list2);
  Overlay parallel, sequential;
  ASSERT_EQ(SP::overlay(mesh1, mesh1.points(), mesh2, mesh2.points(), parallel), SP::OK);
  ASSERT_EQ(SP::overlay<CGAL::Sequential_tag>(mesh1, mesh1.points(), mesh2, mesh2.points(), sequential), SP::OK);
  EXPECT_EQ(parallel.points, sequential.points);
  EXPECT_EQ(parallel.triangles, sequential.triangles);
  EXPECT_EQ(parallel.faces, sequential.faces);
}

TEST(Overlay, does_not_depend_on_the_length_of_directions)
{
  const Triangle_list list1 = icosphere(2), list2 = tilted(icosphere(2));
  const Mesh mesh1 = make(list1), mesh2 = make(list2);
  const Overlay expected = overlay_of(mesh1, list1, mesh2, list2);
  for(const int exponent : {-300, 300})
  {
    const double s = std::ldexp(1., exponent);
    const Overlay overlay = overlay_of(mesh1, scaled(list1, s, s, s), mesh2, scaled(list2, s, s, s));
    ASSERT_EQ(overlay.triangles, expected.triangles);
    for(std::size_t v = 0; v < expected.points.size(); ++v)
      for(const std::size_t surface : {0u, 1u})
        ASSERT_LT(CGAL::squared_distance(overlay.points[v][surface], expected.points[v][surface]), 1e-20);
  }
}

TEST(Overlay, of_what_is_no_bijection_is_refused)
{
  Triangle_list folded = icosphere(1);
  std::swap(folded.points[0], folded.points[1]);
  const Mesh good = make(icosphere(1)), bad = make(folded), torus_mesh = make(torus(5, 5));
  Overlay overlay;
  EXPECT_EQ(SP::overlay(good, good.points(), bad, bad.points(), overlay), SP::ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(SP::overlay(bad, bad.points(), good, good.points(), overlay), SP::ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(SP::overlay(good, good.points(), torus_mesh, torus_mesh.points(), overlay),
            SP::ERROR_NO_TOPOLOGICAL_SPHERE);
  Mesh infinite = good;
  infinite.point(Mesh::Vertex_index(3)) = Point_3(0., std::numeric_limits<double>::infinity(), 0.);
  EXPECT_EQ(SP::overlay(good, good.points(), infinite, Point_map(infinite, icosphere(1).points), overlay),
            SP::ERROR_NON_FINITE_COORDINATE);
  EXPECT_TRUE(overlay.points.empty());
}

SP::Distortion_between distortion_of(const Overlay& overlay)
{
  SP::Distortion_between result;
  EXPECT_EQ(SP::measure_distortion_between(overlay, result), SP::OK);
  return result;
}

TEST(Distortion_between, a_surface_and_itself_is_none)
{
  for(const auto& [name, list] : lists())
  {
    SCOPED_TRACE(name);
    const Mesh mesh1 = surface_of(list, 1.), mesh2 = surface_of(scaled(list, 5., 5., 5.), 1.);
    const SP::Distortion_between distortion = distortion_of(overlay_of(mesh1, list, mesh2, list));
    EXPECT_NEAR(distortion.energy.maximum, 2., 1e-4); // of triangles with a share of 1e-10
    EXPECT_NEAR(distortion.energy.average_over_first, 2., 1e-9);
    EXPECT_NEAR(distortion.isometric.average_over_second, 1., 1e-9);
    EXPECT_GT(distortion.number_of_slivers, 0u);
  }
}

// 0 would be better than an isometry.
TEST(Distortion_between, surfaces_without_area_is_infinite)
{
  const Triangle_list list = icosphere(1);
  const Mesh mesh = make(list), point = make(scaled(list, 0., 0., 0.)), line = make(scaled(list, 0., 1., 0.));
  for(const auto& [first, second] : {std::pair(&mesh, &point), std::pair(&line, &mesh), std::pair(&line, &point)})
  {
    const SP::Distortion_between distortion = distortion_of(overlay_of(*first, list, *second, list));
    EXPECT_EQ(distortion.number_of_slivers, distortion.number_of_triangles);
    for(const auto& statistics : {distortion.isometric, distortion.area, distortion.angle, distortion.energy})
      for(const double value : {statistics.maximum, statistics.average_over_first, statistics.average_over_second})
        EXPECT_EQ(value, std::numeric_limits<double>::infinity());
  }
}

TEST(Distortion_between, nothing_is_refused)
{
  const Triangle_list list = icosphere(1);
  const Mesh mesh = make(list);
  SP::Distortion_between distortion;
  EXPECT_EQ(SP::measure_distortion_between(Overlay(), distortion), SP::ERROR_EMPTY_MESH);
  for(const double smallest_area : {-1e-10, 1., std::nan("")})
    EXPECT_EQ(SP::measure_distortion_between(overlay_of(mesh, list, mesh, list), distortion, smallest_area),
              SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(distortion.number_of_triangles, 0u);
}

// One surface, stretched: all triangles have the same distortion, as the mesh is mapped by one affinity.
TEST(Distortion_between, affine_images_is_that_of_the_affinity)
{
  const Triangle_list list = octahedron();
  Mesh flat1 = make(list), flat2 = make(list);
  for(const auto v : flat1.vertices()) // faces on two sides of the plane z = 0, all of the same area
  {
    const Coordinates p = list.points[v];
    flat1.point(v) = Point_3(p[0], p[1], 0.);
    flat2.point(v) = Point_3(2. * p[0], 0.5 * p[1], 0.);
  }
  const SP::Distortion_between distortion = distortion_of(overlay_of(flat1, list, flat2, list));
  EXPECT_NEAR(distortion.isometric.maximum, 2., 1e-12);
  EXPECT_NEAR(distortion.area.average_over_first, 2., 1e-12);
  EXPECT_NEAR(distortion.angle.average_over_second, 4.25, 1e-12);
  EXPECT_NEAR(distortion.energy.average_over_first, 4.25, 1e-12);
  EXPECT_EQ(distortion.number_of_triangles, 2 * (12u + 18u) - 4u); // with the crossings of each edge with its twin
}

// The inverse has the same distortion, with the averages exchanged, but for how cells are divided into triangles.
TEST(Distortion_between, is_symmetric)
{
  const Triangle_list list1 = icosphere(2), list2 = turned(bumpy_sphere(2), 0.4);
  const Mesh mesh1 = surface_of(list1, 1.), mesh2 = surface_of(list2, 3.);
  const SP::Distortion_between there = distortion_of(overlay_of(mesh1, list1, mesh2, list2)),
                               back = distortion_of(overlay_of(mesh2, list2, mesh1, list1));
  EXPECT_NEAR(there.energy.average_over_first, back.energy.average_over_second, 1e-2);
  EXPECT_NEAR(there.isometric.average_over_second, back.isometric.average_over_first, 1e-2);
  EXPECT_GT(there.energy.average_over_first, 2.1);
}

} // namespace
