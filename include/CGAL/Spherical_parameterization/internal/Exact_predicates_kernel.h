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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXACT_PREDICATES_KERNEL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXACT_PREDICATES_KERNEL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The kernel in which Orientation_about_origin_3 decides exactly about points of `Kernel`, and the conversion of a
// point to it, which never rounds. Coordinates of type double or float become those of one kernel with double, whatever
// their own kernel is; exact number types stay where they are.
template <class Kernel, class FT = typename Kernel::FT>
struct Exact_predicates_kernel
{
  static_assert(!std::is_arithmetic<FT>::value && Algebraic_structure_traits<FT>::Is_exact::value,
                "Coordinates must be of type double or float, or of an exact number type.");

  using type = Kernel;

  static const typename Kernel::Point_3& convert(const typename Kernel::Point_3& p) { return p; }
};

template <class Kernel>
struct Exact_predicates_kernel<Kernel, double>
{
  using type = Exact_predicates_inexact_constructions_kernel;

  static type::Point_3 convert(const typename Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }
};

template <class Kernel>
struct Exact_predicates_kernel<Kernel, float>
{
  using type = Exact_predicates_inexact_constructions_kernel;

  static type::Point_3 convert(const typename Kernel::Point_3& p)
  {
    return {static_cast<double>(p.x()), static_cast<double>(p.y()), static_cast<double>(p.z())};
  }
};

// The same for the point type of a property map.
template <class PropertyMap>
using Exact_predicates_kernel_of_map =
    Exact_predicates_kernel<typename Kernel_traits<typename boost::property_traits<PropertyMap>::value_type>::Kernel>;

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXACT_PREDICATES_KERNEL_H
