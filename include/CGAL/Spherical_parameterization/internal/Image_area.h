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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGE_AREA_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGE_AREA_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Determinant_barrier_3.h>
#include <CGAL/Spherical_parameterization/Flat_area_barrier_3.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Twice the area of the image of a face (x, p, q) as a barrier measures it, as a function of its corner x. All corners
// are offsets from one point of the unit sphere, in the frame of that point; the centre of the sphere is at (0, 0, -1).
template <class Barrier, class FT = double>
class Image_area;

template <class FT>
class Image_area<Determinant_barrier_3, FT>
{
public:
  // the area at x = 0
  Image_area(const Vector_3<FT>& p, const Vector_3<FT>& q)

  {
    // The normal p x q of the plane through p, q and the centre. As p and q are offsets of the size of the edge,
    // nothing cancels.
    const Vector_3<FT> n = cross(p, q);
    m_gradient = {n[0] + (p[1] - q[1]), n[1] + (q[0] - p[0]), n[2]};
  }
  Image_area() = default;

  FT value() const { return m_gradient[2]; }
  FT dx() const { return m_gradient[0]; }
  FT dy() const { return m_gradient[1]; }
  // As x = (x, y, -(x^2 + y^2) / 2), up to higher order, the second derivatives follow from the height.
  FT dxx() const { return -m_gradient[2]; }
  FT dyy() const { return -m_gradient[2]; }
  static constexpr bool has_dxy = false;
  static FT dxy() { return FT(0.); }

  // the area at x, given the determinant and the normal (p - x) x (q - x) there
  static FT value(const FT& determinant, const Vector_3<FT>& /* normal */) { return determinant; }

private:
  Vector_3<FT> m_gradient;
};

template <class FT>
class Image_area<Flat_area_barrier_3, FT>
{
public:
  Image_area(const Vector_3<FT>& p, const Vector_3<FT>& q)
  {
    // The normal (p - x) x (q - x) has the derivative dx x (p - q).
    const Vector_3<FT> n = cross(p, q), w = p - q;
    const Vector_3<FT> nx = {FT(0.), -w[2], w[1]}, ny = {w[2], FT(0.), -w[0]}, second = {w[1], -w[0], FT(0.)};
    m_value = length(n);
    const FT inverse = select(m_value > 0., 1. / m_value, FT(0.)); // no direction where there is no area
    m_dx = inverse * dot(n, nx);
    m_dy = inverse * dot(n, ny);
    m_dxx = inverse * (squared_length(nx) + dot(n, second) - m_dx * m_dx);
    m_dxy = inverse * (dot(nx, ny) - m_dx * m_dy);
    m_dyy = inverse * (squared_length(ny) + dot(n, second) - m_dy * m_dy);
  }
  Image_area() = default;

  FT value() const { return m_value; }
  FT dx() const { return m_dx; }
  FT dy() const { return m_dy; }
  FT dxx() const { return m_dxx; }
  FT dyy() const { return m_dyy; }
  static constexpr bool has_dxy = true;
  FT dxy() const { return m_dxy; }

  static FT value(const FT& /* determinant */, const Vector_3<FT>& normal) { return length(normal); }

private:
  FT m_value, m_dx, m_dy, m_dxx, m_dxy, m_dyy;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGE_AREA_H
