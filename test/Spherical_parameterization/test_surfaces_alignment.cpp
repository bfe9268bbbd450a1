// A surface is turned back onto itself, whatever is done to its sphere, its triangles and its points; and landmarks give
// the rotation that they were turned by.

#include "recording_control.h"
#include "surfaces.h"

#include <CGAL/Spherical_parameterization/cortex.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_levels.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Alignment_descent.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Coarse_pair.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Extremity_search.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Surface_spectrum.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/best_alignments.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace test;

namespace {

SP::Sphere_alignment_3 align(const Mapped_mesh& a, const Mapped_mesh& b)
{
  SP::Sphere_alignment_3 result;
  EXPECT_EQ(SP::align_spheres(a.mesh, a.sphere, b.mesh, b.sphere, result), SP::OK);
  EXPECT_FALSE(result.candidates.empty());
  return result;
}

void expect_good_candidates(const SP::Sphere_alignment_3& alignment)
{
  const auto& candidates = alignment.candidates;
  ASSERT_LE(candidates.size(), 4u);
  for(std::size_t i = 1; i < candidates.size(); ++i)
  {
    EXPECT_GE(candidates[i - 1].score, candidates[i].score);
    for(std::size_t j = 0; j < i; ++j)
      EXPECT_GT(angle(candidates[i].rotation, candidates[j].rotation), 19.9);
  }
  EXPECT_GT(alignment.margin(), 0.1);
  EXPECT_LE(candidates[0].score, 1.);
}

TEST(Alignment, finds_any_rotation_of_the_same_surface)
{
  const Mapped_mesh original(icosphere(4), on_body);
  for(const Quaternion& turn : turns)
  {
    const SP::Sphere_alignment_3 alignment = align(original, Mapped_mesh(icosphere(4), on_body, turn));
    expect_good_candidates(alignment);
    EXPECT_LT(angle(alignment.candidates[0].rotation, rotation(turn)), 1.);
    EXPECT_GT(alignment.candidates[0].score, 0.95);
  }
}

TEST(Alignment, sees_through_noise_a_remesh_and_the_placement)
{
  Random random(1);
  const auto noisy_body = [&](const Point_3& p) {
    const Point_3 q = on_body(p);
    const Coordinates noise = random.in_cube();
    return Point_3(1e3 - 50. * q.y() + 0.5 * noise[0], 50. * q.x() + 0.5 * noise[1], 50. * q.z() + 0.5 * noise[2]);
  };
  const SP::Sphere_alignment_3 alignment =
      align(Mapped_mesh(icosphere(4), on_body), Mapped_mesh(octahedron_of(25), noisy_body, turns[2]));
  expect_good_candidates(alignment);
  EXPECT_LT(angle(alignment.candidates[0].rotation, rotation(turns[2])), 3.);
}

void expect_same(const SP::Sphere_alignment_3& a, const SP::Sphere_alignment_3& b)
{
  ASSERT_EQ(a.candidates.size(), b.candidates.size());
  for(std::size_t k = 0; k < a.candidates.size(); ++k)
  {
    EXPECT_EQ(a.candidates[k].rotation, b.candidates[k].rotation);
    EXPECT_EQ(a.candidates[k].score, b.candidates[k].score);
  }
}

TEST(Alignment, depends_neither_on_threads_nor_on_the_unit)
{
  const Mapped_mesh a(icosphere(3), on_body), b(icosphere(3), on_body, turns[1]);
  const SP::Sphere_alignment_3 expected = align(a, b);
  SP::Sphere_alignment_3 sequential;
  ASSERT_EQ(SP::align_spheres<CGAL::Sequential_tag>(a.mesh, a.sphere, b.mesh, b.sphere, sequential), SP::OK);
  expect_same(sequential, expected);
  for(const double scale : {0x1p+1000, 0x1p-1000})
  {
    const auto scaled_body = [&](const Point_3& p) { return CGAL::ORIGIN + scale * (on_body(p) - CGAL::ORIGIN); };
    expect_same(align(a, Mapped_mesh(icosphere(3), scaled_body, turns[1])), expected);
  }
}

TEST(Alignment, compares_the_features_of_the_caller)
{
  // The surfaces are round: only the features distinguish directions. Their scale does not matter.
  Mapped_mesh a(icosphere(3)), b(icosphere(3), as_it_is, turns[3]);
  const auto feature_a = a.mesh.add_property_map<Vertex_index, double>("v:feature").first;
  const auto feature_b = b.mesh.add_property_map<Vertex_index, float>("v:feature").first;
  for(const Vertex_index v : a.mesh.vertices())
  {
    const Point_3 p = on_body(a.mesh.point(v)); // the vertices are the same in both
    feature_a[v] = p.x() + 0.3 * p.y() * p.z();
    feature_b[v] = static_cast<float>(std::exp(feature_a[v]));
  }
  const std::vector<Mapper::Feature> features = {
      {[&](Vertex_index v) { return feature_a[v]; }, [&](Vertex_index v) { return feature_b[v]; }}};
  SP::Sphere_alignment_3 result;
  ASSERT_EQ(SP::align_spheres(a.mesh, a.sphere, b.mesh, b.sphere, features, result), SP::OK);
  EXPECT_LT(angle(result.candidates[0].rotation, rotation(turns[3])), 1.);

  const SP::Sphere_alignment_3 before = result;
  feature_a[Vertex_index(7)] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(SP::align_spheres(a.mesh, a.sphere, b.mesh, b.sphere, features, result), SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(result.candidates[0].rotation, before.candidates[0].rotation);
}

TEST(Alignment, stops_with_what_it_has)
{
  struct Visitor : SP::Default_visitor
  {
    std::size_t n_left;
    bool go_further(std::size_t, double) { return n_left-- > 0; }
  };
  const Mapped_mesh a(icosphere(3), on_body), b(icosphere(3), on_body, turns[1]);
  SP::Sphere_alignment_3 result;
  for(const std::size_t n : {0u, 2u, 10u})
  {
    Visitor visitor;
    visitor.n_left = n;
    ASSERT_EQ(
        SP::align_spheres(a.mesh, a.sphere, b.mesh, b.sphere, result, CGAL::parameters::visitor(std::ref(visitor))),
        SP::OK);
    EXPECT_TRUE(result.is_stopped);
    ASSERT_FALSE(result.candidates.empty());
  }
  EXPECT_GT(result.candidates[0].score, 0.5); // Some rotations have been tried by the tenth question.
  ASSERT_EQ(SP::align_spheres(a.mesh, a.sphere, b.mesh, b.sphere, result, CGAL::parameters::maximum_running_time(1e-9)),
            SP::OK);
  EXPECT_TRUE(result.is_stopped);
  EXPECT_EQ(result.candidates.size(), 1u);
  EXPECT_FALSE(align(a, b).is_stopped);
}

TEST(Alignment, takes_the_points_of_named_parameters)
{
  Mapped_mesh a(icosphere(3), on_body), b(icosphere(3), on_body, turns[1]);
  const SP::Sphere_alignment_3 expected = align(a, b);
  std::array<Image_map, 2> points = {a.add_map("v:points"), b.add_map("v:points")};
  for(const std::size_t k : {0u, 1u})
    for(const Vertex_index v : a.mesh.vertices()) // the same in both
      std::swap(points[k][v], (k == 0 ? a : b).mesh.point(v));
  SP::Sphere_alignment_3 result;
  ASSERT_EQ(SP::align_spheres(a.mesh, a.sphere, b.mesh, b.sphere, result, CGAL::parameters::vertex_point_map(points[0]),
                              CGAL::parameters::vertex_point_map(points[1])),
            SP::OK);
  expect_same(result, expected);
}

TEST(Alignment, tells_what_is_wrong)
{
  const Mapped_mesh good(icosphere(1), on_body);
  SP::Sphere_alignment_3 result;
  for_each_broken_surface([&](const Mapped_mesh& broken, SP::Error_code error) {
    EXPECT_EQ(SP::align_spheres(good.mesh, good.sphere, broken.mesh, broken.sphere, result), error);
    EXPECT_EQ(SP::align_spheres(broken.mesh, broken.sphere, good.mesh, good.sphere, result), error);
  });
  EXPECT_TRUE(result.candidates.empty());
  EXPECT_EQ(result.margin(), 0.);
}

// A body with arms in these directions, straight or bent, of a length each, and a bump by which front and back differ.
struct Arms
{
  std::vector<CGAL::Vector_3<Kernel>> directions;
  std::vector<double> lengths;
  double bend; // what the ends are turned about the z axis by, in radians

  Point_3 operator()(const Point_3& q) const
  {
    double radius = 1. + 0.15 * std::exp(-8. * (1. - q.z()));
    for(std::size_t k = 0; k < lengths.size(); ++k)
      radius += lengths[k] * std::exp(-30. * (1. - (q - CGAL::ORIGIN) * directions[k]));
    const double angle = bend * (std::max)(radius - 1.5, 0.), s = std::sin(angle), c = std::cos(angle);
    return Point_3(radius * (c * q.x() - s * q.y()), radius * (s * q.x() + c * q.y()), radius * q.z());
  }
};

const Arms straight_arms = {
    {{1., 0., 0.}, {0., 1., 0.}, {-0.6, -0.8, 0.}, {0., 0.6, -0.8}, {0.6, -0.64, -0.48}}, {3.2, 2., 2.6, 1.6, 4.}, 0.};
const Arms bent_arms = {straight_arms.directions, straight_arms.lengths, 0.35};

SP::internal::Surface_descriptor coarse(const Mapped_mesh& mesh, const std::vector<std::vector<double>>& features = {})
{
  const Located_mesh surface(mesh);
  const auto areas = SP::internal::vertex_areas(surface.mesh.rings(), surface.mesh.points());
  std::vector<std::vector<double>> ranks;
  for(const std::vector<double>& feature : features)
    ranks.push_back(SP::internal::ranks_by_area(surface.mesh.in_own_order(feature), areas));
  Recording_control control;
  return SP::internal::Surface_levels(surface.mesh, SP::internal::directions_of(surface.sphere), control, {})
      .coarse_surface(ranks, {});
}

TEST(Surface_descriptor, has_the_ranks_of_features_by_area)
{
  const Mapped_mesh mesh(icosphere(5), on_body);
  std::vector<double> height, constant(mesh.mesh.number_of_vertices(), 3.);
  for(const Vertex_index v : mesh.mesh.vertices())
    height.push_back(std::exp(mesh.mesh.point(v).z()));
  const SP::internal::Surface_descriptor surface = coarse(mesh, {height, constant});
  EXPECT_LE(surface.size(), SP::internal::Surface_descriptor::max_size);
  ASSERT_TRUE(surface.is_bijective());
  double sum = 0., squares = 0., area = 0.;
  for(std::size_t v = 0; v < surface.size(); ++v)
  {
    const double rank = surface.features()[0][v];
    sum += surface.areas()[v] * rank;
    squares += surface.areas()[v] * rank * rank;
    area += surface.areas()[v];
    EXPECT_NEAR(surface.features()[1][v], 0., 1e-12);
  }
  EXPECT_NEAR(area, 1., 1e-9);
  EXPECT_NEAR(sum, 0., 0.01);          // Ranks are spread evenly
  EXPECT_NEAR(squares, 1. / 3., 0.01); // from -1 to 1.
}

TEST(Surface_descriptor, has_the_same_distances_from_a_vertex_and_from_its_direction)
{
  SP::internal::Surface_descriptor surface = coarse(Mapped_mesh(icosphere(4), bent_arms));
  const auto extremities = surface.extremities();
  ASSERT_GE(extremities.size(), 3u);
  for(const auto& origin : extremities)
  {
    EXPECT_EQ(origin.distances[origin.vertex], 0.);
    const auto distances = surface.distances_from(surface.directions()[origin.vertex]);
    for(std::size_t v = 0; v < surface.size(); ++v)
      EXPECT_NEAR(distances[v], origin.distances[v], 1e-6);
  }
}

// The spectrum of a surface, scaled to area 1.
SP::internal::Surface_spectrum spectrum(const test_meshes::Triangle_list& list)
{
  SP::internal::Surface surface;
  std::vector<SP::internal::Vector_3d> points;
  for(const Coordinates& p : list.points)
    points.push_back({p[0], p[1], p[2]});
  SP::internal::Index_triangles triangles;
  for(const auto& [a, b, c] : list.triangles)
    triangles.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
  EXPECT_EQ(surface.assign(points, SP::internal::link_triangles(triangles, points.size())), SP::OK);
  const auto areas = SP::internal::vertex_areas(surface.rings(), surface.points());
  const double scale = 1. / std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.));
  points = surface.points();
  for(SP::internal::Vector_3d& p : points)
    for(double& x : p)
      x *= scale;
  return {surface.rings(), SP::internal::Surface_diffusion(surface.rings(), points, 1e-12, {})};
}

