// The levels of coarser meshes, what a vertex is put into when it comes back, and the maps that are made through them.

#include <CGAL/Spherical_parameterization/internal/descent/Hierarchical_embedding.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Star_kernel.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Vertex_removal.h>

#include "engine.h"
#include "indexed_meshes.h"
#include "judge.h"
#include "methods.h"
#include "random_meshes.h"
#include "recording_control.h"

using namespace test;

namespace {

using namespace SP::internal;

TEST(Edge_set, has_what_was_inserted_and_grows)
{
  for(const std::size_t expected_size : {std::size_t(0), std::size_t(5000)})
  {
    Edge_set edges(expected_size);
    for(std::uint32_t a = 0; a < 5000; ++a)
    {
      EXPECT_FALSE(edges.contains(a, 3 * a + 1));
      edges.insert(3 * a + 1, a);
    }
    for(std::uint32_t a = 0; a < 5000; ++a)
    {
      EXPECT_TRUE(edges.contains(a, 3 * a + 1));
      EXPECT_TRUE(edges.contains(3 * a + 1, a));
      EXPECT_FALSE(edges.contains(a, 3 * a + 2));
    }
  }
}

// A corner tetrahedron with a vertex in a face, which stands out of it by `height`: its removal, and whether it goes into
// the nearest corner.
std::pair<Vertex_removal, bool> removal_in_a_face(double height)
{
  const Triangle_list list = {{{0., 0., 0.}, {10., 0., 0.}, {0., 10., 0.}, {0., 0., 10.}, {1., 2., -height}},
                              {{0, 2, 4}, {2, 1, 4}, {1, 0, 4}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const Surface mesh = surface_of(list);
  const std::vector<std::uint32_t> numbers = callers_numbers(mesh);
  const auto v = static_cast<std::uint32_t>(std::find(numbers.begin(), numbers.end(), 4u) - numbers.begin());
  const Vertex_removal removal = Vertex_removal::best(mesh.rings(), mesh.points(), v, true);
  return {removal, numbers[mesh.rings().ring(v)[removal.target]] == 0};
}

TEST(Vertex_removal, prefers_what_is_flat_and_near)
{
  const auto [flat, is_near] = removal_in_a_face(0.);
  ASSERT_TRUE(flat.is_possible());
  EXPECT_TRUE(is_near);
  std::uint32_t last_rank = flat.rank;
  for(const double height : {0.5, 1., 2.})
  {
    const Vertex_removal removal = removal_in_a_face(height).first;
    EXPECT_GT(removal.rank, last_rank) << height;
    last_rank = removal.rank;
  }
}

void expect_hierarchy(const Surface& mesh, bool has_area = true)
{
  Recording_control control;
  const Mesh_hierarchy hierarchy(mesh.rings(), mesh.points(), vertex_areas(mesh.rings(), mesh.points()), control,
                                 Execution());
  const std::size_t n_levels = hierarchy.number_of_levels();
  ASSERT_GE(n_levels, 1u);
  ASSERT_TRUE(have_same_rings(hierarchy.rings(0), mesh.rings()));
  ASSERT_EQ(hierarchy.level(n_levels - 1).vertices.size(), 4u);
  ASSERT_TRUE(hierarchy.level(n_levels - 1).removed.empty());
  const double total = std::accumulate(hierarchy.level(0).areas.begin(), hierarchy.level(0).areas.end(), 0.);
  ASSERT_NEAR(total, has_area ? 4. * pi : 0., 1e-10);

  std::size_t n_corners = 0; // of all levels
  for(std::size_t k = 0; k < n_levels; ++k)
  {
    SCOPED_TRACE(k);
    const Mesh_hierarchy::Level& level = hierarchy.level(k);
    const std::size_t n = level.vertices.size();
    ASSERT_EQ(hierarchy.rings(k).number_of_vertices(), n);
    ASSERT_EQ(level.areas.size(), n);
    expect_simplicial_sphere(hierarchy.rings(k));
    if(::testing::Test::HasFatalFailure())
      return;
    ASSERT_TRUE(std::is_sorted(level.vertices.begin(), level.vertices.end()));
    ASSERT_NEAR(std::accumulate(level.areas.begin(), level.areas.end(), 0.), total, 1e-9 * total);
    n_corners += hierarchy.rings(k).number_of_corners();
    if(k + 1 == n_levels)
      break;

    const Mesh_hierarchy::Level& coarse = hierarchy.level(k + 1);
    ASSERT_FALSE(level.removed.empty());
    std::vector<char> is_removed(n, 0);
    for(const Mesh_hierarchy::Removed_vertex& r : level.removed)
    {
      ASSERT_LT(r.vertex, n);
      ASSERT_LT(r.target, hierarchy.rings(k).degree(r.vertex));
      ASSERT_FALSE(is_removed[r.vertex]);
      is_removed[r.vertex] = 1;
    }
    std::vector<std::uint32_t> kept;
    std::vector<std::uint32_t> number(n, 0); // in the coarser level
    for(std::uint32_t v = 0; v < n; ++v)
    {
      if(!is_removed[v])
      {
        number[v] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(level.vertices[v]);
      }
    }
    ASSERT_EQ(kept, coarse.vertices);

    // The coarser mesh has the faces without removed vertices and, for each removed one, the fan of its target.
    std::vector<Index_triangle> faces, coarse_faces;
    hierarchy.rings(k).for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      ASSERT_LE(is_removed[a] + is_removed[b] + is_removed[c], 1); // no two of them are neighbours
      if(!is_removed[a] && !is_removed[b] && !is_removed[c])
        faces.push_back({number[a], number[b], number[c]});
    });
    for(const Mesh_hierarchy::Removed_vertex& r : level.removed)
    {
      const Vertex_rings::Ring ring = hierarchy.rings(k).ring(r.vertex);
      for(std::size_t j = 1; j + 1 < ring.size(); ++j)
      {
        faces.push_back({number[ring[r.target]], number[ring[(r.target + j) % ring.size()]],
                         number[ring[(r.target + j + 1) % ring.size()]]});
      }
    }
    hierarchy.rings(k + 1).for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      coarse_faces.push_back({a, b, c});
    });
    ASSERT_EQ(sorted(faces), sorted(coarse_faces));
  }
  // All levels together are a constant times the mesh: they shrink geometrically.
  EXPECT_LE(n_corners, 20 * (mesh.rings().number_of_corners() + 12));
}

