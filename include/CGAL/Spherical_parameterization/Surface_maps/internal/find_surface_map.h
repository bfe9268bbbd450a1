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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FIND_SURFACE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FIND_SURFACE_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Sphere_alignment_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Surface_map_report.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Finds a map of the first surface onto the second one: the directions of its vertices on the sphere of the second one, in the order of
// the caller, and their expected errors, if they can be estimated. The map is not certified yet.
Error_code find_surface_map(Surface_on_sphere first_surface, Surface_on_sphere second_surface,
                            Surface_map_settings settings, std::vector<Vector_3d>& directions,
                            std::vector<double>& errors, Surface_map_report& report, Run_control& control,
                            const Execution& execution);

// Implements align_spheres().
Error_code find_rotations(const Surface_to_align& first, const Surface_to_align& second, Sphere_alignment_3& alignment,
                          Run_control& control, const Execution& execution);

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Surface_maps/internal/find_surface_map_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_FIND_SURFACE_MAP_H