// They are 4 pi l (l + 1), each 2 l + 1 times.
TEST(Surface_spectrum, has_the_eigenvalues_of_a_sphere)
{
  const SP::internal::Surface_spectrum sphere = spectrum(icosphere(4));
  std::size_t k = 0;
  for(const int l : {1, 2, 3, 4})
    for(const std::size_t end = k + 2 * static_cast<std::size_t>(l) + 1; k < end; ++k)
      EXPECT_NEAR(sphere.value(k), 4. * CGAL_PI * l * (l + 1), 0.02 * sphere.value(k)) << k;
}

TEST(Surface_spectrum, is_that_of_the_surface_whatever_the_order_of_its_vertices)
{
  const test_meshes::Triangle_list list = test_meshes::bumpy_sphere(4);
  const SP::internal::Surface_spectrum first = spectrum(list),
                                       second = spectrum(test_meshes::renumbered(
                                           list, test_meshes::random_permutation(list.points.size(), 3), 3));
  ASSERT_EQ(first.number_of_functions(), 100u);
  for(std::size_t k = 0; k < 30; ++k)
    EXPECT_NEAR(first.value(k), second.value(k), 1e-6 * first.value(k)) << k;
  // The signature of the two is the same but for the order: its mean is 1, and the largest value is the same.
  const auto a = first.wave_kernel_signature(4., 0.8), b = second.wave_kernel_signature(4., 0.8);
  EXPECT_NEAR(*std::max_element(a.begin(), a.end()), *std::max_element(b.begin(), b.end()), 1e-5);
  EXPECT_GT(*std::max_element(a.begin(), a.end()), 1.01);
  EXPECT_NEAR(*std::min_element(a.begin(), a.end()), *std::min_element(b.begin(), b.end()), 1e-5);
}