TEST(Mesh_hierarchy, leads_to_a_tetrahedron_through_simplicial_spheres)
{
  for(const Triangle_list& list : spheres())
    expect_hierarchy(surface_of(list));
  // vertices of huge degree, also when they are flat, or all at one point
  expect_hierarchy(surface_of(wavy_suspension(20000)));
  expect_hierarchy(surface_of(test_meshes::scaled(suspension(1000), 1., 1., 0.)));
  expect_hierarchy(surface_of(test_meshes::scaled(suspension(1000), 0., 0., 0.)), false);
}

TEST(Mesh_hierarchy, copes_with_a_thousand_nested_separating_triangles)
{
  // Each vertex is in a face of the vertex before, so that every removal but the last ones breaks the link condition.
  expect_hierarchy(surface_of(nested_triangles(1000)));
}

// A hole whose faces, fanned out from its first vertex, are positive, and which is otherwise as irregular as can be.
std::vector<Coordinates> random_hole(Random& random, double size)
{
  const Tangent_frame frame(random.direction());
  const std::size_t n = 2 + random.below(9); // vertices other than the base
  std::vector<double> steps;
  for(std::size_t j = 1; j < n; ++j)
    steps.push_back(random.between(0.1, 1.));
  // up to 340 degrees around the base, but less than 170 in one step
  const double total = std::accumulate(steps.begin(), steps.end(), 0.),
               largest = *std::max_element(steps.begin(), steps.end()) / total;
  const double turn = (std::min)(random.between(0.2, 5.9), 2.9 / largest);
  double angle = random.between(0., 2. * pi);
  std::vector<Coordinates> hole = {frame.point_at(0., 0.)};
  for(std::size_t j = 0; j < n; ++j)
  {
    const double r = size * random.between(0.1, 1.);
    hole.push_back(frame.point_at(r * std::cos(angle), r * std::sin(angle)));
    angle += j < steps.size() ? turn * steps[j] / total : 0.;
  }
  return hole;
}

