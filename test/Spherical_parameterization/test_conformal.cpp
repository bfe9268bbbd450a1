// Conformal maps: a bijection whatever happens, close to conformal where doubles can hold it, and as close as they can
// elsewhere.

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using test_meshes::Coordinates;
using test_meshes::Triangle_list;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Conformal = SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, SP::Conformal_energy_3,
                                                               CGAL::Default, SP::Fixed_radius_3>;

struct Result
{
  explicit Result(const Triangle_list& list, unsigned int iterations = 200, double radius = 1.)
  {
    const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
    Conformal conformal{SP::Conformal_energy_3(), SP::Relative_sharpness_3(), SP::Fixed_radius_3(radius)};
    const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
    error = SP::parameterize(mesh, conformal, map, CGAL::parameters::number_of_iterations(iterations));
    is_bijective = SP::is_bijective(mesh, map);
    images = test_maps::images(mesh, map);
    report = conformal.report();
    if(is_bijective)
    {
      distortion = SP::measure_distortion(mesh, map);
    }
  }

  SP::Error_code error;
  bool is_bijective;
  std::vector<Coordinates> images;
  SP::Parameterization_report report;
  SP::Distortion_summary distortion;
};

TEST(Conformal, map_of_a_sphere_is_nearly_conformal)
{
  const Result result(test_meshes::icosphere(3));
  ASSERT_EQ(result.error, SP::OK);
  EXPECT_TRUE(result.is_bijective);
  EXPECT_LT(result.distortion.angle.maximum, 2.005);
  EXPECT_LT(result.distortion.angle.average, 2.001);
  EXPECT_EQ(result.report.radius, 1.);
}

TEST(Conformal, map_of_a_bumpy_sphere_keeps_the_angles)
{
  double last_average = 3.;
  for(const unsigned int subdivisions : {2u, 3u, 4u}) // ever more conformal, as the faces become smaller
  {
    const Triangle_list list = test_meshes::bumpy_sphere(subdivisions);
    const Result result(list);
    ASSERT_EQ(result.error, SP::OK);
    EXPECT_TRUE(result.is_bijective);
    EXPECT_EQ(result.report.number_of_attempts, 1u);
    EXPECT_LT(result.distortion.angle.average, last_average);
    last_average = result.distortion.angle.average;
    if(subdivisions == 4)
    {
      EXPECT_LT(result.distortion.angle.maximum, 2.5);
      EXPECT_LT(result.distortion.angle.average, 2.015);

      // the default energy trades angles for areas
      const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
      const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
      ASSERT_EQ(SP::parameterize(mesh, map), SP::OK);
      const SP::Distortion_summary isometric = SP::measure_distortion(mesh, map);
      EXPECT_GT(isometric.angle.average, 1.05 * result.distortion.angle.average);
      EXPECT_LT(isometric.area.maximum, 0.5 * result.distortion.area.maximum);
    }
  }
}

// The energy has no scale, so the radius is a mere factor.
TEST(Conformal, map_does_not_depend_on_the_radius)
{
  const Triangle_list list = test_meshes::bumpy_sphere(2);
  const Result one(list, 20), other(list, 20, 1024.);
  ASSERT_EQ(one.error, SP::OK);
  ASSERT_EQ(other.error, SP::OK);
  EXPECT_EQ(other.report.radius, 1024.);
  std::vector<Coordinates> images = one.images;
  for(Coordinates& p : images)
  {
    p = {1024. * p[0], 1024. * p[1], 1024. * p[2]};
  }
  EXPECT_TRUE(test_maps::have_same_bits(other.images, images));
}

TEST(Conformal, map_of_a_tentacle_is_conformal_as_long_as_doubles_can_hold_it)
{
  const Result result(test_meshes::with_tentacle(20, 1.), 50);
  ASSERT_EQ(result.error, SP::OK);
  EXPECT_TRUE(result.is_bijective);
  EXPECT_EQ(result.report.number_of_attempts, 1u);
  EXPECT_LT(result.distortion.angle.average, 2.2);
  EXPECT_GT(result.distortion.area.maximum, 1e7);
}

TEST(Conformal, map_of_a_long_tentacle_is_a_bijection_still)
{
  for(const double length : {5., 20.})
  {
    SCOPED_TRACE(length);
    const Result result(test_meshes::with_tentacle(static_cast<std::size_t>(20. * length), length), 50);
    ASSERT_EQ(result.error, SP::OK);
    EXPECT_TRUE(result.is_bijective);
    EXPECT_GT(result.report.number_of_attempts, 1u); // by the guard against small faces
    EXPECT_LT(result.distortion.angle.average, 8.);
    EXPECT_TRUE(std::isfinite(result.distortion.angle.maximum));
  }
}

} // namespace
