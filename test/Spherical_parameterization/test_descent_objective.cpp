// What a run lowers: the areas of isometric images, its levels, and its derivatives in the radius, against brute force.

#include <CGAL/Spherical_parameterization/internal/descent/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/descent/Energy_summary.h>
#include <CGAL/Spherical_parameterization/internal/descent/Objective.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_energy.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include "engine.h"
#include "indexed_meshes.h"
#include "random_meshes.h"

using namespace test;

namespace {

using SP::Sharpness;
using namespace SP::internal;

using Energies = std::vector<double>;

// by the first-order term that takes the determinant of a small equilateral face to its flat area
TEST(Face_objective, compares_determinants_with_those_of_isometric_images)
{
  Random random(1);
  Face_objective objective;
  const auto factor = [&](const Coordinates& p, const Coordinates& q, const Coordinates& r) {
    const Rest_triangle rest = Rest_triangle::from_points(p, q, r);
    return objective.area_factor(rest.opposite_0, rest.opposite_1, rest.opposite_2, 1. / rest.inverse_doubled_area);
  };
  const auto squared = [](double x) { return x * x; };
  for(int k = 0; k < 100; ++k)
  {
    const Coordinates p = random.in_cube(), q = random.in_cube(), r = random.in_cube();
    objective.area_correction = 0.;
    EXPECT_EQ(factor(p, q, r), 1.);
    objective = Objective(Sharpness(), true).of_faces();
    const double edges = squared(distance(p, q)) + squared(distance(q, r)) + squared(distance(r, p));
    EXPECT_NEAR(factor(p, q, r), 1. + edges / 18., 1e-9 * (1. + edges));
    EXPECT_NEAR(factor(combination(100., p, 0., p), q, r), 5., 1e-9);
  }
  EXPECT_EQ(Objective(Sharpness(), false).of_faces().area_correction, 0.);
  const double c = 1e-3; // the circumradius of a face inscribed in the unit sphere
  const Coordinates p = {c, 0., 0.}, q = {-0.5 * c, std::sqrt(0.75) * c, 0.}, r = {-0.5 * c, -std::sqrt(0.75) * c, 0.};
  EXPECT_NEAR((factor(p, q, r) - 1.) / (1. / std::sqrt(1. - c * c) - 1.), 1., 1e-4);
}

Mesh_summary summary_of(const Objective& objective, const Energies& ordinary, const Energies& slivers)
{
  Mesh_summary result(objective.of_faces());
  const std::vector<double> ones((std::max)(ordinary.size(), slivers.size()), 1.);
  result.ordinary.add_all<double>(ordinary.data(), ones.data(), ordinary.size());
  result.slivers.add_all<double>(slivers.data(), ones.data(), slivers.size());
  return result;
}

// The objective with its levels at their minimum for these energies.
Objective at_best_levels(double beta, const Energies& ordinary, const Energies& slivers = {})
{
  Objective objective(Sharpness::relative(beta), true);
  objective.start_sweep(0, summary_of(objective, ordinary, slivers));
  for(int k = 0; k < 100 && objective.improve_levels(summary_of(objective, ordinary, slivers)) > 1e-13; ++k)
    ;
  return objective;
}

// S of a group among n faces at the level R, as it is defined
long double soft_maximum(const Energies& group, std::size_t n, long double b, long double R)
{
  long double sum = 0.;
  for(const double e : group)
    sum += std::exp(b * (e / R - 1.));
  return (1. - 1. / b) * R + R / b * sum / static_cast<long double>(n);
}

// the level at least `min` of its minimum, by a search; S is convex
long double best_level(const Energies& group, std::size_t n, long double b, long double min)
{
  long double low = std::log(min),
              high = std::log((std::max)(2. * min, 2.L * *std::max_element(group.begin(), group.end())));
  for(int k = 0; k < 200; ++k)
  {
    const long double first = low + (high - low) / 3., second = high - (high - low) / 3.;
    if(soft_maximum(group, n, b, std::exp(first)) < soft_maximum(group, n, b, std::exp(second)))
      high = second;
    else // or both are infinite
      low = first;
  }
  return std::exp(low);
}

double mean(const Energies& energies)
{
  long double sum = 0.;
  for(const double e : energies)
    sum += e;
  return static_cast<double>(sum / static_cast<long double>(energies.size()));
}

Energies random_energies(std::size_t n, double range)
{
  Random random(6);
  Energies result;
  while(result.size() < n)
    result.push_back(2. + random.factor(range));
  return result;
}

std::vector<Energies> all_kinds_of_energies()
{
  Energies with_one_large(200, 2.5);
  with_one_large[7] = 1e8;
  return {{2.}, {2., 50.}, Energies(100, 3.), random_energies(100, 3.), random_energies(100, 1e4), with_one_large};
}

const double dials[] = {1e-6, 0.5, 3., 20., 50., 1e3, 1e6};

TEST(Objective, has_the_level_of_its_minimum)
{
  for(const double beta : dials)
    for(const Energies& energies : all_kinds_of_energies())
    {
      const std::size_t n = energies.size();
      const double average = mean(energies), largest = *std::max_element(energies.begin(), energies.end());
      const Objective objective = at_best_levels(beta, energies);
      const double value = objective.value(summary_of(objective, energies, {}));
      const long double b = beta + 1., a = beta / (beta + 40.),
                        s = soft_maximum(energies, n, b, best_level(energies, n, b, 0.5 * average));
      const double expected = static_cast<double>((1. - a) * average + a * s);
      EXPECT_NEAR(value, expected, 1e-10 * expected) << beta << ' ' << largest;
      EXPECT_GE(value, average * (1. - 1e-12));
      EXPECT_LE(value, largest * (1. + 1e-12));
      // It is as large as all energies where all are the same.
      EXPECT_GE(objective.of_faces().ordinary.level, average * (1. - 1e-9));
      EXPECT_LE(objective.of_faces().ordinary.level, largest * (1. + 1e-9));
      EXPECT_EQ(objective.of_faces().ordinary.sharpness, static_cast<double>(b) / objective.of_faces().ordinary.level);
    }
}

// The slivers have a level of their own, which is that of the others where they are no worse.
TEST(Objective, has_two_levels_where_there_are_slivers)
{
  const Energies ordinary = random_energies(200, 3.);
  int n_common = 0;
  for(const double beta : {3., 20., 50.})
    for(const double factor : {0.5, 1., 30., 1e6})
    {
      Energies slivers = random_energies(4, 4.);
      for(double& e : slivers)
        e *= factor;
      const std::size_t n = ordinary.size() + slivers.size();
      const Objective objective = at_best_levels(beta, ordinary, slivers);
      const double value = objective.value(summary_of(objective, ordinary, slivers));
      const long double b = beta + 1., a = beta / (beta + 40.), level = best_level(ordinary, n, b, 0.1),
                        level_of_slivers = best_level(slivers, n, b, level);
      const long double s = soft_maximum(ordinary, n, b, level) + soft_maximum(slivers, n, b, level_of_slivers);
      Energies all = ordinary;
      all.insert(all.end(), slivers.begin(), slivers.end());
      // The level of the slivers is not lowered below that of the others, which may go up again by a little.
      const bool is_common = level_of_slivers < level * (1. + 1e-12);
      const double expected = static_cast<double>((1. - a) * mean(all) + a * s);
      EXPECT_NEAR(value, expected, (is_common ? 1e-4 : 1e-9) * value) << beta << ' ' << factor;
      // that of the others is not moved by the slivers, up to their number
      EXPECT_NEAR(objective.of_faces().ordinary.level, static_cast<double>(level), 1e-6 * static_cast<double>(level));
      n_common += is_common;
    }
  EXPECT_GT(n_common, 0);
  EXPECT_LT(n_common, 12);
}

TEST(Objective, does_not_overflow)
{
  for(const double beta : dials)
    for(const double size : {1e-300, 1e-150, 1e150, 1e160, 1e300})
      for(const Energies& energies : {Energies{size, 2. * size}, Energies{size, 1e-3 * size, 0.}, Energies{size}})
      {
        const Objective objective = at_best_levels(beta, energies);
        const double value = objective.value(summary_of(objective, energies, {}));
        EXPECT_GE(value, mean(energies) * (1. - 1e-9)) << beta << ' ' << size;
        EXPECT_LE(value, 2. * size) << beta << ' ' << size;
      }
  const Energies zeros(10, 0.); // an energy whose minimum is 0, reached by all faces
  const Objective objective = at_best_levels(20., zeros);
  EXPECT_EQ(objective.value(summary_of(objective, zeros, {})), 0.);
  EXPECT_TRUE(objective.of_faces().is_average());
}

TEST(Radius_derivatives, are_those_of_the_sum_over_all_but_the_slivers)
{
  using Energy = SP::Symmetric_Dirichlet_energy_3;
  const Face_energy<Energy> energy{Energy()};
  const Triangle_list list = bumpy_sphere(3);
  for(const bool has_slivers : {false, true})
  {
    const Surface mesh = surface_of(has_slivers ? with_slivers(list, 6, 1e-4) : list);
    const Images positions = directions_of(mesh.points());
    using Space = SP::internal::Round_sphere<Energy, Newton_step>;
    Block_coordinate_descent<Space, Newton_step> descent(Space{energy}, Newton_step(), Execution());
    descent.assign(mesh.rings(), SP::internal::Independent_sets(mesh.rings()), mesh.points(), {},
                   SP::internal::Rest_limits(), SP::internal::sliver_vertices(mesh.rings(), mesh.points()));
    ASSERT_EQ(descent.has_slivers(), has_slivers);
    for(const double beta : {0., 20.})
    {
      Objective objective(Sharpness::relative(beta), true);
      objective.set_sliver_radius(has_slivers ? 0.9 : 0.);
      objective.start_sweep(0, descent.measure(positions, 1.1, objective.of_faces()));
      const Face_objective& of_faces = objective.of_faces();
      Mesh_summary summary = descent.measure(positions, 1.1, of_faces);
      EXPECT_EQ(summary.ordinary.size() + summary.slivers.size(), static_cast<double>(mesh.rings().number_of_faces()));
      EXPECT_EQ(summary.slivers.is_empty(), !has_slivers);
      const double a = beta > 0. ? of_faces.share : 0., s = of_faces.ordinary.sharpness, R = of_faces.ordinary.level;
      const auto psi = [&](double e) { return beta > 0. ? (1. - a) * e + a / s * std::exp(s * (e - R)) : e; };
      // from the summary, which leaves out the slivers, and with flat areas from the faces
      const auto sum = [&](double radius) {
        const Energy_summary ordinary = descent.summary(radius, of_faces).ordinary;
        const double linear = (1. - a) * ordinary.average();
        return ordinary.size() *
               (beta > 0. ? linear + a / s * std::exp(s * (ordinary.exponential_mean() - R)) : linear);
      };
      const auto flat_sum = [&](double radius) {
        const double scale = radius / 1.1 * (radius / 1.1);
        double result = 0.;
        for(const SP::Face_invariants_3& face : descent.faces())
          result += psi(energy(scale * face.i, scale * face.flat_d));
        return result;
      };
      const auto expect_derivatives = [&](const auto& f, double SP::Face_invariants_3::*area_ratio) {
        for(const double radius : {1., 1.1, 1.3})
        {
          const auto [first, second, size] = descent.radius_derivatives(radius, of_faces, area_ratio);
          const double h = 1e-4, up = f(radius * std::exp(h)), down = f(radius * std::exp(-h)), here = f(radius);
          EXPECT_NEAR(first, (up - down) / (2. * h), 1e-5 * size);
          EXPECT_NEAR(second, (up - 2. * here + down) / (h * h), 1e-5 * std::abs(second) + 1e-4 * size);
          EXPECT_GT(std::abs(second), 0.1 * size);
        }
      };
      expect_derivatives(sum, &SP::Face_invariants_3::d);
      if(!has_slivers)
        expect_derivatives(flat_sum, &SP::Face_invariants_3::flat_d);
    }
  }
}

} // namespace