TEST(Star_kernel, sees_all_edges_of_any_hole)
{
  Random random(7);
  Star_kernel kernel; // one object for all holes, larger and smaller ones
  int n_holes = 0;
  for(int k = 0; k < 3000; ++k)
  {
    const double sizes[] = {0.9, 0.3, 1e-2, 1e-5, 1e-8};
    const std::vector<Coordinates> hole = random_hole(random, sizes[k % 5]);
    bool is_fan = true; // on a sphere, a large triangle can be negative
    for(std::size_t j = 1; j + 1 < hole.size(); ++j)
      is_fan = is_fan && judge::sign_of_determinant(hole[0], hole[j], hole[j + 1]) > 0;
    if(!is_fan)
      continue;
    ++n_holes;
    Coordinates point;
    ASSERT_TRUE(kernel.find_point(hole, point)) << k;
    EXPECT_NEAR(norm(point), 1., 1e-15);
    for(std::size_t j = 0; j < hole.size(); ++j)
      ASSERT_GT(judge::sign_of_determinant(point, hole[j], hole[(j + 1) % hole.size()]), 0) << k;
  }
  EXPECT_GT(n_holes, 2500);
}

TEST(Star_kernel, is_central_in_a_regular_hole)
{
  Star_kernel kernel;
  for(const double size : {0.1, 1e-3, 1e-7})
  {
    const Tangent_frame frame(normalized({1., -2., 0.5}));
    std::vector<Coordinates> hole;
    for(int j = 0; j < 6; ++j)
      hole.push_back(frame.point_at(size * std::cos(j * pi / 3.), size * std::sin(j * pi / 3.)));
    Coordinates point;
    ASSERT_TRUE(kernel.find_point(hole, point));
    EXPECT_LT(norm(frame.offset_of(point)), 0.05 * size);
  }
}

TEST(Star_kernel, finds_nothing_where_there_is_nothing)
{
  Star_kernel kernel;
  const Tangent_frame frame({0., 0., 1.});
  const auto at = [&](double x, double y) { return frame.point_at(x, y); };
  Coordinates point = {7., 7., 7.};
  for(const std::vector<Coordinates>& hole :
      {std::vector<Coordinates>{at(0., 0.), at(0., 0.1), at(0.1, 0.)}, // clockwise
       {at(0., 0.), at(0.1, 0.), at(0.2, 0.)},                         // on one great circle
       {at(0.1, 0.2), at(0.1, 0.2), at(0.1, 0.2), at(0.1, 0.2)},       // all at one point
       {at(0., 0.), at(0.1, 0.), at(0.1, 1e-16)}})                     // with a kernel that is too narrow for doubles
    EXPECT_FALSE(kernel.find_point(hole, point));
  EXPECT_EQ(point, (Coordinates{7., 7., 7.}));
}

TEST(Hierarchical_embedding, tells_of_every_level)
{
  for(const bool sweeps_finest_level : {false, true})
  {
    const Surface mesh = surface_of(bumpy_sphere(3));
    Recording_control control;
    Images positions;
    EXPECT_TRUE(SP::internal::embed_hierarchically(
        mesh, SP::Isometric_energy_3(), {20, sweeps_finest_level, std::nullopt, {}}, positions, control, Execution()));
    const SP::Parameterization_report& report = control.report();
    EXPECT_EQ(control.levels.size(), report.number_of_levels);
    EXPECT_EQ(control.levels.front(), 4u);
    EXPECT_EQ(control.levels.back(), mesh.number_of_vertices());
    EXPECT_TRUE(std::is_sorted(control.levels.begin(), control.levels.end()));
    EXPECT_GT(report.number_of_level_iterations, report.number_of_levels);
    // before every level is made, and before every sweep
    EXPECT_EQ(control.number_of_questions, report.number_of_levels + report.number_of_level_iterations);
    EXPECT_EQ(report.number_of_attempts, 1u);
    EXPECT_EQ(report.stop_reason, sweeps_finest_level ? SP::CONVERGED : SP::NOT_RUN);
    EXPECT_TRUE(judge::is_one_to_one(mesh.in_callers_order(positions), bumpy_sphere(3).triangles));
  }
}

