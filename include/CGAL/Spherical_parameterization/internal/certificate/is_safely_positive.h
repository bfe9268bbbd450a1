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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_IS_SAFELY_POSITIVE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_IS_SAFELY_POSITIVE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <cstdint>
#include <limits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Whether a face on the unit sphere whose determinant was computed from offsets stays positive when its corners are
// rounded in double precision, both when they are normalized and when they are scaled to the final radius later. In
// total, this moves a corner by less than 6 * 2^-53, and so changes the determinant by less than this number times the
// opposite edge. For three corners, this is less than 18 * 2^-53 * sqrt(2 * sum_of_squared_edges), because no edge is
// longer than the sum of the two others; the bound leaves a factor of 5. `sum_of_squared_edges` is that of two edges of
// the face.
template <class FT>
auto is_safely_positive(const FT& determinant, const FT& sum_of_squared_edges)
{
  constexpr double margin = 64. * std::numeric_limits<double>::epsilon();
  return determinant > 0. && determinant * determinant > margin * margin * sum_of_squared_edges;
}

// The same for the face with these corners on the unit sphere.
inline bool is_safely_positive(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c)
{
  const Vector_3d ab = b - a, ac = c - a;
  return is_safely_positive(dot(a, cross(ab, ac)), squared_length(ab) + squared_length(ac));
}

// The same for all faces of a mesh.
inline bool are_safely_positive(const Vertex_rings& rings, const std::vector<Vector_3d>& positions)
{
  bool result = true;
  rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    result = result && is_safely_positive(positions[a], positions[b], positions[c]);
  });
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_IS_SAFELY_POSITIVE_H