TEST(Extremities, are_found_on_the_ends_of_arms_and_matched_whatever_the_pose)
{
  const Mapped_mesh a(icosphere(4), straight_arms), b(icosphere(4), bent_arms, turns[1]);
  SP::internal::Surface_descriptor first = coarse(a), second = coarse(b);
  const auto tips1 = first.extremities(), tips2 = second.extremities();
  ASSERT_EQ(tips1.size(), 5u);
  ASSERT_EQ(tips2.size(), 5u);
  SP::internal::Extremity_search search(tips1, tips2);
  const auto matchings = search.best(4, first.directions(), second.directions());
  ASSERT_FALSE(matchings.empty());
  EXPECT_EQ(matchings[0].pairs.size(), 5u);
  const Rotation_3 found = SP::internal::as_transformation(matchings[0].rotation);
  EXPECT_LT(angle(found, rotation(turns[1])), 12.);
  for(std::size_t i = 1; i < matchings.size(); ++i)
    EXPECT_LE(matchings[i].score, matchings[i - 1].score);
}

TEST(Extremities, are_not_matched_if_they_are_too_few)
{
  SP::internal::Surface_descriptor surface = coarse(Mapped_mesh(icosphere(4), on_body));
  auto extremities = surface.extremities();
  extremities.resize((std::min<std::size_t>)(extremities.size(), 2));
  for(const auto& few : {extremities, {}})
    EXPECT_TRUE(
        SP::internal::Extremity_search(few, extremities).best(4, surface.directions(), surface.directions()).empty());
}

