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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ABSOLUTE_SHARPNESS_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ABSOLUTE_SHARPNESS_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <algorithm>
#include <cstddef>

/// \file Absolute_sharpness_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSharpness
///
/// The class `Absolute_sharpness_3` is the schedule of the BLD paper: the plain sum of the energies, \f$ s = 0 \f$,
/// first, then \f$ \sum \exp( s E ) \f$ with \f$ s \f$ growing from 0.1 to 10.
///
/// These are eq. 6 and 7 of \cgalCite{cgal:whfl-bspld-16}. The paper leaves eq. 6 after 100 sweeps and names the
/// criterion as open, and of the growth of \f$ s \f$ it says that it adapts. Here \f$ s \f$ is raised by a quarter
/// whenever the current value has done its work: when a sweep has lowered neither the largest nor the average energy by
/// a certain share, a hundredth by default. Eq. 6 is left as soon as a sweep lowers the average energy by less than a
/// thousandth, or after a given number of sweeps, 0 for none; as this is the schedule for plain gradient steps, which
/// are slow, the share is a thousandth then.
///
/// If both values are the same and no number of sweeps is given, \f$ s \f$ is fixed from the first sweep on, as in
/// AMIPS.
///
/// \cgalModels{SharpnessPolicy_3}
///
/// \sa `Relative_sharpness_3`
class Absolute_sharpness_3
{
public:
  /// constructs the schedule from `first` to `last`, 0 < `first` <= `last` <= 10<sup>6</sup>.
  explicit Absolute_sharpness_3(double first = 0.1, double last = 10.)
    : m_first(first)
    , m_last(last)
    , m_current(first == last ? last : 0.)
  {}

  /// constructs the schedule from `first` to `last`, 0 < `first` <= `last` <= 10<sup>6</sup>, after exactly
  /// `number_of_average_sweeps` sweeps with \f$ s = 0 \f$, of which the paper makes 100.
  Absolute_sharpness_3(double first, double last, std::size_t number_of_average_sweeps)
    : m_first(first)
    , m_last(last)
    , m_current(number_of_average_sweeps == 0 ? first : 0.)
    , m_number_of_average_sweeps(number_of_average_sweeps)
    , m_least_fall(least_fall_of_average)
  {}

  /// returns the first positive value of the sharpness.
  double first() const { return m_first; }

  /// returns the last value of the sharpness.
  double last() const { return m_last; }

  /// returns whether the two values are in their range.
  bool is_valid() const { return m_first > 0. && m_first <= m_last && m_last <= 1e6; }

  /// returns the sharpness of the next sweep over the mesh. A level of a hierarchy that is nearly as fine gets that of
  /// the first sweep.
  ///
  /// \param sweep the number of the sweep, from 0
  /// \param average_energy the average energy of the faces before the sweep
  /// \param largest_energy the largest energy of a face before the sweep
  double operator()(std::size_t sweep, double average_energy, double largest_energy)
  {
    if(sweep > 0 && m_current < m_last)
    {
      if(m_current == 0.)
      {
        const bool is_over = m_number_of_average_sweeps == adaptive
                                 ? average_energy > (1. - least_fall_of_average) * m_average_energy
                                 : sweep >= m_number_of_average_sweeps;
        if(is_over)
          m_current = m_first;
      }
      else if(largest_energy > (1. - m_least_fall) * m_largest_energy &&
              average_energy > (1. - m_least_fall) * m_average_energy)
        m_current = (std::min)(growth * m_current, m_last);
    }
    m_average_energy = average_energy;
    m_largest_energy = largest_energy;
    return m_current;
  }

  /// returns the sharpness of the next sweep over a coarse level, which is 0, whatever its energy.
  double on_coarse_level(double /* largest_energy */) const { return 0.; }

  /// returns whether the sharpness has reached its last value.
  bool is_final() const { return m_current == m_last; }

private:
  static constexpr double least_fall_of_average = 1e-3;
  static constexpr double usual_least_fall = 1e-2;
  static constexpr double growth = 1.25;
  static constexpr std::size_t adaptive = static_cast<std::size_t>(-1);

  double m_first, m_last, m_current;
  std::size_t m_number_of_average_sweeps = adaptive;
  double m_least_fall = usual_least_fall;
  double m_average_energy = 0., m_largest_energy = 0.; // before the last sweep
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ABSOLUTE_SHARPNESS_3_H
