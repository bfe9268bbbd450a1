// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_GUARDED_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_GUARDED_ENERGY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// An energy with a share of the area distortion d + 1 / d added, which keeps faces from shrinking without end where the
// energy itself does not mind.
template <class Energy>
class Guarded_energy
{
public:
  Guarded_energy(const Energy& energy, double weight)
    : m_energy(energy)
    , m_weight(weight)
  {}

  double operator()(double i, double d) const { return m_energy(i, d) + m_weight * (d + 1. / d); }

  Energy_derivatives_3 derivatives(double i, double d) const
  {
    const double inverse_d = 1. / d;
    Energy_derivatives_3 e = m_energy.derivatives(i, d);
    e.value += m_weight * (d + inverse_d);
    e.d += m_weight * (1. - inverse_d * inverse_d);
    e.dd += 2. * m_weight * inverse_d * inverse_d * inverse_d;
    return e;
  }

private:
  Energy m_energy;
  double m_weight;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_GUARDED_ENERGY_H