double mean_distance(const Mapped_mesh& a, const Image_map& directions, const Mapped_mesh& b)
{
  return mean_over_vertices(a.mesh, [&](Vertex_index v) { return distance(directions[v], b.sphere[v]); });
}

// The spheres lean to opposite sides, by much more than the arms are wide on them, as those of two poses may.
TEST(Alignment, brings_arms_to_theirs_on_spheres_that_lean_to_different_sides)
{
  const auto leaning = [](const Point_3& p, double share) {
    const CGAL::Vector_3<Kernel> q(p.x(), p.y(), p.z() + share);
    return CGAL::ORIGIN + q / std::sqrt(q.squared_length());
  };
  Mapped_mesh a(icosphere(4), straight_arms), b(icosphere(4), bent_arms, turns[1]);
  for(const Vertex_index v : a.mesh.vertices())
  {
    a.sphere[v] = leaning(a.sphere[v], 0.45);
    b.sphere[v] = rotation(turns[1]).transform(leaning(rotation(turns[1]).inverse().transform(b.sphere[v]), -0.45));
  }
  const Image_map directions = a.add_map(), others = a.add_map("v:others");
  Mapper mapper;
  ASSERT_EQ(SP::map_surface<CGAL::Sequential_tag>(a.mesh, a.sphere, b.mesh, b.sphere, mapper, directions), SP::OK);
  const SP::Surface_map_report& report = mapper.report();
  EXPECT_LT(mean_distance(a, directions, b), 0.06);
  EXPECT_GT(report.agreement, 0.7);
  EXPECT_GT(report.margin, 0.05);
  ASSERT_EQ(SP::map_surface<CGAL::Parallel_if_available_tag>(a.mesh, a.sphere, b.mesh, b.sphere, others), SP::OK);
  for(const Vertex_index v : a.mesh.vertices())
    EXPECT_EQ(directions[v], others[v]);

  // Two landmarks, of which one arm has both, determine less than the features, and are met.
  const Vertex_index tip =
      least_vertex(a.mesh, [&](Vertex_index v) { return -(a.mesh.point(v) - CGAL::ORIGIN).squared_length(); });
  const Vertex_index beside = source(halfedge(tip, a.mesh), a.mesh);
  mapper = mapper.landmarks({{tip, tip}, {beside, beside}});
  ASSERT_EQ(SP::map_surface(a.mesh, a.sphere, b.mesh, b.sphere, mapper, directions), SP::OK);
  EXPECT_EQ(mapper.report().number_of_missed_landmarks, 0u);
  EXPECT_LT(mean_distance(a, directions, b), 0.06);
}

// A half turn brings these bodies onto themselves.
TEST(Alignment, is_chosen_by_a_single_landmark)
{
  const std::vector<CGAL::Vector_3<Kernel>> ends = {{1., 0., 0.}, {-1., 0., 0.}, {0., 1., 0.}, {0., -1., 0.}};
  const std::vector<double> lengths = {3.2, 3.2, 2., 2.};
  const Mapped_mesh a(icosphere(4), Arms{ends, lengths, 0.}), b(icosphere(4), Arms{ends, lengths, 0.35}, turns[1]);
  const auto nearest_vertex = [](const Mapped_mesh& m, const Point_3& p) {
    return least_vertex(m.mesh, [&](Vertex_index v) { return distance(m.sphere[v], p); });
  };
  const Vertex_index v = nearest_vertex(a, Point_3(0.98, 0.1, 0.1));
  const Rotation_3 half_turn(-1., 0., 0., 0., -1., 0., 0., 0., 1.), there = rotation(turns[1]);
  for(const Rotation_3& truth : {there, there * half_turn})
  {
    Mesh mesh = a.mesh;
    const Image_map directions = mesh.add_property_map<Vertex_index, Point_3>("v:directions").first;
    Mapper mapper = Mapper().landmarks({{v, nearest_vertex(b, truth(a.sphere[v]))}});
    ASSERT_EQ(SP::map_surface(a.mesh, a.sphere, b.mesh, b.sphere, mapper, directions), SP::OK);
    const auto error = [&](Vertex_index w) { return distance(directions[w], truth(a.sphere[w])); };
    EXPECT_LT(mean_over_vertices(mesh, error), 0.06);
    EXPECT_EQ(mapper.report().number_of_missed_landmarks, 0u);
    EXPECT_FALSE(mapper.report().is_uncertain) << mapper.report().agreement << ' ' << mapper.report().margin;
  }
}

