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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SHARPNESS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SHARPNESS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <cstddef>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

#ifndef DOXYGEN_RUNNING
namespace internal {
class Sharpness_rule;
}
#endif

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Sharpness` sets the weight of the worst faces in the objective of the descent. The sharpness \f$ s \f$ is
/// the exponent in \f$ \sum \exp( s E ) \f$ (eq. 7 of \cgalCite{cgal:whfl-bspld-16}): the larger it is, the more the
/// sum is determined by the faces with the largest energies \f$ E \f$. With \f$ s = 0 \f$, the objective is the mean of
/// the energies (eq. 6).
///
/// The class offers two rules.
///
/// - <b>Relative sharpness</b> \f$ \beta \f$, the default. The objective is one function of the map and the radius,
///   through the energies \f$ E \f$ of the faces, and of a level \f$ R \f$:
///   \f[ \Phi = ( 1 - a ) \, \overline{E} + a \left( ( 1 - \tfrac{1}{b} ) R + \tfrac{R}{b} \; \overline{\exp( b ( E / R - 1 )
///   )} \right), \quad a = \frac{\beta}{\beta + 40}, \quad b = \beta + 1, \f]
///   where a bar denotes the mean over the faces. For the optimal \f$ R \f$, the term in the large parentheses is a
///   soft maximum of the energies: it equals the energies if they are all the same, and it approaches the largest
///   energy as \f$ b \f$ grows. It has the unit of the energy, so that the same \f$ \beta \f$ suits all surfaces. The
///   first term controls the other faces.
///
///   The level \f$ R \f$ is fixed during a sweep. The objective of a sweep is then a weighted sum of the objectives of
///   eq. 6 and eq. 7 with \f$ s = b / R \f$. The coarse levels of a hierarchy use eq. 6, except that some with at least
///   2000 vertices minimize \f$ \Phi \f$, with \f$ \beta \leq 20 \f$; see \ref SphericalParameterizationHowItWorksHierarchy.
///
///   With \f$ \beta = 0 \f$, the objective is the mean, which gives the lowest average distortion. Larger values
///   decrease the maximum at the cost of the average. The table lists the isometric distortion relative to
///   \f$ \beta = 0 \f$, as geometric means over 38 meshes. \ref SphericalParameterizationSharpness has an example, and
///   \ref SphericalParameterizationQualityEnergies has values of single meshes.
///
///   | \f$ \beta \f$ | 0 | 3 | 6 | 12 | 20 | 40 | 100 |
///   | :------ | -: | -: | -: | -: | -: | -: | -: |
///   | maximum | 1 | 0.74 | 0.69 | 0.66 | 0.64 | 0.63 | 0.62 |
///   | average | 1 | 1.01 | 1.02 | 1.03 | 1.05 | 1.06 | 1.09 |
///
/// - <b>A schedule</b> of absolute values, as in the paper: \f$ s = 0 \f$ first, then values from 0.1 to 10 by default.
///   The first phase ends when a sweep decreases the average energy by less than one thousandth, or after a given
///   number of sweeps. Then \f$ s \f$ is multiplied by 1.25 whenever a sweep decreases neither the largest nor the
///   average energy by at least one hundredth, or by one thousandth if the number of sweeps of the first phase is
///   given. The coarse levels of a hierarchy use eq. 6.
class Sharpness
{
public:
  /// constructs the default, `balanced()`.
  Sharpness() = default;

  /// returns the relative sharpness 0, which gives the lowest average distortion.
  static Sharpness lowest_average() { return relative(0.); }

  /// returns the relative sharpness 20, which gives a low maximum at a low average. This is the default.
  static Sharpness balanced() { return relative(balanced_beta); }

  /// returns the relative sharpness 40, above which the maximum hardly decreases.
  static Sharpness lowest_worst() { return relative(40.); }

  /// returns the relative sharpness `beta`, from 0 to 10<sup>6</sup>. For values above 20, the descent first converges
  /// for 20 and then continues with `beta`.
  static Sharpness relative(double beta)
  {
    Sharpness result;
    result.m_first = result.m_last = beta;
    return result;
  }

  /// returns the fixed value `s`, 0 < `s` <= 10<sup>6</sup>, from the first sweep on, as in AMIPS
  /// \cgalCite{cgal:flg-clima-15}.
  static Sharpness fixed(double s) { return schedule(s, s); }

  /// returns the schedule from `first` to `last`, 0 < `first` <= `last` <= 10<sup>6</sup>. Sweeps with \f$ s = 0 \f$
  /// come first, as long as they decrease the average energy by one thousandth; there are none if both values are
  /// equal.
  static Sharpness schedule(double first = 0.1, double last = 10.)
  {
    return schedule(first, last, first == last ? 0 : adaptive, 1e-2);
  }

  /// returns the schedule from `first` to `last`, 0 < `first` <= `last` <= 10<sup>6</sup>, after exactly
  /// `number_of_average_sweeps` sweeps with \f$ s = 0 \f$. The paper uses 100.
  static Sharpness schedule(double first, double last, std::size_t number_of_average_sweeps)
  {
    return schedule(first, last, number_of_average_sweeps, 1e-3);
  }

  /// returns whether the values are in their ranges.
  bool is_valid() const { return (m_is_relative ? m_first >= 0. : m_first > 0. && m_first <= m_last) && m_last <= 1e6; }

private:
  friend class internal::Sharpness_rule;

  static constexpr double balanced_beta = 20.; // larger values hardly decrease the maximum, see the table
  static constexpr std::size_t adaptive = static_cast<std::size_t>(-1);

  static Sharpness schedule(double first, double last, std::size_t number_of_average_sweeps, double min_fall)
  {
    Sharpness result;
    result.m_is_relative = false;
    result.m_first = first;
    result.m_last = last;
    result.m_number_of_average_sweeps = number_of_average_sweeps;
    result.m_min_fall = min_fall;
    return result;
  }

  bool m_is_relative = true;
  double m_first = balanced_beta, m_last = balanced_beta; // relative sharpness, or limits of the schedule
  std::size_t m_number_of_average_sweeps = 0;
  double m_min_fall = 0.; // the relative decrease of an energy in a sweep below which the schedule advances
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SHARPNESS_H
