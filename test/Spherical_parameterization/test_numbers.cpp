// Functions that the standard library has, too, against numbers of 160 bits, and the exponential in lanes.

#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>
#include <CGAL/Spherical_parameterization/internal/numbers/nearest_double.h>
#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>

#include "random_meshes.h"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>

using namespace test;

namespace {

using namespace CGAL::Spherical_parameterization::internal;

namespace multiprecision = boost::multiprecision;
using Exact =
    multiprecision::number<multiprecision::cpp_bin_float<160, multiprecision::digit_base_2>, multiprecision::et_off>;

constexpr double infinity = std::numeric_limits<double>::infinity();

using Point = std::array<double, 3>;

struct Function
{
  const char* name;
  double bound; // of the error, in units in the last place: what the comment of the function promises
  double (*own)(const Point& p);
  double (*standard)(const Point& p);
  Exact (*exact)(const std::array<Exact, 3>& p);
  Point (*random_point)(Random& random, int k);
};

double signed_magnitude(Random& random, int low, int high)
{
  return (random.one_in(2) ? 1. : -1.) * random.magnitude(low, high);
}

Point random_exponent(Random& random, int k)
{
  return {k % 2 == 0 ? random.between(-12., 1.) : random.between(-745., 709.78)};
}

Point random_positive(Random& random, int k)
{
  return {k % 3 == 0   ? random.magnitude(-1074, 1024)
          : k % 3 == 1 ? random.between(0.5, 2.)
                       : 1. + signed_magnitude(random, -52, -5)};
}

Point random_angle(Random& random, int k)
{
  if(k % 4 == 0)
    return {signed_magnitude(random, -1074, 17)};
  if(k % 4 == 1)
    return {random.between(-7., 7.)};
  if(k % 4 == 2)
    return {random.between(-2e5, 2e5)};
  // next to a multiple of a quarter turn, or of an eighth
  const int n = random.integer(-120000, 120000);
  return {static_cast<double>(boost::math::constants::half_pi<Exact>() * n / random.integer(1, 2))};
}

Point random_place(Random& random, int k)
{
  const double x = k % 2 == 0 ? random.between(-1., 1.) : signed_magnitude(random, -1074, 1020);
  const double factor = k % 3 == 0 ? random.between(-3., 3.) : signed_magnitude(random, -60, 60);
  return {(std::max)((std::min)(x * factor, 1e307), -1e307), x};
}

Point random_place_in_space(Random& random, int k)
{
  const Point p = random_place(random, k);
  return {p[0], p[1], random.one_in(2) ? 0. : p[1] * random.between(-1., 1.)};
}

const std::array<Function, 8> functions = {
    {{"exponential", 1., [](const Point& p) { return exponential(p[0]); },
      [](const Point& p) { return std::exp(p[0]); }, [](const std::array<Exact, 3>& p) { return Exact(exp(p[0])); },
      random_exponent},
     {"logarithm", 0.95, [](const Point& p) { return logarithm(p[0]); }, [](const Point& p) { return std::log(p[0]); },
      [](const std::array<Exact, 3>& p) { return Exact(log(p[0])); }, random_positive},
     {"sine", 0.9, [](const Point& p) { return sine(p[0]); }, [](const Point& p) { return std::sin(p[0]); },
      [](const std::array<Exact, 3>& p) { return Exact(sin(p[0])); }, random_angle},
     {"cosine", 0.9, [](const Point& p) { return cosine(p[0]); }, [](const Point& p) { return std::cos(p[0]); },
      [](const std::array<Exact, 3>& p) { return Exact(cos(p[0])); }, random_angle},
     {"arc_tangent", 0.6, [](const Point& p) { return arc_tangent(p[0], p[1]); },
      [](const Point& p) { return std::atan2(p[0], p[1]); },
      [](const std::array<Exact, 3>& p) { return Exact(atan2(p[0], p[1])); }, random_place},
     {"hypotenuse of two", 0.8, [](const Point& p) { return hypotenuse(p[0], p[1]); },
      [](const Point& p) { return std::hypot(p[0], p[1]); },
      [](const std::array<Exact, 3>& p) { return Exact(sqrt(p[0] * p[0] + p[1] * p[1])); }, random_place},
     {"hypotenuse of three", 0.8, [](const Point& p) { return hypotenuse(p[0], p[1], p[2]); },
      [](const Point& p) { return std::hypot(p[0], p[1], p[2]); },
      [](const std::array<Exact, 3>& p) { return Exact(sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2])); },
      random_place_in_space},
     {"cube_root", 0.6, [](const Point& p) { return cube_root(p[0]); }, [](const Point& p) { return std::cbrt(p[0]); },
      [](const std::array<Exact, 3>& p) {
        const Exact root = cbrt(Exact(abs(p[0])));
        return p[0] < 0 ? Exact(-root) : root;
      },
      [](Random& random, int k) {
        return k % 2 == 0 ? Point{signed_magnitude(random, -1074, 1024)} : Point{random.between(-8., 8.)};
      }}}};

