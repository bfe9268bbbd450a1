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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LANES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LANES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Packed_double.h>

#include <cstddef>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// How to make a number, be it a single one or a packed one.
template <class FT>
struct Lanes
{
  static constexpr std::size_t width = FT::width;
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE FT load(const double* values) { return FT::load(values); }
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE void store(const FT& a, double* values) { a.store(values); }
  template <class Function>
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE FT generate(const Function& f)
  {
    return FT::generate(f);
  }
};

template <>
struct Lanes<double>
{
  static constexpr std::size_t width = 1;
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE double load(const double* values) { return *values; }
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE void store(double a, double* values) { *values = a; }
  template <class Function>
  static CGAL_SPHERICAL_PARAMETERIZATION_INLINE double generate(const Function& f)
  {
    return f(std::size_t(0));
  }
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LANES_H
