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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_ENERGY_SUMMARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_ENERGY_SUMMARY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/descent/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Summary statistics of the energies of many faces. Summaries of parts can be added. If the sharpness s is positive,
// they include moments with the weights exp(s E). The size is the number of faces or, if faces are weighted by area,
// the sum of the areas; all means are weighted accordingly.
class Energy_summary
{
public:
  explicit Energy_summary(double sharpness = 0.)
    : m_sharpness(sharpness)
  {}

  // Adds the energies of many faces, in several independent columns. The assignment of energies to columns does not
  // depend on the number of lanes. Faces have the weights `counts`, or all the same weight if it is null.
  template <class FT>
  void add_all(const double* energies, const double* counts, std::size_t n)
  {
    if(n == 0)
      return;
    // Calls f(energies, count) for the lanes from `column` on, row by row; unused lanes of the last row have the count
    // 0.
    const auto for_each_row = [&](std::size_t column, const auto& f) {
      std::size_t k = column;
      for(; k + Lanes<FT>::width <= n; k += n_columns)
        f(Lanes<FT>::load(energies + k), counts ? Lanes<FT>::load(counts + k) : FT(1.));
      if(k < n)
        f(Lanes<FT>::generate([&](std::size_t lane) { return energies[(std::min)(k + lane, n - 1)]; }),
          Lanes<FT>::generate([&](std::size_t lane) { return k + lane < n ? (counts ? counts[k + lane] : 1.) : 0.; }));
    };
    using Columns = std::array<double, n_columns>;
    const auto total = [](const Columns& columns) { return std::accumulate(columns.begin(), columns.end(), 0.); };

    Energy_summary part(m_sharpness);
    part.m_size = counts ? std::accumulate(counts, counts + n, 0.) : static_cast<double>(n);
    Columns sums, largest;
    for(std::size_t column = 0; column < n_columns; column += Lanes<FT>::width)
    {
      FT sum = 0., max = part.m_max;
      for_each_row(column, [&](const FT& energy, const FT& count) {
        sum += count * energy;
        max = maximum(max, energy);
      });
      Lanes<FT>::store(sum, sums.data() + column);
      Lanes<FT>::store(max, largest.data() + column);
    }
    part.m_sum = total(sums);
    part.m_max = *std::max_element(largest.begin(), largest.end());
    if(m_sharpness > 0.)
    {
      std::array<Columns, 3> moments;
      for(std::size_t column = 0; column < n_columns; column += Lanes<FT>::width)
      {
        const FT sharpness = m_sharpness, shift = part.m_max;
        FT weights = 0., firsts = 0., seconds = 0.;
        for_each_row(column, [&](const FT& energy, const FT& count) {
          const FT weight = count * clamped_exponential(sharpness * (energy - shift)), first = weight * energy;
          weights += weight;
          firsts += first;
          seconds += first * energy;
        });
        Lanes<FT>::store(weights, moments[0].data() + column);
        Lanes<FT>::store(firsts, moments[1].data() + column);
        Lanes<FT>::store(seconds, moments[2].data() + column);
      }
      std::transform(moments.begin(), moments.end(), part.m_moments.begin(), total);
    }
    add(part);
  }

  void add(const Energy_summary& part)
  {
    if(part.is_empty())
      return;
    m_sum += part.m_sum;
    if(m_sharpness > 0.)
    {
      const double max = (std::max)(m_max, part.m_max), factor = rescaling(max), factor_of_part = part.rescaling(max);
      for(std::size_t k = 0; k < m_moments.size(); ++k)
        m_moments[k] = factor * m_moments[k] + factor_of_part * part.m_moments[k];
    }
    m_size += part.m_size;
    m_max = (std::max)(m_max, part.m_max);
  }

  double size() const { return m_size; }
  bool is_empty() const { return m_size == 0.; }
  double average() const { return m_sum / size(); }
  double maximum_energy() const { return m_max; }

  // log(mean of exp(s E)) / s, or the average for s = 0. It increases with s from the average to the maximum.
  double exponential_mean() const
  {
    if(!(m_sharpness > 0.))
      return average();
    return m_max + logarithm(m_moments[0] / size()) / m_sharpness;
  }

  // The means of E and E^2 with the weights exp(s E).
  double weighted_mean() const { return m_moments[1] / m_moments[0]; }
  double weighted_mean_square() const { return m_moments[2] / m_moments[0]; }

  // Whether the change of an energy from `last_value` is a small fraction of the possible gain. This is the difference
  // from the lowest energy, if that is known, or, where all energies are near their minimum, twice the difference
  // between the largest and the average energy; at most `max_gain`, and at least one millionth of the energy.
  bool has_settled(double value, double last_value, double tolerance, double lowest_energy = 0.,
                   double max_gain = (std::numeric_limits<double>::max)()) const
  {
    const double spread = maximum_energy() - average();
    const double height = last_value > lowest_energy ? last_value - lowest_energy : last_value;
    const double scale = (std::max)((std::min)({height, 2. * spread, max_gain}), 1e-6 * last_value);
    return std::abs(value - last_value) <= tolerance * scale;
  }

private:
  double rescaling(double new_max) const { return is_empty() ? 0. : exponential(m_sharpness * (m_max - new_max)); }

  static constexpr std::size_t n_columns = packet_width;

  double m_sharpness;
  double m_size = 0., m_sum = 0., m_max = std::numeric_limits<double>::lowest();
  std::array<double, 3> m_moments = {}; // sums of w, w E and w E^2 with w = exp(s (E - maximum))
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_ENERGY_SUMMARY_H