TEST(Alignment, starts_from_the_inverse_of_a_map)
{
  using namespace SP::internal;
  const Mapped_mesh a(icosphere(4), straight_arms), b(icosphere(4), bent_arms, turns[1]);
  const Rotation_matrix turn = rotation_matrix(turns[1]);
  Recording_control control;
  const Coarse_pair surfaces(coarse(a), coarse(b), control, {});
  const std::vector<Vector_3d>& origins = surfaces.first().directions();
  const Target_metric metric(surfaces.second().sphere(), surfaces.second().points(), surfaces.first().size(), {});
  const Alignment_descent descent(surfaces, metric);
  const Mesh_hierarchy levels = descent.levels();
  std::optional<Alignment_start> start = start_from_inverse(
      surfaces, rotated_directions(transposed(turn), surfaces.second().directions()), levels, descent);
  ASSERT_TRUE(start.has_value());
  EXPECT_GT(cosine_between(start->alignment.rotation, turn), 0.999);
  const auto largest_distance = [&](const std::vector<std::uint32_t>& vertices) {
    double largest = 0.;
    for(const std::uint32_t v : vertices)
      largest = (std::max)(largest, length(start->alignment.directions[v] - rotated(turn, origins[v])));
    return largest;
  };
  EXPECT_LT(largest_distance(levels.level(levels.number_of_levels() - 1).vertices), 0.02);
  descent.lead(false, *start);
  EXPECT_TRUE(start->is_valid);
  EXPECT_LT(largest_distance(levels.level(0).vertices), 0.3);

  const Coarse_pair reversed = surfaces.reversed();
  EXPECT_EQ(&reversed.first(), &surfaces.second());
  EXPECT_EQ(&reversed.second(), &surfaces.first());
}

TEST(Alignment, starts_from_counterparts_by_the_symmetry_of_a_body)
{
  using namespace SP::internal;
  const Arms person = {
      {{1., 0., 0.}, {-1., 0., 0.}, {0., 1., 0.}, {0.6, -0.8, 0.}, {-0.6, -0.8, 0.}}, {2.6, 2.6, 1.5, 3.5, 3.5}, 0.};
  const Mapped_mesh a(icosphere(4), bent_arms), b(icosphere(4), person);
  Recording_control control;
  const Coarse_pair surfaces(coarse(a), coarse(b), control, {});
  const Rotation_matrix half_turn = rotation_matrix({0., 0., 1., 0.}), turn = rotation_matrix(turns[1]);
  EXPECT_GT(cosine_between(surfaces.symmetry_of_second(), half_turn), 0.98);
  const std::vector<Rotation_matrix> rotations = with_counterparts(surfaces, {{turn, {}, {}, 0., 0., 0.}});
  ASSERT_EQ(rotations.size(), 2u);
  EXPECT_EQ(cosine_between(rotations[0], turn), cosine_between(turn, turn));
  EXPECT_GT(cosine_between(rotations[1], product(half_turn, turn)), 0.98);
}

TEST(Alignment, untangles_inverted_faces)
{
  using namespace SP::internal;
  const Mapped_mesh a(icosphere(2));
  const Located_mesh located(a);
  const Vertex_rings& rings = located.mesh.rings();
  std::vector<Vector_3d> directions = located.positions();
  for(const std::uint32_t v : {0u, 40u, 80u})
    std::swap(directions[v], directions[*rings.ring(v).begin()]);
  ASSERT_FALSE(are_safely_positive(rings, directions));
  const std::vector<Vector_3d> before = directions;
  EXPECT_TRUE(untangle(rings, directions));
  EXPECT_TRUE(are_safely_positive(rings, directions));
  std::size_t n_moved = 0;
  for(std::size_t v = 0; v < directions.size(); ++v)
    n_moved += directions[v] != before[v];
  EXPECT_LT(n_moved, directions.size() / 2); // only around the inverted faces
  std::vector<Vector_3d> one_point(directions.size(), Vector_3d{0., 0., 1.});
  EXPECT_FALSE(untangle(rings, one_point));
}

// Here the features are constant.
TEST(Alignment, is_mended_by_eigenfunctions_where_it_has_slid)
{
  using namespace SP::internal;
  const Mapped_mesh a(icosphere(4), straight_arms), b(icosphere(4), bent_arms, turns[1]);
  const std::vector<std::vector<double>> nothing(1, std::vector<double>(num_vertices(a.mesh), 0.));
  Recording_control control;
  Coarse_pair surfaces(coarse(a, nothing), coarse(b, nothing), control, {});
  const Surface_descriptor first = coarse(a), second = coarse(b);
  const std::vector<Vector_3d> truth = rotated_directions(rotation_matrix(turns[1]), first.directions());
  std::vector<Vector_3d> directions, points;
  for(const Vector_3d& p : truth) // They slide by up to 11 degrees to either side.
  {
    const double half = 0.1 * std::sin(6. * p[2]);
    directions.push_back(rotated(rotation_matrix({std::cos(half), 0., 0., std::sin(half)}), p));
  }
  const auto error = [&](const std::vector<Vector_3d>& found) {
    double sum = 0.;
    for(std::size_t v = 0; v < truth.size(); ++v)
      sum += first.areas()[v] * length(found[v] - truth[v]);
    return sum;
  };
  std::vector<Vector_3d> by_energy_alone = directions;
  const double before = error(by_energy_alone);
  for(const Vector_3d& p : first.points())
    points.push_back(std::sqrt(4. * CGAL_PI) * p);
  const Target_metric metric(second.sphere(), second.points(), second.size(), {});
  ASSERT_TRUE(
      minimize_on_target(first.rings(), points, {metric, {}, 0.}, 500, {20, 1e-3, 0.02}, by_energy_alone, control, {}));
  surfaces.find_spectra();
  Alignment alignment;
  alignment.directions = directions;
  Alignment_descent(surfaces, metric).match_functions(alignment);
  EXPECT_EQ(alignment.before_matching, directions);
  EXPECT_LT(error(alignment.directions), 0.5 * before);
  EXPECT_LT(error(alignment.directions), 0.7 * error(by_energy_alone));
}

