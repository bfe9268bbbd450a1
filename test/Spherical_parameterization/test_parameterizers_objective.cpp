// The objective of the default method over whole runs: it never rises, its end is an end, isometries are found, and slivers
// own neither the radius nor the other faces.

#include "engine.h"
#include "methods.h"
#include "random_meshes.h"

#include <CGAL/spherical_parameterization.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace test;

namespace {

Method with_dial(double beta)
{
  return Method("dial", SP::Bijective_low_distortion_parameterizer_3().sharpness(SP::Sharpness::relative(beta)));
}

// Cuts the face `k` by a vertex next to the middle of its first edge: a sliver, and another one across the edge.
Triangle_list with_sliver(Triangle_list list, std::size_t k)
{
  const Triangle t = list.triangles[k];
  const Coordinates a = list.points[t[0]], b = list.points[t[1]], c = list.points[t[2]];
  const auto v = static_cast<std::uint32_t>(list.points.size());
  list.points.push_back(combination(1. - 1e-4, combination(0.5, a, 0.5, b), 1e-4, c));
  list.triangles[k] = {t[0], t[1], v};
  list.triangles.push_back({t[1], t[2], v});
  list.triangles.push_back({t[2], t[0], v});
  return list;
}

// Vertices, radius, level, slivers: no step may take back what the others have gained.
TEST(Objective, never_rises)
{
  const std::pair<const char*, Triangle_list> lists[] = {
      {"bumps", bumpy_sphere(3)},
      {"tentacle", with_tentacle(8, 12.)},
      {"stack", random_stacked_sphere(400, 3)},
      {"ellipsoid", ellipsoid(1., 1., 9., 3)},
      {"slivers", with_sliver(with_sliver(bumpy_sphere(3), 17), 400)},
      {"octahedron", scaled(octahedron(), 1., 2., 3.)}};
  for(const auto& [name, list] : lists)
    for(const double beta : {0., 3., 20., 100.})
    {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(beta));
      Recorder recorder;
      const Result result = with_dial(beta).run(list, Options().visitor(recorder).iterations(300));
      ASSERT_EQ(result.error, SP::OK);
      double last = std::numeric_limits<double>::infinity();
      for(const auto& event : recorder.all("iteration"))
      {
        EXPECT_LE(event.energy, (1. + 1e-12) * last) << event.number;
        last = event.energy;
      }
      EXPECT_LT(last, recorder.all("iteration").front().energy);
    }
}

TEST(Objective, has_its_end_at_isometries)
{
  for(const Triangle_list& list : {tetrahedron(), octahedron(), icosphere(0)})
  {
    const Result result = bijective().run(scaled(list, 7., 7., 7.));
    EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
    EXPECT_LT(result.distortion.isometric.maximum, 1. + 1e-9);
    EXPECT_NEAR(result.report.radius, 7., 1e-8);
  }
}

TEST(Objective, of_small_meshes_is_brought_to_its_end)
{
  for(const Triangle_list& list : {bumpy_sphere(2), with_tentacle(6, 6.), random_stacked_sphere(300, 8)})
  {
    const Result result = bijective().run(list);
    EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
    const Result longer = Method("longer", SP::Bijective_low_distortion_parameterizer_3().tolerances(0., 0.))
                              .run(list, Options().iterations(5000));
    EXPECT_NEAR(longer.distortion.isometric.average / result.distortion.isometric.average, 1., 0.02);
    EXPECT_NEAR(longer.distortion.isometric.maximum / result.distortion.isometric.maximum, 1., 0.05);
  }
}

TEST(Objective, is_not_owned_by_slivers)
{
  const Triangle_list list = bumpy_sphere(3);
  const Result without = bijective().run(list);
  const Result with = bijective().run(with_sliver(list, 100));
  ASSERT_EQ(with.error, SP::OK);
  EXPECT_GT(with.report.largest_energy, 1.5 * without.report.largest_energy); // of the sliver
  EXPECT_NEAR(with.report.radius / without.report.radius, 1., 0.02);
  EXPECT_NEAR(with.distortion.isometric.average / without.distortion.isometric.average, 1., 0.02);
  EXPECT_NEAR(with.report.sharpness / without.report.sharpness, 1., 0.1);
}

TEST(Objective, takes_any_dial)
{
  for(const double beta : {1e-6, 1e-3, 1e3, 1e6})
  {
    const Result result = with_dial(beta).run(bumpy_sphere(2), Options().iterations(30));
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_TRUE(std::isfinite(result.report.average_energy));
    EXPECT_LT(result.report.average_energy, 1.2 * result.report.initial_energy);
  }
}

} // namespace
