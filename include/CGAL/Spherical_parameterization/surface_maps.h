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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_H

/// \file Spherical_parameterization/surface_maps.h
/// Convenience header file that includes the functions for maps between two surfaces: `map_surface()`, the alignment of
/// spheres, the common refinement of two spheres, and the distortion between surfaces.

#if !defined(DOXYGEN_RUNNING) && __cplusplus < 201703L && !(_MSVC_LANG >= 201703L)
#error "Spherical_parameterization needs C++17: compile with -std=c++17 or newer."
#else

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/Distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Sphere_alignment_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Surface_map_report.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Surface_mapper_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Surface_refinement_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/align_spheres.h>
#include <CGAL/Spherical_parameterization/Surface_maps/map_surface.h>
#include <CGAL/Spherical_parameterization/Surface_maps/measure_distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/overlay.h>
#include <CGAL/Spherical_parameterization/Surface_maps/split_bent_faces.h>
#include <CGAL/Spherical_parameterization/Surface_maps/split_blocking_edges.h>

#endif // C++17

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_H
