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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ISOMETRIC_ENERGY_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ISOMETRIC_ENERGY_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>

#include <array>
#include <cmath>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationEnergies
///
/// The class `Isometric_energy_3` is the energy of the BLD paper, a weighted sum of the angle distortion \f$ I / d \f$
/// and the area distortion \f$ d + 1 / d \f$.
///
/// This is eq. 2 of \cgalCite{cgal:whfl-bspld-16},
/// \f[ E = \alpha \frac{I}{d} + (1 - \alpha) \left( d + \frac{1}{d} \right), \f]
/// which the paper uses with \f$ \alpha = 1/2 \f$ for isometric maps. The energy is at least 2, with equality for an
/// isometry.
///
/// \cgalModels{DistortionEnergy_3}
///
/// \sa `Symmetric_Dirichlet_energy_3`
/// \sa `Conformal_energy_3`
class Isometric_energy_3
{
public:
  /// constructs the energy with the weight `alpha` of the angle distortion, greater than 0 and at most 1.
  explicit Isometric_energy_3(double alpha = 0.5)
    : m_alpha(alpha)
  {}

  /// returns the weight of the angle distortion.
  double alpha() const { return m_alpha; }

  /// returns whether the weight is in its range.
  bool is_valid() const { return m_alpha > 0. && m_alpha <= 1.; }

  /// returns the energy of a triangle with the invariants `i` and `d`, both positive.
  template <class FT>
  FT operator()(const FT& i, const FT& d) const
  {
    return (m_alpha * i + (1. - m_alpha)) / d + (1. - m_alpha) * d;
  }

  /// returns the energy of a triangle with the invariants `i` and `d`, both positive, and its derivatives in them.
  template <class FT>
  Energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const
  {
    const double beta = 1. - m_alpha;
    const FT inverse_d = 1. / d;
    const FT pole = (m_alpha * i + beta) * inverse_d; // the part of the energy with a pole at d = 0
    return {pole + beta * d,
            m_alpha * inverse_d,
            beta - pole * inverse_d,
            FT(0.),
            -m_alpha * inverse_d * inverse_d,
            2. * pole * inverse_d * inverse_d};
  }

  /// returns the factor that minimizes the sum of the energies of `faces` when the radius is multiplied by it.
  ///
  /// It is \f$ ( \sum d^{-1} / \sum d )^{1/4} \f$ (eq. 11). If `alpha` is 1, the energy does not depend on the radius,
  /// and the factor is 1. The function takes linear time.
  double optimal_scale(const Face_range_3& faces) const
  {
    if(m_alpha == 1.)
      return 1.;
    const auto [sum, sum_of_inverses] = faces.sums<2>([](const Face_invariants_3& face) {
      return std::array<double, 2>{face.d, 1. / face.d};
    });
    return std::sqrt(std::sqrt(sum_of_inverses / sum));
  }

private:
  double m_alpha;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ISOMETRIC_ENERGY_3_H
