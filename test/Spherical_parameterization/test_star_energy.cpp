// The energy of a star as a function of its vertex: the value from the positions in space, gradient and Hessian in the
// tangential coordinates by central differences, and the Newton update on it.

#include <CGAL/Spherical_parameterization/Determinant_barrier_3.h>
#include <CGAL/Spherical_parameterization/Flat_area_barrier_3.h>
#include <CGAL/Spherical_parameterization/Gradient_update_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Newton_update_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/Star_energy.h>
#include <CGAL/Spherical_parameterization/internal/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/update_on_coarse_levels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using SP::internal::Rest_triangle;
using SP::internal::Star_energy;
using SP::internal::Star_packets;
using SP::internal::Tangent_frame;
using SP::internal::Vector_3d;
using SP::internal::Vertex_rings;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979323846;

double uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * static_cast<double>(random()) / 0x1p32;
}

// The star of a vertex somewhere on the unit sphere: a ring of `degree` vertices about `size` away, and faces whose
// shape on the surface is any, of about the size of their images.
struct Random_star
{
  Random_star(std::mt19937& random, std::size_t degree, double size)
    : center(SP::internal::normalized({uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)}))
  {
    const Tangent_frame frame(center);
    for(std::size_t j = 0; j < degree; ++j)
    {
      const double angle = 2. * pi * (static_cast<double>(j) + uniform(random, 0., 0.4)) / static_cast<double>(degree);
      const double r = size * uniform(random, 0.6, 1.);
      positions.push_back(frame.point_at(r * std::cos(angle), r * std::sin(angle)));
      rings.push_neighbor(static_cast<std::uint32_t>(j));
      const auto coordinate = [&]() { return size * uniform(random, -1., 1.); };
      rests.push_back(Rest_triangle::from_points({coordinate(), coordinate(), coordinate()},
                                                 {coordinate(), coordinate(), coordinate()},
                                                 {coordinate(), coordinate(), coordinate()}));
    }
    rings.end_ring();
  }

  // what Star_packets asks for
  std::size_t degree() const { return positions.size(); }
  std::uint32_t neighbor(std::size_t j) const { return rings.ring(0)[j]; }
  Rest_triangle rest(std::size_t j) const { return rests[j]; }

  // The center is the last of the points.
  template <class Star>
  void load_into(Star& star) const
  {
    points = positions;
    points.push_back(center);
    packets.assign({static_cast<std::uint32_t>(degree())}, {0, 1}, [&](std::uint32_t) { return degree(); });
    packets.fill(0, [&](std::uint32_t) -> const Random_star& { return *this; });
    star.load(packets.view<double>(packets.packet(0), 0), points.data());
  }

  // The energies of the faces with the vertex at u, with the invariants from edge lengths and a determinant or a flat
  // area; infinite where a face is not positive.
  template <class Barrier, class Energy>
  std::vector<double> energies(const Energy& energy, const Vector_3d& u, double squared_radius) const
  {
    std::vector<double> result;
    for(std::size_t j = 0; j < positions.size(); ++j)
    {
      const std::array<const Vector_3d*, 3> x = {&u, &positions[j], &positions[(j + 1) % positions.size()]};
      const auto edge = [&](std::size_t a, std::size_t b, std::size_t k) {
        return static_cast<long double>((*x[b])[k]) - (*x[a])[k];
      };
      const auto squared_length = [&](std::size_t a, std::size_t b) {
        return edge(a, b, 0) * edge(a, b, 0) + edge(a, b, 1) * edge(a, b, 1) + edge(a, b, 2) * edge(a, b, 2);
      };
      // det(u, p, q) = det(u, p - u, q - u)
      const long double determinant = u[0] * (edge(0, 1, 1) * edge(0, 2, 2) - edge(0, 1, 2) * edge(0, 2, 1)) +
                                      u[1] * (edge(0, 1, 2) * edge(0, 2, 0) - edge(0, 1, 0) * edge(0, 2, 2)) +
                                      u[2] * (edge(0, 1, 0) * edge(0, 2, 1) - edge(0, 1, 1) * edge(0, 2, 0));
      const Rest_triangle& r = rests[j];
      const long double i =
          squared_radius * (r.opposite_0 * squared_length(1, 2) + r.opposite_1 * squared_length(2, 0) +
                            r.opposite_2 * squared_length(0, 1));
      // Heron's formula, as twice the area
      const long double pp = squared_length(1, 2), pq = squared_length(2, 0), qq = squared_length(0, 1);
      const long double flat = 0.5L * std::sqrt((std::max)(4.L * pp * pq - (pp + pq - qq) * (pp + pq - qq), 0.L));
      const bool is_flat = std::is_same<Barrier, SP::Flat_area_barrier_3>::value;
      const long double d = squared_radius * r.inverse_area * (is_flat ? flat : determinant);
      result.push_back(determinant > 0.L ? energy(static_cast<double>(i), static_cast<double>(d)) : infinity);
    }
    return result;
  }

  Vector_3d center;
  std::vector<Vector_3d> positions;
  Vertex_rings rings;
  std::vector<Rest_triangle> rests;