double error_in_ulp(double value, const Exact& exact)
{
  int exponent = 0;
  std::frexp(static_cast<double>(exact), &exponent);
  return static_cast<double>(ldexp(Exact(abs(value - exact)), -(std::max)(exponent - 53, -1074)));
}

TEST(Elementary_functions, have_the_errors_that_are_promised)
{
  for(const Function& f : functions)
  {
    Random random(1);
    double largest = 0.;
    for(int k = 0; k < 50000; ++k)
    {
      const Point p = f.random_point(random, k);
      const double error = error_in_ulp(f.own(p), f.exact({p[0], p[1], p[2]}));
      EXPECT_LE(error, f.bound) << f.name << " of " << p[0] << ", " << p[1] << ", " << p[2];
      largest = (std::max)(largest, error);
    }
    std::printf("%s: %.3f ulp\n", f.name, largest);
    EXPECT_GE(largest, 0.4999); // or the test has missed what is hard
  }
}

TEST(Elementary_functions, are_those_of_the_standard_library_for_special_values)
{
  using limits = std::numeric_limits<double>;
  const std::vector<double> values = {0.,
                                      0.5,
                                      1.,
                                      1e-300,
                                      1e300,
                                      limits::denorm_min(),
                                      (limits::min)(),
                                      (limits::max)(),
                                      infinity,
                                      limits::quiet_NaN()};
  std::vector<double> all = values;
  for(const double x : values)
    all.push_back(-x);
  for(const Function& f : functions)
    for(const double x : all)
      for(const double y : all)
      {
        // It reduces all angles exactly, and the one of g++ knows no infinity of three lengths.
        if((f.random_point == random_angle && std::abs(x) > 2e5 && std::abs(x) < infinity) ||
           f.random_point == random_place_in_space)
          continue;
        const Point p = {x, y, x};
        const double own = f.own(p), standard = f.standard(p);
        if(std::isnan(standard) || std::isinf(standard) || standard == 0.)
        {
          EXPECT_EQ(std::isnan(own), std::isnan(standard)) << f.name << " of " << x << ", " << y;
          EXPECT_TRUE(std::isnan(standard) || own == standard) << f.name << " of " << x << ", " << y;
          EXPECT_TRUE(std::isnan(standard) || std::signbit(own) == std::signbit(standard)) << f.name << " of " << x;
        }
        else
          EXPECT_LE(error_in_ulp(own, Exact(standard)), 2.) << f.name << " of " << x << ", " << y;
      }
}

TEST(Elementary_functions, are_exact_where_they_can_be)
{
  EXPECT_EQ(exponential(0.), 1.);
  EXPECT_EQ(logarithm(1.), 0.);
  EXPECT_EQ(cosine(0.), 1.);
  EXPECT_EQ(hypotenuse(3., 4.), 5.);
  EXPECT_EQ(hypotenuse(3e300, 4e300), 5e300);
  EXPECT_EQ(hypotenuse(2., -3., 6.), 7.);
  EXPECT_EQ(hypotenuse(1., std::nan(""), -infinity), infinity);
  for(int k = 1; k < 1000; ++k)
    EXPECT_EQ(cube_root(-1. * k * k * k), -k);
  for(const double size : {5e-324, 1., 1e308})
    for(int k = -4; k <= 4; ++k)
    {
      const std::array<double, 9> xs = {-1., -1., -0., 1., 1., 1., 0., -1., -1.},
                                  ys = {-0., -1., -1., -1., 0., 1., 1., 1., 0.};
      const auto i = static_cast<std::size_t>(k + 4);
      EXPECT_EQ(arc_tangent(size * ys[i], size * xs[i]), k * (CGAL_PI / 4.));
    }
}

