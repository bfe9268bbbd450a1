// The energies of a triangle: values by their definition in the singular values, derivatives by central differences, and
// the scale that minimises a sum of energies by a search.

#include <CGAL/Spherical_parameterization/Conformal_energy_3.h>
#include <CGAL/Spherical_parameterization/Face_invariants_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/Energy_summary.h>
#include <CGAL/Spherical_parameterization/internal/Guarded_energy.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

// log-uniform in [1 / range, range]
double random_factor(std::mt19937& random, double range)
{
  const double t = static_cast<double>(random()) / 0x1p32;
  return std::pow(range, 2. * t - 1.);
}

using Definition = std::function<long double(long double, long double)>; // of the singular values

template <class Energy>
void expect_definition(const Energy& energy, const Definition& definition)
{
  std::mt19937 random(1);
  for(int k = 0; k < 1000; ++k)
  {
    const double s1 = random_factor(random, 1e3), s2 = random_factor(random, 1e3);
    const double reference = static_cast<double>(definition(s1, s2));
    const double value = energy(s1 * s1 + s2 * s2, s1 * s2);
    ASSERT_NEAR(value, reference, 1e-14 * reference);
    ASSERT_GE(value, 2. * (1. - 1e-14));
  }
  EXPECT_DOUBLE_EQ(energy(2., 1.), 2.);
}

template <class Energy>
void expect_derivatives(const Energy& energy)
{
  std::mt19937 random(2);
  for(int k = 0; k < 1000; ++k)
  {
    const double s1 = random_factor(random, 100.), s2 = random_factor(random, 100.);
    const double i = s1 * s1 + s2 * s2, d = s1 * s2;
    const double hi = 1e-4 * i, hd = 1e-4 * d;
    const SP::Energy_derivatives_3 e = energy.derivatives(i, d);
    ASSERT_NEAR(e.value, energy(i, d), 1e-14 * e.value);

    // The error of a central difference is a sixth of the third derivative times the square of the step, and the energies
    // have no higher power than the -4th in d.
    const double tolerance = 1e-6 * e.value;
    ASSERT_NEAR(e.i * i, (energy(i + hi, d) - energy(i - hi, d)) / (2. * hi) * i, tolerance);
    ASSERT_NEAR(e.d * d, (energy(i, d + hd) - energy(i, d - hd)) / (2. * hd) * d, tolerance);
    const SP::Energy_derivatives_3 i1 = energy.derivatives(i + hi, d), i0 = energy.derivatives(i - hi, d);
    const SP::Energy_derivatives_3 d1 = energy.derivatives(i, d + hd), d0 = energy.derivatives(i, d - hd);
    ASSERT_NEAR(e.ii * i * i, (i1.i - i0.i) / (2. * hi) * i * i, tolerance);
    ASSERT_NEAR(e.id * i * d, (i1.d - i0.d) / (2. * hi) * i * d, tolerance);
    ASSERT_NEAR(e.id * i * d, (d1.i - d0.i) / (2. * hd) * i * d, tolerance);
    ASSERT_NEAR(e.dd * d * d, (d1.d - d0.d) / (2. * hd) * d * d, tolerance);
  }
}

std::vector<SP::Face_invariants_3> random_faces(std::uint32_t seed, double scale)
{
  std::mt19937 random(seed);
  std::vector<SP::Face_invariants_3> faces;
  for(int k = 0; k < 50; ++k)
  {
    const double s1 = scale * random_factor(random, 5.), s2 = scale * random_factor(random, 5.);
    const double area = random_factor(random, 10.), flatness = 1. + random_factor(random, 10.);
    faces.push_back({area, s1 * s1 + s2 * s2, s1 * s2, flatness * s1 * s2});
  }
  return faces;
}

template <class Energy>
double total_energy(const Energy& energy, const std::vector<SP::Face_invariants_3>& faces, double scale)
{
  double total = 0.;
  for(const SP::Face_invariants_3& face : faces)
  {
    total += energy(scale * scale * face.i, scale * scale * face.d);
  }
  return total;
}

// golden section search in the logarithm of the scale
template <class Energy>
double best_scale(const Energy& energy, const std::vector<SP::Face_invariants_3>& faces)
{
  const double ratio = 0.5 * (std::sqrt(5.) - 1.);
  double a = -20., b = 20.;
  while(b - a > 1e-9)
  {
    const double c = b - ratio * (b - a), d = a + ratio * (b - a);
    if(total_energy(energy, faces, std::exp(c)) < total_energy(energy, faces, std::exp(d)))
    {
      b = d;
    }
    else
    {
      a = c;
    }
  }
  return std::exp(0.5 * (a + b));
}

template <class Energy>
void expect_optimal_scale(const Energy& energy)
{
  for(std::uint32_t seed = 0; seed < 20; ++seed)
  {
    const std::vector<SP::Face_invariants_3> faces = random_faces(seed, std::pow(10., static_cast<int>(seed % 7) - 3.));
    const double scale = energy.optimal_scale(faces);
    EXPECT_NEAR(scale / best_scale(energy, faces), 1., 1e-6); // a search finds a minimum to half of the digits
    const double least = total_energy(energy, faces, scale);
    EXPECT_LT(least, total_energy(energy, faces, 1.0001 * scale));
    EXPECT_LT(least, total_energy(energy, faces, 0.9999 * scale));
  }
}

