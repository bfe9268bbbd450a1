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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_MAKE_OVERLAY_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_MAKE_OVERLAY_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Sphere_mesh.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/make_overlay.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/refine_in_common.h>

#include <utility>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE
Error_code make_overlay(Surface_on_sphere first, Surface_on_sphere second, std::optional<std::size_t> max_vertices,
                        Overlay_arrays& overlay, Run_control& control, const Execution& execution)
{
  Sphere_mesh sphere1, sphere2;
  sphere1.assign(std::move(first.images), std::move(first.triangles));
  sphere2.assign(std::move(second.images), std::move(second.triangles));
  return refine_in_common(sphere1, first.points, sphere2, second.points, max_vertices, overlay, control, execution);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_MAKE_OVERLAY_IMPL_H
