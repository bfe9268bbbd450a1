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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_REST_LIMITS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_REST_LIMITS_H

#include <CGAL/license/Spherical_parameterization.h>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// How flat and how small the shape of a face may be that a Rest_triangle asks for. A flatter one would ask for
// derivatives beyond all measure and freeze its neighbours; it is given the least height instead. One without size has
// no shape that it could ask for; it becomes equilateral.
struct Rest_limits
{
  double height = 1e-4; // over the longest edge, in units of that edge
  double edge = 1e-12;  // the longest one; surfaces are scaled to the area of the unit sphere

  // Whether the surface does not count at all: every face is the same equilateral triangle.
  bool is_uniform = false;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_REST_LIMITS_H
