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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_EXACT_PREDICATES_KERNEL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_EXACT_PREDICATES_KERNEL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <limits>
#include <type_traits>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

template <class K, class FT>
class Orientation_about_origin_3
{
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_NO_IEEE_ARITHMETIC
  static_assert(sizeof(K) == 0, "The interval arithmetic of an exact number type is wrong with -ffast-math or -Ofast: "
                                "turn them off, or use points with coordinates of type double.");
#endif
  using Point_3 = typename K::Point_3;

public:
  Sign operator()(const Point_3& a, const Point_3& b, const Point_3& c) const
  {
    if(!is_finite(a) || !is_finite(b) || !is_finite(c))
      return ZERO;
    return m_orientation(m_origin, a, b, c);
  }

private:
  // An exact number cannot be infinite, but a lazy one that was made from infinity or NaN must not be evaluated. Its
  // interval reveals it. A finite number beyond the range of double has one finite end.
  static bool is_finite(const FT& x)
  {
    const std::pair<double, double> interval = CGAL::to_interval(x);
    return interval.first < std::numeric_limits<double>::infinity() &&
           interval.second > -std::numeric_limits<double>::infinity();
  }

  static bool is_finite(const Point_3& p)
  {
    return is_finite(p.x()) && is_finite(p.y()) && is_finite(p.z());
  }

  typename K::Orientation_3 m_orientation = K().orientation_3_object();
  Point_3 m_origin{ORIGIN};
};

// The kernel in which Orientation_about_origin_3 makes exact decisions about points of `Kernel`, and the conversion of
// a point to it, which never rounds. Coordinates of type double or float are converted to one kernel with double,
// whatever their own kernel is; exact number types are not converted.
template <class Kernel>
struct Exact_predicates_kernel
{
  using FT = typename Kernel::FT;
  static constexpr bool has_doubles = std::is_same<FT, double>::value || std::is_same<FT, float>::value;
  static_assert(has_doubles || (!std::is_arithmetic<FT>::value && Algebraic_structure_traits<FT>::Is_exact::value),
                "Coordinates must be of type double or float, or of an exact number type.");

  using type = std::conditional_t<has_doubles, Exact_predicates_inexact_constructions_kernel, Kernel>;

  static typename type::Point_3 convert(const typename Kernel::Point_3& p)
  {
    if constexpr(has_doubles)
      return {static_cast<double>(p.x()), static_cast<double>(p.y()), static_cast<double>(p.z())};
    else
      return p;
  }
};

// The same for the point type of a property map.
template <class PropertyMap>
using Exact_predicates_kernel_of_map =
    Exact_predicates_kernel<typename Kernel_traits<typename boost::property_traits<PropertyMap>::value_type>::Kernel>;

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_EXACT_PREDICATES_KERNEL_H