private:
  // what the star that has been loaded refers to
  mutable std::vector<Vector_3d> points;
  mutable Star_packets packets;
};

template <class Energy_, class Barrier_>
struct Model
{
  using Energy = Energy_;
  using Barrier = Barrier_;
  using Star = Star_energy<Energy, Barrier>;
};

template <class Model>
class Star_energy_test : public ::testing::Test
{};

using Models = ::testing::Types<Model<SP::Symmetric_Dirichlet_energy_3, SP::Determinant_barrier_3>,
                                Model<SP::Isometric_energy_3, SP::Determinant_barrier_3>,
                                Model<SP::Symmetric_Dirichlet_energy_3, SP::Flat_area_barrier_3>,
                                Model<SP::Isometric_energy_3, SP::Flat_area_barrier_3>>;
TYPED_TEST_SUITE(Star_energy_test, Models, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Star_energy_test, is_the_sum_over_the_faces)
{
  const typename TypeParam::Energy energy;
  std::mt19937 random(1);
  typename TypeParam::Star star(energy); // one object for all stars, larger and smaller ones
  for(int k = 0; k < 300; ++k)
  {
    const double sizes[] = {0.6, 0.1, 1e-3, 1e-6};
    const double size = sizes[k % 4];
    const Random_star faces(random, 3 + random() % 12, size);
    const double squared_radius = uniform(random, 0.5, 2.);
    for(const double relative_sharpness : {0., 0.5, 12.})
    {
      const std::vector<double> at_center =
          faces.template energies<typename TypeParam::Barrier>(energy, faces.center, squared_radius);
      const double largest = *std::max_element(at_center.begin(), at_center.end());
      const double sharpness = relative_sharpness / largest;
      star.set_objective(squared_radius, sharpness);
      faces.load_into(star);

      std::array<double, 2> gradient;
      std::array<double, 3> hessian;
      const double f = star.derivatives(gradient, hessian);
      EXPECT_NEAR(f, star(0., 0.), 1e-9 * f);
      std::array<double, 2> gradient_alone;
      EXPECT_EQ(star.gradient(gradient_alone), f);
      EXPECT_EQ(gradient_alone, gradient);

      const double x = 0.2 * size * uniform(random, -1., 1.), y = 0.2 * size * uniform(random, -1., 1.);
      double sum = 0., amplification = 1.; // of the relative error, by the exponential
      for(const double e :
          faces.template energies<typename TypeParam::Barrier>(energy, star.point_at(x, y), squared_radius))
      {
        sum += sharpness > 0. ? std::exp(sharpness * (e - largest)) : e;
        amplification = (std::max)(amplification, sharpness * e);
      }
      // The positions in space are rounded to 1e-16 of the radius, the offsets are not.
      const double tolerance = amplification * (1e-10 + 1e-13 / size);
      if(sum < infinity)
      {
        EXPECT_NEAR(star(x, y), sum, tolerance * sum);
      }
      else
      {
        EXPECT_EQ(star(x, y), infinity);
      }
    }
  }
}

