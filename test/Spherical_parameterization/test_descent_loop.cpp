// The descent of a whole mesh: independent sets, all faces measured at once, and the sharpness of the sweeps.

#include <CGAL/Spherical_parameterization/internal/descent/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/descent/Measured_faces.h>
#include <CGAL/Spherical_parameterization/internal/descent/Objective.h>
#include <CGAL/Spherical_parameterization/internal/execution/Large_array.h>

#include "engine.h"
#include "methods.h"
#include "random_stars.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

using namespace test;

namespace {

using SP::Sharpness;
using namespace SP::internal;

TEST(Independent_sets, are_independent_and_complete)
{
  for(const Triangle_list& list : spheres())
  {
    const Surface mesh = surface_of(list);
    const Vertex_rings& rings = mesh.rings();
    const std::size_t n = rings.number_of_vertices();
    const Independent_sets sets(rings);
    ASSERT_EQ(sets.first.front(), 0u);
    ASSERT_EQ(sets.first.back(), n);
    std::vector<std::size_t> color(n, n);
    for(std::size_t k = 0; k + 1 < sets.first.size(); ++k)
    {
      ASSERT_LT(sets.first[k], sets.first[k + 1]);
      for(std::size_t slot = sets.first[k]; slot < sets.first[k + 1]; ++slot)
      {
        const std::uint32_t v = sets.vertices[slot];
        ASSERT_EQ(color[v], n); // for the first time
        color[v] = k;
        EXPECT_TRUE(slot == sets.first[k] || sets.vertices[slot - 1] < v);
      }
    }
    for(std::uint32_t v = 0; v < n; ++v)
      for(const std::uint32_t w : rings.ring(v))
        EXPECT_NE(color[v], color[w]);
    EXPECT_LE(sets.first.size(), 13u); // a greedy coloring of a planar graph, hardly ever above 7
  }
}

// The mean that the stopping rule looks at, from one summary and from the summaries of parts.
TEST(Energy_summary, agrees_with_the_definition_of_the_means)
{
  Random random(6);
  std::vector<double> energies;
  for(int k = 0; k < 1000; ++k)
    energies.push_back(2. * random.factor(4.));
  for(const double s : {0., 1e-3, 0.5, 3.})
  {
    long double sum = 0., sum_of_exponentials = 0.;
    for(const double e : energies)
    {
      sum += e;
      sum_of_exponentials += std::exp(static_cast<long double>(s) * e);
    }
    const double n = static_cast<double>(energies.size());
    const double average = static_cast<double>(sum) / n;
    const double mean = s > 0. ? static_cast<double>(std::log(sum_of_exponentials / n) / s) : average;
    for(const std::size_t part : {1u, 7u, 100u, 1000u})
    {
      Energy_summary total(s);
      total.add(Energy_summary(s)); // an empty part
      for(std::size_t first = 0; first < energies.size(); first += part)
      {
        Energy_summary summary(s);
        const std::size_t size = (std::min)(part, energies.size() - first);
        summary.add_all<double>(energies.data() + first, std::vector<double>(size, 1.).data(), size);
        total.add(summary);
      }
      EXPECT_NEAR(total.average(), average, 1e-12 * average);
      EXPECT_EQ(total.maximum_energy(), *std::max_element(energies.begin(), energies.end()));
      EXPECT_NEAR(total.exponential_mean(), mean, 1e-10 * mean);
    }
  }
}

TEST(Energy_summary, does_not_overflow)
{
  Energy_summary summary(1e3);
  const double one = 1.;
  for(const double energy : {2., 1e10, 5.})
    summary.add_all<double>(&energy, &one, 1);
  EXPECT_NEAR(summary.exponential_mean(), 1e10 - std::log(3.) / 1e3, 1e-5);
}

// All energies of a mesh at once: those of the single faces, up to rounding.
TEST(Measured_faces, agree_with_the_single_faces)
{
  const Surface mesh = surface_of(icosphere(3));
  const std::size_t n = mesh.number_of_vertices();
  const Images& surface = mesh.points();
  Images positions = surface;
  for(Coordinates& p : positions)
    p = normalized(combination(1., p, 1., {0.1, 0.2, -0.1}));
  // Each vertex is a set of its own, so that the faces come in the order of their smallest vertices.
  std::vector<std::uint32_t> vertices(n);
  std::vector<std::size_t> first_of_set(n + 1);
  std::iota(vertices.begin(), vertices.end(), 0);
  std::iota(first_of_set.begin(), first_of_set.end(), 0);
  const Star_packets stars = stars_of(mesh, vertices, first_of_set);
  SP::internal::Measured_faces faces;
  faces.assign(stars, places_of(stars, n), mesh.rings().number_of_faces(), Execution());

  const Face_energy<SP::Symmetric_Dirichlet_energy_3> energy{SP::Symmetric_Dirichlet_energy_3()};
  const double sharpness = 3., radius = 1.2;
  const SP::internal::Round_sphere<SP::Symmetric_Dirichlet_energy_3, Newton_step> sphere(energy);
  const Energy_summary all = faces.measure(sphere, stars, positions, radius, sharpness, Execution());
  const auto& invariants = faces.all_invariants(sphere, stars, positions, radius, sharpness, Execution());
  Energy_summary expected(sharpness);
  std::size_t face = 0, n_above = 0;
  mesh.rings().for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Coordinates u = positions[a], p = difference(positions[b], u), q = difference(positions[c], u);
    const Coordinates normal = cross(p, q), pq = difference(q, p);
    const Rest_triangle rest = Rest_triangle::from_points(surface[a], surface[b], surface[c]);
    const double i =
        radius * radius * (rest.opposite_0 * dot(pq, pq) + rest.opposite_1 * dot(q, q) + rest.opposite_2 * dot(p, p));
    const double to_d = radius * radius * rest.inverse_doubled_area, d = to_d * dot(u, normal);
    const SP::Face_invariants_3& measured = invariants[face++];
    EXPECT_NEAR(measured.i, i, 1e-13 * i);
    EXPECT_NEAR(measured.d, d, 1e-13 * d);
    EXPECT_NEAR(measured.flat_d, to_d * norm(normal), 1e-13 * d);
    EXPECT_NEAR(measured.area, area(surface[a], surface[b], surface[c]), 1e-14);
    const double e = energy(i, d);
    const double one = 1.;
    expected.add_all<double>(&e, &one, 1);
    n_above += e > 2.05;
  });
  ASSERT_EQ(face, invariants.size());
  EXPECT_NEAR(all.average(), expected.average(), 1e-13 * expected.average());
  EXPECT_NEAR(all.maximum_energy(), expected.maximum_energy(), 1e-13 * expected.maximum_energy());
  EXPECT_NEAR(all.exponential_mean(), expected.exponential_mean(), 1e-12 * expected.exponential_mean());

  ASSERT_GT(n_above, 10u);
  ASSERT_LT(n_above, face);
  std::size_t n_told = 0;
  faces.for_each_above(energy, 2.05, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    EXPECT_TRUE(a < b && a < c && b != c);
    ++n_told;
    return true;
  });
  EXPECT_EQ(n_told, n_above);
  n_told = 0;
  faces.for_each_above(energy, 2.05, [&](std::uint32_t, std::uint32_t, std::uint32_t) { return ++n_told < 3; });
  EXPECT_EQ(n_told, 3u);
}

