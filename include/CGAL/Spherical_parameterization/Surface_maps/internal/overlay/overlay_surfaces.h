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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_SURFACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_SURFACES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>

#include <optional>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Computes the common refinement, with at most `max_vertices` vertices if a bound is given. Returns the same errors as Sphere_overlay.
Error_code make_overlay(Surface_on_sphere first, Surface_on_sphere second, std::optional<std::size_t> max_vertices,
                        Overlay_arrays& overlay, Run_control& control, const Execution& execution);

// Finds the edges of the first surface that split_bent_faces() splits, as sides of its triangles, see Triangle_sides, in the order in
// which they must be split. Returns the same errors as make_overlay().
Error_code find_bent_sides(Surface_on_sphere first, Surface_on_sphere second, std::optional<std::size_t> max_vertices,
                           std::size_t max_edges, std::vector<std::size_t>& result, Run_control& control,
                           const Execution& execution);

// The fraction of the area of a surface below which a triangle is a sliver: measures of triangles caused by ties or rounding errors are
// meaningless.
constexpr double default_smallest_area = 1e-10; // the same as in measure_distortion_between()

// The scaled edges of a triangle, see Triangle_edges.
inline std::array<Vector_3d, 3> scaled_edges(const std::array<Vector_3d, 3>& p, double factor)
{
  return {factor * (p[2] - p[1]), factor * (p[0] - p[2]), factor * (p[1] - p[0])};
}

// The distortion of a map that is linear in each of these triangles, given their points on both surfaces. If all triangles are slivers,
// for example because a surface has no area, all measures are infinite. If `bending` is not null, it receives the contribution of each
// triangle to the integral of the logarithm of half the energy.
Distortion_between distortion_between(const std::array<std::vector<Vector_3d>, 2>& points,
                                      const Index_triangles& triangles, double smallest_area,
                                      const Execution& execution = Execution(), std::vector<double>* bending = nullptr);

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/overlay_surfaces_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_SURFACES_H