TEST(Alignment, of_arms_with_bodies_that_have_none_is_uncertain)
{
  Mapped_mesh a(icosphere(4), straight_arms);
  const Image_map directions = a.add_map();
  const Mapped_mesh body(icosphere(4), on_body, turns[1]), sphere(icosphere(4), as_it_is, turns[2]);
  for(const Mapped_mesh* const b : {&body, &sphere})
  {
    Mapper mapper;
    ASSERT_EQ(SP::map_surface(a.mesh, a.sphere, b->mesh, b->sphere, mapper, directions), SP::OK);
    EXPECT_TRUE(mapper.report().is_uncertain) << mapper.report().agreement << ' ' << mapper.report().margin;
    EXPECT_TRUE(SP::is_bijective(a.mesh, directions));
  }
}

// Whenever the control says no, there is an alignment.
TEST(Alignment, of_surfaces_stops_when_it_is_told_to)
{
  const Mapped_mesh a(icosphere(3), straight_arms), b(icosphere(3), bent_arms, turns[1]);
  const Located_mesh first(a), second(b);
  const SP::internal::Target_metric metric(second.sphere, second.points, first.points.size(), {});
  const SP::internal::Surface_map_settings settings;
  const SP::internal::Execution execution;
  std::size_t n_questions = 0;
  for(const std::size_t max_questions : {1000u, 0u, 3u, 8u, 14u, 18u})
  {
    Recording_control control;
    control.max_questions = max_questions;
    SP::internal::Coarse_pair surfaces(coarse(a), coarse(b), control, {});
    const auto best =
        SP::internal::best_alignments(surfaces, {first, second, settings, control, execution, metric, {}});
    ASSERT_FALSE(best.empty());
    EXPECT_EQ(control.is_stopped(), max_questions < 1000u);
    EXPECT_LE(control.number_of_questions, max_questions + 1);
    n_questions = (std::max)(n_questions, control.number_of_questions);
  }
  EXPECT_GT(n_questions, 10u);
}

TEST(Landmarks, give_their_rotation)
{
  const Mapped_mesh a(icosphere(1));
  for(const Quaternion& turn : turns)
  {
    const Mapped_mesh b(icosphere(1), as_it_is, turn);
    for(const std::size_t n : {2u, 3u, 17u})
    {
      Vertex_pairs landmarks;
      for(const Vertex_index v : a.mesh.vertices())
        if(landmarks.size() < n)
          landmarks.emplace_back(v, v);
      Rotation_3 result;
      ASSERT_EQ(SP::fit_rotation(a.sphere, b.sphere, landmarks, result), SP::OK);
      EXPECT_LT(angle(result, rotation(turn)), 1e-6);
    }
  }
}

// and not a reflection
void expect_rotation(const Rotation_3& r)
{
  EXPECT_GT(CGAL::determinant(r.m(0, 0), r.m(0, 1), r.m(0, 2), r.m(1, 0), r.m(1, 1), r.m(1, 2), r.m(2, 0), r.m(2, 1),
                              r.m(2, 2)),
            0.99);
}

TEST(Landmarks, are_approximated_by_a_rotation_where_they_are_mirrored)
{
  Mapped_mesh a(icosphere(1));
  const Image_map mirrored = a.add_map();
  Vertex_pairs landmarks;
  for(const Vertex_index v : a.mesh.vertices())
  {
    mirrored[v] = Point_3(-a.sphere[v].x(), 2. * a.sphere[v].y(), 0.5 * a.sphere[v].z());
    if(std::abs(a.sphere[v].x()) < 0.6)
      landmarks.emplace_back(v, v);
  }
  Rotation_3 result;
  ASSERT_EQ(SP::fit_rotation(a.sphere, mirrored, landmarks, result), SP::OK);
  expect_rotation(result);
}

TEST(Rotation_to_surface, turns_a_sphere_back)
{
  // Dense on one side, so that the mean over the vertices would be another rotation.
  Triangle_list list = icosphere(4);
  for(Coordinates& p : list.points)
    p = test_meshes::normalized({p[0], p[1], p[2] + 0.7});
  for(const double unit : {1., 1e-200, 1e200})
    for(const Quaternion& turn : turns)
    {
      const auto moved = [&](const Point_3& p) {
        return Point_3(unit * (10. + p.x()), unit * (p.y() - 20.), unit * (5. + p.z()));
      };
      const Mapped_mesh body(list, moved, turn);
      Rotation_3 result;
      ASSERT_EQ(SP::fit_rotation_to_surface(body.mesh, body.sphere, result), SP::OK);
      EXPECT_LT(angle(result, rotation(turn).inverse()), 1e-2);
    }
}

