// A surface is mapped onto another one: certified always, exact onto a copy, near to the identity onto a remesh, through its
// landmarks wherever straight edges allow it.

#include "random_stars.h"
#include "recording_control.h"
#include "surfaces.h"

#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Sphere_image.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_star.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Mesh_hierarchy.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

using namespace test;

namespace {

struct Asking_visitor : SP::Default_visitor
{
  std::function<bool()> ask;
  bool go_further(std::size_t, double) { return !ask || ask(); }
};

// The map of one surface onto another one, and its report.
struct Match
{
  SP::Error_code error;
  std::vector<Point_3> directions;
  SP::Surface_map_report report;
  double energy = 0.;
  std::vector<double> errors; // that are expected; empty if there is no estimate

  template <class ConcurrencyTag = CGAL::Parallel_if_available_tag>
  static Match make(Mapped_mesh& a, const Mapped_mesh& b, Mapper mapper = {},
                    const std::function<bool()>& ask = nullptr, double max_seconds = 0., ConcurrencyTag = {})
  {
    Match result;
    const Image_map images = a.add_map();
    for(const Vertex_index v : a.mesh.vertices())
      images[v] = Point_3(7., 7., 7.);
    Asking_visitor visitor;
    visitor.ask = ask;
    result.error =
        SP::map_surface<ConcurrencyTag>(a.mesh, a.sphere, b.mesh, b.sphere, mapper, images,
                                        CGAL::parameters::visitor(std::ref(visitor)).maximum_running_time(max_seconds));
    result.report = mapper.report();
    result.errors.assign(a.mesh.number_of_vertices(), -1.);
    if(!mapper.get_expected_errors(CGAL::make_property_map(result.errors)))
      result.errors.clear();
    EXPECT_EQ(result.errors.empty(), !result.report.expected_error);
    for(std::size_t v = 0; v < result.errors.size(); ++v)
    {
      const bool has_face = !a.mesh.is_isolated(Vertex_index(static_cast<std::uint32_t>(v)));
      EXPECT_TRUE(has_face ? result.errors[v] >= 0. && result.errors[v] <= 0.5 : result.errors[v] == -1.)
          << result.errors[v];
    }
    for(const Vertex_index v : a.mesh.vertices())
      result.directions.push_back(images[v]);
    if(result.error == SP::OK)
    {
      EXPECT_TRUE(SP::is_bijective(a.mesh, images));
      SP::Surface_overlay_3<Mesh, Mesh> overlay;
      EXPECT_EQ(SP::overlay(a.mesh, images, b.mesh, b.sphere, overlay), SP::OK);
      SP::Distortion_between distortion;
      EXPECT_EQ(SP::measure_distortion_between(overlay, distortion), SP::OK);
      const double mean = result.energy =
          0.5 * (distortion.energy.average_over_first + distortion.energy.average_over_second);
      const bool is_stopped = result.report.stop_reason == SP::STOPPED || result.report.stop_reason == SP::TIME_LIMIT;
      EXPECT_TRUE((is_stopped && result.report.energy == 0.) || mean > 100. ||
                  std::abs(result.report.energy - mean) < 1e-6 * mean)
          << result.report.energy << ", but " << mean; // infinite if a surface has no area
      EXPECT_EQ(result.report.distortion.has_value(), result.report.energy != 0. && !result.report.is_energy_sampled);
      if(result.report.distortion && mean < 100.)
      {
        EXPECT_NEAR(result.report.distortion->isometric.maximum, distortion.isometric.maximum,
                    1e-6 * distortion.isometric.maximum);
        EXPECT_NEAR(result.report.distortion->angle.average_over_second, distortion.angle.average_over_second, 1e-6);
        EXPECT_EQ(result.report.distortion->number_of_triangles, distortion.number_of_triangles);
      }
    }
    else
      for(const Point_3& p : result.directions)
        EXPECT_EQ(p, Point_3(7., 7., 7.)); // nothing is written
    return result;
  }
};

// The hubs of two double pyramids have millions of edges that cross each other: they are not needed.
TEST(Map_surface, between_hubs_is_measured_by_samples)
{
  const Triangle_list list = suspension(3000);
  const auto stretched = [](const Point_3& p) { return Point_3(p.x(), p.y(), 1.5 * p.z()); };
  Mapped_mesh first(list);
  const Mapped_mesh second(list, stretched);
  Mapper mapper;
  const Image_map images = first.add_map();
  ASSERT_EQ(SP::map_surface(first.mesh, first.sphere, second.mesh, second.sphere, mapper, images), SP::OK);
  EXPECT_TRUE(SP::is_bijective(first.mesh, images));
  EXPECT_TRUE(mapper.report().is_energy_sampled);
  EXPECT_GT(mapper.report().energy, 2.);
  EXPECT_LT(mapper.report().energy, 2.35); // 2.17 to 2.29 for other rotations and numbers of corners, by rounding alone
}

TEST(Map_surface, is_exact_onto_the_surface_itself_and_a_turned_copy)
{
  Mapped_mesh a(icosphere(4), on_body);
  const auto turned_body = [](const Point_3& p) {
    const Point_3 q = on_body(p);
    return Point_3(3. * q.z() + 9., 3. * q.x(), 3. * q.y());
  };
  const Mapped_mesh itself(icosphere(4), on_body), copy(icosphere(4), turned_body, turns[2]);
  for(const Mapped_mesh* const b : {&itself, &copy})
  {
    const Match match = Match::make(a, *b);
    ASSERT_EQ(match.error, SP::OK);
    EXPECT_NEAR(match.report.energy, 2., 1e-9);
    EXPECT_GT(match.report.agreement, 0.97);
    EXPECT_GT(match.report.margin, 0.1);
    EXPECT_FALSE(match.report.is_uncertain);
    ASSERT_TRUE(match.report.expected_error);
    EXPECT_LT(*match.report.expected_error, 0.01);
    EXPECT_TRUE(match.report.landmark_distances.empty());
    for(const Vertex_index v : a.mesh.vertices())
      EXPECT_LT(distance(match.directions[v], b->sphere[v]), 1e-9);
  }
}

TEST(Map_surface, finds_the_identity_onto_a_remesh)
{
  Mapped_mesh a(icosphere(4), on_body);
  const Match match = Match::make(a, Mapped_mesh(octahedron_of(25), on_body, turns[1]));
  ASSERT_EQ(match.error, SP::OK);
  EXPECT_LT(match.report.energy, 2.05);
  const auto error = [&](Vertex_index v) {
    return distance(match.directions[v], rotation(turns[1]).transform(a.sphere[v]));
  };
  EXPECT_LT(mean_over_vertices(a.mesh, error), 0.03); // the edges are 0.07 long
}

// A flat tube with bumps, bent by the curvature `bend`: both faces and both ends would look the same but for a bump in front of one
// end and one at the left of the other; `side` is -1 for the tube that a mirror shows, whose bump is at the right.
Point_3 on_tube(const Point_3& p, double bend, double side)
{
  const auto bump = [&](double x, double y, double z, double height) {
    return height * std::exp(-6. * CGAL::squared_distance(p, Point_3(x, y, z)));
  };
  const double width = std::sqrt(p.x() * p.x() + p.y() * p.y() + 0.1);
  const double r = (1. + bump(0., 0.7, 0.7, 0.5) + bump(side * 0.9, 0., -0.5, 0.6)) / width;
  const double x = 0.8 * r * p.x(), y = 0.5 * r * p.y(), z = 3. * p.z();
  return bend == 0.
             ? Point_3(x, y, z)
             : Point_3(x, 1. / bend - (1. / bend - y) * std::cos(bend * z), (1. / bend - y) * std::sin(bend * z));
}

// What belongs together is known: the mean distance from there, in percent of the square root of the area.
TEST(Map_surface, tells_front_from_back_and_left_from_right_of_a_tube_that_bends)
{
  const auto map_from = [](double side) {
    Mapped_mesh a(icosphere(4), [&](const Point_3& p) { return on_tube(p, 0., side); });
    const Mapped_mesh b(
        octahedron_of(25), [](const Point_3& p) { return on_tube(p, 0.35, 1.); }, turns[1]);
    const Match match = Match::make(a, b);
    EXPECT_EQ(match.error, SP::OK);
    const double error = mean_over_vertices(a.mesh, [&](Vertex_index v) {
      return distance(on_tube(rotation(turns[1]).inverse().transform(match.directions[v]), 0.35, 1.),
                      on_tube(a.sphere[v], 0.35, 1.));
    });
    return std::make_pair(match, 100. * error / std::sqrt(CGAL::Polygon_mesh_processing::area(b.mesh)));
  };
  const auto [same, error] = map_from(1.);
  const Match mirrored = map_from(-1.).first;
  EXPECT_LT(error, 1.6);
  EXPECT_FALSE(same.report.is_uncertain) << *same.report.expected_error << ' ' << same.report.margin;
  ASSERT_EQ(same.errors.size(), mirrored.errors.size());
  EXPECT_LT(*same.report.expected_error, *mirrored.report.expected_error);
  // Of a mirrored tube one of the bumps has no counterpart.
  EXPECT_TRUE(mirrored.report.is_uncertain);
  EXPECT_LT(mirrored.report.agreement, same.report.agreement);
  EXPECT_LT(mirrored.report.margin, same.report.margin);
}

// A sphere that another map of the same surface has bent: the descent straightens it.
TEST(Map_surface, lowers_the_distortion_of_spheres_that_differ_by_more_than_a_rotation)
{
  Mapped_mesh a(icosphere(4), on_body), b(octahedron_of(25), on_body);
  const auto bent = [](const Point_3& p) {
    const double x = p.x() + 0.6 * p.y() * p.z(), y = p.y() - 0.4 * p.x() * p.x(), z = p.z() + 0.3 * p.x() * p.y();
    const double l = std::sqrt(x * x + y * y + z * z);
    return Point_3(x / l, y / l, z / l);
  };
  for(const Vertex_index v : b.mesh.vertices())
    b.sphere[v] = bent(b.sphere[v]);
  const Match match = Match::make(a, b);
  ASSERT_EQ(match.error, SP::OK);
  const auto off = [&](Vertex_index v) { return distance(a.sphere[v], bent(a.sphere[v])); };
  const auto left = [&](Vertex_index v) { return distance(match.directions[v], bent(a.sphere[v])); };
  EXPECT_LT(mean_over_vertices(a.mesh, left), 0.3 * mean_over_vertices(a.mesh, off));
  EXPECT_LT(match.report.energy, 2.3);
}

TEST(Map_surface, meets_hard_landmarks_and_comes_nearer_to_soft_ones_of_more_weight)
{
  Mapped_mesh a(icosphere(3));
  const Mapped_mesh b(octahedron_of(12), as_it_is, turns[1]);
  Vertex_pairs landmarks;
  for(std::uint32_t k = 0; k < 6; ++k) // the corners of the octahedron, but some of them elsewhere
  {
    const Point_3& p = b.mesh.point(Vertex_index(k));
    const Point_3 moved(p.x() + 0.3 * p.y(), p.y() - 0.2 * p.z(), p.z());
    landmarks.emplace_back(least_vertex(a.mesh, [&](Vertex_index v) { return distance(a.mesh.point(v), moved); }),
                           Vertex_index(k));
  }
  const Match hard = Match::make(a, b, Mapper().landmarks(landmarks));
  ASSERT_EQ(hard.error, SP::OK);
  EXPECT_EQ(hard.report.number_of_missed_landmarks, 0u);
  EXPECT_EQ(hard.report.agreement, 0.);
  EXPECT_EQ(hard.report.landmark_distances, std::vector<double>(landmarks.size(), 0.));
  for(const auto& [v, w] : landmarks)
    EXPECT_LT(distance(hard.directions[v], b.sphere[w]), 1e-15);
  double last = 1., last_energy = 0.;
  for(const double weight : {0.01, 1., 100.})
  {
    const SP::Surface_map_report report =
        Match::make(a, b, Mapper().landmarks(landmarks).landmark_weight(weight)).report;
    EXPECT_EQ(report.number_of_missed_landmarks, 0u);
    const double sum = std::accumulate(report.landmark_distances.begin(), report.landmark_distances.end(), 0.);
    EXPECT_LT(sum, last);
    EXPECT_GT(report.energy, last_energy);
    last = sum;
    last_energy = report.energy;
  }
  EXPECT_GT(hard.report.energy, last_energy);
}

// Landmarks on a mesh of few vertices, that are to go some way: its straight edges are in the way of some.
TEST(Split_blocking_edges, meets_landmarks_that_straight_edges_keep_away)
{
  const auto body = [](const Point_3& p) { return Point_3(p.x(), 1.3 * p.y(), 0.8 * p.z()); };
  const Mapped_mesh b(octahedron_of(20), body);
  std::size_t n_missed = 0, n_left = 0;
  Random random(7);
  for(int trial = 0; trial < 30; ++trial)
  {
    Mapped_mesh a(octahedron_of(3), body);
    const double area = CGAL::to_double(CGAL::Polygon_mesh_processing::area(a.mesh));
    Vertex_pairs landmarks;
    std::set<Vertex_index> taken;
    for(std::uint32_t k = 0; k < 14; ++k)
    {
      const Vertex_index v(2 * k + static_cast<std::uint32_t>(trial) % 2);
      const Point_3& p = a.sphere[v];
      const Point_3 goal(p.x() + random.between(-0.6, 0.6), p.y() + random.between(-0.6, 0.6),
                         p.z() + random.between(-0.6, 0.6));
      landmarks.emplace_back(v, least_vertex(b.mesh, [&](Vertex_index w) {
                               return taken.count(w) > 0 ? HUGE_VAL : distance(b.sphere[w], goal);
                             }));
      taken.insert(landmarks.back().second);
    }
    const Image_map directions = a.add_map();
    auto mapper = Mapper().landmarks(landmarks).keep_alignment(); // which features would mend
    ASSERT_EQ(SP::map_surface(a.mesh, a.sphere, b.mesh, b.sphere, mapper, directions), SP::OK);
    n_missed += mapper.report().number_of_missed_landmarks;
    for(int round = 0; round < 5 && mapper.report().number_of_missed_landmarks > 0; ++round)
    {
      std::size_t n_split = 0;
      ASSERT_EQ(SP::split_blocking_edges(a.mesh, a.sphere, directions, b.sphere, landmarks, n_split), SP::OK);
      if(n_split == 0)
        break;
      ASSERT_TRUE(CGAL::is_triangle_mesh(a.mesh) && CGAL::is_closed(a.mesh));
      ASSERT_TRUE(SP::is_bijective(a.mesh, a.sphere));
      ASSERT_EQ(SP::map_surface(a.mesh, a.sphere, b.mesh, b.sphere, mapper, directions), SP::OK);
    }
    n_left += mapper.report().number_of_missed_landmarks;
    EXPECT_NEAR(CGAL::to_double(CGAL::Polygon_mesh_processing::area(a.mesh)), area, 1e-12 * area);
  }
  EXPECT_GT(n_missed, 20u);
  EXPECT_LT(2 * n_left, n_missed);
}

TEST(Map_surface, stops_when_it_is_told_to)
{
  Mapped_mesh a(icosphere(3));
  const Mapped_mesh b(octahedron_of(12), on_body, turns[1]);
  // soft landmarks, which make for more levels
  const Mapper mapper = Mapper()
                            .landmarks({{Vertex_index(0), Vertex_index(0)},
                                        {Vertex_index(1), Vertex_index(1)},
                                        {Vertex_index(2), Vertex_index(2)}})
                            .landmark_weight(0.1);
  std::size_t n_calls = 0;
  const auto energy_after = [&](std::size_t n_sweeps) {
    n_calls = 0;
    const auto go_further = [&, thread = std::this_thread::get_id()] {
      EXPECT_EQ(std::this_thread::get_id(), thread);
      return n_calls++ < n_sweeps;
    };
    const Match match = Match::make(a, b, mapper, go_further);
    EXPECT_EQ(match.error, SP::OK); // and certified
    EXPECT_EQ(match.report.stop_reason == SP::STOPPED, n_calls > n_sweeps);
    return match.energy;
  };
  const double last = energy_after((std::numeric_limits<std::size_t>::max)());
  const std::size_t n_sweeps = n_calls;
  const double middle = energy_after(n_sweeps / 2);
  EXPECT_EQ(n_calls, n_sweeps / 2 + 1); // It is not asked again.
  EXPECT_GT(middle, last);
  EXPECT_GT(energy_after(0), middle);
}

TEST(Map_surface, keeps_a_time_limit)
{
  Mapped_mesh a(octahedron_of(30));
  const Mapped_mesh b(octahedron_of(32), on_body, turns[1]);
  const Match match = Match::make(a, b, {}, nullptr, 1e-9), whole = Match::make(a, b);
  EXPECT_EQ(match.error, SP::OK); // and certified
  EXPECT_EQ(match.report.stop_reason, SP::TIME_LIMIT);
  EXPECT_TRUE(match.report.is_uncertain); // Nothing has been compared.
  EXPECT_FALSE(match.report.expected_error);
  EXPECT_EQ(whole.report.stop_reason, SP::CONVERGED);
  EXPECT_LT(whole.energy, match.energy);
  EXPECT_LT(match.report.number_of_sweeps, whole.report.number_of_sweeps);
}

// Its energy may not be known then, so that it cannot be compared with that of the start.
TEST(Map_surface, keeps_what_it_has_reached_if_it_is_stopped_while_that_is_measured)
{
  Mapped_mesh a(icosphere(3), on_body);
  const Mapped_mesh b(octahedron_of(12));
  std::size_t n_calls = 0, n_allowed = (std::numeric_limits<std::size_t>::max)();
  const auto run = [&] {
    n_calls = 0;
    return Match::make(a, b, Mapper().keep_alignment(), [&] { return n_calls++ < n_allowed; });
  };
  const Match whole = run();
  ASSERT_EQ(whole.error, SP::OK);
  n_allowed = n_calls - 1;
  const Match stopped = run();
  ASSERT_EQ(stopped.error, SP::OK);
  EXPECT_EQ(stopped.report.stop_reason, SP::STOPPED);
  EXPECT_EQ(stopped.directions, whole.directions);
  const auto moved = [&](Vertex_index v) { return distance(stopped.directions[v], a.sphere[v]); };
  EXPECT_GT(mean_over_vertices(a.mesh, moved), 1e-3);
}

// What concerns the start comes between its two events, levels and the overlay follow.
TEST(Map_surface, tells_the_visitor_of_its_parts)
{
  Mapped_mesh a(icosphere(3));
  const Mapped_mesh b(octahedron_of(12), on_body, turns[1]);
  struct Visitor : SP::Default_visitor
  {
    std::vector<std::string> events;
    std::vector<std::size_t> levels;
    void on_initialization_begin(std::size_t n) { events.push_back("begin " + std::to_string(n)); }
    void on_initialization_end() { events.push_back("end"); }
    void on_level(std::size_t n)
    {
      EXPECT_EQ(events.back(), "end");
      levels.push_back(n);
    }
    void on_optimization_end() { events.push_back("optimization end"); }
  } visitor;
  ASSERT_EQ(
      SP::map_surface(a.mesh, a.sphere, b.mesh, b.sphere, a.add_map(), CGAL::parameters::visitor(std::ref(visitor))),
      SP::OK);
  EXPECT_EQ(visitor.events, (std::vector<std::string>{"begin 642", "end", "optimization end"}));
  ASSERT_FALSE(visitor.levels.empty());
  EXPECT_EQ(visitor.levels.back(), 642u);
}

// The distances of images from the origin say nothing.
TEST(Split_blocking_edges, takes_spheres_of_any_size)
{
  const auto number_of_split_edges = [](double scale) {
    Mapped_mesh a(octahedron_of(3)), b(octahedron_of(3));
    Vertex_pairs landmarks;
    for(std::uint32_t k = 0; k < 6; ++k)
      landmarks.emplace_back(k, (7 * k + 11) % 38);
    for(const Vertex_index v : b.mesh.vertices())
      b.sphere[v] = CGAL::ORIGIN + scale * (b.sphere[v] - CGAL::ORIGIN);
    std::size_t result = 0;
    EXPECT_EQ(SP::split_blocking_edges(a.mesh, a.sphere, a.sphere, b.sphere, landmarks, result), SP::OK);
    EXPECT_TRUE(SP::is_bijective(a.mesh, a.sphere));
    return result;
  };
  const std::size_t n = number_of_split_edges(1.);
  EXPECT_GT(n, 0u);
  EXPECT_EQ(number_of_split_edges(std::ldexp(1., 600)), n);
  EXPECT_EQ(number_of_split_edges(std::ldexp(1., -600)), n);
}

TEST(Split_blocking_edges, refuses_what_is_no_surface)
{
  Mapped_mesh a(octahedron_of(1));
  const Mapped_mesh b(octahedron_of(1));
  CGAL::Euler::remove_face(halfedge(*faces(a.mesh).begin(), a.mesh), a.mesh);
  std::size_t n = 7;
  EXPECT_EQ(SP::split_blocking_edges(a.mesh, a.sphere, a.sphere, b.sphere,
                                     Vertex_pairs{{Vertex_index(0), Vertex_index(1)}}, n),
            SP::ERROR_NON_CLOSED_MESH);
}

// The surface stays the same set of points, each edge is reported, and the map goes on from where it is.
TEST(Split_bent_faces, lowers_the_energy)
{
  Mapped_mesh a(icosphere(3));
  const Mapped_mesh b(octahedron_of(30), on_body, turns[1]);
  const double area = CGAL::to_double(CGAL::Polygon_mesh_processing::area(a.mesh));
  const std::size_t n_vertices = a.mesh.number_of_vertices(), n_faces = a.mesh.number_of_faces();
  const Image_map directions = a.add_map();
  Mapper mapper;
  ASSERT_EQ(SP::map_surface(a.mesh, a.sphere, b.mesh, b.sphere, mapper, directions), SP::OK);
  const double before = mapper.report().energy;

  std::vector<SP::Split_edge<Mesh>> split;
  constexpr std::size_t n = 40;
  ASSERT_EQ(SP::split_bent_faces(a.mesh, directions, b.mesh, b.sphere, n, split), SP::OK);
  EXPECT_EQ(split.size(), n);
  EXPECT_EQ(a.mesh.number_of_vertices(), n_vertices + n);
  EXPECT_EQ(a.mesh.number_of_faces(), n_faces + 2 * n);
  EXPECT_TRUE(CGAL::is_triangle_mesh(a.mesh) && CGAL::is_closed(a.mesh) && CGAL::is_valid_polygon_mesh(a.mesh));
  EXPECT_TRUE(SP::is_bijective(a.mesh, directions));
  EXPECT_NEAR(CGAL::to_double(CGAL::Polygon_mesh_processing::area(a.mesh)), area, 1e-12 * area);
  for(std::size_t k = 0; k < split.size(); ++k)
  {
    const auto& [v, ends, faces, halved] = split[k];
    EXPECT_EQ(v.idx(), n_vertices + k);
    const Point_3 middle = CGAL::midpoint(a.mesh.point(ends[0]), a.mesh.point(ends[1]));
    EXPECT_LT(distance(a.mesh.point(v), middle), 1e-15);
    for(const auto f : faces)
      EXPECT_GE(f.idx(), n_faces);
    EXPECT_NE(halved[0], halved[1]);
  }

  auto further = mapper.keep_alignment();
  for(int round = 0; round < 3; ++round)
  {
    ASSERT_EQ(SP::map_surface(a.mesh, directions, b.mesh, b.sphere, further, directions), SP::OK);
    ASSERT_EQ(SP::split_bent_faces(a.mesh, directions, b.mesh, b.sphere, n, split), SP::OK);
  }
  EXPECT_LT(further.report().energy, before);
  EXPECT_EQ(further.report().agreement, 0.); // Nothing has been aligned.
}

TEST(Split_bent_faces, leaves_what_is_no_map_or_needs_nothing)
{
  Mapped_mesh a(icosphere(1));
  const Mapped_mesh b(icosphere(1));
  std::vector<SP::Split_edge<Mesh>> split(1);
  const std::size_t n = a.mesh.number_of_vertices();
  EXPECT_EQ(SP::split_bent_faces(a.mesh, a.sphere, b.mesh, b.sphere, 0, split), SP::OK);
  EXPECT_TRUE(split.empty());
  for(const Vertex_index v : a.mesh.vertices())
    a.sphere[v] = Point_3(1., 0., 0.);
  EXPECT_EQ(SP::split_bent_faces(a.mesh, a.sphere, b.mesh, b.sphere, n, split), SP::ERROR_NO_1_TO_1_MAPPING);
  EXPECT_TRUE(split.empty());
  EXPECT_EQ(a.mesh.number_of_vertices(), n);
}

// All vertices but two neighbours can stay where they are, and these cannot change places.
TEST(Map_surface, tells_how_far_two_neighbours_are_from_each_others_places)
{
  Mapped_mesh a(icosphere(2), on_body);
  const Mesh::Halfedge_index h = *a.mesh.halfedges().begin();
  const Vertex_index v = a.mesh.source(h), w = a.mesh.target(h);
  Vertex_pairs landmarks;
  for(const Vertex_index u : a.mesh.vertices())
    landmarks.emplace_back(u, u == v ? w : u == w ? v : u);
  const Match match = Match::make(a, a, Mapper().landmarks(landmarks));
  ASSERT_EQ(match.error, SP::OK);
  EXPECT_GE(match.report.number_of_missed_landmarks, 1u);
  std::size_t n_missed = 0;
  for(std::size_t k = 0; k < landmarks.size(); ++k)
  {
    const bool is_missed = distance(match.directions[landmarks[k].first], a.sphere[landmarks[k].second]) > 1e-12;
    EXPECT_EQ(match.report.landmark_distances[k] > 0., is_missed) << k;
    n_missed += is_missed;
  }
  EXPECT_EQ(match.report.number_of_missed_landmarks, n_missed);
}

TEST(Map_surface, permutes_the_corners_of_a_tetrahedron_where_orientation_allows_it)
{
  Mapped_mesh a(tetrahedron());
  const Mapped_mesh b(scaled(tetrahedron(), 1., 1., 3.));
  const auto n_missed = [&](const std::array<std::uint32_t, 4>& corners) {
    Vertex_pairs landmarks;
    for(std::uint32_t k = 0; k < 4; ++k)
      landmarks.emplace_back(Vertex_index(k), Vertex_index(corners[k]));
    const Match match = Match::make(a, b, Mapper().landmarks(landmarks));
    EXPECT_EQ(match.error, SP::OK);
    return match.report.number_of_missed_landmarks;
  };
  EXPECT_EQ(n_missed({0, 1, 2, 3}), 0u);
  EXPECT_EQ(n_missed({1, 2, 0, 3}), 0u);
  EXPECT_EQ(n_missed({1, 0, 3, 2}), 0u);
  EXPECT_GT(n_missed({1, 0, 2, 3}), 0u); // the mirror image
}

// With hard landmarks: test_surfaces_threads.
TEST(Map_surface, depends_neither_on_threads_nor_on_the_unit)
{
  const Mapper by_landmarks = Mapper()
                                  .landmarks({{Vertex_index(0), Vertex_index(0)},
                                              {Vertex_index(37), Vertex_index(1)},
                                              {Vertex_index(74), Vertex_index(2)}})
                                  .landmark_weight(5.);
  for(const Mapper& mapper : {Mapper(), by_landmarks})
  {
    const auto map_onto = [&](double scale, auto tag) {
      Mapped_mesh a(icosphere(3), on_body);
      const auto body = [&](const Point_3& p) {
        const Point_3 q = on_body(p);
        return Point_3(scale * q.x(), scale * (q.y() + 0.2 * q.x() * q.x()), scale * q.z());
      };
      return Match::make(a, Mapped_mesh(octahedron_of(12), body, turns[1]), mapper, nullptr, 0., tag).directions;
    };
    const std::vector<Point_3> expected = map_onto(1., CGAL::Parallel_if_available_tag());
    EXPECT_EQ(map_onto(1., CGAL::Sequential_tag()), expected);
    EXPECT_EQ(map_onto(0x1p-500, CGAL::Sequential_tag()), expected);
  }
}

TEST(Map_surface, maps_the_smallest_the_flattest_and_those_without_any_area)
{
  const auto map_onto = [](const Triangle_list& first, double height, const Triangle_list& second,
                           double other_height) {
    Mapped_mesh a(first);
    Mapped_mesh b(second, as_it_is, turns[1]);
    for(const auto& [m, z] : {std::pair(&a, height), std::pair(&b, other_height)})
      for(Point_3& p : m->mesh.points())
        p = Point_3(p.x(), p.y(), z * p.z());
    EXPECT_EQ(Match::make(a, b).error, SP::OK);
  };
  map_onto(tetrahedron(), 1., octahedron_of(1), 1.);
  map_onto(octahedron_of(5), 1e-9, tetrahedron(), 1.);
  map_onto(icosphere(1), 1., octahedron_of(5), 0.);
  Mapped_mesh point(icosphere(1), [](const Point_3&) { return Point_3(1., 2., 3.); }), sphere(icosphere(2));
  for(const Match& match : {Match::make(point, sphere), Match::make(sphere, point)})
  {
    EXPECT_EQ(match.error, SP::OK);
    EXPECT_EQ(match.report.energy, std::numeric_limits<double>::infinity()); // and not less than that of a copy
  }
}

TEST(Map_surface, maps_needles_and_slivers)
{
  const auto as_needle = [](const Point_3& p) {
    const Point_3 q = on_body(p);
    return Point_3(300. * q.x(), q.y(), q.z());
  };
  const Triangle_list slivers = with_slivers(icosphere(1), 5, 1e-9);
  Mapped_mesh a(slivers, as_needle), d(slivers, on_body);
  const Mapped_mesh b(octahedron_of(8), as_needle, turns[1]), c(slivers, as_it_is, turns[1]);
  EXPECT_EQ(Match::make(a, b).error, SP::OK);
  const Mapper mapper = // the second one is the end of a short edge
      Mapper().landmarks({{Vertex_index(5), Vertex_index(5)}, {Vertex_index(45), Vertex_index(45)}});
  EXPECT_EQ(Match::make(a, c, mapper).error, SP::OK);
  const Match match = Match::make(d, c, mapper);
  EXPECT_EQ(match.error, SP::OK);
  EXPECT_EQ(match.report.number_of_missed_landmarks, 0u);
}

TEST(Map_surface, takes_images_at_any_distance_from_the_origin)
{
  const auto scale = [](Mapped_mesh& m, const auto& exponent) {
    for(const Vertex_index v : m.mesh.vertices())
    {
      const double s = std::ldexp(1., exponent());
      m.sphere[v] = Point_3(s * m.sphere[v].x(), s * m.sphere[v].y(), s * m.sphere[v].z());
    }
  };
  Mapped_mesh a(icosphere(1), on_body), b(icosphere(1), on_body, turns[1]);
  const Mapper mapper = Mapper().landmarks({{Vertex_index(0), Vertex_index(5)}, {Vertex_index(5), Vertex_index(0)}});
  const std::vector<Point_3> without = Match::make(a, b).directions, with = Match::make(a, b, mapper).directions;
  scale(a, [] { return -800; });
  scale(b, [] { return 800; });
  EXPECT_EQ(Match::make(a, b).directions, without);
  EXPECT_EQ(Match::make(a, b, mapper).directions, with);
  // How far each image is along its ray says how a face is spread out, so that the result is another one.
  Random random(1);
  scale(a, [&] { return random.integer(780, 820); });
  scale(b, [&] { return random.integer(-820, -780); });
  EXPECT_EQ(Match::make(a, b, mapper).error, SP::OK);
}

// Handles of vertices that are no numbers, and numbers of single precision in both surfaces and in all maps.
TEST(Map_surface, takes_other_types_of_meshes_and_numbers)
{
  using Float_point_3 = CGAL::Simple_cartesian<float>::Point_3;
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<float>>;
  using Float_mesh = CGAL::Surface_mesh<Float_point_3>;
  Triangle_list first = icosphere(2), second = octahedron_of(8);
  const std::vector<Coordinates> images1 = first.points, images2 = second.points;
  for(Triangle_list* const list : {&first, &second})
    for(Coordinates& x : list->points)
    {
      const Point_3 p = on_body(Point_3(x[0], x[1], x[2]));
      x = {p.x(), p.y(), p.z()};
    }
  const Polyhedron a = make_mesh<Polyhedron>(first);
  const Float_mesh b = make_mesh<Float_mesh>(second);
  const auto sphere1 = make_vertex_map<Float_point_3>(a, images1);
  const auto sphere2 = make_vertex_map<Float_point_3>(b, images2);
  const auto directions = make_vertex_map<Float_point_3>(a, images1);
  SP::Surface_mapper_3<Polyhedron, Float_mesh> mapper;
  ASSERT_EQ(SP::map_surface(a, sphere1, b, sphere2, mapper, directions), SP::OK);
  EXPECT_TRUE(SP::is_bijective(a, directions));
  EXPECT_LT(mapper.report().energy, 2.5);

  const auto last = std::prev(vertices(a).end());
  mapper = mapper.landmarks({{*vertices(a).begin(), Vertex_index(0)}, {*last, Vertex_index(7)}});
  ASSERT_EQ(SP::map_surface(a, sphere1, b, sphere2, mapper, directions), SP::OK);
  EXPECT_EQ(mapper.report().number_of_missed_landmarks, 0u);
  EXPECT_LT(CGAL::squared_distance(get(directions, *last), get(sphere2, Vertex_index(7))), 1e-12f);
}

// Landmarks keep the rotation; the features want it otherwise in between.
TEST(Map_surface, brings_features_nearer_by_more_weight)
{
  Mapped_mesh a(icosphere(3));
  const Mapped_mesh b(octahedron_of(12));
  Vertex_pairs landmarks;
  for(const Vertex_index v : {Vertex_index(0), Vertex_index(1)}) // where they are
    landmarks.emplace_back(
        v, least_vertex(b.mesh, [&](Vertex_index w) { return distance(b.mesh.point(w), a.mesh.point(v)); }));
  const auto second = [](const Point_3& p) { return p.z() + 0.3 * p.x() * p.y(); };
  const Mapper mapper = Mapper().landmarks(landmarks).features(
      {{[&](Vertex_index v) { return a.mesh.point(v).z(); }, [&](Vertex_index w) { return second(b.mesh.point(w)); }}});
  double last = 1., last_energy = 0.;
  for(const double weight : {0., 1., 10.})
  {
    const Match match = Match::make(a, b, mapper.feature_weight(weight));
    ASSERT_EQ(match.error, SP::OK);
    EXPECT_EQ(match.report.number_of_missed_landmarks, 0u);
    const double error = mean_over_vertices(a.mesh, [&](Vertex_index v) { // The second surface is its sphere.
      return std::abs(second(match.directions[v]) - a.mesh.point(v).z());
    });
    EXPECT_LT(error, last);
    EXPECT_GT(match.report.energy, last_energy);
    last = error;
    last_energy = match.report.energy;
  }
  EXPECT_LT(last, 0.03); // from 0.06; the spheres have vertices 0.1 apart
}

// Surfaces that are round: only the features, functions of the points, distinguish points.
class Round_surfaces
{
public:
  using Function = std::function<double(const Point_3&)>;

