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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_FIND_BENT_SIDES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_FIND_BENT_SIDES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Finds the edges of the first surface that split_bent_faces() splits, as sides of its triangles, see Triangle_sides, in the
// order in which they are to be split. Returns the same errors as make_overlay().
Error_code find_bent_sides(Surface_on_sphere first, Surface_on_sphere second, std::optional<std::size_t> max_vertices,
                           std::size_t max_edges, std::vector<std::size_t>& result, Run_control& control,
                           const Execution& execution);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/find_bent_sides_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_FIND_BENT_SIDES_H