Definition blend(long double alpha)
{
  return [alpha](long double s1, long double s2) {
    return alpha * (s1 / s2 + s2 / s1) + (1.L - alpha) * (s1 * s2 + 1.L / (s1 * s2));
  };
}

TEST(Symmetric_Dirichlet_energy, has_its_definition_and_derivatives)
{
  const SP::Symmetric_Dirichlet_energy_3 energy;
  expect_definition(energy, [](long double s1, long double s2) {
    return (s1 * s1 + s2 * s2 + 1.L / (s1 * s1) + 1.L / (s2 * s2)) / 2.L;
  });
  expect_derivatives(energy);
  expect_optimal_scale(energy);
}

TEST(Symmetric_Dirichlet_energy, grows_with_the_square_of_the_isometric_distortion)
{
  const SP::Symmetric_Dirichlet_energy_3 energy;
  std::mt19937 random(3);
  for(int k = 0; k < 100; ++k)
  {
    const double s1 = random_factor(random, 1e3), s2 = random_factor(random, 1e3);
    const double isometric = (std::max)({s1, s2, 1. / s1, 1. / s2});
    const double value = energy(s1 * s1 + s2 * s2, s1 * s2);
    EXPECT_GE(value, 0.5 * isometric * isometric);
    EXPECT_LE(value, 2. * isometric * isometric * (1. + 1e-14));
  }
}

TEST(Isometric_energy, has_its_definition_and_derivatives)
{
  EXPECT_EQ(SP::Isometric_energy_3().alpha(), 0.5);
  for(const double alpha : {0.1, 0.5, 0.9, 1.})
  {
    const SP::Isometric_energy_3 energy(alpha);
    expect_definition(energy, blend(alpha));
    expect_derivatives(energy);
    if(alpha < 1.)
    {
      expect_optimal_scale(energy);
    }
  }
}

TEST(Isometric_energy, knows_the_range_of_its_weight)
{
  EXPECT_TRUE(SP::Isometric_energy_3(1e-3).is_valid());
  EXPECT_TRUE(SP::Isometric_energy_3(1.).is_valid());
  EXPECT_FALSE(SP::Isometric_energy_3(0.).is_valid());
  EXPECT_FALSE(SP::Isometric_energy_3(1.001).is_valid());
  EXPECT_FALSE(SP::Isometric_energy_3(std::nan("")).is_valid());
}

TEST(Conformal_energy, has_its_definition_and_derivatives)
{
  const SP::Conformal_energy_3 energy;
  expect_definition(energy, blend(1.));
  expect_derivatives(energy);
}

TEST(Conformal_energy, does_not_depend_on_the_radius)
{
  const SP::Conformal_energy_3 energy;
  EXPECT_EQ(energy.optimal_scale(random_faces(1, 1.)), 1.);
  std::mt19937 random(4);
  for(int k = 0; k < 100; ++k)
  {
    const double s1 = random_factor(random, 1e3), s2 = random_factor(random, 1e3), q = random_factor(random, 1e3);
    const double i = s1 * s1 + s2 * s2, d = s1 * s2;
    EXPECT_NEAR(energy(q * i, q * d), energy(i, d), 1e-14 * energy(i, d));
  }
}

TEST(Guarded_energy, adds_a_share_of_the_area_distortion)
{
  const double weight = 0.01;
  const SP::internal::Guarded_energy<SP::Conformal_energy_3> energy(SP::Conformal_energy_3(), weight);
  std::mt19937 random(5);
  for(int k = 0; k < 100; ++k)
  {
    const double s1 = random_factor(random, 1e3), s2 = random_factor(random, 1e3);
    const double reference = s1 / s2 + s2 / s1 + weight * (s1 * s2 + 1. / (s1 * s2));
    EXPECT_NEAR(energy(s1 * s1 + s2 * s2, s1 * s2), reference, 1e-13 * reference);
  }
  expect_derivatives(energy);
}

// The mean that the stopping rule looks at, from one summary and from the summaries of parts.
TEST(Energy_summary, agrees_with_the_definition_of_the_means)
{
  std::mt19937 random(6);
  std::vector<double> energies;
  for(int k = 0; k < 1000; ++k)
  {
    energies.push_back(2. * random_factor(random, 4.));
  }
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
      SP::internal::Energy_summary total(s);
      total.add(SP::internal::Energy_summary(s)); // an empty part
      for(std::size_t first = 0; first < energies.size(); first += part)
      {
        SP::internal::Energy_summary summary(s);
        summary.add_all<double>(energies.data() + first, (std::min)(std::size_t(part), energies.size() - first));
        total.add(summary);
      }
      EXPECT_NEAR(total.average(), average, 1e-12 * average);
      EXPECT_EQ(total.largest(), *std::max_element(energies.begin(), energies.end()));
      EXPECT_NEAR(total.mean(), mean, 1e-10 * mean);
    }
  }
}

TEST(Energy_summary, does_not_overflow)
{
  SP::internal::Energy_summary summary(1e3);
  for(const double energy : {2., 1e10, 5.})
  {
    summary.add_all<double>(&energy, 1);
  }
  EXPECT_NEAR(summary.mean(), 1e10 - std::log(3.) / 1e3, 1e-5);
}

} // namespace
