// Numbers in lanes, the frame at a point of the sphere, the areas of images and their derivatives, and energies of several
// faces at once.

#include <CGAL/Spherical_parameterization/Conformal_energy_3.h>
#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_energy.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include "archetypes.h"
#include "engine.h"
#include "long_doubles.h"
#include "random_meshes.h"

#include <gtest/gtest.h>

using namespace test;

namespace {

namespace SP = CGAL::Spherical_parameterization;

using namespace SP::internal;

template <class FT>
void expect_decisions_lane_by_lane()
{
  const FT a = Lanes<FT>::generate([](std::size_t i) { return static_cast<double>(i) - 1.; });
  const FT b = FT(0.5);
  const FT low = minimum(a, b), high = maximum(a, b), size = absolute(a), root = square_root(size);
  const FT chosen = select(a < b && !(a < FT(0.)), FT(7.), a), either = select(a < FT(0.) || a > b, FT(7.), -a);
  for(std::size_t i = 0; i < Lanes<FT>::width; ++i)
  {
    const double x = static_cast<double>(i) - 1.;
    EXPECT_EQ(lane(a < b, i), x < 0.5);
    EXPECT_EQ(lane(either, i), x < 0. || x > 0.5 ? 7. : -x);
    EXPECT_EQ(lane(low, i), x < 0.5 ? x : 0.5);
    EXPECT_EQ(lane(high, i), x < 0.5 ? 0.5 : x);
    EXPECT_EQ(lane(size, i), std::abs(x));
    EXPECT_EQ(lane(root, i), std::sqrt(std::abs(x)));
    EXPECT_EQ(lane(chosen, i), x < 0.5 && !(x < 0.) ? 7. : x);
  }
  EXPECT_TRUE(any(a < b));
  EXPECT_TRUE(any(a < FT(-0.5)));
  EXPECT_FALSE(any(a > FT(9.)));
  const std::array<float, 8> floats = {0.5f, 1.f, 1.5f, 2.f, 2.5f, 3.f, 3.5f, 4.f};
  std::array<double, 8> stored = {};
  Lanes<FT>::store(Lanes<FT>::load(floats.data()), stored.data());
  for(std::size_t i = 0; i < stored.size(); ++i)
    EXPECT_EQ(stored[i], i < Lanes<FT>::width ? static_cast<double>(floats[i]) : 0.);
  std::array<const float*, Lanes<FT>::width> rows;
  for(std::size_t l = 0; l < rows.size(); ++l)
    rows[l] = floats.data() + (3 * l) % 5;
  const std::array<FT, 4> columns = Lanes<FT>::load_columns(rows);
  for(std::size_t l = 0; l < rows.size(); ++l)
    for(std::size_t k = 0; k < columns.size(); ++k)
      EXPECT_EQ(lane(columns[k], l), static_cast<double>(rows[l][k]));
}

TEST(Packed_double, decides_lane_by_lane)
{
  expect_decisions_lane_by_lane<Two_lanes>();
  expect_decisions_lane_by_lane<Four_lanes>();
  run_in_lanes([](auto number_type) { expect_decisions_lane_by_lane<typename decltype(number_type)::FT>(); });
}

std::vector<Vector_3d> frame_origins()
{
  Random random(4);
  std::vector<Vector_3d> result = {{0., 0., 1.},  {0., 0., -1.},  {1., 0., 0.},   {0., -1., 0.},
                                   {0., 1., -0.}, {-1., 0., -0.}, {0.6, 0.8, 0.}, {0.6, -0.8, -0.}};
  for(int k = 0; k < 200; ++k)
  {
    Vector_3d n = random.in_cube();
    if(k % 4 == 0) // near a pole
      n[2] *= 1e9;
    else if(k % 4 == 2) // near the equator
    {
      n[0] *= 1e9;
      n[2] *= 1e-9;
    }
    result.push_back(normalized(n));
  }
  return result;
}

TEST(Tangent_frame, is_orthonormal_and_right_handed)
{
  for(const Vector_3d& n : frame_origins())
  {
    const Tangent_frame frame(n);
    // the axes, as differences of two points of the sphere that lie symmetric to the origin of the frame
    const Long_vector x = long_difference(frame.point_at(0.5, 0.), frame.point_at(-0.5, 0.));
    const Long_vector y = long_difference(frame.point_at(0., 0.5), frame.point_at(0., -0.5));
    EXPECT_NEAR(static_cast<double>(long_dot(x, x)), 1., 1e-15);
    EXPECT_NEAR(static_cast<double>(long_dot(y, y)), 1., 1e-15);
    EXPECT_NEAR(static_cast<double>(long_dot(x, y)), 0., 1e-15);
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      EXPECT_NEAR(static_cast<double>(x[j] * y[k] - x[k] * y[j]), n[i], 2e-15);
    }
  }
}

