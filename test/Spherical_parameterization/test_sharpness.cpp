// The sharpness of the objective: the two policies by themselves, on runs, and the stopping rule that waits for them.

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

TEST(Relative_sharpness, is_inverse_to_the_largest_energy)
{
  EXPECT_EQ(SP::Relative_sharpness_3().beta(), 13.5);
  SP::Relative_sharpness_3 policy(6.);
  for(std::size_t sweep = 0; sweep < 5; ++sweep)
  {
    EXPECT_EQ(policy(sweep, 2.5, 8.), 0.75);
    EXPECT_EQ(policy(sweep, 7.5, 48.), 0.125);
    EXPECT_TRUE(policy.is_final());
  }
  // as scale-free on the coarse levels, and never sharper than on the finest
  EXPECT_NEAR(policy.on_coarse_level(8.), 6. * policy.on_coarse_level(48.), 1e-15);
  EXPECT_GT(policy.on_coarse_level(8.), 0.);
  EXPECT_LE(policy.on_coarse_level(8.), 0.75);
}

TEST(Relative_sharpness, of_zero_is_the_plain_sum)
{
  SP::Relative_sharpness_3 policy(0.);
  EXPECT_TRUE(policy.is_valid());
  EXPECT_EQ(policy(0, 2., 100.), 0.);
  EXPECT_EQ(policy(1, 2., 2.), 0.);
  EXPECT_EQ(policy.on_coarse_level(10.), 0.);
}

TEST(Absolute_sharpness, leaves_the_plain_sum_when_the_average_settles)
{
  SP::Absolute_sharpness_3 policy;
  EXPECT_EQ(policy.first(), 0.1);
  EXPECT_EQ(policy.last(), 10.);
  double average = 10.;
  std::size_t sweep = 0;
  EXPECT_EQ(policy(sweep++, average, 50.), 0.);
  for(int k = 0; k < 30; ++k) // it falls by half a percent each time; that the largest one stays does not matter
  {
    average *= 0.995;
    EXPECT_EQ(policy(sweep++, average, 50.), 0.);
    EXPECT_FALSE(policy.is_final());
  }
  average *= 0.9995;
  EXPECT_EQ(policy(sweep++, average, 50.), 0.1);
  EXPECT_FALSE(policy.is_final());
}

TEST(Absolute_sharpness, leaves_the_plain_sum_when_the_average_rises)
{
  SP::Absolute_sharpness_3 policy;
  EXPECT_EQ(policy(0, 2., 50.), 0.);
  EXPECT_EQ(policy(1, 2.1, 50.), 0.1);
}

TEST(Absolute_sharpness, rises_when_the_largest_energy_settles)
{
  SP::Absolute_sharpness_3 policy(0.2, 3.);
  std::size_t sweep = 0;
  EXPECT_EQ(policy(sweep++, 2., 100.), 0.);
  double largest = 100., last = policy(sweep++, 2., largest);
  EXPECT_EQ(last, 0.2);
  for(int k = 0; k < 20; ++k) // while it falls by more than a percent, nothing changes, whatever the average does
  {
    largest *= 0.98;
    EXPECT_EQ(policy(sweep++, 2., largest), last);
  }
  int n_rises = 0;
  while(!policy.is_final())
  {
    largest *= 0.995;
    const double s = policy(sweep++, 2., largest);
    EXPECT_GT(s, last);
    EXPECT_LE(s, 2. * last); // no jump
    last = s;
    ASSERT_LT(++n_rises, 100);
  }
  EXPECT_EQ(last, 3.);
  for(int k = 0; k < 5; ++k) // and there it stays
  {
    EXPECT_EQ(policy(sweep++, 2., largest), 3.);
    EXPECT_TRUE(policy.is_final());
  }
}

TEST(Absolute_sharpness, waits_while_the_average_falls)
{
  SP::Absolute_sharpness_3 policy(0.2, 3.);
  EXPECT_EQ(policy(0, 2., 100.), 0.);
  EXPECT_EQ(policy(1, 2., 100.), 0.2);
  EXPECT_EQ(policy(2, 1.96, 100.), 0.2);
  EXPECT_GT(policy(3, 1.95, 100.), 0.2);
}

// With a given number of sweeps of the plain sum, which is for slow steps, it takes a thousandth instead of a hundredth.
TEST(Absolute_sharpness, is_patient_with_slow_steps)
{
  SP::Absolute_sharpness_3 policy(0.2, 3., 1);
  EXPECT_EQ(policy(0, 2., 100.), 0.);
  EXPECT_EQ(policy(1, 2., 100.), 0.2);
  EXPECT_EQ(policy(2, 2., 99.8), 0.2);
  EXPECT_EQ(policy(3, 1.996, 99.8), 0.2);
  EXPECT_GT(policy(4, 1.995, 99.75), 0.2);
}

