// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
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
template <class Barrier>
class Image_area;

template <>
class Image_area<Determinant_barrier_3>
{
public:
  // the area at x = 0
  Image_area(const Vector_3d& p, const Vector_3d& q)

  {
    // The normal p x q of the plane through p, q and the centre. As p and q are offsets of the size of the edge,
    // nothing cancels.
    const Vector_3d n = cross(p, q);
    m_gradient = {n[0] + (p[1] - q[1]), n[1] + (q[0] - p[0]), n[2]};
  }
  Image_area() = default;

  double value() const { return m_gradient[2]; }
  double dx() const { return m_gradient[0]; }
  double dy() const { return m_gradient[1]; }
  // As x = (x, y, -(x^2 + y^2) / 2), up to higher order, the second derivatives follow from the height.
  double dxx() const { return -m_gradient[2]; }
  double dyy() const { return -m_gradient[2]; }
  static constexpr bool has_dxy = false;
  static constexpr double dxy() { return 0.; }

  // the area at x, given the determinant and the normal (p - x) x (q - x) there
  static double value(double determinant, const Vector_3d& /* normal */) { return determinant; }

private:
  Vector_3d m_gradient;
};

template <>
class Image_area<Flat_area_barrier_3>
{
public:
  Image_area(const Vector_3d& p, const Vector_3d& q)
  {
    // The normal (p - x) x (q - x) has the derivative dx x (p - q).
    const Vector_3d n = cross(p, q), w = p - q;
    const Vector_3d nx = {0., -w[2], w[1]}, ny = {w[2], 0., -w[0]}, second = {w[1], -w[0], 0.};
    m_value = length(n);
    const double inverse = 1. / m_value;
    m_dx = inverse * dot(n, nx);
    m_dy = inverse * dot(n, ny);
    m_dxx = inverse * (squared_length(nx) + dot(n, second) - m_dx * m_dx);
    m_dxy = inverse * (dot(nx, ny) - m_dx * m_dy);
    m_dyy = inverse * (squared_length(ny) + dot(n, second) - m_dy * m_dy);
  }
  Image_area() = default;

  double value() const { return m_value; }
  double dx() const { return m_dx; }
  double dy() const { return m_dy; }
  double dxx() const { return m_dxx; }
  double dyy() const { return m_dyy; }
  static constexpr bool has_dxy = true;
  double dxy() const { return m_dxy; }

  static double value(double /* determinant */, const Vector_3d& normal) { return length(normal); }

private:
  double m_value, m_dx, m_dy, m_dxx, m_dxy, m_dyy;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGE_AREA_H
