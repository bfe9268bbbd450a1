// Thousands of random triangulations, small and large, placed in ways that have nothing to do with a sphere: all of
// them get a certified bijection, however the vertices are connected and wherever they are.

#include <CGAL/spherical_parameterization.h>

#include "fuzzing.h"
#include "independent_check.h"
#include "random_triangulations.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using fuzzing::Mesh;
using fuzzing::Outcome;
using fuzzing::Random;
using fuzzing::Seeds;
using fuzzing::Tally;
using random_triangulations::Random_triangulation;
using test_meshes::Coordinates;
using test_meshes::Triangle;
using test_meshes::Triangle_list;

#ifdef CGAL_LINKED_WITH_TBB
using Several_threads = CGAL::Parallel_tag;
#else
using Several_threads = CGAL::Sequential_tag;
#endif

// of all tests of this file together
constexpr std::size_t number_of_triangulations = 20000;

// What the tests rely on: the check that has nothing to do with the package, and the triangulations.

Triangle_list moved(Triangle_list list, std::size_t v, const Coordinates& p)
{
  list.points[v] = p;
  return list;
}

TEST(Independent_check, tells_bijections_from_other_maps)
{
  const auto is_one_to_one = [](const Triangle_list& list) {
    return static_cast<bool>(independent_check::is_one_to_one(list.points, list.triangles));
  };
  const Triangle_list sphere = test_meshes::icosphere(2);
  EXPECT_TRUE(is_one_to_one(sphere));
  EXPECT_TRUE(is_one_to_one(test_meshes::ellipsoid(1e-3, 1., 1e3, 2)));
  EXPECT_TRUE(is_one_to_one(test_meshes::random_stacked_sphere(200, 1)));
  for(std::size_t v = 0; v < sphere.points.size(); ++v)
  {
    const Coordinates& p = sphere.points[v];
    EXPECT_FALSE(is_one_to_one(moved(sphere, v, {-p[0], -p[1], -p[2]})));
    EXPECT_FALSE(is_one_to_one(moved(sphere, v, {0., 0., 0.})));
    EXPECT_FALSE(is_one_to_one(moved(sphere, v, {HUGE_VAL, 0., 0.})));
    EXPECT_FALSE(is_one_to_one(moved(sphere, v, sphere.points[(v + 1) % sphere.points.size()])));
  }
  EXPECT_FALSE(is_one_to_one(test_meshes::scaled(sphere, -1., 1., 1.)));
  EXPECT_TRUE(is_one_to_one(test_meshes::suspension(7)));
  EXPECT_FALSE(is_one_to_one(test_meshes::suspension(7, 2))); // all faces are positive, but cover the sphere twice
  // The last bit decides.
  const Triangle_list octahedron = test_meshes::octahedron();
  EXPECT_TRUE(is_one_to_one(moved(octahedron, 0, {0x1p-60, 1., -1.})));
  EXPECT_FALSE(is_one_to_one(moved(octahedron, 0, {0., 1., -1.})));
  EXPECT_FALSE(is_one_to_one(moved(octahedron, 0, {-0x1p-60, 1., -1.})));
  EXPECT_TRUE(is_one_to_one(test_meshes::scaled(sphere, 1e-120, 1e-120, 1e-120))); // where products underflow
}

TEST(Random_triangulations_themselves, are_simplicial_spheres_of_all_kinds)
{
  const std::size_t n_seeds = 3000;
  std::vector<std::size_t> n_connectivities(random_triangulations::NUMBER_OF_CONNECTIVITIES, 0);
  std::vector<std::size_t> n_placements(random_triangulations::NUMBER_OF_PLACEMENTS, 0);
  std::set<std::vector<Triangle>> different;
  std::size_t smallest = 300, largest = 4;
  for(std::uint64_t seed = 0; seed < n_seeds; ++seed)
  {
    SCOPED_TRACE(seed);
    const Random_triangulation t = random_triangulations::random_triangulation(seed);
    const std::size_t n = t.list.points.size();
    ++n_connectivities[t.connectivity];
    ++n_placements[t.placement];
    smallest = (std::min)(smallest, n);
    largest = (std::max)(largest, n);
    different.insert(t.list.triangles);

    // Each edge has one triangle on each side, no two edges join the same vertices: every pair is found once each way.
    std::set<std::array<std::size_t, 2>> edges;
    for(const Triangle& f : t.list.triangles)
      for(std::size_t k = 0; k < 3; ++k)
      {
        ASSERT_NE(f[k], f[(k + 1) % 3]);
        ASSERT_TRUE(edges.insert({f[k], f[(k + 1) % 3]}).second);
      }
    for(const std::array<std::size_t, 2>& e : edges)
      ASSERT_EQ(edges.count({e[1], e[0]}), 1u);
    ASSERT_EQ(edges.size(), 6 * n - 12); // Euler
    ASSERT_EQ(t.list.triangles.size(), 2 * n - 4);
    const Mesh mesh = test_meshes::make_mesh<Mesh>(t.list); // throws unless it is a manifold
    ASSERT_TRUE(CGAL::is_closed(mesh));
    for(const auto v : vertices(mesh))
      ASSERT_FALSE(mesh.is_isolated(v));

    for(const Coordinates& p : t.list.points)
      for(const double x : p)
        ASSERT_TRUE(std::isfinite(x));
    ASSERT_EQ(random_triangulations::has_coincident(t.list.points), t.placement >= random_triangulations::SOME_COINCIDE)
        << t.kind();
  }
  EXPECT_EQ(smallest, 4u);
  EXPECT_GE(largest, 290u);
  for(const std::size_t n : n_connectivities)
    EXPECT_GE(n, n_seeds / 20);
  for(const std::size_t n : n_placements)
    EXPECT_GE(n, n_seeds / 20);
  EXPECT_GE(different.size(),
            n_seeds * 9 / 10); // the numbers of a tetrahedron, say, can be permuted in a few ways only
}

