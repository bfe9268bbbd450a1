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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_LOCATED_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_LOCATED_SURFACE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Sphere_mesh.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>

#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// A surface on its sphere, in which directions can be located. The length that is 1 for its points is 2 to the power of
// `exponent`, see normalize().
struct Located_surface
{
  Surface mesh; // the same surface; all else is in the order of the caller
  Sphere_mesh sphere;
  std::vector<Vector_3d> points;
  int exponent = 0;

  Error_code assign(Surface_on_sphere surface)
  {
    if(const Error_code error = mesh.assign(surface.points, surface.triangles))
      return error;
    points = std::move(surface.points);
    exponent = normalize(points);
    sphere.assign(std::move(surface.images), std::move(surface.triangles));
    sphere.make_grid();
    return OK;
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_LOCATED_SURFACE_H
