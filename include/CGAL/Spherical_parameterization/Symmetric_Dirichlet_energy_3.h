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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SYMMETRIC_DIRICHLET_ENERGY_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SYMMETRIC_DIRICHLET_ENERGY_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>

#include <array>
#include <cmath>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationEnergies
///
/// The class `Symmetric_Dirichlet_energy_3` is the symmetric Dirichlet energy \cgalCite{cgal:ss-bpfb-15}. It is the
/// default energy of the package.
///
/// The energy
/// \f[ E = \tfrac{1}{2} ( \sigma_1^2 + \sigma_2^2 + \sigma_1^{-2} + \sigma_2^{-2} ) = \tfrac{1}{2} I ( 1 + d^{-2} ) \f]
/// is at least 2, with equality for an isometry. It grows with the square of the isometric distortion
/// \f$ \max \{ \sigma_2, 1 / \sigma_1 \} \f$, and therefore penalizes the worst faces more than `Isometric_energy_3`
/// does.
///
/// \cgalModels{DistortionEnergy_3}
///
/// \sa `Conformal_energy_3`
class Symmetric_Dirichlet_energy_3
{
public:
  /// returns the energy of a triangle with the invariants `i` and `d`, both positive.
  template <class FT>
  FT operator()(const FT& i, const FT& d) const
  {
    return 0.5 * i * (1. + 1. / (d * d));
  }

  /// returns the energy of a triangle with the invariants `i` and `d`, both positive, and its derivatives in them.
  template <class FT>
  Energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const
  {
    const FT inverse_d = 1. / d;
    const FT inverse_d2 = inverse_d * inverse_d;
    const FT inverse_d3 = inverse_d2 * inverse_d;
    return {0.5 * i * (1. + inverse_d2),     0.5 * (1. + inverse_d2), -i * inverse_d3, FT(0.), -inverse_d3,
            3. * i * inverse_d2 * inverse_d2};
  }

  /// returns the factor that minimizes the sum of the energies of `faces` when the radius is multiplied by it.
  ///
  /// A factor \f$ \rho \f$ changes \f$ (I, d) \f$ to \f$ (\rho^2 I, \rho^2 d) \f$, so the optimal factor is
  /// \f$ ( \sum I d^{-2} / \sum I )^{1/4} \f$. The function takes linear time.
  double optimal_scale(const Face_range_3& faces) const
  {
    const auto [sum_of_i, sum_of_i_over_d2] = faces.sums<2>([](const Face_invariants_3& face) {
      return std::array<double, 2>{face.i, face.i / (face.d * face.d)};
    });
    return std::sqrt(std::sqrt(sum_of_i_over_d2 / sum_of_i));
  }
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SYMMETRIC_DIRICHLET_ENERGY_3_H
