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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The common refinement of two surfaces, triangulated, with the points of its vertices on both.
struct Overlay_arrays
{
  std::array<std::vector<Vector_3d>, 2> points; // on each surface
  Index_triangles triangles;
  std::vector<std::array<std::uint32_t, 2>> parents; // of the triangles, on each surface
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H
