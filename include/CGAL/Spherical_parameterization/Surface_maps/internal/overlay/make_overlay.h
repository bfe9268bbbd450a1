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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_MAKE_OVERLAY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_MAKE_OVERLAY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_on_sphere.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/Overlay_arrays.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>

#include <cstddef>
#include <optional>

namespace CGAL::Spherical_parameterization::internal {

// Makes the common refinement, of at most so many vertices if a bound is given. Returns the same errors as Sphere_overlay.
Error_code make_overlay(Surface_on_sphere first, Surface_on_sphere second, std::optional<std::size_t> max_vertices,
                        Overlay_arrays& overlay, Run_control& control, const Execution& execution);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/make_overlay_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_MAKE_OVERLAY_H
