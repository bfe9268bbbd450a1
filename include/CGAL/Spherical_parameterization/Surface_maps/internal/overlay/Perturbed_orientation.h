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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_PERTURBED_ORIENTATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_PERTURBED_ORIENTATION_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cstddef>

namespace CGAL::Spherical_parameterization::internal {

// The orientation about the origin of points of two meshes of the sphere, without degenerate mixed triples: the points a of the first mesh
// are replaced by (1 + E) a, where E is a matrix of infinitesimals.
//
// Let the entries of E, row by row, be d, d^1.1, d^1.2, ... with an infinitesimal d > 0, so that every entry is infinitely smaller than the
// one before, and every product of two of them is infinitely smaller than each entry. With n = a1 x a2, which is not 0 for the ends of an
// edge of a certified mesh,
//   det((1 + E) a1, (1 + E) a2, b) = det(1 + E) n . (1 + E)^-1 b = (1 + ...) (n . b - n . E b + ...),
// where the omitted terms contain products of entries. If n . b = 0, the sign is the opposite of that of the first nonzero product n_i b_j,
// in the order of the entries; it exists, because neither n nor b is 0. In the same way, with m = b1 x b2,
// det(b1, b2, (1 + E) a) = m . a + m . E a has the sign of the first nonzero product m_i a_j if m . a = 0.
//
// Nonzero signs do not change, and neither do signs within one mesh: since det(1 + E) > 0, the first mesh is moved as a whole. Hence all
// signs are those of two certified meshes in general position.
class Perturbed_orientation
{
public:
  using Point_3 = Sphere_kernel::Point_3;

  // For the ends of an edge of the first mesh and a vertex of the second one, or vice versa.
  explicit Perturbed_orientation(bool is_edge_of_first)
    : m_sign_of_tie(is_edge_of_first ? NEGATIVE : POSITIVE)
  {}

  Sign operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    const Sign sign = m_orientation(p, q, r);
    return sign == ZERO ? m_sign_of_tie * sign_of_product(p, q, r) : sign;
  }

private:
  // The sign of the first nonzero product (p x q)_i r_j.
  Sign sign_of_product(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    const std::array<Point_3, 3> units = {Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1)};
    Sign normal = ZERO, coordinate = ZERO;
    for(std::size_t i = 0; i < 3 && normal == ZERO; ++i)
      normal = m_orientation(units[i], p, q);
    for(int j = 0; j < 3 && coordinate == ZERO; ++j)
      coordinate = CGAL::sign(r[j]);
    return normal * coordinate;
  }

  Sign m_sign_of_tie; // times that of the product
  Orientation_about_origin_3<Sphere_kernel> m_orientation;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_PERTURBED_ORIENTATION_H
