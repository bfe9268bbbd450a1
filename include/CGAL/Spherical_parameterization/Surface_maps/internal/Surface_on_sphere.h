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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_ON_SPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_ON_SPHERE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The kernel of all images on spheres that are compared with others.
using Sphere_kernel = Exact_predicates_inexact_constructions_kernel;

// A surface and its map to the sphere, as they have been read: in the order of the caller.
struct Surface_on_sphere
{
  std::vector<Vector_3d> points;
  std::vector<Sphere_kernel::Point_3> images;
  std::vector<Linked_triangle> triangles;
};

// A surface, the directions of its images, and features, if any, in the order of the caller.
struct Aligned_surface
{
  std::vector<Vector_3d> points, directions;
  std::vector<Linked_triangle> triangles;
  std::vector<std::vector<double>> features;
};

// The common refinement of two surfaces, triangulated, with the points of its vertices on both.
struct Overlay_arrays
{
  std::array<std::vector<Vector_3d>, 2> points; // on each surface
  Index_triangles triangles;
  std::vector<std::array<std::uint32_t, 2>> parents; // of the triangles, on each surface
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_ON_SPHERE_H
