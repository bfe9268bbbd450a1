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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_GUARDED_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_GUARDED_ENERGY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/internal/evaluate_energy.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// An energy with a share of the area distortion d + 1 / d added, which keeps faces from shrinking without end where the
// energy itself does not mind.
template <class Energy>
class Guarded_energy
{
public:
  using Is_lanewise = Tag_true; // whatever the energy is

  Guarded_energy(const Energy& energy, double weight)
    : m_energy(energy)
    , m_weight(weight)
  {}

  template <class FT>
  FT operator()(const FT& i, const FT& d) const
  {
    return energy_value(m_energy, i, d) + m_weight * (d + 1. / d);
  }

  template <class FT>
  Basic_energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const
  {
    const FT inverse_d = 1. / d;
    Basic_energy_derivatives_3<FT> e = energy_derivatives(m_energy, i, d);
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
