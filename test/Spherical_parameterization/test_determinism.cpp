// The same input and options give the same bits: sequentially or in parallel, with any number of threads, again and
// again.

#include <CGAL/Spherical_parameterization/internal/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/Independent_sets.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Rest_limits.h>
#include <CGAL/Spherical_parameterization/internal/run_both.h>
#include <CGAL/spherical_parameterization.h>

#include "test_indexed_meshes.h"
#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using test_meshes::Coordinates;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Parameterizer = SP::Bijective_low_distortion_parameterizer_3<Mesh>;

template <class ConcurrencyTag>
std::vector<Coordinates> images(const Mesh& mesh, Parameterizer& parameterizer)
{
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
  EXPECT_EQ(SP::parameterize<ConcurrencyTag>(mesh, parameterizer, map, CGAL::parameters::number_of_iterations(10u)),
            SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  return test_maps::images(mesh, map);
}

template <class ConcurrencyTag>
std::vector<Coordinates> images(const Mesh& mesh)
{
  Parameterizer parameterizer;
  return images<ConcurrencyTag>(mesh, parameterizer);
}

// large enough that all loops are cut into many blocks
const Mesh& mesh()
{
  static const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(5));
  return mesh;
}

const std::vector<Coordinates>& sequential_images()
{
  static const std::vector<Coordinates> result = images<CGAL::Sequential_tag>(mesh());
  return result;
}

TEST(Determinism, of_repeated_runs)
{
  EXPECT_TRUE(test_maps::have_same_bits(images<CGAL::Sequential_tag>(mesh()), sequential_images()));
}

TEST(Determinism, of_a_parameterizer_used_again)
{
  Parameterizer parameterizer;
  EXPECT_TRUE(test_maps::have_same_bits(images<CGAL::Sequential_tag>(mesh(), parameterizer), sequential_images()));
  // another mesh in between leaves no trace
  images<CGAL::Sequential_tag>(test_meshes::make_mesh<Mesh>(test_meshes::suspension(7)), parameterizer);
  EXPECT_TRUE(test_maps::have_same_bits(images<CGAL::Sequential_tag>(mesh(), parameterizer), sequential_images()));
}

// Policies that keep a state start anew as well.
TEST(Determinism, of_policies_with_a_state)
{
  const Mesh small = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
  SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, SP::Isometric_energy_3, SP::Absolute_sharpness_3>
      parameterizer;
  const auto map = test_maps::make_sentinel_map<Point_3>(small);
  ASSERT_EQ(SP::parameterize(small, parameterizer, map), SP::OK);
  const std::vector<Coordinates> first = test_maps::images(small, map);
  const std::size_t n = parameterizer.report().number_of_average_iterations;
  EXPECT_GT(n, 0u);
  EXPECT_GT(parameterizer.report().number_of_sharp_iterations, 0u);
  ASSERT_EQ(SP::parameterize(small, parameterizer, map), SP::OK);
  EXPECT_EQ(parameterizer.report().number_of_average_iterations, n);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(small, map), first));
}