TEST(Absolute_sharpness, is_fixed_if_both_values_are_the_same)
{
  SP::Absolute_sharpness_3 policy(0.7, 0.7);
  EXPECT_TRUE(policy.is_valid());
  EXPECT_TRUE(policy.is_final());
  for(std::size_t sweep = 0; sweep < 5; ++sweep)
  {
    EXPECT_EQ(policy(sweep, 10. - static_cast<double>(sweep), 50.), 0.7);
  }
}

TEST(Absolute_sharpness, leaves_coarse_levels_to_the_plain_sum)
{
  EXPECT_EQ(SP::Absolute_sharpness_3().on_coarse_level(5.), 0.);
}

template <class Sharpness>
using Parameterizer =
    SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, CGAL::Default, Sharpness, CGAL::Default>;

// A run on the bumpy sphere, and what its visitor saw.
template <class Sharpness>
struct Result
{
  Result(const Sharpness& sharpness, unsigned int iterations, double energy_tolerance = 1e-5,
         double radius_tolerance = 1e-3)
  {
    const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
    Parameterizer<Sharpness> bld(SP::Symmetric_Dirichlet_energy_3(), sharpness);
    bld.set_tolerances(energy_tolerance, radius_tolerance);
    const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
    EXPECT_EQ(SP::parameterize(mesh, bld, map, CGAL::parameters::number_of_iterations(iterations)), SP::OK);
    EXPECT_TRUE(SP::is_bijective(mesh, map));
    report = bld.report();
    distortion = SP::measure_distortion(mesh, map);
  }

  SP::Parameterization_report report;
  SP::Distortion_summary distortion;
};

TEST(Sharpness_of_a_run, goes_from_first_to_last)
{
  const Result<SP::Absolute_sharpness_3> short_run(SP::Absolute_sharpness_3(0.1, 10.), 3);
  EXPECT_EQ(short_run.report.stop_reason, SP::ITERATION_LIMIT);
  EXPECT_LT(short_run.report.sharpness, 10.);
  const Result<SP::Absolute_sharpness_3> run(SP::Absolute_sharpness_3(0.1, 10.), 2000);
  EXPECT_EQ(run.report.sharpness, 10.);
  EXPECT_GT(run.report.number_of_average_iterations, 0u);
  EXPECT_GT(run.report.number_of_sharp_iterations, 0u);
  EXPECT_EQ(run.report.stop_reason, SP::CONVERGED);
}

TEST(Sharpness_of_a_run, trades_the_average_for_the_maximum)
{
  const Result<SP::Relative_sharpness_3> plain(SP::Relative_sharpness_3(0.), 300),
      sharp(SP::Relative_sharpness_3(25.), 300);
  EXPECT_EQ(plain.report.number_of_sharp_iterations, 0u);
  EXPECT_EQ(plain.report.sharpness, 0.);
  EXPECT_EQ(sharp.report.number_of_average_iterations, 0u);
  EXPECT_NEAR(sharp.report.sharpness * sharp.report.largest_energy, 25., 1.);
  EXPECT_LT(plain.report.average_energy, sharp.report.average_energy);
  EXPECT_LT(sharp.report.largest_energy, plain.report.largest_energy);
  EXPECT_LT(plain.distortion.isometric.average, sharp.distortion.isometric.average);
  EXPECT_LT(sharp.distortion.isometric.maximum, 0.9 * plain.distortion.isometric.maximum);
}

TEST(Sharpness_of_a_run, may_be_as_large_as_you_like)
{
  for(const double beta : {1e3, 1e6})
  {
    const Result<SP::Relative_sharpness_3> run(SP::Relative_sharpness_3{beta}, 20);
    EXPECT_LT(run.report.largest_energy, 100.);
  }
  const Result<SP::Absolute_sharpness_3> run(SP::Absolute_sharpness_3(1e5, 1e5), 20);
  EXPECT_LT(run.report.largest_energy, 100.);
}

// What a policy was asked for: 'm' for the mesh before its first sweep, 'M' after it, 'c' for a coarse level.
struct Noted_sharpness
{
  std::string* notes;

  double operator()(std::size_t sweep, double, double) const
  {
    *notes += sweep == 0 ? 'm' : 'M';
    return 0.;
  }
  double on_coarse_level(double) const
  {
    *notes += 'c';
    return 0.;
  }
  bool is_final() const { return true; }
};