TYPED_TEST(Star_energy_test, has_the_derivatives_of_its_value)
{
  std::mt19937 random(2);
  typename TypeParam::Star star((typename TypeParam::Energy()));
  for(int k = 0; k < 300; ++k)
  {
    const double sizes[] = {0.6, 0.1, 1e-3, 1e-6};
    const Random_star faces(random, 3 + random() % 8, sizes[k % 4]);
    const double squared_radius = uniform(random, 0.5, 2.);
    const std::vector<double> energies = faces.template energies<typename TypeParam::Barrier>(
        typename TypeParam::Energy(), faces.center, squared_radius);
    for(const double relative_sharpness : {0., 1., 12.})
    {
      star.set_objective(squared_radius, relative_sharpness / *std::max_element(energies.begin(), energies.end()));
      faces.load_into(star);
      std::array<double, 2> g;
      std::array<double, 3> h;
      const double f = star.derivatives(g, h);

      // Everything in units of the shortest edge, of which the step is so small a part that the star does not notice,
      // and so large that rounding does not matter.
      const double unit = star.shortest_edge(), step = 2e-4 * unit;
      const double fx = star(step, 0.), fX = star(-step, 0.), fy = star(0., step), fY = star(0., -step);
      const double scale = f + unit * std::hypot(g[0], g[1]) + unit * unit * (std::abs(h[0]) + std::abs(h[2]));
      EXPECT_NEAR(g[0] * unit, (fx - fX) / (2. * step) * unit, 1e-4 * scale);
      EXPECT_NEAR(g[1] * unit, (fy - fY) / (2. * step) * unit, 1e-4 * scale);
      const double unit2 = unit * unit, step2 = step * step;
      EXPECT_NEAR(h[0] * unit2, (fx - 2. * f + fX) / step2 * unit2, 1e-3 * scale);
      EXPECT_NEAR(h[2] * unit2, (fy - 2. * f + fY) / step2 * unit2, 1e-3 * scale);
      const double mixed = (star(step, step) - star(step, -step) - star(-step, step) + star(-step, -step));
      EXPECT_NEAR(h[1] * unit2, mixed / (4. * step2) * unit2, 1e-3 * scale);
    }
  }
}

TYPED_TEST(Star_energy_test, is_infinite_where_a_face_is_not_positive)
{
  std::mt19937 random(3);
  typename TypeParam::Star star((typename TypeParam::Energy()));
  for(int k = 0; k < 100; ++k)
  {
    const double size = k % 2 == 0 ? 0.5 : 1e-4;
    const Random_star faces(random, 5, size);
    faces.load_into(star);
    EXPECT_LT(star(0., 0.), infinity);
    double shortest = infinity;
    for(const Vector_3d& p : faces.positions)
    {
      shortest =
          (std::min)(shortest, std::hypot(p[0] - faces.center[0], p[1] - faces.center[1], p[2] - faces.center[2]));
    }
    EXPECT_NEAR(star.shortest_edge(), shortest, 1e-9 * shortest);
    for(int j = 0; j < 12; ++j)
    {
      const double angle = 2. * pi * j / 12.;
      EXPECT_EQ(star(1.1 * size * std::cos(angle), 1.1 * size * std::sin(angle)), infinity);
    }
    EXPECT_EQ(star(2., 0.), infinity); // beyond the sphere
    EXPECT_EQ(star(std::nan(""), 0.), infinity);
  }
}

// exp(s E) is beyond doubles, exp(s (E - largest E)) is not.
TYPED_TEST(Star_energy_test, does_not_overflow)
{
  std::mt19937 random(4);
  typename TypeParam::Star star((typename TypeParam::Energy()));
  for(const double sharpness : {1e3, 1e6})
  {
    const Random_star faces(random, 6, 0.1);
    star.set_objective(1., sharpness);
    faces.load_into(star);
    std::array<double, 2> g;
    std::array<double, 3> h;
    const double f = star.derivatives(g, h);
    EXPECT_GE(f, 1. - 1e-9); // the sharpness times the rounding of an energy
    EXPECT_LE(f, 6.);
    EXPECT_TRUE(std::isfinite(g[0] + g[1] + h[0] + h[1] + h[2]));
    EXPECT_GT(std::hypot(g[0], g[1]), 0.);
  }
}

