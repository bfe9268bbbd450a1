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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_TRANSFORMATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_TRANSFORMATION_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A conformal map of the unit sphere to itself that pushes all points towards one, along the circles through it and its
// opposite. Together with the rotations, these generate all that preserve the orientation.
class Moebius_transformation
{
public:
  // Pushes towards c / |c|, the more so the closer |c| < 1 is to 1.
  explicit Moebius_transformation(const Vector_3d& c)
    : m_c(c)
    , m_numerator(1. - squared_length(c))
  {}

  Vector_3d operator()(const Vector_3d& u) const
  {
    const Vector_3d s = u + m_c;
    return normalized((m_numerator / squared_length(s)) * s + m_c);
  }

private:
  Vector_3d m_c;
  double m_numerator;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_TRANSFORMATION_H
