#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_JUDGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_JUDGE_H

// Whether a map to the sphere is one-to-one, decided without any code of the package and in another way: the signs of
// determinants of rational numbers, and the degree by the Riemann-Hurwitz formula, from how often the faces at each vertex
// turn around its image.

#include "images.h"

#include <CGAL/Spherical_parameterization/internal/numbers/nearest_double.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

namespace test {
namespace judge {

template <class Number>
using Image = std::array<Number, 3>;

template <class Number>
Number determinant(const Image<Number>& a, const Image<Number>& b, const Image<Number>& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

template <class Number>
Image<CGAL::Exact_rational> exact(const Image<Number>& p)
{
  using CGAL::Spherical_parameterization::internal::exact_rational;
  return {exact_rational(p[0]), exact_rational(p[1]), exact_rational(p[2])};
}

// The exact sign of the determinant of three finite points.
template <class Number>
int sign_of_determinant(const Image<Number>& a, const Image<Number>& b, const Image<Number>& c)
{
  if constexpr(std::is_floating_point<Number>::value)
  {
    // Doubles decide if they can: what is rounded off is below the bound, unless products underflow.
    double sum = 0., sum_of_sizes = 0.;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const double p = double(a[i]) * double(b[j]) * double(c[k]), q = double(a[i]) * double(b[k]) * double(c[j]);
      sum += p - q;
      sum_of_sizes += std::abs(p) + std::abs(q);
    }
    if(std::isfinite(sum_of_sizes) && sum_of_sizes > 1e-250 && std::abs(sum) > 1e-14 * sum_of_sizes)
      return sum > 0. ? 1 : -1;
    return CGAL::sign(determinant(exact(a), exact(b), exact(c)));
  }
  else
    return CGAL::sign(determinant(a, b, c));
}

// The faces at each vertex, turned so that the vertex comes first.
inline std::vector<std::vector<Triangle>> stars(const std::vector<Triangle>& triangles, std::size_t number_of_vertices)
{
  std::vector<std::vector<Triangle>> result(number_of_vertices);
  for(const Triangle& t : triangles)
    for(std::size_t i = 0; i < 3; ++i)
      result[t[i]].push_back({t[i], t[(i + 1) % 3], t[(i + 2) % 3]});
  return result;
}

// The neighbours of the vertex whose star this is, counterclockwise.
inline std::vector<std::size_t> ring(const std::vector<Triangle>& faces)
{
  std::map<std::size_t, std::size_t> successor;
  for(const Triangle& t : faces)
    successor[t[1]] = t[2];
  std::vector<std::size_t> result = {successor.begin()->first};
  while(result.size() < successor.size())
    result.push_back(successor[result.back()]);
  return result;
}

template <class Number>
bool is_positive(const std::vector<Image<Number>>& images, const Triangle& t)
{
  return sign_of_determinant(images[t[0]], images[t[1]], images[t[2]]) > 0;
}

// How often the faces at a vertex, all of them positive, turn around its image: that many of them contain the direction to
// any of the neighbours.
template <class Number>
std::size_t number_of_turns(const std::vector<Image<Number>>& images, const std::vector<Triangle>& star)
{
  const Image<Number>&v = images[star[0][0]], &w = images[star[0][1]];
  return static_cast<std::size_t>(std::count_if(star.begin(), star.end(), [&](const Triangle& t) {
    return sign_of_determinant(v, images[t[1]], w) >= 0 && sign_of_determinant(v, w, images[t[2]]) > 0;
  }));
}

// Precondition: all faces are positive, and the mesh is a topological sphere.
template <class Number>
std::size_t degree(const std::vector<Image<Number>>& images, const std::vector<Triangle>& triangles)
{
  std::size_t n_more_turns = 0; // than one
  for(const std::vector<Triangle>& star : stars(triangles, images.size()))
    n_more_turns += star.empty() ? 0 : number_of_turns(images, star) - 1;
  return 1 + n_more_turns / 2;
}

// Precondition: the mesh is a topological sphere, but for vertices without faces.
template <class Number>
::testing::AssertionResult is_one_to_one(const std::vector<Image<Number>>& images,
                                         const std::vector<Triangle>& triangles)
{
  std::size_t n_folds = 0;
  for(const Triangle& t : triangles)
  {
    if constexpr(std::is_floating_point<Number>::value)
      for(const std::size_t v : t)
        for(const Number x : images[v])
          if(!std::isfinite(x))
            return ::testing::AssertionFailure() << "an image is not finite";
    n_folds += !is_positive(images, t);
  }
  if(n_folds > 0)
    return ::testing::AssertionFailure() << n_folds << " faces are not positive";
  const std::size_t n = degree(images, triangles);
  if(n != 1)
    return ::testing::AssertionFailure() << "the faces cover the sphere " << n << " times";
  return ::testing::AssertionSuccess();
}

} // namespace judge
} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_JUDGE_H