  Mapped_mesh a{icosphere(3)}, b{octahedron_of(15), as_it_is, turns[3]};
  Mapper mapper;

  void add(const Function& on_a, const Function& on_b)
  {
    m_features.emplace_back([this, on_a](Vertex_index v) { return on_a(a.mesh.point(v)); },
                            [this, on_b](Vertex_index v) { return on_b(b.mesh.point(v)); });
    mapper = mapper.features(m_features);
  }

  void add(const Function& function) { add(function, function); }

  // The vertices of either surface that count.
  void set_mask(const std::function<bool(const Point_3&)>& counts)
  {
    mapper = mapper.masks({[this, counts](Vertex_index v) { return counts(a.mesh.point(v)); },
                           [this, counts](Vertex_index v) { return counts(b.mesh.point(v)); }});
  }

  // How far places are in the mean from where they should be.
  double error(const std::function<bool(const Point_3&)>& counts = [](const Point_3&) { return true; })
  {
    const Match match = Match::make(a, b, mapper);
    EXPECT_EQ(match.error, SP::OK);
    double sum = 0.;
    std::size_t n = 0;
    for(const Vertex_index v : a.mesh.vertices())
      if(counts(a.mesh.point(v)))
      {
        sum += distance(match.directions[v], rotation(turns[3]).transform(a.mesh.point(v)));
        ++n;
      }
    return sum / static_cast<double>(n);
  }

private:
  std::vector<Mapper::Feature> m_features;
};

double first_wave(const Point_3& p)
{
  return p.x() + 0.3 * p.x() * p.z();
}
double second_wave(const Point_3& p)
{
  return p.y() + 0.3 * p.y() * p.z();
}

TEST(Map_surface, weighs_features_against_each_other)
{
  Round_surfaces surfaces;
  surfaces.add(first_wave);
  surfaces.add(second_wave);
  surfaces.add([](const Point_3& p) { return p.x(); }, [](const Point_3& p) { return -p.z(); }); // which is wrong
  surfaces.mapper = surfaces.mapper.feature_weights({1., 1., 0.});
  EXPECT_LT(surfaces.error(), 0.1);
  surfaces.mapper = surfaces.mapper.feature_weights({0., 0., 3.});
  EXPECT_GT(surfaces.error(), 0.5);
}

TEST(Map_surface, may_write_over_the_sphere)
{
  Round_surfaces surfaces;
  surfaces.add(first_wave);
  surfaces.add(second_wave);
  Mapped_mesh &a = surfaces.a, &b = surfaces.b;
  const std::vector<Point_3> expected = Match::make(a, b, surfaces.mapper).directions;
  ASSERT_EQ(SP::map_surface(a.mesh, a.sphere, b.mesh, b.sphere, surfaces.mapper, a.sphere), SP::OK);
  EXPECT_EQ(std::vector<Point_3>(a.sphere.begin(), a.sphere.end()), expected);
}

// Ranks do not see that a scale is another one; values do, and outliers as well.
TEST(Map_surface, compares_values_or_ranks)
{
  const auto step = [](double x) { return x > 0. ? 1. : 0.; };
  Round_surfaces surfaces;
  surfaces.add(first_wave, [](const Point_3& p) { return std::exp(3. * first_wave(p)); }); // of another scale
  surfaces.add(second_wave, [](const Point_3& p) { return std::exp(3. * second_wave(p)); });
  const double by_ranks = surfaces.error();
  EXPECT_LT(by_ranks, 0.1);
  surfaces.mapper = surfaces.mapper.compare_values();
  EXPECT_GT(surfaces.error(), 2. * by_ranks);

  Round_surfaces same;
  same.add([&](const Point_3& p) { return first_wave(p) + 10. * step(p.z() - 0.5); });
  same.add(second_wave);
  same.mapper = same.mapper.compare_values();
  EXPECT_LT(same.error(), 0.1);
}

// A cap of the second surface has other values of the features, as a medial wall has.
TEST(Map_surface, leaves_out_where_surfaces_do_not_count)
{
  const auto counts = [](const Point_3& p) { return p.z() < 0.4; };
  const auto spoilt = [&](double (*f)(const Point_3&), double sign) {
    return [=](const Point_3& p) { return counts(p) ? f(p) : 2. + sign * std::cos(9. * p.x() * p.y()); };
  };
  Round_surfaces surfaces;
  surfaces.add(spoilt(first_wave, 1.), spoilt(first_wave, -1.));
  surfaces.add(spoilt(second_wave, 1.), spoilt(second_wave, -1.));
  const double without_mask = surfaces.error(counts);
  surfaces.set_mask(counts);
  const double error = surfaces.error(counts);
  EXPECT_LT(error, 0.1);
  EXPECT_GT(without_mask, 1.2 * error);
  surfaces.set_mask([](const Point_3&) { return false; }); // which leaves nothing
  EXPECT_EQ(Match::make(surfaces.a, surfaces.b, surfaces.mapper).error, SP::ERROR_WRONG_PARAMETER);

  // As values they are compared as well, whatever stands for none there.
  Round_surfaces sentinel;
  for(double (*f)(const Point_3&) : {first_wave, second_wave})
    sentinel.add([&, f](const Point_3& p) { return counts(p) ? f(p) : -1e30; });
  sentinel.mapper = sentinel.mapper.compare_values();
  sentinel.set_mask(counts);
  EXPECT_LT(sentinel.error(counts), 0.1);
}

TEST(Map_surface, tells_what_is_wrong)
{
  Mapped_mesh a(icosphere(1)), b(icosphere(1));
  const Vertex_index v(0), w(1), isolated = a.mesh.add_vertex();
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const auto expect = [&](SP::Error_code error, const Mapper& mapper) {
    EXPECT_EQ(Match::make(a, b, mapper).error, error);
  };
  for(const Vertex_pairs& landmarks :
      {Vertex_pairs{{v, v}, {v, w}}, {{v, v}, {w, v}}, {{v, Vertex_index(1000)}}, {{isolated, v}}})
    expect(SP::ERROR_INVALID_LANDMARK, Mapper().landmarks(landmarks));
  for(const double weight : {0., -1., infinity, nan})
    expect(SP::ERROR_WRONG_PARAMETER, Mapper().landmarks({{v, v}}).landmark_weight(weight));
  expect(SP::OK, Mapper().landmark_weight(1.)); // of no landmark
  for(const double weight : {-1., infinity, nan})
    expect(SP::ERROR_WRONG_PARAMETER, Mapper().feature_weight(weight));
  const auto constants = [](double first, double second) -> std::vector<Mapper::Feature> {
    return {{[=](Vertex_index) { return first; }, [=](Vertex_index) { return second; }}};
  };
  for(const std::vector<double>& weights : {std::vector<double>{0.}, {-1.}, {1., 1.}, {nan}})
    expect(SP::ERROR_WRONG_PARAMETER, Mapper().features(constants(1., 1.)).feature_weights(weights));
  expect(SP::ERROR_WRONG_PARAMETER, Mapper().features(constants(1., nan)));
  expect(SP::ERROR_WRONG_PARAMETER, Mapper().features(constants(infinity, 1.)));
  for_each_broken_surface([&](Mapped_mesh& broken, SP::Error_code error) {
    EXPECT_EQ(Match::make(a, broken).error, error);
    EXPECT_EQ(Match::make(broken, b).error, error);
  });

  const auto throwing = [](Vertex_index) -> double { throw std::runtime_error("feature"); };
  EXPECT_THROW(
      (void)SP::map_surface(b.mesh, b.sphere, b.mesh, b.sphere, Mapper().features({{throwing, throwing}}), b.sphere),
      std::runtime_error);
  for(const Vertex_index u : b.mesh.vertices())
    EXPECT_EQ(b.sphere[u], b.mesh.point(u));
}

// The squared length of a vector on a surface, in a direction of its sphere.
double squared_length_on(const SP::internal::Target_metric& metric, const Vector_3d& p, std::size_t level,
                         const Vector_3d& e)
{
  const SP::internal::Cube_location location = metric.locate(p, level);
  const auto flat = location.flattened(e);
  return metric.at(location, level).product(flat, flat);
}

// On a sphere that is mapped to itself, lengths and areas are what they are.
TEST(Target_metric, of_a_sphere_is_that_of_its_tangent_planes)
{
  const Located_mesh sphere(Mapped_mesh(icosphere(5)));
  const SP::internal::Target_metric metric(sphere.sphere, sphere.points, sphere.points.size(), {});
  Random random(1);
  for(int k = 0; k < 100; ++k)
  {
    const Vector_3d p =
        SP::internal::normalized(Vector_3d{random.between(-1., 1.), random.between(-1., 1.), random.between(-1., 1.)});
    const SP::internal::Tangent_frame frame(p);
    for(const std::size_t n : {100u, 10000u})
    {
      const std::size_t level = metric.level_for(n);
      const SP::internal::Cube_location location = metric.locate(p, level);
      EXPECT_NEAR(metric.at(location, level).area(), 1., 0.05);
      EXPECT_NEAR(squared_length_on(metric, p, level, frame.vector_of(0.6, 0.8)), 1., 0.05);
      EXPECT_NEAR(squared_length_on(metric, p, level, p), 0., 1e-20); // what is along the direction does not count
    }
  }
}

// Images at different distances from the origin are in the same directions, but what is between them is not.
TEST(Target_metric, sees_the_lengths_of_images)
{
  using namespace SP::internal;
  Mapped_mesh surface(octahedron_of(1));
  const Vertex_index far_vertex(0);
  surface.sphere[far_vertex] = CGAL::ORIGIN + 4. * (surface.sphere[far_vertex] - CGAL::ORIGIN);
  const Located_mesh located(surface);
  const Sphere_mesh& images = located.sphere;
  const Target_metric metric(images, located.points, located.points.size(), {});
  const Coordinates& corner = located.points[0];
  const double scale =
      std::sqrt(4. * pi / (4. * std::sqrt(3.) * dot(corner, corner))); // to the area of the unit sphere
  for(const auto& t : images.triangles())
  {
    const Vector_3d p = normalized(images.direction(t[0]) + images.direction(t[1]) + images.direction(t[2]));
    const Tangent_frame frame(p);
    const auto place = [&](double x) {
      const Vector_3d q = p + x * frame.vector_of(0.6, 0.8);
      Sphere_mesh::Hint hint;
      return interpolated(located.points, images.triangles(), images.locate(Point_3(q[0], q[1], q[2]), hint));
    };
    constexpr double h = 1e-4;
    const double stretch = scale * length(place(h) - place(-h)) / (2. * h);
    const double seen = std::sqrt(squared_length_on(metric, p, 0, frame.vector_of(0.6, 0.8)));
    EXPECT_NEAR(seen, stretch, 0.3 * stretch); // an average over a neighbourhood, by an image of 96 nodes
  }
}

// The stars of all vertices of a surface, in one set.
SP::internal::Star_packets all_stars_of(const SP::internal::Surface& mesh)
{
  std::vector<std::uint32_t> vertices(mesh.number_of_vertices());
  std::iota(vertices.begin(), vertices.end(), 0);
  return stars_of(mesh, vertices, {0, vertices.size()});
}

// Features of a sphere.
SP::internal::Sphere_image features_of(const SP::internal::Sphere_mesh& images)
{
  std::vector<std::vector<double>> channels(2);
  for(std::size_t v = 0; v < images.points().size(); ++v)
  {
    const Vector_3d q = images.direction(v);
    channels[0].push_back(q[0] * q[1]);
    channels[1].push_back(q[2]);
  }
  return SP::internal::Sphere_image(SP::internal::Sphere_image::locate_nodes(images, {}), images.triangles(), channels);
}

// The gradient is the derivative of the value, wherever the metric has one.
TEST(Target_star, has_the_gradient_of_its_value)
{
  const Located_mesh target(Mapped_mesh(octahedron_of(20), on_body, turns[1])),
      source(Mapped_mesh(icosphere(2), on_body, turns[2]));
  const SP::internal::Target_metric metric(target.sphere, target.points, target.points.size(), {});
  const std::vector<Vector_3d> positions = source.positions();
  SP::internal::Target_star star(metric);
  const std::size_t level = metric.level_for(200);
  const Vector_3d goal = SP::internal::normalized(Vector_3d{1., 2., 3.});
  const SP::internal::Sphere_image features = features_of(target.sphere);
  const std::array<double, 4> feature_values = {0.2, -0.3, 0., 0.}; // a row of the image
  const SP::internal::Star_packets stars = all_stars_of(source.mesh);
  std::size_t n_right = 0;
  for(std::size_t v = 0; v < stars.number_of_places(); ++v)
  {
    star.load(stars.star(v), positions.data(), level);
    if(v % 2 == 0)
      star.set_goal(goal, 3.);
    if(v % 3 == 0)
      star.set_features(&features, {feature_values.data()}, 5.);
    std::array<double, 2> gradient;
    std::array<double, 3> hessian;
    const double value = star.derivatives(gradient, hessian);
    EXPECT_NEAR(star(0., 0.), value, 1e-9 * value);
    constexpr double h = 1e-6;
    const double dx = (star(h, 0.) - star(-h, 0.)) / (2. * h), dy = (star(0., h) - star(0., -h)) / (2. * h);
    n_right += std::hypot(dx - gradient[0], dy - gradient[1]) < 1e-4 * std::hypot(dx, dy) + 1e-6 * value;
  }
  EXPECT_GT(n_right, stars.number_of_places() * 95 / 100); // others have a face at the border of two texels
}

// On a sphere that is mapped to itself by short edges, the metric hardly changes, and the Hessian, which leaves its change
// out, is that of the value.
TEST(Target_star, has_positive_curvature_where_the_metric_is_nearly_constant)
{
  const Located_mesh sphere(Mapped_mesh(icosphere(4)));
  const SP::internal::Target_metric metric(sphere.sphere, sphere.points, sphere.points.size(), {});
  std::vector<Vector_3d> positions = sphere.positions();
  Random random(2);
  for(Vector_3d& p : positions)
    p = SP::internal::normalized(combination(1., p, 0.005, random.in_cube()));
  SP::internal::Target_star star(metric);
  const std::size_t level = metric.level_for(positions.size());
  const SP::internal::Star_packets stars = all_stars_of(sphere.mesh);
  for(std::size_t v = 0; v < stars.number_of_places(); ++v)
  {
    star.load(stars.star(v), positions.data(), level);
    std::array<double, 2> gradient;
    std::array<double, 3> hessian;
    const double value = star.derivatives(gradient, hessian);
    EXPECT_GT(hessian[0], 0.);
    EXPECT_GT(hessian[0] * hessian[2] - hessian[1] * hessian[1], 0.);
    constexpr double h = 1e-3; // more than rounding, less than an edge
    const double trace = hessian[0] + hessian[2];
    EXPECT_NEAR((star(h, 0.) + star(-h, 0.) - 2. * value) / (h * h), hessian[0], 0.1 * trace);
    EXPECT_NEAR((star(0., h) + star(0., -h) - 2. * value) / (h * h), hessian[2], 0.1 * trace);
    EXPECT_NEAR((star(h, h) + star(-h, -h) - star(h, -h) - star(-h, h)) / (4. * h * h), hessian[1], 0.1 * trace);
  }
}

// What is computed for several stars at once, of different numbers of faces, is what each of them has alone.
TEST(Target_star, is_the_same_beside_others)
{
  using Lanes = SP::internal::Lanes<SP::internal::Four_lanes>;
  using FT = SP::internal::Four_lanes;
  const Located_mesh target(Mapped_mesh(octahedron_of(20), on_body, turns[1])),
      source(Mapped_mesh(octahedron_of(4), on_body, turns[2])); // of degrees 4 and 6
  const SP::internal::Target_metric metric(target.sphere, target.points, target.points.size(), {});
  const std::vector<Vector_3d> positions = source.positions();
  const SP::internal::Sphere_image features = features_of(target.sphere);
  const std::array<std::array<double, 4>, 2> values = {{{0.2, -0.3, 0., 0.}, {-0.1, 0.4, 0., 0.}}};
  const Vector_3d goal = SP::internal::normalized(Vector_3d{1., 2., 3.});
  const auto weight = [](std::size_t k, std::size_t modulus) { return k % modulus == 0 ? 3. : 0.; };
  const SP::internal::Star_packets stars = all_stars_of(source.mesh);
  const std::size_t level = metric.level_for(200);
  SP::internal::Target_star<FT> together(metric);
  SP::internal::Target_star<double> alone(metric);
  std::size_t n_compared = 0;
  for(std::size_t k = 0; k < stars.number_of_packets(); ++k)
    for(std::size_t first = 0; first < stars.packet(k).stride; first += Lanes::width)
    {
      together.load(stars.view<FT>(stars.packet(k), first), positions.data(), level);
      together.set_goal({goal[0], goal[1], goal[2]}, Lanes::generate([&](std::size_t i) { return weight(i, 2); }));
      SP::internal::Target_star<FT>::Values rows;
      for(std::size_t i = 0; i < Lanes::width; ++i)
        rows[i] = values[i % 2].data();
      together.set_features(&features, rows, Lanes::generate([&](std::size_t i) { return weight(i, 3); }));
      std::array<FT, 2> gradient;
      std::array<FT, 3> hessian;
      const FT value = together.derivatives(gradient, hessian), x = 0.02, y = -0.01, moved = together(x, y);
      for(std::size_t i = 0; i < Lanes::width && first + i < stars.packet(k).number_of_stars; ++i)
      {
        alone.load(stars.view<double>(stars.packet(k), first + i), positions.data(), level);
        alone.set_goal(goal, weight(i, 2));
        alone.set_features(&features, {values[i % 2].data()}, weight(i, 3));
        std::array<double, 2> g;
        std::array<double, 3> h;
        EXPECT_EQ(alone.derivatives(g, h), lane(value, i));
        for(std::size_t j = 0; j < 2; ++j)
          EXPECT_EQ(g[j], lane(gradient[j], i));
        for(std::size_t j = 0; j < 3; ++j)
          EXPECT_EQ(h[j], lane(hessian[j], i));
        EXPECT_EQ(alone(0.02, -0.01), lane(moved, i));
        EXPECT_EQ(alone.squared_shortest_edge(), lane(together.squared_shortest_edge(), i));
        EXPECT_EQ(alone.area(), lane(together.area(), i));
        ++n_compared;
      }
    }
  EXPECT_GE(n_compared, source.mesh.number_of_vertices());
}

TEST(Hierarchy_on_the_sphere, keeps_all_faces_positive_and_all_fixed_vertices)
{
  Random random(3);
  for(int k = 0; k < 10; ++k)
  {
    const Located_mesh source(Mapped_mesh(icosphere(3), on_body));
    const SP::internal::Surface& mesh = source.mesh;
    std::vector<Vector_3d> positions = source.positions();
    std::vector<char> is_fixed;
    for(Vector_3d& p : positions)
    {
      // A linear map turns no face over.
      p = SP::internal::normalized(Vector_3d{(1. + k) * p[0], p[1] + 0.5 * p[0], p[2]});
      is_fixed.push_back(random.between(0., 1.) < 0.02);
    }
    Recording_control control;
    const SP::internal::Mesh_hierarchy hierarchy(mesh.rings(), mesh.points(),
                                                 SP::internal::vertex_areas(mesh.rings(), mesh.points()), control, {},
                                                 positions, is_fixed);
    EXPECT_GT(hierarchy.number_of_levels(), 5u);
    for(std::size_t level = 0; level < hierarchy.number_of_levels(); ++level)
      EXPECT_TRUE(
          SP::internal::are_safely_positive(hierarchy.rings(level), hierarchy.level(level).gathered(positions)));
    const auto& coarsest = hierarchy.level(hierarchy.number_of_levels() - 1).vertices;
    for(std::uint32_t v = 0; v < is_fixed.size(); ++v)
      EXPECT_TRUE(!is_fixed[v] || std::binary_search(coarsest.begin(), coarsest.end(), v));
  }
}

} // namespace
