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
/// The class `Sharpness` says how much the worst faces count: the objective of the descent over the vertices.
///
/// There are two rules.
///
/// - <b>A dial</b> \f$ \beta \f$. The objective is one function of the map and the radius, through the energies
///   \f$ E \f$ of the faces, and of a level \f$ R \f$:
///   \f[ \Phi = ( 1 - a ) \, \overline{E} + a \left( ( 1 - \tfrac{1}{b} ) R + \tfrac{R}{b} \; \overline{\exp( b ( E / R - 1 )
///   )} \right), \quad a = \frac{\beta}{\beta + 40}, \quad b = \beta + 1, \f]
///   where a bar stands for the mean over the faces. At the best \f$ R \f$, the second part is a soft maximum: it has the
///   unit of the energy, so that one \f$ \beta \f$ serves a smooth and a limbed surface, equals the energies where they are
///   all the same, and is nearer to the largest the larger \f$ b \f$ is. The first part holds all other faces meanwhile.
///
///   In a sweep, \f$ R \f$ is fixed, and the objective is a mixture of eq. 6 and of eq. 7 of
///   \cgalCite{cgal:whfl-bspld-16} with the sharpness \f$ s = b / R \f$. The levels of a hierarchy follow eq. 6.
///
///   The dial goes from the lowest average distortion, 0, which is the plain mean of eq. 6, to a low maximum.
///   In the geometric mean over 38 meshes, the isometric distortions are these times those at 0:
///
///   | \f$ \beta \f$ | 0 | 3 | 6 | 12 | 20 | 40 | 100 |
///   | :------ | -: | -: | -: | -: | -: | -: | -: |
///   | maximum | 1 | 0.74 | 0.69 | 0.66 | 0.64 | 0.63 | 0.62 |
///   | average | 1 | 1.01 | 1.02 | 1.03 | 1.04 | 1.06 | 1.09 |
///
///   \ref SphericalParameterizationSharpness has those of single meshes.
/// - <b>A schedule</b> of absolute values, that of the paper: \f$ s = 0 \f$ first, then from 0.1 to 10. The paper
///   leaves eq. 6 after 100 sweeps and names the criterion as open, and of the growth of \f$ s \f$ it says that it
///   adapts. Here \f$ s \f$ is raised by a quarter whenever a sweep has lowered neither the largest nor the average
///   energy by a hundredth. Eq. 6 is left as soon as a sweep lowers the average energy by less than a thousandth, or
///   after a given number of sweeps; as this is the schedule for plain gradient steps, which are slow, a thousandth
///   takes the place of a hundredth then. Coarse levels follow eq. 6.
class Sharpness
{
public:
  /// constructs the default, `balanced()`.
  Sharpness() = default;

  /// returns the dial at 0: the lowest average distortion.
  static Sharpness lowest_average() { return relative(0.); }

  /// returns the dial at 20: a low maximum at a low average.
  static Sharpness balanced() { return relative(balanced_beta); }

  /// returns the dial at 40: the lowest maximum.
  static Sharpness lowest_worst() { return relative(40.); }

  /// returns the dial at `beta`, from 0 to 10<sup>6</sup>.
  static Sharpness relative(double beta)
  {
    Sharpness result;
    result.m_first = result.m_last = beta;
    return result;
  }

  /// returns the fixed value `s`, 0 < `s` <= 10<sup>6</sup>, from the first sweep on, as in AMIPS.
  static Sharpness fixed(double s) { return schedule(s, s); }

  /// returns the schedule from `first` to `last`, 0 < `first` <= `last` <= 10<sup>6</sup>, after as many sweeps with
  /// \f$ s = 0 \f$ as help, or none if both values are the same.
  static Sharpness schedule(double first = 0.1, double last = 10.)
  {
    return schedule(first, last, first == last ? 0 : adaptive, 1e-2);
  }

  /// returns the schedule from `first` to `last`, 0 < `first` <= `last` <= 10<sup>6</sup>, after exactly
  /// `number_of_average_sweeps` sweeps with \f$ s = 0 \f$, of which the paper makes 100.
  static Sharpness schedule(double first, double last, std::size_t number_of_average_sweeps)
  {
    return schedule(first, last, number_of_average_sweeps, 1e-3);
  }

  /// returns whether the values are in their ranges.
  bool is_valid() const { return (m_is_relative ? m_first >= 0. : m_first > 0. && m_first <= m_last) && m_last <= 1e6; }

private:
  friend class internal::Sharpness_rule;

  static constexpr double balanced_beta = 20.; // more hardly lowers the maximum, see the table
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
  double m_first = balanced_beta, m_last = balanced_beta; // the dial, or the ends of the schedule
  std::size_t m_number_of_average_sweeps = 0;
  double m_min_fall = 0.; // of an energy in a sweep, relative: below, the schedule goes on
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SHARPNESS_H
