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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ENERGY_SUMMARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ENERGY_SUMMARY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Lanes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The energies of many faces in a few figures. Summaries of parts add up to that of the whole.
class Energy_summary
{
public:
  explicit Energy_summary(double sharpness = 0.)
    : m_sharpness(sharpness)
  {}

  // Adds the energies of many faces, in several columns, which do not wait for each other. Which energies a column gets
  // does not depend on the number of lanes.
  template <class FT>
  void add_all(const double* energies, std::size_t n)
  {
    const std::size_t n_in_rows = n - n % n_columns;
    std::array<double, n_columns> sums = {}, largest;
    largest.fill(lowest);
    for(std::size_t column = 0; column < n_columns; column += Lanes<FT>::width)
    {
      FT column_sum = 0., column_largest = lowest;
      for(std::size_t k = column; k < n_in_rows; k += n_columns)
      {
        const FT energy = Lanes<FT>::load(energies + k);
        column_sum += energy;
        column_largest = larger(column_largest, energy);
      }
      Lanes<FT>::store(column_sum, sums.data() + column);
      Lanes<FT>::store(column_largest, largest.data() + column);
    }
    for(std::size_t k = n_in_rows; k < n; ++k)
    {
      sums[k - n_in_rows] += energies[k];
      largest[k - n_in_rows] = (std::max)(largest[k - n_in_rows], energies[k]);
    }
    Energy_summary part(m_sharpness);
    part.m_size = n;
    part.m_sum = std::accumulate(sums.begin(), sums.end(), 0.);
    part.m_largest = *std::max_element(largest.begin(), largest.end());
    if(m_sharpness > 0.)
    {
      const auto exponential_of = [&](const FT& energy) {
        const FT sharpness = m_sharpness, shift = part.m_largest;
        return exponential(sharpness * (energy - shift));
      };
      std::array<double, n_columns> last_row;
      last_row.fill(part.m_largest);
      std::copy(energies + n_in_rows, energies + n, last_row.begin());
      for(std::size_t column = 0; column < n_columns; column += Lanes<FT>::width)
      {
        FT column_sum = 0.;
        for(std::size_t k = column; k < n_in_rows; k += n_columns)
          column_sum += exponential_of(Lanes<FT>::load(energies + k));
        Lanes<FT>::store(column_sum, sums.data() + column);
        Lanes<FT>::store(exponential_of(Lanes<FT>::load(last_row.data() + column)), last_row.data() + column);
      }
      for(std::size_t k = n_in_rows; k < n; ++k)
        sums[k - n_in_rows] += last_row[k - n_in_rows];
      part.m_sum_of_exponentials = std::accumulate(sums.begin(), sums.end(), 0.);
    }
    add(part);
  }

  void add(const Energy_summary& part)
  {
    if(part.m_size == 0)
      return;
    m_size += part.m_size;
    m_sum += part.m_sum;
    if(m_sharpness > 0.)
    {
      // sums of exp(s (E - largest)), rescaled to the larger one
      if(part.m_largest > m_largest)
        m_sum_of_exponentials = part.m_sum_of_exponentials + m_sum_of_exponentials * rescaling(part.m_largest);
      else
        m_sum_of_exponentials += part.m_sum_of_exponentials * part.rescaling(m_largest);
    }
    m_largest = (std::max)(m_largest, part.m_largest);
  }

  double average() const { return m_sum / static_cast<double>(m_size); }
  double largest() const { return m_largest; }

  // log(mean of exp(s E)) / s, or the average for s = 0: the objective of eq. 7 in the unit of the energy. It lies
  // between the average and the largest energy and goes from the one to the other as s grows, so that its values for
  // different s can be compared.
  double mean() const
  {
    if(!(m_sharpness > 0.))
      return average();
    return m_largest + std::log(m_sum_of_exponentials / static_cast<double>(m_size)) / m_sharpness;
  }

  // What a change of an energy near `energy` is to be compared with. Where all energies are near their least value, a
  // small part of them is much of what could still be gained.
  double scale_of_changes(double energy) const
  {
    const double spread = largest() - average();
    return (std::max)((std::min)(energy, 2. * spread), 1e-6 * energy);
  }

private:
  double rescaling(double new_largest) const
  {
    return m_size > 0 && m_largest > lowest ? std::exp(m_sharpness * (m_largest - new_largest)) : 0.;
  }

  static constexpr std::size_t n_columns = 8;
  static constexpr double lowest = std::numeric_limits<double>::lowest();

  double m_sharpness;
  std::size_t m_size = 0;
  double m_sum = 0., m_largest = lowest, m_sum_of_exponentials = 0.;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ENERGY_SUMMARY_H