// A descent that takes over one mesh after the other does what one of its own would do on each; also if it looks for its
// focus while it sweeps, and gives a search up that finds too much.
TEST(Block_coordinate_descent, takes_over_another_mesh)
{
  using Energy = SP::Symmetric_Dirichlet_energy_3;
  using Space = SP::internal::Round_sphere<Energy, Newton_step>;
  using Descent = Block_coordinate_descent<Space, Newton_step>;
  const Space energy{Face_energy<Energy>(Energy())};
  const auto assign = [](Descent& descent, const Surface& mesh) {
    descent.assign(mesh.rings(), Independent_sets(mesh.rings()), mesh.points(), {}, SP::internal::Rest_limits());
    EXPECT_EQ(descent.focus_on_faces_above(0., mesh.number_of_vertices()), 0u); // it is not measured yet
  };
  const auto optimize = [&](Descent& descent, const Surface& mesh, Execution execution) {
    Images positions = directions_of(mesh.points()); // of an ellipsoid
    const std::size_t n = mesh.number_of_vertices();
    for(int k = 0; k < 3; ++k)
    {
      const double bound = 0.9 * descent.measure(positions, 1., 1.).maximum_energy();
      const auto sweep = [&] { descent.sweep(positions, 1., 1.); };
      const auto look_for_focus = [&] { EXPECT_GT(descent.focus_on_faces_above(bound, n), 0u); };
      if(execution.run != Execution().run)
      {
        EXPECT_GT(descent.focus_on_faces_above(0., n / 2), n / 2);
      }
      SP::internal::run_both(execution, sweep, look_for_focus);
      descent.sweep_focus(positions, 1., 1.);
    }
    return positions;
  };
  const Execution in_parallel = SP::internal::execution_of<CGAL::Parallel_if_available_tag>();
  Descent descent(energy, Newton_step(), in_parallel);
  descent.reserve(600); // for some of them
  for(const unsigned int subdivisions : {3u, 2u, 4u, 3u})
  {
    const Surface mesh = surface_of(ellipsoid(1., 2., 3., subdivisions));
    Descent own(energy, Newton_step(), Execution());
    assign(own, mesh);
    assign(descent, mesh);
    EXPECT_TRUE(have_same_bits(optimize(descent, mesh, in_parallel), optimize(own, mesh, Execution())));
  }
}