TEST(Tangent_frame, takes_a_point_to_its_offset_and_back)
{
  Random random(5);
  for(const Vector_3d& n : frame_origins())
  {
    const Tangent_frame frame(n);
    for(const double size : {0.7, 1e-3, 1e-6, 1e-12})
    {
      const double x = size * random.between(-1., 1.), y = size * random.between(-1., 1.);
      const Vector_3d p = frame.point_at(x, y), offset = frame.offset_of(p);
      EXPECT_NEAR(norm(p), 1., 1e-15);
      EXPECT_NEAR(offset[0], x, 1e-15); // the rounding of p
      EXPECT_NEAR(offset[1], y, 1e-15);
      EXPECT_NEAR(offset[2], Tangent_frame::height_at(x, y), 1e-15);
      // What makes tiny triangles work: the offset of a point that is near is as precise as the difference of the points.
      const Long_vector exact = long_difference(p, n);
      EXPECT_NEAR(norm(offset) / std::sqrt(static_cast<double>(long_dot(exact, exact))), 1., 2e-15);
    }
  }
}

TEST(Tangent_frame, has_precise_heights)
{
  for(const double size : {0.9, 0.5, 1e-3, 1e-8, 1e-100})
  {
    const long double t = static_cast<long double>(size) * size;
    // -t / 2 - t^2 / 8 - t^3 / 16 where sqrt(1 - t) - 1 would cancel
    const long double reference = size > 0.01 ? std::sqrt(1.L - t) - 1.L : -t * (0.5L + t * (0.125L + t / 16.L));
    const double height = Tangent_frame::height_at(0.6 * size, -0.8 * size);
    EXPECT_NEAR(height, static_cast<double>(reference), 1e-15 * std::abs(height));
  }
}

Vector_3d offset_at(double x, double y)
{
  return {x, y, Tangent_frame::height_at(x, y)};
}

template <class Measure, bool has_second_derivatives>
void expect_derivatives_of_measure()
{
  Random random(1);
  for(int k = 0; k < 200; ++k)
  {
    const double size = k % 2 == 0 ? 0.5 : 1e-2;
    const double first = random.between(0., 2. * pi), second = first + random.between(0.5, 2.);
    const Vector_3d p = offset_at(size * std::cos(first), size * std::sin(first));
    const Vector_3d q = offset_at(size * std::cos(second), size * std::sin(second));
    const Measure measure(p, q);
    const auto value_at = [&](double x, double y) {
      const Vector_3d u = offset_at(x, y), n = cross(difference(p, u), difference(q, u));
      return Measure::value(n[0] * u[0] + n[1] * u[1] + n[2] * (u[2] + 1.), n);
    };
    [[maybe_unused]] const double h = 1e-4 * size, h2 = h * h;
    const double f = value_at(0., 0.);
    EXPECT_NEAR(measure.value(), f, 1e-14 * size * size);
    EXPECT_NEAR(measure.dx(), (value_at(h, 0.) - value_at(-h, 0.)) / (2. * h), 1e-6 * size);
    EXPECT_NEAR(measure.dy(), (value_at(0., h) - value_at(0., -h)) / (2. * h), 1e-6 * size);
    if constexpr(has_second_derivatives)
    {
      EXPECT_NEAR(measure.dxx(), (value_at(h, 0.) - 2. * f + value_at(-h, 0.)) / h2, 1e-5);
      EXPECT_NEAR(measure.dyy(), (value_at(0., h) - 2. * f + value_at(0., -h)) / h2, 1e-5);
      const double mixed = value_at(h, h) - value_at(h, -h) - value_at(-h, h) + value_at(-h, -h);
      EXPECT_NEAR(mixed / (4. * h2), 0., 1e-5);
    }
  }
}