// Whatever the star, the update goes downhill or stays.
TYPED_TEST(Star_energy_test, is_lowered_by_the_newton_update)
{
  std::mt19937 random(5);
  typename TypeParam::Star star((typename TypeParam::Energy()));
  for(const double over_relaxation : {1., 1.9})
  {
    const SP::Newton_update_3 update(over_relaxation);
    int n_moves = 0;
    for(int k = 0; k < 200; ++k)
    {
      const Random_star faces(random, 3 + random() % 8, k % 2 == 0 ? 0.5 : 1e-5);
      star.set_objective(1., k % 3 == 0 ? 0. : 0.5);
      faces.load_into(star);
      std::array<double, 2> step = {-7., -7.};
      if(update(star, step))
      {
        ++n_moves;
        EXPECT_LT(star(step[0], step[1]), star(0., 0.));
      }
      else
      {
        EXPECT_EQ(step, (std::array<double, 2>{-7., -7.}));
      }
    }
    EXPECT_GE(n_moves, 195); // a random star is hardly ever at its minimum
  }
}

TYPED_TEST(Star_energy_test, is_lowered_by_the_gradient_update)
{
  std::mt19937 random(9);
  typename TypeParam::Star star((typename TypeParam::Energy()));
  const SP::Gradient_update_3 update;
  int n_moves = 0;
  for(int k = 0; k < 200; ++k)
  {
    const Random_star faces(random, 3 + random() % 8, k % 2 == 0 ? 0.5 : 1e-5);
    star.set_objective(1., k % 3 == 0 ? 0. : 0.5);
    faces.load_into(star);
    std::array<double, 2> step = {-7., -7.}, g;
    if(update(star, step))
    {
      ++n_moves;
      EXPECT_LT(star(step[0], step[1]), star(0., 0.));
      EXPECT_LE(std::hypot(step[0], step[1]), star.shortest_edge());
      star.gradient(g);
      EXPECT_NEAR(step[0] * g[1], step[1] * g[0], 1e-12 * std::hypot(step[0], step[1]) * std::hypot(g[0], g[1]));
    }
    else
    {
      EXPECT_EQ(step, (std::array<double, 2>{-7., -7.}));
    }
  }
  EXPECT_GE(n_moves, 195);
}

// A few updates of one vertex lead to a point where the gradient vanishes.
TYPED_TEST(Star_energy_test, is_minimised_by_newton_updates)
{
  std::mt19937 random(6);
  typename TypeParam::Star star((typename TypeParam::Energy()));
  const SP::Newton_update_3 update(1.);
  for(int k = 0; k < 50; ++k)
  {
    Random_star faces(random, 6, 0.1);
    star.set_objective(1., k % 2 == 0 ? 0. : 0.1);
    faces.load_into(star);
    std::array<double, 2> g, step;
    std::array<double, 3> h;
    star.derivatives(g, h);
    const double start = std::hypot(g[0], g[1]) * star.shortest_edge() / star(0., 0.);
    for(int i = 0; i < 60 && update(star, step); ++i)
    {
      faces.center = star.point_at(step[0], step[1]);
      faces.load_into(star);
    }
    star.derivatives(g, h);
    EXPECT_GT(start, 1e-4);
    EXPECT_LT(std::hypot(g[0], g[1]) * star.shortest_edge() / star(0., 0.), 1e-7);
  }
}

// A quadratic function with the given eigenvalues and axes, as a vertex energy: where Newton's method is exact.
struct Quadratic
{
  double derivatives(std::array<double, 2>& gradient, std::array<double, 3>& hessian) const
  {
    gradient = g;
    hessian = h;
    return value;
  }
  double operator()(double x, double y) const
  {
    return value + g[0] * x + g[1] * y + 0.5 * (h[0] * x * x + 2. * h[1] * x * y + h[2] * y * y);
  }
  double shortest_edge() const { return 1.; }

  double value;
  std::array<double, 2> g;
  std::array<double, 3> h;
};