// The level of a quarter of the vertices minimizes the objective, so that fewer sweeps over the mesh are left.
TEST(Hierarchical_embedding, minimizes_the_objective_on_levels)
{
  const Triangle_list list = bumpy_sphere(5);
  const Surface mesh = surface_of(list);
  const SP::Symmetric_Dirichlet_energy_3 energy;
  const auto embed = [&](const std::optional<SP::Sharpness>& sharpness) {
    Recording_control control;
    Images positions;
    EXPECT_TRUE(embed_hierarchically(mesh, energy, {5, false, sharpness, {}}, positions, control, Execution()));
    EXPECT_TRUE(judge::is_one_to_one(mesh.in_callers_order(positions), list.triangles));
    const SP::Parameterization_report& report = control.report();
    EXPECT_EQ(control.number_of_questions, report.number_of_levels + report.number_of_level_iterations);
    EXPECT_EQ(report.stop_reason, SP::NOT_RUN);
    EXPECT_EQ(report.number_of_iterations(), 0u);
    EXPECT_TRUE(control.energies.empty());
    return positions;
  };
  const auto number_of_sweeps = [&](Images positions) {
    Recording_control control;
    using Loop = Descent_loop<SP::Symmetric_Dirichlet_energy_3, Newton_step>;
    const Loop::Space space{Loop::Space::Energy(energy)};
    Block_coordinate_descent<Loop::Space, Newton_step> descent(space, Newton_step(), Execution());
    descent.assign(mesh.rings(), Independent_sets(mesh.rings()), mesh.points(), {}, Rest_limits());
    Loop(descent, mesh.unit(), SP::Sharpness(), nullptr, Descent_settings(), control, Execution()).run(positions, 250);
    EXPECT_EQ(control.report().stop_reason, SP::CONVERGED);
    return control.report().number_of_iterations();
  };
  const Images by_average = embed(std::nullopt), by_objective = embed(SP::Sharpness());
  EXPECT_LT(number_of_sweeps(by_objective), number_of_sweeps(by_average));
  // a larger sharpness begins as the default does, and a schedule begins with the average energy
  EXPECT_TRUE(have_same_bits(embed(SP::Sharpness::lowest_worst()), by_objective));
  EXPECT_TRUE(have_same_bits(embed(SP::Sharpness::schedule()), by_average));
}

// With one sweep for a level, small ones still get what they need to settle.
TEST(Hierarchical_parameterizer, sweeps_small_levels_until_they_have_settled)
{
  const Method method("one sweep", SP::Hierarchical_parameterizer_3().sweeps_per_level(1));
  const SP::Parameterization_report report = method.run(bumpy_sphere(2)).report;
  EXPECT_GT(report.number_of_level_iterations, report.number_of_levels);
  EXPECT_LE(report.number_of_level_iterations, 300 * report.number_of_levels);
  // and a small mesh as well; a larger one as often as was asked for
  EXPECT_EQ(hierarchical().run(bumpy_sphere(3)).report.stop_reason, SP::CONVERGED);
  EXPECT_EQ(hierarchical().run(bumpy_sphere(4)).report.stop_reason, SP::ITERATION_LIMIT);
}

// A conformal map leaves no room for insertions: the attempt that succeeds is that of a run without descents.
TEST(Hierarchical_embedding, tries_again_without_descents)
{
  const Surface mesh = surface_of(with_tentacle(1500, 2.));
  const auto embed = [&](const std::optional<SP::Sharpness>& sharpness) {
    Recording_control control;
    Images positions;
    EXPECT_TRUE(embed_hierarchically(mesh, SP::Conformal_energy_3(), {5, false, sharpness, {}}, positions, control,
                                     Execution()));
    EXPECT_GT(control.report().number_of_attempts, 1u);
    return positions;
  };
  EXPECT_TRUE(have_same_bits(embed(SP::Sharpness()), embed(std::nullopt)));
}

// A conformal map of a long tentacle needs the guard against small faces.
TEST(Hierarchical_parameterizer, tries_again_with_a_guard)
{
  const Result result = bijective_conformal().run(with_tentacle(100, 5.), Options().iterations(50));
  EXPECT_EQ(result.error, SP::OK);
  EXPECT_GT(result.report.number_of_attempts, 1u);
}

} // namespace