TEST(Image_measure, has_the_derivatives_of_its_value)
{
  expect_derivatives_of_measure<SP::internal::Determinant_measure<double>, true>();
  expect_derivatives_of_measure<SP::internal::Flat_measure<double>, false>();
}

// Whether an energy is written for lanes is seen from whether it can be called for them.
static_assert(is_lanewise<SP::Symmetric_Dirichlet_energy_3, Four_lanes>, "");
static_assert(is_lanewise<archetypes::Distortion_energy_in_lanes, Four_lanes>, "");
static_assert(!is_lanewise<archetypes::Distortion_energy, Four_lanes>, "");
static_assert(!is_lanewise<Hooked_energy, Four_lanes>, "");

// What is derived from an energy for lanes may be for single numbers again.
struct Derived_energy : SP::Symmetric_Dirichlet_energy_3
{
  double operator()(double i, double d) const { return SP::Symmetric_Dirichlet_energy_3::operator()(i, d); }
};
static_assert(!is_lanewise<Derived_energy, Four_lanes>, "");

// The energy of two faces at once is that of each, to the last bit.
template <class Energy>
void expect_same_in_lanes(const Energy& energy, double guard)
{
  const SP::internal::Face_energy<Energy> guarded(energy, guard);
  Random random(5);
  for(int k = 0; k < 100; ++k)
  {
    std::array<double, 2> i, d;
    for(std::size_t j = 0; j < 2; ++j)
    {
      const double s1 = random.factor(1e3), s2 = random.factor(1e3);
      i[j] = s1 * s1 + s2 * s2;
      d[j] = s1 * s2;
    }
    const Two_lanes packed_i = Lanes<Two_lanes>::load(i.data()), packed_d = Lanes<Two_lanes>::load(d.data());
    const Two_lanes value = guarded(packed_i, packed_d);
    const auto derivatives = guarded.derivatives(packed_i, packed_d);
    for(std::size_t j = 0; j < Lanes<Two_lanes>::width; ++j)
    {
      const auto e = guarded.derivatives(i[j], d[j]);
      EXPECT_EQ(lane(value, j), guarded(i[j], d[j]));
      EXPECT_EQ(lane(derivatives.value, j), e.value);
      EXPECT_EQ(lane(derivatives.i, j), e.i);
      EXPECT_EQ(lane(derivatives.d, j), e.d);
      EXPECT_EQ(lane(derivatives.ii, j), e.ii);
      EXPECT_EQ(lane(derivatives.id, j), e.id);
      EXPECT_EQ(lane(derivatives.dd, j), e.dd);
    }
  }
}

TEST(Face_energy, is_the_same_in_lanes)
{
  for(const double guard : {0., 0.01})
  {
    expect_same_in_lanes(SP::Conformal_energy_3(), guard);
    expect_same_in_lanes(SP::Stretch_energy_3(), guard);
    expect_same_in_lanes(Hooked_energy(), guard);
    expect_same_in_lanes(archetypes::Distortion_energy_in_lanes(archetypes::Copy_constructible::MADE_BY_TEST), guard);
  }
}

TEST(Face_energy, adds_a_share_of_the_area_distortion)
{
  const double guard = 0.01;
  const SP::Conformal_energy_3 conformal;
  const SP::internal::Face_energy<SP::Conformal_energy_3> energy(conformal, guard);
  Random random(5);
  for(int k = 0; k < 100; ++k)
  {
    const double s1 = random.factor(1e2), s2 = random.factor(1e2), i = s1 * s1 + s2 * s2, d = s1 * s2;
    const double reference = conformal(i, d) + guard * (d + 1. / d);
    EXPECT_NEAR(energy(i, d), reference, 1e-13 * reference);
    const auto e = energy.derivatives(i, d), e0 = conformal.derivatives(i, d);
    EXPECT_NEAR(e.value, reference, 1e-13 * reference);
    EXPECT_EQ(e.i, e0.i);
    EXPECT_EQ(e.ii, e0.ii);
    EXPECT_EQ(e.id, e0.id);
    EXPECT_NEAR((e.d - e0.d) * d, guard * (d - 1. / d), 1e-12 * reference);
    EXPECT_NEAR((e.dd - e0.dd) * d * d, 2. * guard / d, 1e-12 * reference);
  }
}

} // namespace