TEST(Rotation_to_surface, is_the_best_one_and_no_reflection)
{
  const Triangle_list list = icosphere(4);
  for(const bool is_mirrored : {false, true})
  {
    const auto point_on_body = [&](const Point_3& p) {
      return is_mirrored ? Point_3(-p.x(), 2. * p.y(), 3. * p.z()) : on_body(p);
    };
    const Mapped_mesh body(list, point_on_body, turns[1]);
    const Images surface = points(body.mesh);
    std::vector<double> weights(surface.size(), 0.);
    double area = 0.;
    Coordinates center = {0., 0., 0.};
    for(const Triangle& t : list.triangles)
      for(const std::size_t v : t)
      {
        const double a = test::area(surface[t[0]], surface[t[1]], surface[t[2]]);
        weights[v] += a;
        area += a;
        center = combination(1., center, a, surface[v]);
      }
    const auto squared_distance = [&](const Rotation_3& turn) { // weighted as the reference says
      return mean_over_vertices(body.mesh, [&](Vertex_index v) {
        const Coordinates d = test_meshes::normalized(combination(1., surface[v], -1. / area, center));
        return weights[v] * CGAL::squared_distance(Point_3(d[0], d[1], d[2]), turn.transform(body.sphere[v]));
      });
    };
    Rotation_3 result;
    ASSERT_EQ(SP::fit_rotation_to_surface(body.mesh, body.sphere, result), SP::OK);
    expect_rotation(result);
    const double least = squared_distance(result);
    for(std::size_t i = 1; i < 4; ++i)
      for(const double x : {1e-3, -1e-3})
      {
        Quaternion step = turns[0];
        step[i] = x;
        EXPECT_GT(squared_distance(rotation(step) * result), least);
      }
  }
}

TEST(Rotation_to_surface, is_left_as_it_was_where_there_is_none)
{
  Mapped_mesh body(icosphere(2), on_body, turns[1]);
  const Rotation_3 before(CGAL::SCALING, 3.);
  Rotation_3 result = before;
  const auto fit = [&] { return SP::fit_rotation_to_surface(body.mesh, body.sphere, result); };
  const Vertex_index v = *body.mesh.vertices().begin();
  const Point_3 image = body.sphere[v], point = body.mesh.point(v);
  body.sphere[v] = Point_3(0., 0., 0.);
  EXPECT_EQ(fit(), SP::ERROR_INVALID_DIRECTION);
  body.sphere[v] = image;
  body.mesh.point(v) = Point_3(0., std::numeric_limits<double>::infinity(), 0.);
  EXPECT_EQ(fit(), SP::ERROR_NON_FINITE_COORDINATE);
  for(const Vertex_index w : body.mesh.vertices())
    body.mesh.point(w) = point;
  EXPECT_EQ(fit(), SP::ERROR_UNDETERMINED_ROTATION);
  EXPECT_EQ(result, before);
}

TEST(Landmarks, that_do_not_determine_a_rotation_are_refused)
{
  Mesh mesh;
  const Vertex_index x = mesh.add_vertex(Point_3(1., 0., 0.)), far_x = mesh.add_vertex(Point_3(9., 0., 0.)),
                     opposite_x = mesh.add_vertex(Point_3(-2., 0., 0.)), y = mesh.add_vertex(Point_3(0., 1., 0.)),
                     zero = mesh.add_vertex(Point_3(0., 0., 0.));
  const Rotation_3 before(CGAL::SCALING, 3.);
  Rotation_3 result = before;
  const auto fit = [&](const Vertex_pairs& landmarks) {
    return SP::fit_rotation(mesh.points(), mesh.points(), landmarks, result);
  };
  EXPECT_EQ(fit({}), SP::ERROR_UNDETERMINED_ROTATION);
  EXPECT_EQ(fit({{x, y}}), SP::ERROR_UNDETERMINED_ROTATION);
  EXPECT_EQ(fit({{x, y}, {x, y}, {x, y}}), SP::ERROR_UNDETERMINED_ROTATION);
  EXPECT_EQ(fit({{x, x}, {far_x, x}, {opposite_x, opposite_x}}), SP::ERROR_UNDETERMINED_ROTATION);
  EXPECT_EQ(fit({{x, x}, {y, x}}), SP::ERROR_UNDETERMINED_ROTATION);
  EXPECT_EQ(fit({{x, x}, {y, zero}}), SP::ERROR_INVALID_DIRECTION);
  EXPECT_EQ(result, before);
  EXPECT_EQ(fit({{x, x}, {y, y}}), SP::OK);
}

SP::Sulcal_measures sulcal_measures_of(const Mesh& mesh)
{
  SP::Sulcal_measures result;
  EXPECT_EQ(SP::compute_sulcal_measures(mesh, result), SP::OK);
  return result;
}

