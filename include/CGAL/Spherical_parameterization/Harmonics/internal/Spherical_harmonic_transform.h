// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERICAL_HARMONIC_TRANSFORM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERICAL_HARMONIC_TRANSFORM_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Sphere_nodes.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The map from coefficients to the values of three functions, sums of real harmonics up to a degree, and its adjoint.
// The harmonics are in 4 pi normalization, with mean square 1 over the sphere, and without the phase (-1)^m:
//
//   P_lm(cos t) cos(m p) and P_lm(cos t) sin(m p), where t is the angle from the z-axis and p the longitude.
//
// Coefficients are in the order [m][l][cosine or sine][function], with l starting at m.
//
// P_lm = P_mm q_lm, where P_mm = c_m sin^m t, and q_lm is computed by the recursion in l from q_mm = 1, which is
// stable. Where P_lm is not tiny, t is beyond the turning point, at which sin t is about m / l, so that P_mm > (m /
// l)^m. The minimum of this bound is e^(-l / e) at m = l / e, which is 1e-160 for the degree 1000. So P_mm may be set
// to 0 below 1e-290, and no q_lm overflows. The scale of Holmes and Featherstone (2002), 1e-280 for degrees up to 2700,
// is not needed.
class Spherical_harmonic_transform
{
public:
  static constexpr std::size_t n_functions = Sphere_nodes::n_functions, n_sums = 2 * n_functions;

  explicit Spherical_harmonic_transform(std::size_t degree)
    : m_degree(degree)
  {
    for(std::size_t m = 0; m <= degree; ++m)
    {
      m_begins.push_back(m_steps.size());
      for(std::size_t l = m; l <= degree; ++l)
      {
        // P_lm = a x P_(l - 1)m - b P_(l - 2)m
        const double i = static_cast<double>(l), j = i - 1., k = static_cast<double>(m);
        const double a = std::sqrt((4. * i * i - 1.) / ((i - k) * (i + k)));
        m_steps.push_back(l == m       ? Step{0., 0.}
                          : l == m + 1 ? Step{a, 0.}
                                       : Step{a, a * std::sqrt((j - k) * (j + k) / (4. * j * j - 1.))});
      }
      const double n = static_cast<double>(m + 1);
      m_diagonal.push_back(m == 0 ? std::sqrt(3.) : std::sqrt((2. * n + 1.) / (2. * n)));
    }
  }

  std::size_t degree() const { return m_degree; }
  std::size_t number_of_coefficients() const { return n_sums * m_steps.size(); }

  // index of the coefficients of the three functions for P_lm cos(m p) or P_lm sin(m p)
  std::size_t place(std::size_t l, std::size_t m, bool is_sine) const
  {
    return n_sums * (m_begins[m] + l - m) + (is_sine ? n_functions : 0);
  }

  // Computes the values at the nodes.
  void evaluate(const Sphere_nodes& nodes, const std::vector<double>& coefficients, std::vector<double>& values,
                const Execution& execution) const
  {
    values.assign(nodes.number_of_values(), 0.);
    for_each_part(nodes, execution, [&](auto number_type, std::size_t, std::size_t begin, std::size_t end) {
      using FT = typename decltype(number_type)::FT;
      for_each_order<FT>(
          nodes, begin, end,
          [&](std::size_t m, std::size_t group, std::size_t lane, const FT& x, const FT& diagonal,
              const double* turns) {
            std::array<FT, n_sums> sums = zeros<FT>();
            for_each_degree(m, x, [&](std::size_t step, const FT& q) {
              const double* const c = coefficients.data() + n_sums * step;
              for(std::size_t k = 0; k < n_sums; ++k)
                sums[k] += q * FT(c[k]);
            });
            for(FT& sum : sums)
              sum *= diagonal;
            double* const v = values.data() + group * nodes.size_of_group() + lane;
            const std::size_t width = nodes.width() * Sphere_nodes::lanes;
            for(std::size_t i = 0; i < width; i += Sphere_nodes::lanes)
            {
              const FT cosine = Lanes<FT>::load(turns + i + lane), sine = Lanes<FT>::load(turns + width + i + lane);
              for(std::size_t k = 0; k < n_functions; ++k)
                Lanes<FT>::store(Lanes<FT>::load(v + k * width + i) + (sums[k] * cosine + sums[n_functions + k] * sine),
                                 v + k * width + i);
            }
          });
    });
  }

