// The common refinement of two meshes of the sphere is closed, covers each face of both exactly, and has the crossings that
// a rational brute force finds, whatever coincides.

#include "Counting_kernel.h"
#include "judge.h"
#include "recording_control.h"
#include "surfaces.h"

#include <CGAL/Spherical_parameterization/Surface_maps/internal/measure_map.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/Edge_traces.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/Perturbed_orientation.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/Sphere_overlay.h>

using namespace test;

namespace {

using Overlay = SP::Surface_overlay_3<Mesh, Mesh>;

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
      {"suspension", suspension(50)},
      {"tilted", tilted(random_stacked_sphere(30, 7))}}; // in general position to all others
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

Coordinates coordinates_of(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

double area_of(const Overlay& overlay, std::size_t k, std::size_t surface)
{
  const auto p = [&](std::size_t i) { return coordinates_of(overlay.points[overlay.triangles[k][i]][surface]); };
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

// Where the surfaces are the spheres themselves, both places of a vertex, and of a crossing, are the same but for their length.
TEST(Overlay, gives_each_vertex_one_direction)
{
  for(const auto& [name1, list1] : lists())
    for(const auto& [name2, list2] : lists())
    {
      SCOPED_TRACE(name1 + " and " + name2);
      const Mesh mesh1 = make(list1), mesh2 = make(list2);
      const Overlay overlay = overlay_of(mesh1, list1, mesh2, list2);
      // Where an edge of 1e-9 goes on another one, rounding leaves open which of its ends is theirs.
      const double tolerance = name1 == "slivers" || name2 == "slivers" ? 1e-9 : 1e-14;
      for(std::size_t v = 0; v < overlay.points.size(); ++v)
      {
        const Coordinates p = coordinates_of(overlay.points[v][0]), q = coordinates_of(overlay.points[v][1]);
        ASSERT_GT(dot(p, q), 0.) << v;
        ASSERT_LT(norm(cross(p, q)), tolerance) << v; // of lengths of about 1
      }
    }
}

using Ends = std::array<std::size_t, 2>;
using Crossings = std::set<std::array<Ends, 2>>; // the ends of an edge of each mesh, the smaller number first

Ends edge_of(std::size_t v, std::size_t w)
{
  return {(std::min)(v, w), (std::max)(v, w)};
}

std::set<Ends> edges_of(const Triangle_list& list)
{
  std::set<Ends> result;
  for(const Triangle& t : list.triangles)
    for(std::size_t i = 0; i < 3; ++i)
      result.insert(edge_of(t[i], t[(i + 1) % 3]));
  return result;
}

// Multiples of 2^-40: no determinant of three points, nor product of coordinates of (p x q) and r, is nearer to 0 than
// 2^-120, but for 0.
Triangle_list on_grid(Triangle_list list)
{
  for(Coordinates& p : list.points)
    for(double& x : p)
      x = std::ldexp(std::round(std::ldexp(x, 40)), -40);
  return list;
}

using Exact_image = judge::Image<CGAL::Exact_rational>;

std::vector<Exact_image> exact_points(const Triangle_list& list)
{
  std::vector<Exact_image> result;
  for(const Coordinates& p : list.points)
    result.push_back(judge::exact(p));
  return result;
}

// (1 + E) p in rationals, for the matrix E of Perturbed_orientation with d = 2^-2000: each entry is 2^-200 times the one
// before, and products of two are below 2^-4000, the last entry is 2^-3600. For points on the grid, these are
// infinitesimals: what is infinitely smaller than an entry is smaller than 2^-120 times the entry.
std::vector<Exact_image> perturbed_points(const Triangle_list& list)
{
  std::array<CGAL::Exact_rational, 9> entries;
  CGAL::Exact_rational x = 1;
  for(int k = 0; k < 10; ++k)
    x *= CGAL::Exact_rational(0x1p-200);
  for(CGAL::Exact_rational& entry : entries)
  {
    entry = x;
    x *= CGAL::Exact_rational(0x1p-200);
  }
  std::vector<Exact_image> result = exact_points(list);
  for(Exact_image& p : result)
  {
    const Exact_image q = p;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        p[i] += entries[3 * i + j] * q[j];
  }
  return result;
}

// For each edge of `of`, the sides of the vertices of `in`: by the doubles, and where these are on it, by exact points.
std::map<Ends, std::vector<int>> sides_of(const Triangle_list& of, const std::vector<Exact_image>& exact_of,
                                          const Triangle_list& in, const std::vector<Exact_image>& exact_in)
{
  std::map<Ends, std::vector<int>> result;
  for(const Ends& e : edges_of(of))
    for(std::size_t v = 0; v < in.points.size(); ++v)
    {
      int side = judge::sign_of_determinant(of.points[e[0]], of.points[e[1]], in.points[v]);
      if(side == 0)
        side = CGAL::sign(judge::determinant(exact_of[e[0]], exact_of[e[1]], exact_in[v]));
      EXPECT_NE(side, 0);
      result[e].push_back(side);
    }
  return result;
}

// The pairs of edges whose ends are on different sides of each other, of the first mesh as it is perturbed.
Crossings crossings_of_brute_force(const Triangle_list& list1, const Triangle_list& list2)
{
  const std::vector<Exact_image> points1 = perturbed_points(list1), points2 = exact_points(list2);
  const auto sides1 = sides_of(list1, points1, list2, points2), sides2 = sides_of(list2, points2, list1, points1);
  Crossings result;
  for(const auto& [e, sides_of_e] : sides1)
    for(const auto& [f, sides_of_f] : sides2)
    {
      const int c = sides_of_e[f[0]], d = sides_of_e[f[1]], a = sides_of_f[e[0]], b = sides_of_f[e[1]];
      if(c != d && a != b && c == b) // or they would cross on the other side of the sphere
        result.insert({e, f});
    }
  return result;
}

TEST(Overlay, has_the_crossings_of_a_brute_force)
{
  for(const auto& [name1, list1] : lists())
    for(const auto& [name2, list2] : lists())
    {
      SCOPED_TRACE(name1 + " and " + name2);
      const Triangle_list on_grid1 = on_grid(list1), on_grid2 = on_grid(list2);
      ASSERT_TRUE(judge::is_one_to_one(on_grid1.points, on_grid1.triangles));
      const auto first = triangulation_of<Kernel>(on_grid1), second = triangulation_of<Kernel>(on_grid2);
      Recording_control control;
      SP::internal::Sphere_overlay overlay;
      ASSERT_EQ(overlay.assign(first, second, control, {}), SP::OK);
      const SP::internal::Triangle_sides sides1(first.triangles()), sides2(second.triangles());
      const auto ends = [](const auto& sides, std::size_t e) { return edge_of(sides.source(e), sides.target(e)); };
      Crossings crossings;
      for(const auto& [e, f] : overlay.crossings())
        ASSERT_TRUE(crossings.insert({ends(sides1, e), ends(sides2, f)}).second);
      EXPECT_EQ(crossings, crossings_of_brute_force(on_grid1, on_grid2));
    }
}

// Counts how often it is asked.
class Counting_orientation : public SP::internal::Perturbed_orientation
{
public:
  using SP::internal::Perturbed_orientation::Perturbed_orientation;

  CGAL::Sign operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    ++n_orientations;
    return SP::internal::Perturbed_orientation::operator()(p, q, r);
  }

  inline static std::size_t n_orientations = 0;
};

// What the overlay of two meshes asks for, and how many vertices it has.
std::pair<double, double> orientations_and_vertices(const Triangle_list& list1, const Triangle_list& list2)
{
  const auto first = triangulation_of<Kernel>(list1), second = triangulation_of<Kernel>(list2);
  SP::internal::Sphere_overlay overlay;
  Recording_control control;
  Counting_orientation::n_orientations = 0;
  EXPECT_EQ(overlay.assign<Counting_orientation>(first, second, control, {}), SP::OK);
  return {static_cast<double>(Counting_orientation::n_orientations), static_cast<double>(overlay.number_of_vertices())};
}

// The time is linear in what comes out, which is in proportion to the degree of a vertex, and to the product of the degrees
// where two such vertices coincide.
TEST(Overlay, asks_in_proportion_to_its_vertices_around_vertices_of_high_degree)
{
  const Triangle_list other = tilted(icosphere(3));
  const auto expect_linear = [](const std::pair<double, double>& small, const std::pair<double, double>& large) {
    EXPECT_GT(large.second, 1.8 * small.second);
    EXPECT_LT(large.first / small.first, 1.05 * large.second / small.second);
    EXPECT_LT(large.first, 6. * large.second); // 3.4 times as many were counted
  };
  expect_linear(orientations_and_vertices(suspension(1000), other), orientations_and_vertices(suspension(2000), other));
  expect_linear(orientations_and_vertices(other, suspension(1000)), orientations_and_vertices(other, suspension(2000)));
  expect_linear(orientations_and_vertices(suspension(100), suspension(100)),
                orientations_and_vertices(suspension(200), suspension(200)));
}

TEST(Overlay, that_is_too_large_is_refused)
{
  const auto small = triangulation_of<Kernel>(octahedron());
  Recording_control control;
  SP::internal::Sphere_overlay overlay;
  ASSERT_EQ(overlay.assign(small, small, control, {}), SP::OK);
  const std::size_t n = overlay.number_of_vertices();
  SP::internal::Sphere_overlay large(n - 1), fitting(n);
  EXPECT_EQ(large.assign(small, small, control, {}), SP::ERROR_TOO_LARGE_OVERLAY);
  EXPECT_EQ(fitting.assign(small, small, control, {}), SP::OK);

  Mapped_mesh mesh(octahedron());
  Overlay result;
  const auto with_bound = [&](std::size_t bound) {
    return SP::overlay(mesh.mesh, mesh.sphere, mesh.mesh, mesh.sphere, result, CGAL::parameters::maximum_number(bound));
  };
  EXPECT_EQ(with_bound(n - 1), SP::ERROR_TOO_LARGE_OVERLAY);
  EXPECT_TRUE(result.triangles.empty());
  EXPECT_EQ(with_bound(n), SP::OK);
  EXPECT_EQ(result.points.size(), n);
  // Two hubs would fill the memory: 20,000 vertices have 200 million crossings.
  const Mapped_mesh hubs(suspension(20000));
  EXPECT_EQ(SP::overlay(hubs.mesh, hubs.sphere, hubs.mesh, hubs.sphere, result), SP::ERROR_TOO_LARGE_OVERLAY);
  EXPECT_EQ(result.points.size(), n);
}

TEST(Overlay, may_be_stopped_at_any_question)
{
  const auto first = triangulation_of<Kernel>(icosphere(4)), second = triangulation_of<Kernel>(tilted(icosphere(4)));
  Recording_control control;
  SP::internal::Sphere_overlay overlay;
  ASSERT_EQ(overlay.assign(first, second, control, {}), SP::OK);
  EXPECT_GE(control.number_of_questions, 8u); // 7,680 edges are traced, and the parts of 5,120 faces are sorted
  for(std::size_t k = 0; k < control.number_of_questions; ++k)
  {
    Recording_control stopping;
    stopping.max_questions = k;
    EXPECT_EQ(overlay.assign(first, second, stopping, {}), SP::ERROR_STOPPED);
    EXPECT_EQ(stopping.number_of_questions, k + 1);
  }
}

TEST(Overlay, keeps_a_time_limit_and_its_result_then)
{
  const Triangle_list list = icosphere(2);
  const Mapped_mesh m(list);
  const auto overlay_within = [&](double seconds, Overlay& overlay) {
    return SP::overlay(m.mesh, m.sphere, m.mesh, m.sphere, overlay, CGAL::parameters::maximum_running_time(seconds));
  };
  Overlay overlay = overlay_of(m.mesh, list, m.mesh, tilted(list));
  const std::size_t n = overlay.triangles.size();
  EXPECT_EQ(overlay_within(1e-9, overlay), SP::ERROR_STOPPED);
  EXPECT_EQ(overlay.triangles.size(), n);
  EXPECT_EQ(overlay_within(1e9, overlay), SP::OK);
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
  const Mapped_mesh good(icosphere(1));
  Overlay overlay;
  for_each_broken_surface([&](const Mapped_mesh& broken, SP::Error_code error) {
    EXPECT_EQ(SP::overlay(good.mesh, good.sphere, broken.mesh, broken.sphere, overlay), error);
    EXPECT_EQ(SP::overlay(broken.mesh, broken.sphere, good.mesh, good.sphere, overlay), error);
  });
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
  const Triangle_list list = octahedron(); // faces on two sides of the plane z = 0, all of the same area
  const Mesh flat1 = make(scaled(list, 1., 1., 0.)), flat2 = make(scaled(list, 2., 0.5, 0.));
  const SP::Distortion_between distortion = distortion_of(overlay_of(flat1, list, flat2, list));
  EXPECT_NEAR(distortion.isometric.maximum, 2., 1e-12);
  EXPECT_NEAR(distortion.area.average_over_first, 2., 1e-12);
  EXPECT_NEAR(distortion.angle.average_over_second, 4.25, 1e-12);
  EXPECT_NEAR(distortion.energy.average_over_first, 4.25, 1e-12);
  EXPECT_EQ(distortion.number_of_triangles, 2 * (12u + 18u) - 4u); // with the crossings of each edge with its twin
}

double sampled_energy(const Mesh& mesh1, const Triangle_list& list1, const Mesh& mesh2, const Triangle_list& list2)
{
  const auto sphere1 = triangulation_of<Kernel>(list1);
  auto sphere2 = triangulation_of<Kernel>(list2);
  sphere2.make_grid();
  Recording_control control;
  return SP::internal::mean_energy_over_first(sphere1, points(mesh1), sphere2, points(mesh2), control, {});
}

// Samples of a map find its energy: exactly where it is affine, and elsewhere near to that on the common refinement, whose
// triangles are large here, and affine.
TEST(Distortion_between, is_found_by_samples)
{
  const Triangle_list list = octahedron();
  const Mesh flat1 = make(scaled(list, 1., 1., 0.)),
             flat2 = make(scaled(list, 6., 1.5, 0.)); // three times the size, which does not count
  EXPECT_NEAR(sampled_energy(flat1, list, flat2, list), 4.25, 1e-12);

  for(const double angle : {0., 0.4, 2.})
  {
    const Triangle_list list1 = icosphere(2), list2 = turned(bumpy_sphere(2), angle);
    const Mesh mesh1 = surface_of(list1, 1.), mesh2 = surface_of(list2, 3.);
    const double expected = distortion_of(overlay_of(mesh1, list1, mesh2, list2)).energy.average_over_first;
    for(const double size : {1e-200, 1., 1e200})
      EXPECT_NEAR(sampled_energy(mesh1, scaled(list1, size, size, size), mesh2, list2), expected, 0.03 * expected);
    Triangle_list uneven = list2; // directions of other lengths: another map, between the same surfaces
    for(std::size_t v = 0; v < uneven.points.size(); ++v)
      for(double& x : uneven.points[v])
        x *= 1. + 0.1 * static_cast<double>(v % 3);
    const double expected_of_uneven = distortion_of(overlay_of(mesh1, list1, mesh2, uneven)).energy.average_over_first;
    EXPECT_NEAR(sampled_energy(mesh1, list1, mesh2, uneven), expected_of_uneven, 0.03 * expected_of_uneven);
  }
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
