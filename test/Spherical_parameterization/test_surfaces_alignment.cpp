// A surface is turned back onto itself, whatever is done to its sphere, its triangles and its points; and landmarks give
// the rotation that they were turned by.

#include "judge.h"
#include "methods.h"
#include "random_meshes.h"
#include "surfaces.h"

#include <CGAL/Spherical_parameterization/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/align_spheres.h>
#include <CGAL/Spherical_parameterization/internal/align/Bent_map.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
  SP::Sphere_alignment_3 result;
  ASSERT_EQ(SP::align_spheres(a.mesh, a.sphere, b.mesh, b.sphere, result, std::make_pair(feature_a, feature_b)),
            SP::OK);
  EXPECT_LT(angle(result.candidates[0].rotation, rotation(turns[3])), 1.);

  const SP::Sphere_alignment_3 before = result;
  feature_a[Vertex_index(7)] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(SP::align_spheres(a.mesh, a.sphere, b.mesh, b.sphere, result, std::make_pair(feature_a, feature_b)),
            SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(result.candidates[0].rotation, before.candidates[0].rotation);
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

  const SP::internal::Sphere_grid grid;
  std::vector<SP::internal::Vector_3d> results[2];
  double turned_error = 0., bent_error = 0.;
  for(const bool is_parallel : {false, true})
  {
    const SP::internal::Execution execution =
        is_parallel ? SP::internal::execution_of<CGAL::Parallel_if_available_tag>() : SP::internal::Execution();
    SP::internal::Surface_alignment::Samples samples_a, samples_b;
    ASSERT_EQ(SP::internal::read_samples(grid, a.mesh, a.sphere, execution, samples_a), SP::OK);
    ASSERT_EQ(SP::internal::read_samples(grid, b.mesh, b.sphere, execution, samples_b), SP::OK);
    const SP::internal::Surface_alignment alignment(grid, samples_a, samples_b, execution);
    const SP::internal::Scored_rotation start = alignment.best_rotations(1).front();
    const auto bent_grid = alignment.bent(start.rotation);
    EXPECT_GT(alignment.agreement(bent_grid), start.score);

    SP::internal::Mesh_on_sphere<Mesh, Mesh::Property_map<Vertex_index, Point_3>> arrays;
    ASSERT_EQ(arrays.read(a.mesh, a.sphere, false, execution), SP::OK);
    SP::internal::Sphere_triangulation<Kernel> images;
    images.assign(arrays.images, arrays.triangles);
    const auto directions =
        SP::internal::Bent_map<Kernel>(images).directions(grid, bent_grid, start.rotation, execution);
    ASSERT_TRUE(directions);
    results[is_parallel] = *directions;
    Mapped_mesh bent = a;
    auto sphere = bent.mesh.add_property_map<Vertex_index, Point_3>("v:bent").first;
    turned_error = bent_error = 0.;
    for(const Vertex_index v : a.mesh.vertices())
    {
      const SP::internal::Vector_3d& p = (*directions)[v];
      sphere[v] = Point_3(p[0], p[1], p[2]);
      const Point_3 turned = SP::internal::as_transformation(start.rotation).transform(a.sphere[v]);
      turned_error += std::sqrt(CGAL::squared_distance(turned, b.sphere[v]));
      bent_error += std::sqrt(CGAL::squared_distance(sphere[v], b.sphere[v]));
    }
    EXPECT_TRUE(SP::is_bijective(bent.mesh, sphere));
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_LT(bent_error, 0.75 * turned_error); // The body is smooth: it has few features to go by.
}

// A grid that is bent so much that triangles of a mesh, whose edges stay straight, turn over.
TEST(Bending, repairs_what_straight_edges_turn_over)
{
  const SP::internal::Sphere_grid grid;
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
  const auto directions =
      SP::internal::Bent_map<Kernel>(images).directions(grid, bent_grid, SP::internal::rotation_matrix(turns[0]), {});
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
