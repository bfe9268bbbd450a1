#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_LONG_DOUBLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_LONG_DOUBLES_H

// References in extended precision, where there is one.

#include "images.h"

namespace test {

using Long_vector = std::array<long double, 3>;

inline Long_vector long_difference(const Coordinates& a, const Coordinates& b)
{
  return {static_cast<long double>(a[0]) - b[0], static_cast<long double>(a[1]) - b[1],
          static_cast<long double>(a[2]) - b[2]};
}

inline long double long_dot(const Long_vector& a, const Long_vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline long double long_norm_of_cross(const Long_vector& a, const Long_vector& b)
{
  const Long_vector n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return std::sqrt(long_dot(n, n));
}

// The singular values of the linear map between two triangles, the smaller one first: those of the matrix of the map in
// coordinates of the first plane, by one rotation of its two columns (Jacobi) that makes them orthogonal. The longer one is the
// larger singular value then; the product of both is the ratio of the areas.
inline std::array<long double, 2> singular_values(const std::array<Coordinates, 3>& from,
                                                  const std::array<Coordinates, 3>& to)
{
  const auto sum = [](long double s, const Long_vector& a, long double t, const Long_vector& b) {
    return Long_vector{s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
  };
  const Long_vector e1 = long_difference(from[1], from[0]), e2 = long_difference(from[2], from[0]),
                    f1 = long_difference(to[1], to[0]), f2 = long_difference(to[2], to[0]);
  // e1 is mapped to f1, and the height over it, which is e2 - foot e1, to f2 - foot f1.
  const long double foot = long_dot(e1, e2) / long_dot(e1, e1);
  const Long_vector h = sum(1.L, e2, -foot, e1);
  const long double base = std::sqrt(long_dot(e1, e1)), height = std::sqrt(long_dot(h, h));
  const Long_vector a = sum(1.L / base, f1, 0.L, f1), b = sum(1.L / height, f2, -foot / height, f1);
  const long double angle = 0.5L * std::atan2(2.L * long_dot(a, b), long_dot(a, a) - long_dot(b, b));
  const Long_vector major = sum(std::cos(angle), a, std::sin(angle), b);
  const long double s2 = std::sqrt(long_dot(major, major));
  return {long_norm_of_cross(f1, f2) / long_norm_of_cross(e1, e2) / s2, s2};
}

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_LONG_DOUBLES_H