// Takes the notes of each level.
struct Level_notes : SP::Default_visitor
{
  explicit Level_notes(std::string& notes)
    : m_notes(notes)
  {}

  void on_level(std::size_t n_vertices)
  {
    levels.emplace_back(n_vertices, m_notes);
    m_notes.clear();
  }

  std::vector<std::pair<std::size_t, std::string>> levels;

private:
  std::string& m_notes;
};

// Levels that are nearly as fine as the mesh are swept as the mesh will be.
TEST(Sharpness_of_a_run, is_that_of_the_mesh_on_the_last_levels)
{
  std::size_t n_like_the_mesh = 0;
  for(const unsigned int n_subdivisions : {2u, 4u, 5u}) // 162, 2,562 and 10,242 vertices
  {
    const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::icosphere(n_subdivisions));
    const std::size_t n = num_vertices(mesh);
    const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
    const auto run = [&](auto parameterizer, std::string& notes) {
      Level_notes levels(notes);
      EXPECT_EQ(SP::parameterize(mesh, parameterizer, map,
                                 CGAL::parameters::number_of_iterations(3).visitor(std::ref(levels))),
                SP::OK);
      EXPECT_EQ(levels.levels.back().first, n);
      for(const auto& [n_level, asked] : levels.levels)
      {
        if(n_level == n)
          break;
        const bool is_like_the_mesh = n_level >= 2500 && 2 * n_level >= n;
        n_like_the_mesh += is_like_the_mesh;
        EXPECT_EQ(asked.empty(), n_level < 300);
        EXPECT_EQ(asked, std::string(asked.size(), is_like_the_mesh ? 'm' : 'c')) << n_level << " of " << n;
      }
      return levels.levels.back().second;
    };
    std::string notes;
    Parameterizer<Noted_sharpness> bld(SP::Symmetric_Dirichlet_energy_3(), Noted_sharpness{&notes});
    bld.set_tolerances(0., 0.);
    EXPECT_EQ(run(bld, notes), "");
    EXPECT_EQ(notes, "mMM"); // of the sweeps over the mesh, after all levels
    notes.clear();
    const std::string asked =
        run(SP::Hierarchical_parameterizer_3<Mesh, CGAL::Default, Noted_sharpness>(SP::Isometric_energy_3(), {&notes}),
            notes);
    EXPECT_GT(asked.size(), 1u);
    EXPECT_EQ(asked, 'm' + std::string(asked.size() - 1, 'M'));
  }
  EXPECT_EQ(n_like_the_mesh, 4u); // two of the large mesh, with each of the methods
}

TEST(Stopping_rule, is_met_within_its_tolerance)
{
  const SP::Relative_sharpness_3 sharpness;
  const Result<SP::Relative_sharpness_3> loose(sharpness, 1000, 1e-3), tight(sharpness, 1000, 1e-6),
      never(sharpness, 150, 0., 0.);
  EXPECT_EQ(loose.report.stop_reason, SP::CONVERGED);
  EXPECT_EQ(tight.report.stop_reason, SP::CONVERGED);
  EXPECT_LT(loose.report.number_of_iterations(), tight.report.number_of_iterations());
  EXPECT_LT(tight.report.largest_energy, loose.report.largest_energy * 1.001);
  EXPECT_EQ(never.report.stop_reason, SP::ITERATION_LIMIT);
  EXPECT_EQ(never.report.number_of_iterations(), 150u);
}

// A policy that does not change and yet says that it is going to, or that it is there after some sweeps.
struct Late_sharpness
{
  std::size_t first_final_sweep;
  std::size_t sweep = 0;

  double operator()(std::size_t i, double, double)
  {
    sweep = i;
    return 0.;
  }
  double on_coarse_level(double) const { return 0.; }
  bool is_final() const { return sweep >= first_final_sweep; }
};

TEST(Stopping_rule, waits_for_the_final_sharpness)
{
  const Result<Late_sharpness> at_once(Late_sharpness{0}, 150, 1e-2), late(Late_sharpness{70}, 150, 1e-2),
      never(Late_sharpness{1000}, 150, 1e-2);
  EXPECT_EQ(at_once.report.stop_reason, SP::CONVERGED);
  EXPECT_LT(at_once.report.number_of_iterations(), 20u);
  EXPECT_EQ(late.report.stop_reason, SP::CONVERGED);
  EXPECT_GE(late.report.number_of_iterations(), 70u);
  EXPECT_LE(late.report.number_of_iterations(), 73u);
  EXPECT_EQ(never.report.stop_reason, SP::ITERATION_LIMIT);
}

} // namespace
