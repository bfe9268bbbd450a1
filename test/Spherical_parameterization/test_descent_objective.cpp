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

Energy_summary summary_of(const Objective& objective, const Energies& energies)
{
  Energy_summary result(objective.of_faces().sharpness);
  result.add_all<double>(energies.data(), nullptr, energies.size());
  return result;
}

// The objective with its level at the minimum for these energies.
Objective at_best_level(double beta, const Energies& energies)
{
  Objective objective(Sharpness::relative(beta), true);
  objective.set_final_sharpness();
  objective.start_sweep(0, summary_of(objective, energies));
  for(int k = 0; k < 100 && objective.improve_level(summary_of(objective, energies)) > 1e-13; ++k)
    ;
  return objective;
}

// S at the level R, as it is defined
long double soft_maximum(const Energies& energies, long double b, long double R)
{
  long double sum = 0.;
  for(const double e : energies)
    sum += std::exp(b * (e / R - 1.));
  return (1. - 1. / b) * R + R / b * sum / static_cast<long double>(energies.size());
}

// the level at least `min` of its minimum, by a search; S is convex
long double best_level(const Energies& energies, long double b, long double min)
{
  long double low = std::log(min),
              high = std::log((std::max)(2. * min, 2.L * *std::max_element(energies.begin(), energies.end())));
  for(int k = 0; k < 200; ++k)
  {
    const long double first = low + (high - low) / 3., second = high - (high - low) / 3.;
    if(soft_maximum(energies, b, std::exp(first)) < soft_maximum(energies, b, std::exp(second)))
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
      const double average = mean(energies), largest = *std::max_element(energies.begin(), energies.end());
      const Objective objective = at_best_level(beta, energies);
      const double value = objective.value(summary_of(objective, energies));
      const long double b = beta + 1., a = beta / (beta + 40.),
                        s = soft_maximum(energies, b, best_level(energies, b, 0.5 * average));
      const double expected = static_cast<double>((1. - a) * average + a * s);
      EXPECT_NEAR(value, expected, 1e-10 * expected) << beta << ' ' << largest;
      EXPECT_GE(value, average * (1. - 1e-12));
      EXPECT_LE(value, largest * (1. + 1e-12));
      // It is as large as all energies where all are the same.
      EXPECT_GE(objective.of_faces().level, average * (1. - 1e-9));
      EXPECT_LE(objective.of_faces().level, largest * (1. + 1e-9));
      EXPECT_EQ(objective.of_faces().sharpness, static_cast<double>(b) / objective.of_faces().level);
    }
}

// A dial beyond that of the default starts there.
TEST(Objective, turns_the_dial_once)
{
  for(const double beta : {0., 3., 20.})
    EXPECT_FALSE(Objective(Sharpness::relative(beta), true).set_final_sharpness()) << beta;
  EXPECT_FALSE(Objective(Sharpness::schedule(), true).set_final_sharpness());
  const Energies energies = random_energies(100, 3.);
  Objective objective(Sharpness::lowest_worst(), true);
  objective.start_sweep(0, summary_of(objective, energies));
  EXPECT_NEAR(objective.of_faces().share, 1. / 3., 1e-15);
  EXPECT_NEAR(objective.of_faces().sharpness * objective.of_faces().level, 21., 1e-12);
  const double level = objective.of_faces().level;
  EXPECT_TRUE(objective.set_final_sharpness());
  EXPECT_EQ(objective.of_faces().share, 0.5);
  EXPECT_EQ(objective.of_faces().level, level);
  EXPECT_NEAR(objective.of_faces().sharpness * level, 41., 1e-12);
  EXPECT_FALSE(objective.set_final_sharpness());
}

TEST(Objective, does_not_overflow)
{
  for(const double beta : dials)
    for(const double size : {1e-300, 1e-150, 1e150, 1e160, 1e300})
      for(const Energies& energies : {Energies{size, 2. * size}, Energies{size, 1e-3 * size, 0.}, Energies{size}})
      {
        const Objective objective = at_best_level(beta, energies);
        const double value = objective.value(summary_of(objective, energies));
        EXPECT_GE(value, mean(energies) * (1. - 1e-9)) << beta << ' ' << size;
        EXPECT_LE(value, 2. * size) << beta << ' ' << size;
      }
  const Energies zeros(10, 0.); // an energy whose minimum is 0, reached by all faces
  const Objective objective = at_best_level(20., zeros);
  EXPECT_EQ(objective.value(summary_of(objective, zeros)), 0.);
  EXPECT_TRUE(objective.of_faces().is_average());
}

TEST(Radius_derivatives, are_those_of_the_sum)
{
  using Energy = SP::Symmetric_Dirichlet_energy_3;
  const Face_energy<Energy> energy{Energy()};
  const Surface mesh = surface_of(bumpy_sphere(3));
  const Images positions = directions_of(mesh.points());
  using Space = SP::internal::Round_sphere<Energy, Newton_step>;
  Block_coordinate_descent<Space, Newton_step> descent(Space{energy}, Newton_step(), Execution());
  descent.assign(mesh.rings(), SP::internal::Independent_sets(mesh.rings()), mesh.points(), {},
                 SP::internal::Rest_limits());
  for(const double beta : {0., 20.})
  {
    Objective objective(Sharpness::relative(beta), true);
    objective.start_sweep(0, descent.measure(positions, 1.1, objective.of_faces()));
    const Face_objective& of_faces = objective.of_faces();
    const double a = beta > 0. ? of_faces.share : 0., s = of_faces.sharpness, R = of_faces.level;
    const auto psi = [&](double e) { return beta > 0. ? (1. - a) * e + a / s * std::exp(s * (e - R)) : e; };
    const SP::Face_range_3 faces = descent.faces(positions, 1.1, of_faces);
    const std::vector<SP::Face_invariants_3> measured(faces.begin(), faces.end());
    for(const bool are_flat : {false, true})
    {
      const Energy_summary summary = descent.measure(positions, 1.1, of_faces, are_flat);
      EXPECT_EQ(summary.size(), static_cast<double>(mesh.rings().number_of_faces()));
      const auto sum = [&](double radius) {
        const double scale = radius / 1.1 * (radius / 1.1);
        double result = 0.;
        for(const SP::Face_invariants_3& face : measured)
          result += psi(energy(scale * face.i, scale * (are_flat ? face.flat_d : face.d)));
        return result;
      };
      for(const double radius : {1., 1.1, 1.3})
      {
        const auto [first, second, size] = descent.radius_derivatives(radius, of_faces);
        const double h = 1e-4, up = sum(radius * std::exp(h)), down = sum(radius * std::exp(-h)), here = sum(radius);
        EXPECT_NEAR(first, (up - down) / (2. * h), 1e-5 * size);
        EXPECT_NEAR(second, (up - 2. * here + down) / (h * h), 1e-5 * std::abs(second) + 1e-4 * size);
        EXPECT_GT(std::abs(second), 0.1 * size);
      }
    }
  }
}

} // namespace