// Arrays of all sizes around that of a huge page, of which large ones begin with one.
TEST(Large_array, keeps_its_elements)
{
  using Array = Large_array<std::uint32_t>;
  constexpr std::size_t n_of_page = (std::size_t(1) << 21) / sizeof(std::uint32_t);
  Array last;
  for(const std::size_t n : {n_of_page - 1, n_of_page, n_of_page + 1, 3 * n_of_page - 1, 5 * n_of_page + 12345})
  {
    Array numbers(n, boost::container::default_init);
    std::iota(numbers.begin(), numbers.end(), 7u);
    Array copy = numbers;
    copy.push_back(0);
    numbers.swap(last);
    ASSERT_EQ(copy.size(), n + 1);
    EXPECT_TRUE(std::equal(last.begin(), last.end(), copy.begin()));
    EXPECT_EQ(copy[n - 1], n + 6);
#ifdef __linux__
    EXPECT_TRUE(n < n_of_page || reinterpret_cast<std::uintptr_t>(last.data()) % (std::size_t(1) << 21) == 0);
#endif
  }
}

TEST(Sharpness_rule, of_a_dial_at_0_stays_there)
{
  Sharpness_rule rule(Sharpness::lowest_average());
  for(std::size_t sweep = 0; sweep < 5; ++sweep)
  {
    EXPECT_EQ(rule.next(sweep, 2.5, 8.), 0.);
    EXPECT_TRUE(rule.is_final());
  }
}

TEST(Sharpness_rule, of_a_schedule_leaves_the_plain_sum_when_the_average_settles)
{
  Sharpness_rule rule(Sharpness::schedule());
  double average = 10.;
  std::size_t sweep = 0;
  EXPECT_EQ(rule.next(sweep++, average, 50.), 0.);
  for(int k = 0; k < 30; ++k) // it falls by half a percent each time; that the largest one stays does not matter
  {
    average *= 0.995;
    EXPECT_EQ(rule.next(sweep++, average, 50.), 0.);
    EXPECT_FALSE(rule.is_final());
  }
  EXPECT_EQ(rule.next(sweep++, 0.9995 * average, 50.), 0.1);
  EXPECT_FALSE(rule.is_final());

  Sharpness_rule rising(Sharpness::schedule());
  EXPECT_EQ(rising.next(0, 2., 50.), 0.);
  EXPECT_EQ(rising.next(1, 2.1, 50.), 0.1);
}

TEST(Sharpness_rule, of_a_schedule_rises_when_nothing_falls)
{
  Sharpness_rule rule(Sharpness::schedule(0.2, 3.));
  std::size_t sweep = 0;
  EXPECT_EQ(rule.next(sweep++, 2., 100.), 0.);
  EXPECT_EQ(rule.next(sweep++, 2., 100.), 0.2);
  double largest = 100., average = 2.;
  for(int k = 0; k < 20; ++k) // while either falls by more than a percent, nothing changes
  {
    (k % 2 == 0 ? largest : average) *= 0.98;
    EXPECT_EQ(rule.next(sweep++, average, largest), 0.2);
  }
  double last = 0.2;
  while(!rule.is_final() && sweep < 200)
  {
    largest *= 0.995;
    const double s = rule.next(sweep++, average, largest);
    EXPECT_GT(s, last);
    EXPECT_LE(s, 2. * last); // no jump
    last = s;
  }
  EXPECT_EQ(last, 3.);
  EXPECT_EQ(rule.next(sweep++, average, largest), 3.); // and there it stays
  EXPECT_TRUE(rule.is_final());
}

TEST(Sharpness_rule, of_a_schedule_makes_as_many_average_sweeps_as_given)
{
  for(const std::size_t n : {0u, 1u, 3u, 100u})
  {
    Sharpness_rule rule(Sharpness::schedule(0.1, 10., n));
    for(std::size_t sweep = 0; sweep < n; ++sweep) // whatever the energies do: fall, stay or rise
    {
      EXPECT_EQ(rule.next(sweep, sweep % 2 == 0 ? 2. : 3., 50.), 0.);
      EXPECT_FALSE(rule.is_final());
    }
    EXPECT_EQ(rule.next(n, 2., 50.), 0.1);
    // patient with slow steps: a thousandth takes the place of a hundredth
    EXPECT_EQ(rule.next(n + 1, 2., 49.9), 0.1);
    EXPECT_GT(rule.next(n + 2, 2., 49.89), 0.1);
  }
  Sharpness_rule fixed(Sharpness::fixed(5.)), after_one(Sharpness::schedule(5., 5., 1));
  EXPECT_TRUE(fixed.is_final());
  EXPECT_EQ(fixed.next(0, 3., 50.), 5.);
  EXPECT_FALSE(after_one.is_final());
  EXPECT_EQ(after_one.next(0, 3., 50.), 0.);
  EXPECT_EQ(after_one.next(1, 3., 50.), 5.);
  EXPECT_TRUE(after_one.is_final());
}

} // namespace
