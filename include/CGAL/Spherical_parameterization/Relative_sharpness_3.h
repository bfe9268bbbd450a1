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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_RELATIVE_SHARPNESS_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_RELATIVE_SHARPNESS_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <cstddef>

/// \file Relative_sharpness_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSharpness
///
/// The class `Relative_sharpness_3` chooses the sharpness \f$ s = \beta / E_{max} \f$ of the objective
/// \f$ \sum \exp( s E ) \f$, where \f$ E_{max} \f$ is the largest energy of the map at hand. It is the default of the
/// package.
///
/// The objective is eq. 7 of \cgalCite{cgal:whfl-bspld-16}, whose \f$ s \f$ is a number. Relative to the map, it has no
/// scale, so that one \f$ \beta \f$ serves a smooth and a limbed surface, the coarse levels of a hierarchy and the
/// finest, and needs no phase of its own for the plain sum of eq. 6, which is \f$ \beta = 0 \f$.
///
/// \f$ \beta \f$ is a dial from the lowest average distortion, 0, to a low maximum; beyond 50 it may rise again, as the
/// sweeps of the default do not bring so sharp an objective to its end. With 13.5, the default, the average is 3 to 20
/// percent above the lowest; \ref SphericalParameterizationSharpness has a table.
///
/// \cgalModels{SharpnessPolicy_3}
///
/// \sa `Absolute_sharpness_3`
class Relative_sharpness_3
{
public:
  /// constructs the policy with the dial `beta`, from 0 to 10<sup>6</sup>.
  explicit Relative_sharpness_3(double beta = 13.5)
    : m_beta(beta)
  {}

  /// returns the dial.
  double beta() const { return m_beta; }

  /// returns whether the dial is in its range.
  bool is_valid() const { return m_beta >= 0. && m_beta <= 1e6; }

  /// returns the sharpness of the next sweep over the mesh, or over a level that is nearly as fine,
  /// `beta() / largest_energy`, or 0 if that energy is 0.
  ///
  /// \param largest_energy the largest energy of a face before the sweep
  double operator()(std::size_t /* sweep */, double /* average_energy */, double largest_energy)
  {
    return relative(m_beta, largest_energy);
  }

  /// returns the sharpness of the next sweep over a coarse level, with \f$ \beta^2 / (\beta + 47) \f$ in the place of
  /// \f$ \beta \f$.
  ///
  /// The worst faces of a coarse mesh are partly so for being coarse, so less than a quarter of the default dial is
  /// enough there; where only the maximum counts, the large features have to make room for it from the beginning.
  ///
  /// \param largest_energy the largest energy of a face of the level
  double on_coarse_level(double largest_energy) const
  {
    return relative(m_beta * m_beta / (m_beta + 47.), largest_energy);
  }

  /// returns `true`: the sharpness follows the map only, and settles with it.
  bool is_final() const { return true; }

private:
  // An energy may be 0 at its minimum, and a map may reach it.
  static double relative(double beta, double largest_energy)
  {
    return largest_energy > 0. ? beta / largest_energy : 0.;
  }

  double m_beta;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_RELATIVE_SHARPNESS_3_H
