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
// to doubles, in normalising them there and in scaling them to the final radius later. Both move a corner by less than
// 6 * 2^-53 altogether, and so the determinant by less than that times the opposite edge. For three corners this is less than
// 18 * 2^-53 * sqrt(2 * sum_of_squared_edges), as no edge is longer than the two others together; the bound leaves a factor
// of 5. `sum_of_squared_edges` is that of two edges of the face.
inline bool is_safely_positive(double determinant, double sum_of_squared_edges)
{
  constexpr double margin = 64. * std::numeric_limits<double>::epsilon();
  return determinant > 0. && determinant * determinant > margin * margin * sum_of_squared_edges;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IS_SAFELY_POSITIVE_H
