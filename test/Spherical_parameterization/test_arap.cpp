// As rigid as possible: the energy against singular values, its gradient against differences, the radius and the
// descent; whole runs on surfaces whose best map is known, and on limbs where it folds.

#include <CGAL/spherical_parameterization.h>

#include "test_indexed_meshes.h"
#include "test_maps.h"
#include "test_meshes.h"
#include "test_runs.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <type_traits>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace params = CGAL::parameters;

namespace {

using SP::internal::cross;
using SP::internal::dot;
using SP::internal::Indexed_mesh;
using SP::internal::length;
using SP::internal::normalized;
using SP::internal::squared_length;
using SP::internal::Vector_3d;
using SP::internal::operator+;
using SP::internal::operator-;
using SP::internal::operator*;
using test_indexed_meshes::indexed_mesh;
using test_meshes::Coordinates;
using test_meshes::Triangle_list;
using test_runs::Result;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Arap = SP::ARAP_parameterizer_3<Mesh>;
using Energy = SP::internal::ARAP_energy<CGAL::Sequential_tag>;

constexpr double pi = test_meshes::pi;

// The energy has settled, or, where it is not smooth because a face folds, no step lowers it.
bool has_come_to_an_end(const SP::Parameterization_report& report)
{
  return report.stop_reason == SP::CONVERGED || report.stop_reason == SP::OBSTRUCTED;
}

// The energy of the map u on the sphere of radius r by its singular values: their squares add up to I and their
// product, negative for a face that is turned over, is d, so their sum is the root of I + 2 d.
double energy_of(const Indexed_mesh& mesh, const std::vector<Vector_3d>& u, double r)
{
  double sum = 0.;
  mesh.rings().for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::vector<Vector_3d>& p = mesh.points();
    const Vector_3d e = p[b] - p[a], f = p[c] - p[a], g = u[b] - u[a], h = u[c] - u[a], n = cross(g, h);
    const double area = length(cross(e, f));
    const double i =
        r * r *
        (squared_length(f) * squared_length(g) - 2. * dot(e, f) * dot(g, h) + squared_length(e) * squared_length(h)) /
        (area * area);
    const double d = (dot(n, u[a] + u[b] + u[c]) < 0. ? -1. : 1.) * r * r * length(n) / area;
    sum += 0.25 * area * (i - 2. * std::sqrt((std::max)(i + 2. * d, 0.)) + 2.);
  });
  return sum / (4. * pi);
}

// A map of the bumpy sphere, with faces turned over if `scatter` is large.
struct Scattered_map
{
  explicit Scattered_map(double scatter)
    : list(test_meshes::bumpy_sphere(2))
    , mesh(indexed_mesh(list))
    , u(test_indexed_meshes::renumbered(mesh, test_meshes::icosphere(2).points))
  {
    std::mt19937 random(1);
    for(Vector_3d& p : u)
    {
      for(double& x : p)
      {
        x += scatter * (static_cast<double>(random()) / 0x1p31 - 1.);
      }
      p = normalized(p);
    }
  }

  std::size_t number_of_inverted_faces() const
  {
    std::size_t n = 0;
    mesh.rings().for_each_face(
        [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { n += dot(u[a], cross(u[b], u[c])) < 0.; });
    return n;
  }

  Triangle_list list;
  Indexed_mesh mesh;
  std::vector<Vector_3d> u;
};

TEST(ARAP_energy, is_that_of_the_singular_values)
{
  for(const double scatter : {0., 0.05, 0.3})
  {
    const Scattered_map map(scatter);
    EXPECT_EQ(map.number_of_inverted_faces() > 0, scatter > 0.1);
    Energy energy(map.mesh.rings(), map.mesh.points());
    const double value = energy.fit(map.u), radius = energy.radius();
    EXPECT_GT(value, 0.);
    EXPECT_NEAR(value, energy_of(map.mesh, map.u, radius), 1e-12);
  }
}

TEST(ARAP_energy, is_stationary_in_the_radius)
{
  // The rotations do not depend on the radius, so the energy is a parabola in it.
  for(const double scatter : {0., 0.3})
  {
    const Scattered_map map(scatter);
    Energy energy(map.mesh.rings(), map.mesh.points());
    const double value = energy.fit(map.u), radius = energy.radius();
    const double below = energy_of(map.mesh, map.u, 0.99 * radius), above = energy_of(map.mesh, map.u, 1.01 * radius);
    EXPECT_GT(below, value);
    EXPECT_GT(above, value);
    EXPECT_NEAR(above, below, 1e-12);
  }
}

TEST(ARAP_energy, of_an_isometry_is_0)
{
  for(const double scale : {1., 7.})
  {
    const Triangle_list sphere = test_meshes::icosphere(2), list = test_meshes::scaled(sphere, scale, scale, scale);
    const Indexed_mesh mesh = indexed_mesh(list);
    Energy energy(mesh.rings(), mesh.points());
    EXPECT_NEAR(energy.fit(test_indexed_meshes::renumbered(mesh, sphere.points)), 0., 1e-14);
    EXPECT_NEAR(energy.radius() * mesh.equal_area_radius(), scale, 1e-14 * scale);
    // the mirror image is none
    const std::vector<Coordinates> mirrored = test_meshes::scaled(sphere, 1., 1., -1.).points;
    EXPECT_GT(energy.fit(test_indexed_meshes::renumbered(mesh, mirrored)), 0.1);
  }
}

TEST(ARAP_energy, has_the_gradient_of_its_value)
{
  for(const double scatter : {0.05, 0.3})
  {
    Scattered_map map(scatter);
    Energy energy(map.mesh.rings(), map.mesh.points());
    energy.fit(map.u);
    const double radius = energy.radius();
    std::vector<Vector_3d> forces(map.u.size());
    energy.forces(map.u, forces);
    Vector_3d sum = {0., 0., 0.};
    for(std::size_t v = 0; v < map.u.size(); ++v)
    {
      sum = sum + forces[v];
      const double h = 1e-6;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Vector_3d u = map.u[v];
        map.u[v][i] = u[i] + h;
        const double above = energy.fit(map.u); // with the best radius, which makes no difference to first order
        map.u[v][i] = u[i] - h;
        const double below = energy.fit(map.u);
        map.u[v] = u;
        EXPECT_NEAR(-radius * forces[v][i] / (4. * pi), (above - below) / (2. * h), 1e-7 * (1. + length(forces[v])));
      }
    }
    EXPECT_LT(length(sum), 1e-12); // moving all points together changes nothing
  }
}