  // Computes the sum over the nodes of the products of the values and each harmonic. Parts and lanes are added in a
  // fixed order, so that the result is bitwise identical for any number of threads and any width of vector registers.
  void project(const Sphere_nodes& nodes, const std::vector<double>& values, std::vector<double>& coefficients,
               const Execution& execution) const
  {
    std::vector<std::vector<double>> parts(max_parts);
    for_each_part(nodes, execution, [&](auto number_type, std::size_t part, std::size_t begin, std::size_t end) {
      using FT = typename decltype(number_type)::FT;
      constexpr std::size_t lanes = Sphere_nodes::lanes;
      parts[part].assign(number_of_coefficients(), 0.);
      std::vector<double> sums_of_lanes(lanes * n_sums * (m_degree + 1)); // for one m
      std::size_t m_before = 0;
      const auto add_up_lanes = [&] {
        for(std::size_t k = 0; k < n_sums * (m_degree + 1 - m_before); ++k)
        {
          double* const sums = sums_of_lanes.data() + lanes * k;
          parts[part][n_sums * m_begins[m_before] + k] = (sums[0] + sums[1]) + (sums[2] + sums[3]);
          sums[0] = sums[1] = sums[2] = sums[3] = 0.;
        }
      };
      for_each_order<FT>(nodes, begin, end,
                         [&](std::size_t m, std::size_t group, std::size_t lane, const FT& x, const FT& diagonal,
                             const double* turns) {
                           if(m != m_before)
                           {
                             add_up_lanes();
                             m_before = m;
                           }
                           std::array<FT, n_sums> factors = zeros<FT>();
                           const double* const v = values.data() + group * nodes.size_of_group() + lane;
                           const std::size_t width = nodes.width() * lanes;
                           for(std::size_t i = 0; i < width; i += lanes)
                           {
                             const FT cosine = Lanes<FT>::load(turns + i + lane),
                                      sine = Lanes<FT>::load(turns + width + i + lane);
                             for(std::size_t k = 0; k < n_functions; ++k)
                             {
                               const FT value = Lanes<FT>::load(v + k * width + i);
                               factors[k] += value * cosine;
                               factors[n_functions + k] += value * sine;
                             }
                           }
                           for(FT& factor : factors)
                             factor *= diagonal;
                           for_each_degree(m, x, [&](std::size_t step, const FT& q) {
                             double* const sums = sums_of_lanes.data() + lanes * n_sums * (step - m_begins[m]) + lane;
                             for(std::size_t k = 0; k < n_sums; ++k)
                               Lanes<FT>::store(Lanes<FT>::load(sums + lanes * k) + q * factors[k], sums + lanes * k);
                           });
                         });
      add_up_lanes();
    });
    coefficients.assign(number_of_coefficients(), 0.);
    for(const std::vector<double>& part : parts)
      for(std::size_t k = 0; k < part.size(); ++k)
        coefficients[k] += part[k];
  }

private:
  static constexpr std::size_t max_parts = 16; // enough for as many threads; each part has a copy of the coefficients

  struct Step
  {
    double a, b;
  };

  template <class FT>
  static std::array<FT, n_sums> zeros()
  {
    return {FT(0.), FT(0.), FT(0.), FT(0.), FT(0.), FT(0.)};
  }

  // Calls f(number_type, part, begin, end) for ranges of groups of nodes, in parallel.
  template <class Function>
  void for_each_part(const Sphere_nodes& nodes, const Execution& execution, const Function& f) const
  {
    const std::size_t n = nodes.number_of_groups(), size = (n + max_parts - 1) / max_parts;
    for_each_block(execution, 0, n, size, [&](std::size_t begin, std::size_t end) {
      run_in_lanes<Sphere_nodes::lanes>([&](auto number_type) { f(number_type, begin / size, begin, end); });
    });
  }