// What a kind is named after.
TEST(Random_triangulations_themselves, have_the_degrees_of_their_kinds)
{
  const std::size_t n = 120;
  const auto degrees = [&](random_triangulations::Connectivity connectivity, std::uint64_t seed) {
    Random random(seed);
    std::vector<std::size_t> result(n, 0);
    for(const Triangle& t : random_triangulations::random_triangles(connectivity, n, random))
      for(const std::size_t v : t)
        ++result[v];
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto low = [](const std::vector<std::size_t>& d, std::size_t bound) {
    return static_cast<std::size_t>(std::upper_bound(d.begin(), d.end(), bound) - d.begin());
  };
  for(std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    using namespace random_triangulations;
    EXPECT_EQ(degrees(HUB, seed).back(), n - 1);
    const std::vector<std::size_t> wheel = degrees(DOUBLE_WHEEL, seed);
    EXPECT_GE(wheel[n - 2], n - 2);
    EXPECT_LE(wheel[n - 3], 4u);
    EXPECT_GE(low(degrees(LOW_DEGREE, seed), 4), n / 2);
    EXPECT_LE(low(degrees(FLIPPED, seed), 4), n / 2 + 10);
    const std::vector<std::size_t> tube = degrees(TUBE, seed);
    EXPECT_GE(low(tube, 6) - low(tube, 5), n - 20); // all but those at both ends
    EXPECT_GE(degrees(HUBS, seed).back(), n / 6);
  }
}

// The triangles of the first seeds, as they have been from the start: if this changes, seeds mean something else.
TEST(Random_triangulations_themselves, are_the_same_everywhere)
{
  std::uint64_t hash = 14695981039346656037u; // FNV-1a
  for(std::uint64_t seed = 0; seed < 300; ++seed)
  {
    for(const Triangle& t : random_triangulations::random_triangulation(seed).list.triangles)
      for(const std::size_t v : t)
        hash = (hash ^ v) * 1099511628211u;
  }
  EXPECT_EQ(hash, 11459543503091790600u);
}

// The parameterizers on them.

// Runs a method on the triangulations of these seeds. It may refuse them, but not return OK for a map that folds.
template <class Parameterizer, class ConcurrencyTag>
Tally run(const Seeds& seeds, unsigned int most_iterations)
{
  Tally tally;
  for(std::size_t i = 0; i < seeds.size(); ++i)
  {
    const Random_triangulation t = random_triangulations::random_triangulation(seeds[i]);
    const std::string description = fuzzing::how_to_repeat(seeds[i], t.kind());
    Parameterizer parameterizer;
    const Outcome outcome = fuzzing::run<ConcurrencyTag>(t.list, parameterizer, most_iterations, description);
    tally.add({std::string("edges: ") + random_triangulations::to_string(t.connectivity),
               std::string("points: ") + random_triangulations::to_string(t.placement)},
              outcome, seeds[i], description);
  }
  tally.print();
  return tally;
}

using Default_method = SP::Bijective_low_distortion_parameterizer_3<Mesh>;

// Those with points that coincide are no exception.
template <class ConcurrencyTag>
void expect_all_mapped(const Seeds& seeds, unsigned int most_iterations)
{
  const Tally tally = run<Default_method, ConcurrencyTag>(seeds, most_iterations);
  EXPECT_EQ(tally.size(), seeds.size());
  EXPECT_EQ(tally.number_of_refusals(), 0u) << tally.refusals();
}

TEST(Random_triangulations, are_mapped)
{
  expect_all_mapped<CGAL::Sequential_tag>(Seeds(number_of_triangulations, 0.56, 1000000), 5u);
}

TEST(Random_triangulations, are_mapped_with_more_iterations)
{
  expect_all_mapped<CGAL::Sequential_tag>(Seeds(number_of_triangulations, 0.32, 2000000), 20u);
}

TEST(Random_triangulations, are_mapped_with_as_many_iterations_as_help)
{
  expect_all_mapped<CGAL::Sequential_tag>(Seeds(number_of_triangulations, 0.06, 3000000), 100u);
}

TEST(Random_triangulations, are_mapped_by_several_threads)
{
  expect_all_mapped<Several_threads>(Seeds(number_of_triangulations, 0.06, 4000000), 10u);
}

// Other methods that promise a bijection may say that they have found none, but not for the most of them.
template <class Parameterizer>
class Other_methods : public ::testing::Test
{};

using Methods = ::testing::Types<SP::Hierarchical_parameterizer_3<Mesh>, SP::Harmonic_parameterizer_3<Mesh>,
                                 SP::Stereographic_parameterizer_3<Mesh>>;
TYPED_TEST_SUITE(Other_methods, Methods, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Other_methods, map_random_triangulations_or_refuse_them)
{
  const Seeds seeds(number_of_triangulations, 0.02, 5000000);
  const Tally tally = run<TypeParam, CGAL::Sequential_tag>(seeds, 20u);
  EXPECT_EQ(tally.size(), seeds.size());
  if(seeds.size() >= 100)
  {
    EXPECT_LE(tally.number_of_refusals(), seeds.size() / 3);
  }
}

} // namespace