struct Energies : SP::Default_visitor
{
  void after_iteration(std::size_t, double energy, double radius)
  {
    energies.push_back(energy);
    radii.push_back(radius);
  }
  std::vector<double> energies, radii;
};

TEST(ARAP, energy_never_rises)
{
  for(const Triangle_list& list : {test_meshes::bumpy_sphere(3), test_meshes::with_tentacle(20, 1.),
                                   test_meshes::scaled(test_meshes::suspension(12), 1., 1., 10.)})
  {
    const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
    Arap arap;
    Energies visitor;
    const Result result = test_runs::run<Point_3>(mesh, arap, true, params::visitor(std::ref(visitor)));
    ASSERT_EQ(result.report.number_of_iterations(), visitor.energies.size());
    ASSERT_GT(visitor.energies.size(), 5u);
    double last = result.report.initial_energy;
    for(const double energy : visitor.energies)
    {
      EXPECT_LT(energy, last);
      last = energy;
    }
    EXPECT_EQ(result.report.average_energy, last);
    EXPECT_EQ(result.report.radius, visitor.radii.back());
    EXPECT_TRUE(has_come_to_an_end(result.report));

    // what is reported is the energy of the map that was written, and its radius is the best one
    const Indexed_mesh indexed = indexed_mesh(list);
    std::vector<Vector_3d> u = test_indexed_meshes::renumbered(indexed, result.images);
    for(Vector_3d& p : u)
    {
      p = normalized(p);
    }
    const double radius = indexed.scaled_radius(result.report.radius);
    EXPECT_NEAR(energy_of(indexed, u, radius), last, 1e-10);
    EXPECT_GT(energy_of(indexed, u, 1.001 * radius), last);
    EXPECT_GT(energy_of(indexed, u, 0.999 * radius), last);
  }
}

TEST(ARAP, map_of_a_sphere_is_the_identity)
{
  for(const double scale : {1., 5.})
  {
    const Triangle_list list = test_meshes::scaled(test_meshes::icosphere(2), scale, scale, scale);
    Arap arap;
    const Result result = test_runs::run<Point_3>(test_meshes::make_mesh<Mesh>(list), arap, true);
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_LT(result.report.average_energy, 1e-12);
    EXPECT_NEAR(result.report.radius, scale, 1e-6 * scale);
    EXPECT_LT(test_runs::largest_difference_up_to_rotation(result.images, list.points), 1e-5 * scale);
    EXPECT_LT(result.distortion.isometric.maximum, 1.00001);
  }
}

TEST(ARAP, map_is_near_an_isometry_where_it_can_be)
{
  Arap arap;
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(3));
  const Result result = test_runs::run<Point_3>(mesh, arap, true);
  EXPECT_EQ(result.error, SP::OK);
  EXPECT_LT(result.report.average_energy, 0.9 * result.report.initial_energy);
  // a critical point: a run from there finds nothing to do
  const auto map = test_meshes::make_vertex_map<Point_3>(mesh, result.images);
  using Precomputed = SP::Precomputed_parameterizer_3<Mesh, std::remove_const_t<decltype(map)>>;
  SP::ARAP_parameterizer_3<Mesh, Precomputed> again{Precomputed(map)};
  const Result further = test_runs::run<Point_3>(mesh, again, true);
  EXPECT_NEAR(further.report.initial_energy, result.report.average_energy, 1e-10);
  EXPECT_NEAR(further.report.average_energy / result.report.average_energy, 1., 1e-3);
  EXPECT_LT(further.report.number_of_iterations(), result.report.number_of_iterations());
}

