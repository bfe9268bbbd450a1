// A surface is turned back onto itself, whatever is done to its sphere, its triangles and its points; and landmarks give
// the rotation that they were turned by.

#include "judge.h"
#include "methods.h"
#include "random_meshes.h"
#include "recording_control.h"
#include "surfaces.h"

#include <CGAL/Spherical_parameterization/Surface_mapper_3.h>
#include <CGAL/Spherical_parameterization/align_spheres.h>
#include <CGAL/Spherical_parameterization/internal/align/Sphere_bending.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

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
  const Mapped_mesh original(icosphere(4), on_body, rotation(turns[0]));
  for(const Quaternion& turn : turns)
  {
    const Rotation_3 expected = rotation(turn);
    const Mapped_mesh turned(icosphere(4), on_body, expected);
    const SP::Sphere_alignment_3 alignment = align(original, turned);
    expect_good_candidates(alignment);
    EXPECT_LT(angle(alignment.candidates[0].rotation, expected), 1.);
    EXPECT_GT(alignment.candidates[0].score, 0.95);
  }
}

TEST(Alignment, sees_through_noise_a_remesh_and_the_placement)
{
  Random random(1);
  const Mapped_mesh original(icosphere(4), on_body, rotation(turns[0]));
  const Mapped_mesh changed(
      octahedron_of(25),
      [&](const Point_3& p) {
        const Point_3 q = on_body(p);
        const auto noise = [&] { return random.between(-0.01, 0.01); };
        return Point_3(1e3 - 50. * (q.y() + noise()), 50. * (q.x() + noise()), 50. * (q.z() + noise()));
      },
      rotation(turns[2]));
  const SP::Sphere_alignment_3 alignment = align(original, changed);
  expect_good_candidates(alignment);
  EXPECT_LT(angle(alignment.candidates[0].rotation, rotation(turns[2])), 3.);
}

TEST(Alignment, depends_neither_on_threads_nor_on_the_unit)
{
  const Mapped_mesh a(icosphere(3), on_body, rotation(turns[0]));
  const auto scaled_body = [](double scale) {
    return [scale](const Point_3& p) {
      const Point_3 q = on_body(p);
      return Point_3(scale * q.x(), scale * q.y(), scale * q.z());
    };
  };
  const Mapped_mesh b(icosphere(3), on_body, rotation(turns[1]));
  const SP::Sphere_alignment_3 expected = align(a, b);
  const auto expect_same = [&](const SP::Sphere_alignment_3& result) {
    ASSERT_EQ(result.candidates.size(), expected.candidates.size());
    for(std::size_t k = 0; k < result.candidates.size(); ++k)
    {
      EXPECT_EQ(result.candidates[k].rotation, expected.candidates[k].rotation);
      EXPECT_EQ(result.candidates[k].score, expected.candidates[k].score);
    }
  };
  SP::Sphere_alignment_3 sequential;
  ASSERT_EQ(SP::align_spheres<CGAL::Sequential_tag>(a.mesh, a.sphere, b.mesh, b.sphere, sequential), SP::OK);
  expect_same(sequential);
  expect_same(align(a, Mapped_mesh(icosphere(3), scaled_body(0x1p+1000), rotation(turns[1]))));
  expect_same(align(a, Mapped_mesh(icosphere(3), scaled_body(0x1p-1000), rotation(turns[1]))));
}

using Mapper = SP::Surface_mapper_3<Mesh>;

TEST(Alignment, compares_the_features_of_the_caller)
{
  // The surfaces are round: all that tells directions apart are the features. Their scale does not matter.
  const auto round = [](const Point_3& p) { return p; };
  Mapped_mesh a(icosphere(3), round, rotation(turns[0])), b(icosphere(3), round, rotation(turns[3]));
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
  const Mapped_mesh a(icosphere(3), on_body, rotation(turns[0])), b(icosphere(3), on_body, rotation(turns[1]));
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
  Mapped_mesh a(icosphere(3), on_body, rotation(turns[0])), b(icosphere(3), on_body, rotation(turns[1]));
  const SP::Sphere_alignment_3 expected = align(a, b);
  std::array<Mesh::Property_map<Vertex_index, Point_3>, 2> points;
  for(const std::size_t k : {0u, 1u})
  {
    Mesh& mesh = (k == 0 ? a : b).mesh;
    points[k] = mesh.add_property_map<Vertex_index, Point_3>("v:points").first;
    for(const Vertex_index v : mesh.vertices())
    {
      points[k][v] = mesh.point(v);
      mesh.point(v) = Point_3(0., 0., 0.);
    }
  }
  SP::Sphere_alignment_3 result;
  ASSERT_EQ(SP::align_spheres(a.mesh, a.sphere, b.mesh, b.sphere, result, CGAL::parameters::vertex_point_map(points[0]),
                              CGAL::parameters::vertex_point_map(points[1])),
            SP::OK);
  EXPECT_EQ(result.candidates[0].score, expected.candidates[0].score);
}