TEST(Newton_update, is_the_newton_step_where_the_hessian_is_positive)
{
  std::mt19937 random(7);
  for(int k = 0; k < 200; ++k)
  {
    const double angle = uniform(random, 0., 2. * pi), c = std::cos(angle), s = std::sin(angle);
    const double a = uniform(random, 0.1, 5.), b = uniform(random, 0.1, 5.);
    const Quadratic f = {3.,
                         {uniform(random, -1., 1.), uniform(random, -1., 1.)},
                         {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c}};
    const double determinant = a * b;
    const std::array<double, 2> newton = {-(f.h[2] * f.g[0] - f.h[1] * f.g[1]) / determinant,
                                          -(f.h[0] * f.g[1] - f.h[1] * f.g[0]) / determinant};
    for(const double over_relaxation : {1., 1.5})
    {
      std::array<double, 2> step;
      ASSERT_TRUE(SP::Newton_update_3(over_relaxation)(f, step));
      EXPECT_NEAR(step[0], over_relaxation * newton[0], 1e-12 * (1. + std::abs(newton[0])));
      EXPECT_NEAR(step[1], over_relaxation * newton[1], 1e-12 * (1. + std::abs(newton[1])));
    }
  }
}

TEST(Newton_update, takes_the_absolute_values_of_the_eigenvalues)
{
  std::mt19937 random(8);
  for(int k = 0; k < 200; ++k)
  {
    const double angle = uniform(random, 0., 2. * pi), c = std::cos(angle), s = std::sin(angle);
    const double a = uniform(random, -5., 5.), b = uniform(random, -5., 5.);
    if((std::min)(std::abs(a), std::abs(b)) < 0.01)
    {
      continue;
    }
    const Quadratic f = {3.,
                         {uniform(random, -1., 1.), uniform(random, -1., 1.)},
                         {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c}};
    const double ga = c * f.g[0] + s * f.g[1], gb = -s * f.g[0] + c * f.g[1];
    const double x = -ga / std::abs(a), y = -gb / std::abs(b);
    std::array<double, 2> step;
    ASSERT_TRUE(SP::Newton_update_3(1.)(f, step));
    // along the eigenvectors, up to the halvings
    const double along_a = c * step[0] + s * step[1], along_b = -s * step[0] + c * step[1];
    EXPECT_NEAR(along_a * y, along_b * x, 1e-10 * (1. + std::abs(x * y)));
    EXPECT_GT(along_a * x + along_b * y, 0.);
    EXPECT_LT(f(step[0], step[1]), f.value);
  }
}

TEST(Newton_update, stays_where_there_is_nothing_to_do)
{
  const SP::Newton_update_3 update;
  std::array<double, 2> step;
  EXPECT_FALSE(update(Quadratic{1., {0., 0.}, {1., 0., 1.}}, step));
  EXPECT_FALSE(update(Quadratic{1., {1., 0.}, {0., 0., 0.}}, step));
  EXPECT_FALSE(update(Quadratic{1., {infinity, 0.}, {infinity, 0., 1.}}, step));
  EXPECT_FALSE(update(Quadratic{1., {std::nan(""), 0.}, {1., 0., 1.}}, step));
}

TEST(Newton_update, knows_the_range_of_its_factor)
{
  EXPECT_TRUE(SP::Newton_update_3(1.).is_valid());
  EXPECT_TRUE(SP::Newton_update_3(1.99).is_valid());
  EXPECT_FALSE(SP::Newton_update_3(0.99).is_valid());
  EXPECT_FALSE(SP::Newton_update_3(2.).is_valid());
  EXPECT_FALSE(SP::Newton_update_3(std::nan("")).is_valid());
  EXPECT_EQ(SP::Newton_update_3(1.5).over_relaxation(), 1.5);
}

// Inherits on_coarse_levels(), which returns the base, and so is not called.
struct Derived_update : SP::Newton_update_3
{
  using SP::Newton_update_3::Newton_update_3;
};

TEST(Newton_update, is_more_careful_on_coarse_levels)
{
  EXPECT_EQ(SP::Newton_update_3().on_coarse_levels().over_relaxation(), 1.7);
  EXPECT_EQ(SP::Newton_update_3(1.2).on_coarse_levels().over_relaxation(), 1.2);
  EXPECT_EQ(SP::internal::update_on_coarse_levels(SP::Newton_update_3()).over_relaxation(), 1.7);
  EXPECT_EQ(SP::internal::update_on_coarse_levels(Derived_update(1.8)).over_relaxation(), 1.8);
}

} // namespace