// A descent that takes over one mesh after the other does what one of its own would do on each.
TEST(Determinism, of_a_descent_on_another_mesh)
{
  namespace Internal = SP::internal;
  using Tag = CGAL::Parallel_if_available_tag;
  using Descent = Internal::Block_coordinate_descent<SP::Symmetric_Dirichlet_energy_3, SP::Newton_update_3, Tag>;
  const auto start_on = [](const Internal::Indexed_mesh& mesh) {
    std::vector<Coordinates> positions;
    for(const Coordinates& p : mesh.points()) // those of an ellipsoid
      positions.push_back(test_meshes::normalized(p));
    return positions;
  };
  // The one looks for its focus while it sweeps, and gives a search up that finds too much, the other does not.
  const auto optimize = [&](Descent& descent, const Internal::Indexed_mesh& mesh) {
    std::vector<Coordinates> positions = start_on(mesh);
    const std::size_t n = mesh.number_of_vertices();
    for(int k = 0; k < 3; ++k)
    {
      const double largest = descent.measure(positions, 1., 1.).largest();
      EXPECT_GT(descent.focus_on_faces_above(0., n / 2), n / 2);
      descent.reserve_focus(n / 2);
      const auto sweep = [&] { descent.sweep(positions, 1., 1.); };
      Internal::run_both<Tag>(sweep, [&] { EXPECT_GT(descent.focus_on_faces_above(0.9 * largest, n), 0u); });
      descent.sweep_focus(positions, 1., 1.);
    }
    return positions;
  };
  const auto optimize_step_by_step = [&](Descent& descent, const Internal::Indexed_mesh& mesh) {
    std::vector<Coordinates> positions = start_on(mesh);
    for(int k = 0; k < 3; ++k)
    {
      const double largest = descent.measure(positions, 1., 1.).largest();
      descent.sweep(positions, 1., 1.);
      descent.focus_on_faces_above(0.9 * largest, mesh.number_of_vertices());
      descent.sweep_focus(positions, 1., 1.);
    }
    return positions;
  };
  const SP::Symmetric_Dirichlet_energy_3 energy;
  const SP::Newton_update_3 update;
  Descent descent(energy, update);
  descent.reserve(600); // for some of them
  for(const unsigned int subdivisions : {3u, 2u, 4u, 3u})
  {
    const Internal::Indexed_mesh mesh =
        test_indexed_meshes::indexed_mesh(test_meshes::ellipsoid(1., 2., 3., subdivisions));
    Descent own(mesh.rings(), mesh.points(), energy, update);
    descent.assign(mesh.rings(), Internal::Independent_sets(mesh.rings()), mesh.points(), std::vector<double>(),
                   Internal::Rest_limits());
    EXPECT_EQ(descent.focus_on_faces_above(0., mesh.number_of_vertices()), 0u); // of a mesh that is not measured yet
    EXPECT_TRUE(test_maps::have_same_bits(optimize(descent, mesh), optimize_step_by_step(own, mesh))) << subdivisions;
  }
}

// The other methods, which have parallel parts of their own.
template <class Method>
class Determinism_of_method : public ::testing::Test
{};

using Methods = ::testing::Types<SP::Stereographic_parameterizer_3<Mesh>, SP::Harmonic_parameterizer_3<Mesh>,
                                 SP::Conformal_parameterizer_3<Mesh>, SP::ARAP_parameterizer_3<Mesh>,
                                 SP::Published_low_distortion_parameterizer_3<Mesh>>;
TYPED_TEST_SUITE(Determinism_of_method, Methods, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Determinism_of_method, sequential_and_parallel)
{
  TypeParam method;
  const auto images_of = [&](auto tag) {
    const auto map = test_maps::make_sentinel_map<Point_3>(mesh());
    EXPECT_EQ(SP::parameterize<decltype(tag)>(mesh(), method, map, CGAL::parameters::number_of_iterations(5u)), SP::OK);
    return test_maps::images(mesh(), map);
  };
  const std::vector<Coordinates> sequential = images_of(CGAL::Sequential_tag());
  const double energy = method.report().average_energy;
  EXPECT_TRUE(test_maps::have_same_bits(images_of(CGAL::Sequential_tag()), sequential));
  EXPECT_TRUE(test_maps::have_same_bits(images_of(CGAL::Parallel_if_available_tag()), sequential));
  EXPECT_EQ(method.report().average_energy, energy);
}

TEST(Determinism, of_the_default)
{
  EXPECT_TRUE(test_maps::have_same_bits(images<CGAL::Parallel_if_available_tag>(mesh()), sequential_images()));
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Determinism, of_any_number_of_threads)
{
  for(const int n_threads : {1, 2, 4, 7})
  {
    // TBB's own limit is the number of cores; an arena may be larger.
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>((std::max)(n_threads, 1)));
    tbb::task_arena arena(n_threads);
    for(int run = 0; run < 2; ++run)
    {
      arena.execute([&] {
        EXPECT_TRUE(test_maps::have_same_bits(images<CGAL::Parallel_tag>(mesh()), sequential_images())) << n_threads;
      });
    }
  }
}

// Two runs at once do not disturb each other.
TEST(Determinism, of_runs_side_by_side)
{
  const Mesh copy = mesh(); // images() adds a property map to its mesh
  std::vector<Coordinates> first, second;
  sequential_images();
  std::thread one([&] { first = images<CGAL::Parallel_tag>(mesh()); });
  std::thread other([&] { second = images<CGAL::Parallel_tag>(copy); });
  one.join();
  other.join();
  EXPECT_TRUE(test_maps::have_same_bits(first, sequential_images()));
  EXPECT_TRUE(test_maps::have_same_bits(second, sequential_images()));
}
#endif

} // namespace