TEST(ARAP, number_of_iterations_is_respected)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
  Arap arap;
  double last = HUGE_VAL;
  for(const unsigned int n : {0u, 1u, 7u})
  {
    const Result result = test_runs::run<Point_3>(mesh, arap, true, params::number_of_iterations(n));
    EXPECT_EQ(result.report.number_of_iterations(), n);
    EXPECT_EQ(result.report.stop_reason, SP::ITERATION_LIMIT);
    EXPECT_LT(result.report.average_energy, last);
    last = result.report.average_energy;
  }
  EXPECT_EQ(test_runs::run<Point_3>(mesh, arap, true, params::number_of_iterations(-1)).error,
            SP::ERROR_WRONG_PARAMETER);
}

// Being stopped while the start is made counts, even if there is nothing left to do then.
TEST(ARAP, stop_during_the_start_is_reported)
{
  struct Stopping_visitor : SP::Default_visitor
  {
    bool go_further(std::size_t, double) { return false; }
  };
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
  Stopping_visitor visitor;
  Arap arap;
  SP::parameterize(mesh, arap, map, params::visitor(std::ref(visitor)).number_of_iterations(0u));
  EXPECT_EQ(arap.report().stop_reason, SP::STOPPED);
  EXPECT_EQ(arap.report().number_of_iterations(), 0u);
}

TEST(ARAP, folds_are_told_of)
{
  std::vector<Triangle_list> lists = {test_meshes::with_tentacle(20, 1.), test_meshes::with_tentacle(40, 2.),
                                      test_meshes::scaled(test_meshes::suspension(12), 1., 1., 10.)};
  lists.push_back(test_meshes::icosphere(1)); // a star
  for(std::size_t v = 0; v < 12; ++v)
  {
    for(double& x : lists.back().points[v])
    {
      x *= 8.;
    }
  }
  std::size_t n_obstructed = 0;
  for(const Triangle_list& list : lists)
  {
    const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
    Arap arap;
    const Result result = test_runs::run<Point_3>(mesh, arap, true);
    n_obstructed += result.report.stop_reason == SP::OBSTRUCTED ? 1 : 0;
    EXPECT_EQ(result.error, SP::ERROR_NO_1_TO_1_MAPPING);
    EXPECT_GT(result.distortion.number_of_inverted_faces, 0u);
    EXPECT_TRUE(has_come_to_an_end(result.report));
    EXPECT_LT(result.report.average_energy, result.report.initial_energy);
    // what never folds does not on these either, from the same start
    SP::Bijective_low_distortion_parameterizer_3<Mesh> bld;
    EXPECT_EQ(test_runs::run<Point_3>(mesh, bld, false).error, SP::OK);
  }
  EXPECT_GT(n_obstructed, 0u); // a fold is where no step helps, and that is not called convergence
}

TEST(ARAP, starts_from_any_map)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
  Arap arap;
  SP::ARAP_parameterizer_3<Mesh, SP::Harmonic_parameterizer_3<Mesh>> from_harmonic;
  const Result one = test_runs::run<Point_3>(mesh, arap, true),
               other = test_runs::run<Point_3>(mesh, from_harmonic, true);
  EXPECT_EQ(one.error, SP::OK);
  EXPECT_EQ(other.error, SP::OK);
  EXPECT_GT(std::abs(other.report.initial_energy / one.report.initial_energy - 1.), 0.1);
  EXPECT_NEAR(other.report.average_energy / one.report.average_energy, 1., 1e-2);
  EXPECT_NEAR(other.report.radius / one.report.radius, 1., 1e-2);
  // but not from one that folds
  SP::ARAP_parameterizer_3<Mesh, SP::Conformal_parameterizer_3<Mesh>> from_folds;
  EXPECT_EQ(test_runs::run<Point_3>(mesh, from_folds, true).error, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  // nor with an initial parameterizer that is not valid
  using Hierarchical = Arap::Initial_parameterizer;
  Arap invalid(Hierarchical(Hierarchical::Energy(), Hierarchical::Sharpness(0.), Hierarchical::Vertex_update(), 0));
  EXPECT_FALSE(invalid.is_valid());
  EXPECT_EQ(test_runs::run<Point_3>(mesh, invalid, true).error, SP::ERROR_WRONG_PARAMETER);
}

// Surfaces that lie in a plane, on a line, or in one point: nothing is promised but an end.
TEST(ARAP, of_flat_surfaces)
{
  for(const double y : {1., 0.})
  {
    for(const double x : {1., 0.})
    {
      const Triangle_list list = test_meshes::scaled(test_meshes::icosphere(1), x, x * y, 0.);
      Arap arap;
      const Result result = test_runs::run<Point_3>(test_meshes::make_mesh<Mesh>(list), arap, true);
      EXPECT_TRUE(result.error == SP::OK || result.error == SP::ERROR_NO_1_TO_1_MAPPING);
    }
  }
}

} // namespace
