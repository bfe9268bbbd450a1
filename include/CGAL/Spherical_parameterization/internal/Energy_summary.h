// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ENERGY_SUMMARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ENERGY_SUMMARY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <algorithm>
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

  static constexpr double lowest = std::numeric_limits<double>::lowest();

  double m_sharpness;
  std::size_t m_size = 0;
  double m_sum = 0., m_largest = lowest, m_sum_of_exponentials = 0.;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ENERGY_SUMMARY_H
