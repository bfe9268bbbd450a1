// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_SAFELY_POSITIVE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_SAFELY_POSITIVE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <limits>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Whether a face on the unit sphere whose determinant was computed from offsets stays positive when its corners are rounded
// to doubles, there and again after scaling to the final radius. Rounding moves a corner by less than
// 2 sqrt(3) 2^-53 and so the determinant by less than that times the opposite edge, which is at most the sum of the other
// two; the bound leaves a factor above 5 for all three corners. `sum_of_squared_edges` is that of two edges of the face.
inline bool is_safely_positive(double determinant, double sum_of_squared_edges)
{
  constexpr double margin = 64. * std::numeric_limits<double>::epsilon();
  return determinant > 0. && determinant * determinant > margin * margin * sum_of_squared_edges;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_SAFELY_POSITIVE_H
