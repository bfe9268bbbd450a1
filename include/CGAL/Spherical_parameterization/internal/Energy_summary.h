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

  void add(double energy)
  {
    ++m_size;
    m_sum += energy;
    if(m_sharpness > 0.)
    {
      // sum of exp(s (E - largest)), rescaled whenever a larger one comes
      if(energy > m_largest)
        m_sum_of_exponentials = 1. + m_sum_of_exponentials * rescaling(energy);
      else
        m_sum_of_exponentials += std::exp(m_sharpness * (energy - m_largest));
    }
    m_largest = (std::max)(m_largest, energy);
  }

  // Adds the energies of many faces.
  template <class FT>
  void add_all(const double* energies, std::size_t n)
  {
    Energy_summary part(m_sharpness);
    part.m_size = n;
    for(std::size_t k = 0; k < n; ++k)
      part.m_largest = (std::max)(part.m_largest, energies[k]);
    part.m_sum = sum_of(energies, n);
    if(m_sharpness > 0.)
    {
      std::array<double, packet_size> exponentials;
      for(std::size_t first = 0; first < n; first += packet_size)
      {
        const std::size_t size = (std::min)(n - first, packet_size);
        for(std::size_t k = 0; k < packet_size; ++k)
          exponentials[k] = k < size ? m_sharpness * (energies[first + k] - part.m_largest) : 0.;
        for(std::size_t k = 0; k < packet_size; k += Lanes<FT>::width)
          Lanes<FT>::store(exponential(Lanes<FT>::load(exponentials.data() + k)), exponentials.data() + k);
        part.m_sum_of_exponentials += sum_of(exponentials.data(), size);
      }
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

private:
  double rescaling(double new_largest) const
  {
    return m_size > 0 && m_largest > lowest ? std::exp(m_sharpness * (m_largest - new_largest)) : 0.;
  }

  // In several sums, which do not wait for each other. Which ones does not depend on the processor.
  static double sum_of(const double* values, std::size_t n)
  {
    std::array<double, packet_size> sums = {};
    std::size_t k = 0;
    for(; k + packet_size <= n; k += packet_size)
      for(std::size_t i = 0; i < packet_size; ++i)
        sums[i] += values[k + i];
    for(std::size_t i = 0; k < n; ++k, ++i)
      sums[i] += values[k];
    double result = 0.;
    for(const double sum : sums)
      result += sum;
    return result;
  }

  static constexpr std::size_t packet_size = 8;
  static constexpr double lowest = std::numeric_limits<double>::lowest();

  double m_sharpness;
  std::size_t m_size = 0;
  double m_sum = 0., m_largest = lowest, m_sum_of_exponentials = 0.;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ENERGY_SUMMARY_H