  // Calls f(m, group, lane, x, P_mm, turns) for each m, for all groups and lanes. `turns` points to cos(m p) for all
  // longitudes of the group, followed by sin(m p).
  template <class FT, class Function>
  void for_each_order(const Sphere_nodes& nodes, std::size_t begin, std::size_t end, const Function& f) const
  {
    constexpr std::size_t lanes = Sphere_nodes::lanes;
    constexpr double negligible = 1e-290;
    const std::size_t width = nodes.width() * lanes;
    const std::size_t stride = nodes.first_longitude(1) == 0 ? 0 : 2 * width; // distance of the groups in `turns`
    std::vector<double> diagonals((end - begin) * lanes, 1.), turns((stride == 0 ? 1 : end - begin) * 2 * width);
    for(std::size_t k = 0; k < turns.size(); ++k)
      turns[k] = k / width % 2 == 0 ? 1. : 0.;
    for(std::size_t m = 0; m <= m_degree; ++m)
    {
      const FT factor(m_diagonal[m]);
      for(std::size_t group = begin; group < end; ++group)
        for(std::size_t lane = 0; lane < lanes; lane += Lanes<FT>::width)
        {
          double* const place = diagonals.data() + (group - begin) * lanes + lane;
          const FT diagonal = Lanes<FT>::load(place);
          f(m, group, lane, Lanes<FT>::load(nodes.cosines.data() + group * lanes + lane), diagonal,
            turns.data() + (group - begin) * stride);
          const FT next = diagonal * factor * Lanes<FT>::load(nodes.sines.data() + group * lanes + lane);
          Lanes<FT>::store(select(next < FT(negligible), FT(0.), next), place);
        }
      for(std::size_t group = begin; group < (stride == 0 ? begin + 1 : end); ++group)
        for(std::size_t i = 0; i < width; i += Lanes<FT>::width)
        {
          double* const turn = turns.data() + (group - begin) * stride + i;
          const std::size_t longitude = nodes.first_longitude(group) + i;
          const FT c = Lanes<FT>::load(nodes.cosines_of_longitudes.data() + longitude),
                   s = Lanes<FT>::load(nodes.sines_of_longitudes.data() + longitude), x = Lanes<FT>::load(turn),
                   y = Lanes<FT>::load(turn + width);
          Lanes<FT>::store(c * x - s * y, turn);
          Lanes<FT>::store(s * x + c * y, turn + width);
        }
    }
  }

  // Calls f(step, q_lm) for l from m to the degree.
  template <class FT, class Function>
  void for_each_degree(std::size_t m, const FT& x, const Function& f) const
  {
    FT q(1.), before(0.);
    const std::size_t begin = m_begins[m], end = begin + m_degree + 1 - m;
    f(begin, q);
    for(std::size_t step = begin + 1; step < end; ++step)
    {
      const FT next = FT(m_steps[step].a) * x * q - FT(m_steps[step].b) * before;
      before = q;
      q = next;
      f(step, q);
    }
  }

  std::size_t m_degree;
  std::vector<std::size_t> m_begins; // index of the first step of each m
  std::vector<Step> m_steps;         // for each m and l
  std::vector<double> m_diagonal;    // P_(m + 1)(m + 1) / (P_mm sin t)
};

// Calls f(place, l, m, function) for the coefficients of up to three functions, beginning with the function `first`, in
// the order of the transform.
template <class Function>
void for_each_coefficient(const Spherical_harmonic_transform& transform, std::size_t first, std::size_t n_functions,
                          const Function& f)
{
  const auto degree = static_cast<std::ptrdiff_t>(transform.degree());
  for(std::ptrdiff_t l = 0; l <= degree; ++l)
    for(std::ptrdiff_t m = -l; m <= l; ++m)
      for(std::size_t k = 0; k < Spherical_harmonic_transform::n_functions && first + k < n_functions; ++k)
        f(transform.place(static_cast<std::size_t>(l), static_cast<std::size_t>(m < 0 ? -m : m), m < 0) + k,
          static_cast<std::size_t>(l), m, first + k);
}

// Writes coefficients in the order of the transform to `harmonics`, which must have the normalization of the transform.
inline void write_coefficients(const Spherical_harmonic_transform& transform, const std::vector<double>& coefficients,
                               std::size_t first, Spherical_harmonics_3& harmonics)
{
  for_each_coefficient(transform, first, harmonics.number_of_functions(),
                       [&](std::size_t place, std::size_t l, std::ptrdiff_t m, std::size_t function) {
                         harmonics.set_coefficient(function, l, m, coefficients[place]);
                       });
}

// Returns coefficients in the order of the transform.
inline std::vector<double> read_coefficients(const Spherical_harmonic_transform& transform,
                                             const Spherical_harmonics_3& harmonics, std::size_t first)
{
  std::vector<double> result(transform.number_of_coefficients(), 0.);
  for_each_coefficient(transform, first, harmonics.number_of_functions(),
                       [&](std::size_t place, std::size_t l, std::ptrdiff_t m, std::size_t function) {
                         result[place] = harmonics.coefficient(function, l, m);
                       });
  return result;
}

// Converts to the normalization of the transform.
inline Spherical_harmonics_3 in_normalization_of_transform(Spherical_harmonics_3 harmonics)
{
  harmonics.convert(Harmonic_normalization::four_pi, false);
  return harmonics;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERICAL_HARMONIC_TRANSFORM_H
