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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_DISTORTION_BETWEEN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_DISTORTION_BETWEEN_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/Distortion_between.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <array>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The fraction of the area of a surface below which a part of it is a sliver: of those that ties or rounding make, nothing can
// be said.
constexpr double default_smallest_area = 1e-10; // as measure_distortion_between() has it

// The edges of a triangle, see Triangle_edges.
inline std::array<Vector_3d, 3> scaled_edges(const std::array<Vector_3d, 3>& p, double factor)
{
  return {factor * (p[2] - p[1]), factor * (p[0] - p[2]), factor * (p[1] - p[0])};
}

// The distortion of a map that is linear in each of these triangles, with their points on both surfaces. If nothing is left
// beside slivers, as where a surface has no area, all measures are infinite. `bending` receives the contribution of each
// triangle to the integral of the logarithm of the energy, if there is one.
Distortion_between distortion_between(const std::array<std::vector<Vector_3d>, 2>& points,
                                      const Index_triangles& triangles, double smallest_area,
                                      const Execution& execution = Execution(), std::vector<double>* bending = nullptr);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/distortion_between_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_DISTORTION_BETWEEN_H