TEST(Elementary_functions, take_large_angles_for_ones_next_to_them)
{
  Random random(2);
  for(int k = 0; k < 1000; ++k)
  {
    const double angle = signed_magnitude(random, 17, 40), bound = std::ldexp(std::abs(angle), -53) + 1e-15;
    EXPECT_NEAR(sine(angle), std::sin(angle), bound);
    EXPECT_NEAR(cosine(angle), std::cos(angle), bound);
  }
}

template <class FT>
void expect_same_exponential()
{
  Random random(3);
  for(int k = 0; k < 20000; ++k)
  {
    const double x = k % 2 == 0 ? random.between(-720., 720.) : random.between(-12., 1.);
    const FT packed = Lanes<FT>::generate([&](std::size_t i) { return x + static_cast<double>(i); });
    const FT e = clamped_exponential(packed);
    for(std::size_t i = 0; i < Lanes<FT>::width; ++i)
      EXPECT_EQ(lane(e, i), exponential((std::min)((std::max)(lane(packed, i), -708.), 709.)));
  }
  const auto exponential_of = [](double x) { return lane(clamped_exponential(FT(x)), 0); };
  for(const double x : {std::nan(""), -1e300, -infinity})
    EXPECT_EQ(exponential_of(x), exponential(-708.));
  for(const double x : {1e3, infinity})
    EXPECT_EQ(exponential_of(x), exponential(709.));
}

TEST(Packed_double, has_the_exponential_of_a_double)
{
  expect_same_exponential<double>();
  expect_same_exponential<Two_lanes>();
  expect_same_exponential<Four_lanes>();
  run_in_lanes([](auto number_type) { expect_same_exponential<typename decltype(number_type)::FT>(); });
}

TEST(Exact_rational, is_made_of_every_double)
{
  for(const double x : {0., 0.1, -1., 1e-199, 1e-201, -1.7e-308, 3e-310, 4.9406564584124654e-324, 1.7e308})
    EXPECT_EQ(nearest_double(exact_rational(x)), x);
  EXPECT_TRUE(exact_rational(4.9406564584124654e-324) * exact_rational(0x1p1000) == exact_rational(0x1p-74));
}

TEST(Nearest_double, rounds_rational_numbers_to_the_even_one_of_two)
{
  using Rational = CGAL::Exact_rational;
  std::mt19937_64 random(1);
  const auto odd_integer = [&] { return static_cast<double>((random() >> 12) | (std::uint64_t(1) << 52) | 1u); };
  for(int k = 0; k < 5000; ++k)
  {
    const double sign = k % 2 == 0 ? 1. : -1., a = sign * std::ldexp(odd_integer(), -60), b = odd_integer();
    EXPECT_EQ(nearest_double(Rational(Rational(a) / Rational(b))), a / b);
    const Rational middle = (Rational(a) + Rational(std::nextafter(a, sign * HUGE_VAL))) / 2;
    EXPECT_EQ(nearest_double(middle), std::nextafter(a, sign * HUGE_VAL)); // a is odd
    EXPECT_EQ(nearest_double(Rational(middle - Rational(std::ldexp(sign, -300)))), a);
  }

  // The quotient of numbers beyond the range of doubles is a double.
  const Rational large(std::ldexp(1., 1000));
  const Rational quotient = (large * large + 1) / (large * large * 3);
  EXPECT_EQ(nearest_double(quotient), 1. / 3.);
  EXPECT_EQ(nearest_double(Rational(-quotient)), -1. / 3.);
  EXPECT_EQ(nearest_double(Rational(0)), 0.);
  EXPECT_EQ(nearest_double(Rational(1. / 3.)), 1. / 3.);
}

} // namespace