TEST(Alignment, tells_what_is_wrong)
{
  const Mapped_mesh good(icosphere(1), on_body, rotation(turns[0]));
  Mapped_mesh folded(icosphere(1), on_body, rotation(turns[0]));
  std::swap(folded.sphere[Vertex_index(0)], folded.sphere[Vertex_index(1)]);
  Mapped_mesh not_finite(icosphere(1), on_body, rotation(turns[0]));
  not_finite.mesh.point(Vertex_index(3)) = Point_3(0., std::numeric_limits<double>::infinity(), 0.);
  SP::Sphere_alignment_3 result;
  for(const bool is_first : {true, false})
  {
    const auto align_with = [&](const Mapped_mesh& bad) {
      const Mapped_mesh &a = is_first ? bad : good, &b = is_first ? good : bad;
      return SP::align_spheres(a.mesh, a.sphere, b.mesh, b.sphere, result);
    };
    EXPECT_EQ(align_with(folded), SP::ERROR_NO_1_TO_1_MAPPING);
    EXPECT_EQ(align_with(not_finite), SP::ERROR_NON_FINITE_COORDINATE);
  }
  EXPECT_TRUE(result.candidates.empty());
  EXPECT_EQ(result.margin(), 0.);
}

// The spheres of two meshes as a run between surfaces has them.
struct Aligned_spheres
{
  using Triangulation = SP::internal::Sphere_triangulation<Kernel>;
  using Features = std::vector<std::vector<double>>;

  Aligned_spheres(const SP::internal::Sphere_grid& grid, const Mapped_mesh& a, const Mapped_mesh& b,
                  const std::array<Features, 2>& features, SP::internal::Run_control& control,
                  const SP::internal::Execution& execution)
    : alignment(grid, sampled(grid, a, features[0], execution, first), sampled(grid, b, features[1], execution, second),
                control, execution)
  {}

  static SP::internal::Sampled_surface sampled(const SP::internal::Sphere_grid& grid, const Mapped_mesh& mesh,
                                               const Features& features, const SP::internal::Execution& execution,
                                               Triangulation& sphere)
  {
    SP::internal::Mesh_on_sphere<Mesh, Mesh::Property_map<Vertex_index, Point_3>> arrays;
    EXPECT_EQ(arrays.read_with_points(mesh.mesh, mesh.sphere, mesh.mesh.points(), execution), SP::OK);
    sphere.assign(arrays.images, arrays.triangles);
    sphere.make_grid();
    return SP::internal::Sampled_surface(grid, sphere, arrays.points, features, execution);
  }

  Triangulation first, second;
  SP::internal::Surface_alignment alignment;
};

Point_3 point(const SP::internal::Vector_3d& p)
{
  return Point_3(p[0], p[1], p[2]);
}

void expect_bijective(const Mapped_mesh& original, const std::vector<SP::internal::Vector_3d>& directions)
{
  Mesh mesh = original.mesh;
  ASSERT_EQ(directions.size(), mesh.number_of_vertices());
  for(const Vertex_index v : mesh.vertices())
    mesh.point(v) = point(directions[v]);
  EXPECT_TRUE(SP::is_bijective(mesh, mesh.points()));
}

