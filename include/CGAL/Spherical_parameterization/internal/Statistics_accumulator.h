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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_ACCUMULATOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_ACCUMULATOR_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Distortion_statistics.h>
#include <CGAL/Spherical_parameterization/internal/is_finite.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Maximum, average and standard deviation of a sequence of numbers >= 0, in one pass. The sums are those of Welford,
// because a difference of the sums of squares has no correct digit left where the numbers hardly differ.
class Statistics_accumulator
{
public:
  void add(double x)
  {
    m_maximum = (std::max)(m_maximum, x);
    ++m_size;
    const double difference = x - m_average;
    m_average += difference / static_cast<double>(m_size);
    m_squares += difference * (x - m_average);
  }

  double average() const { return !is_finite(m_maximum) ? m_maximum : m_average; }

  Distortion_statistics statistics() const
  {
    if(m_size == 0 || !is_finite(m_maximum))
    {
      return {m_maximum, m_maximum, m_maximum};
    }
    return {m_maximum, m_average, std::sqrt(m_squares / static_cast<double>(m_size))};
  }

private:
  std::size_t m_size = 0;
  double m_maximum = 0.;
  double m_average = 0.;
  double m_squares = 0.; // sum of the squared differences from the average
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_ACCUMULATOR_H
