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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_FIND_ROTATIONS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_FIND_ROTATIONS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Sphere_alignment_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// A surface, the directions of its images, and features, if any, in the order of the caller.
struct Aligned_surface
{
  std::vector<Vector_3d> points, directions;
  std::vector<Linked_triangle> triangles;
  std::vector<std::vector<double>> features;
};

// Finds what align_spheres() does.
Error_code find_rotations(const Aligned_surface& first, const Aligned_surface& second, Sphere_alignment_3& alignment,
                          Run_control& control, const Execution& execution);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/find_rotations_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_FIND_ROTATIONS_H