// Another sphere of the same body: its map differs from the first one by a smooth bijection, which a rotation is not.
TEST(Bending, comes_nearer_to_a_smooth_map_and_stays_a_bijection)
{
  const auto warped = [](const Point_3& p) {
    const CGAL::Vector_3<Kernel> q(p.x() + 0.35 * p.y() * p.y(), p.y() - 0.3 * p.z(), p.z() * (1. + 0.3 * p.x()));
    return CGAL::ORIGIN + q / std::sqrt(q.squared_length());
  };
  const Mapped_mesh a(icosphere(4), on_body, rotation(turns[0]));
  Mapped_mesh b(icosphere(4), on_body, rotation(turns[0]));
  for(const Vertex_index v : b.mesh.vertices())
    b.sphere[v] = rotation(turns[1]).transform(warped(a.sphere[v]));

  const SP::internal::Sphere_grid grid({});
  std::vector<SP::internal::Vector_3d> results[2];
  double turned_error = 0., bent_error = 0.;
  for(const bool is_parallel : {false, true})
  {
    const SP::internal::Execution execution =
        is_parallel ? SP::internal::execution_of<CGAL::Parallel_if_available_tag>() : SP::internal::Execution();
    Recording_control control;
    Aligned_spheres spheres(grid, a, b, {}, control, execution);
    const auto start = spheres.alignment.best_rotations(1);
    const auto bent_grids = spheres.alignment.bent(start);
    ASSERT_EQ(bent_grids.size(), 1u);
    EXPECT_GT(bent_grids[0].score, start[0].score);
    EXPECT_EQ(spheres.alignment.margin(bent_grids), bent_grids[0].score);

    const auto directions =
        SP::internal::bent_directions(spheres.first, grid, bent_grids[0].directions, control, execution);
    ASSERT_TRUE(directions);
    results[is_parallel] = *directions;
    const Rotation_3 rotation = SP::internal::as_transformation(start[0].rotation);
    turned_error = bent_error = 0.;
    for(const Vertex_index v : a.mesh.vertices())
    {
      turned_error += std::sqrt(CGAL::squared_distance(rotation.transform(a.sphere[v]), b.sphere[v]));
      bent_error += std::sqrt(CGAL::squared_distance(point((*directions)[v]), b.sphere[v]));
    }
    expect_bijective(a, *directions);
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_LT(bent_error, 0.75 * turned_error); // The body is smooth: it has few features to go by.
}

// The features of the caller do not agree, and the start that is bent is the only one.
TEST(Bending, starts_from_a_single_rotation_however_bad_it_is)
{
  const Mapped_mesh a(icosphere(3), on_body, rotation(turns[0]));
  const SP::internal::Sphere_grid grid({});
  std::array<std::vector<double>, 2> features;
  for(const Vertex_index v : a.mesh.vertices())
  {
    features[0].push_back(a.sphere[v].z());
    features[1].push_back(-a.sphere[v].z());
  }
  Recording_control control;
  Aligned_spheres spheres(grid, a, a, {{{features[0]}, {features[1]}}}, control, {});
  const auto bent = spheres.alignment.bent({{SP::internal::rotation_matrix(turns[0]), -1.}});
  ASSERT_EQ(bent.size(), 1u);
  EXPECT_LT(bent[0].score, 0.);
  EXPECT_EQ(spheres.alignment.margin(bent), bent[0].score);
}

// Whenever the control says no, there is a start, and it is a bijection.
TEST(Bending, stops_when_it_is_told_to)
{
  const Mapped_mesh a(icosphere(3), on_body, rotation(turns[0]));
  Mapped_mesh b(
      icosphere(3), [](const Point_3& p) { return Point_3(p.x(), p.y(), 2. * p.z()); }, rotation(turns[1]));
  const SP::internal::Sphere_grid grid({});
  std::size_t n_questions = 0;
  for(const std::size_t max_questions : {1000u, 0u, 3u, 12u, 40u})
  {
    Recording_control control;
    control.max_questions = max_questions;
    Aligned_spheres spheres(grid, a, b, {}, control, {});
    const SP::internal::Aligned_start start = spheres.alignment.start(spheres.first, spheres.second);
    expect_bijective(a, start.directions);
    EXPECT_EQ(control.is_stopped(), max_questions < 1000u);
    EXPECT_LE(control.number_of_questions, max_questions + 1);
    n_questions = (std::max)(n_questions, control.number_of_questions);
  }
  EXPECT_GT(n_questions, 100u);
}

// A grid that is bent so much that triangles of a mesh, whose edges stay straight, turn over.
TEST(Bending, repairs_what_straight_edges_turn_over)
{
  const SP::internal::Sphere_grid grid({});
  std::vector<SP::internal::Vector_3d> bent_grid;
  for(const SP::internal::Vector_3d& q : grid.directions())
  {
    const double angle = 2. * std::sin(9. * q[2]); // whirls
    bent_grid.push_back(
        {std::cos(angle) * q[0] - std::sin(angle) * q[1], std::sin(angle) * q[0] + std::cos(angle) * q[1], q[2]});
  }
  const Mapped_mesh a(icosphere(2), on_body, rotation(turns[0]));
  SP::internal::Mesh_on_sphere<Mesh, Mesh::Property_map<Vertex_index, Point_3>> arrays;
  ASSERT_EQ(arrays.read(a.mesh, a.sphere, false, {}), SP::OK);
  SP::internal::Sphere_triangulation<Kernel> images;
  images.assign(arrays.images, arrays.triangles);
  Recording_control control;
  const auto directions = SP::internal::bent_directions(images, grid, bent_grid, control, {});
  ASSERT_TRUE(directions);
  const SP::internal::Orientation_about_origin_3<Kernel> orientation;
  const auto count = [&](const auto& point_of) {
    std::size_t n = 0;
    for(const auto& t : arrays.triangles)
      n += orientation(point_of(t[0]), point_of(t[1]), point_of(t[2])) != CGAL::POSITIVE;
    return n;
  };
  EXPECT_EQ(count([&](std::uint32_t v) {
              const auto& p = (*directions)[v];
              return Point_3(p[0], p[1], p[2]);
            }),
            0u);
  const std::size_t n_turned_over = count([&](std::uint32_t v) {
    const Point_3& q = arrays.images[v];
    const double angle = 2. * std::sin(9. * q.z());
    return Point_3(std::cos(angle) * q.x() - std::sin(angle) * q.y(), std::sin(angle) * q.x() + std::cos(angle) * q.y(),
                   q.z());
  });
  EXPECT_GT(n_turned_over, 10u);
}

TEST(Landmarks, give_their_rotation)
{
  const auto stay = [](const Point_3& p) { return p; };
  const Triangle_list list = icosphere(1);
  const Mapped_mesh a(list, stay, rotation(turns[0]));
  for(const Quaternion& turn : turns)
  {
    Mapped_mesh b(list, stay, rotation(turn));
    for(const std::size_t n : {2u, 3u, 17u})
    {
      Vertex_pairs landmarks;
      for(std::size_t k = 0; k < n; ++k)
        landmarks.emplace_back(Vertex_index(static_cast<Mesh::size_type>(k)),
                               Vertex_index(static_cast<Mesh::size_type>(k)));
      Rotation_3 result;
      ASSERT_EQ(SP::fit_rotation(a.sphere, b.sphere, landmarks, result), SP::OK);
      EXPECT_LT(angle(result, rotation(turn)), 1e-6);
    }
  }
}

TEST(Landmarks, are_approximated_by_a_rotation_where_they_are_mirrored)
{
  const Triangle_list list = icosphere(1);
  const Mapped_mesh a(
      list, [](const Point_3& p) { return p; }, rotation(turns[0]));
  Mapped_mesh mirrored = a;
  Vertex_pairs landmarks;
  auto sphere = mirrored.mesh.add_property_map<Vertex_index, Point_3>("v:mirrored").first;
  for(const Vertex_index v : a.mesh.vertices())
  {
    sphere[v] = Point_3(-a.sphere[v].x(), 2. * a.sphere[v].y(), 0.5 * a.sphere[v].z());
    if(std::abs(a.sphere[v].x()) < 0.6)
      landmarks.emplace_back(v, v);
  }
  Rotation_3 result;
  ASSERT_EQ(SP::fit_rotation(a.sphere, sphere, landmarks, result), SP::OK);
  EXPECT_GT(CGAL::determinant(result.m(0, 0), result.m(0, 1), result.m(0, 2), result.m(1, 0), result.m(1, 1),
                              result.m(1, 2), result.m(2, 0), result.m(2, 1), result.m(2, 2)),
            0.99);
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

} // namespace