// Of a vertex with five neighbors, the share of the area is a tenth too small.
TEST(Folding, of_a_sphere_is_its_curvature)
{
  constexpr double radius = 10.;
  const Mapped_mesh sphere(
      icosphere(5), [](const Point_3& p) { return Point_3(radius * p.x(), radius * p.y(), 3. + radius * p.z()); });
  const SP::Sulcal_measures folding = sulcal_measures_of(sphere.mesh);
  const auto curvature = [&](Vertex_index v) { return folding.curvature[v] * radius; };
  const auto inflated_curvature = [&](Vertex_index v) { return folding.inflated_curvature[v] * radius; };
  for(const Vertex_index v : sphere.mesh.vertices())
  {
    EXPECT_NEAR(curvature(v), -1., 0.1);
    EXPECT_NEAR(folding.depth[v] / radius, 0., 2e-4);
    EXPECT_NEAR(inflated_curvature(v), -1., 0.05);
  }
  EXPECT_NEAR(mean_over_vertices(sphere.mesh, curvature), -1., 2e-3);
  EXPECT_NEAR(mean_over_vertices(sphere.mesh, inflated_curvature), -1., 0.03); // the sphere has shrunk by 1.3 per cent
}

TEST(Folding, does_not_depend_on_the_samples_the_place_and_the_threads)
{
  const auto waves = [](const Point_3& p) {
    const double r = 1. + 0.05 * std::sin(12. * p.x()) * std::sin(11. * p.y() + 1.) * std::sin(10. * p.z() + 2.);
    return Point_3(r * p.x(), r * p.y(), r * p.z());
  };
  const auto moved = [&](const Point_3& p) {
    const Point_3 q = waves(p);
    return Point_3(7. - 2e3 * q.y(), 2e3 * q.x(), 2e3 * q.z());
  };
  const Mapped_mesh first(icosphere(5), waves), second(octahedron_of(64), moved);
  const SP::Sulcal_measures a = sulcal_measures_of(first.mesh), b = sulcal_measures_of(second.mesh);
  SP::Sulcal_measures sequential;
  ASSERT_EQ(SP::compute_sulcal_measures<CGAL::Sequential_tag>(second.mesh, sequential), SP::OK);
  EXPECT_EQ(sequential.curvature, b.curvature);
  EXPECT_EQ(sequential.depth, b.depth);
  EXPECT_EQ(sequential.inflated_curvature, b.inflated_curvature);
  const auto selected = [&](unsigned int selection) {
    SP::Sulcal_measures result = b; // what was there is replaced
    EXPECT_EQ(SP::compute_sulcal_measures(second.mesh, result, selection), SP::OK);
    return result;
  };
  using Values = std::vector<double>;
  const SP::Sulcal_measures one = selected(SP::Sulcal_measures::CURVATURE),
                            two = selected(SP::Sulcal_measures::DEPTH | SP::Sulcal_measures::INFLATED_CURVATURE);
  EXPECT_TRUE(one.curvature == b.curvature && one.depth == Values() && one.inflated_curvature == Values());
  EXPECT_TRUE(two.curvature == Values() && two.depth == b.depth && two.inflated_curvature == b.inflated_curvature);
  EXPECT_EQ(selected(SP::Sulcal_measures::INFLATED_CURVATURE).depth, Values());

  // Where the first surface has a vertex, the second one has a face.
  const SP::Sphere_locator_3 locator(second.mesh, second.sphere, true);
  const auto values = [](const SP::Sulcal_measures& measures, double unit, Vertex_index v) {
    return Coordinates{unit * measures.curvature[v], measures.depth[v] / unit, unit * measures.inflated_curvature[v]};
  };
  std::array<double, 3> squares = {}, differences = {};
  for(const Vertex_index v : first.mesh.vertices())
  {
    const auto [face, weights] = locator.locate(first.sphere[v]);
    const Mesh::Halfedge_index h = second.mesh.halfedge(face);
    const Coordinates here = values(a, 1., v);
    Coordinates there = {};
    std::size_t k = 0;
    for(const Vertex_index w : CGAL::vertices_around_face(second.mesh.prev(h), second.mesh)) // source(h) first
      there = combination(1., there, weights[k++], values(b, 2e3, w));
    for(std::size_t i = 0; i < 3; ++i)
    {
      squares[i] += here[i] * here[i];
      differences[i] += (here[i] - there[i]) * (here[i] - there[i]);
    }
    EXPECT_LT(std::abs(here[1]), 0.1);
  }
  for(std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(std::sqrt(differences[i] / squares[i]), 0.05) << i;
}

TEST(Folding, of_what_is_no_surface_is_left_as_it_was)
{
  Mapped_mesh body(icosphere(2), on_body, turns[1]);
  const Vertex_index lonely = body.mesh.add_vertex(Point_3(1., 2., 3.));
  SP::Sulcal_measures folding = sulcal_measures_of(body.mesh);
  EXPECT_EQ(folding.depth.size(), body.mesh.number_of_vertices());
  EXPECT_EQ(folding.depth[lonely], 0.);
  const std::vector<double> before = folding.depth;
  const Vertex_index v = *body.mesh.vertices().begin();
  body.mesh.point(v) = Point_3(0., std::numeric_limits<double>::infinity(), 0.);
  EXPECT_EQ(SP::compute_sulcal_measures(body.mesh, folding), SP::ERROR_NON_FINITE_COORDINATE);
  CGAL::Euler::remove_face(body.mesh.halfedge(v), body.mesh);
  EXPECT_EQ(SP::compute_sulcal_measures(body.mesh, folding), SP::ERROR_NON_CLOSED_MESH);
  EXPECT_EQ(folding.depth, before);
}

} // namespace
