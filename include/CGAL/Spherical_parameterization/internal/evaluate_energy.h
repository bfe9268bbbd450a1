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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EVALUATE_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EVALUATE_ENERGY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/internal/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/Is_lanewise.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The value of an energy, in all lanes: at once if the energy is written for that, else one after the other.
template <class Energy, class FT>
FT energy_value(const Energy& energy, const FT& i, const FT& d)
{
  if constexpr(std::is_same<FT, double>::value || Is_lanewise<Energy, const FT&, const FT&>::value)
    return energy(i, d);
  else
    return FT::generate([&](std::size_t k) { return energy(lane(i, k), lane(d, k)); });
}

// Whether the energy has derivatives for the number type.
template <class Energy, class FT, class = void>
struct Has_derivatives : std::false_type
{};

template <class Energy, class FT>
struct Has_derivatives<
    Energy, FT,
    std::void_t<decltype(std::declval<const Energy&>().derivatives(std::declval<FT>(), std::declval<FT>()))>>
  : std::true_type
{};

// The same with the derivatives.
template <class Energy, class FT>
Basic_energy_derivatives_3<FT> energy_derivatives(const Energy& energy, const FT& i, const FT& d)
{
  if constexpr(std::is_same<FT, double>::value ||
               (Is_lanewise<Energy, const FT&, const FT&>::value && Has_derivatives<Energy, FT>::value))
    return energy.derivatives(i, d);
  else
  {
    Energy_derivatives_3 e[FT::width];
    for(std::size_t k = 0; k < FT::width; ++k)
      e[k] = energy.derivatives(lane(i, k), lane(d, k));
    const auto all = [&](auto member) { return FT::generate([&](std::size_t k) { return e[k].*member; }); };
    return {all(&Energy_derivatives_3::value), all(&Energy_derivatives_3::i),  all(&Energy_derivatives_3::d),
            all(&Energy_derivatives_3::ii),    all(&Energy_derivatives_3::id), all(&Energy_derivatives_3::dd)};
  }
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EVALUATE_ENERGY_H
