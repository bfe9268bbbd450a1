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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_MEASURE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_MEASURE_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Located_surface.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Sphere_mesh.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_pair.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/energy_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/refine_in_common.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The distance of the point in a direction from a vertex.
inline double distance_left(const Located_surface& surface, const Vector_3d& p, std::size_t w)
{
  Sphere_mesh::Hint hint;
  const auto location = surface.sphere.locate(point_of(p), hint);
  return std::ldexp(length(interpolated(surface.points, surface.sphere.triangles(), location) - surface.points[w]),
                    surface.exponent);
}

// The energy of a map between surfaces: the mean of both directions.
struct Map_energy
{
  std::optional<double> value; // There is none once the run has been stopped.
  bool is_sampled = false;
  std::optional<Distortion_between> distortion; // unless it is sampled
};

// Measures the map that puts the vertices of the first surface at these directions of the second one's sphere: on the common
// refinement, or by samples if that would be too large. Returns false if the map is no bijection.
inline bool measure_map(const Surface_pair& pair, const std::vector<Vector_3d>& directions, Map_energy& energy)
{
  const std::vector<Vector_3d>&points1 = pair.first.points, &points2 = pair.second.points;
  const Sphere_mesh& sphere2 = pair.second.sphere;
  Sphere_mesh sphere1;
  sphere1.assign(points_of(directions), pair.first.sphere.triangles());
  if(!certify_bijectivity<Sphere_kernel>(sphere1.points(), sphere1.triangles(), pair.execution).is_bijective())
    return false;
  Overlay_arrays overlay;
  const Error_code error =
      refine_in_common(sphere1, points1, sphere2, points2, std::nullopt, overlay, pair.control, pair.execution);
  if(error == OK)
  {
    const Distortion_between measured =
        distortion_between(overlay.points, overlay.triangles, default_smallest_area, pair.execution);
    energy = {0.5 * (measured.energy.average_over_first + measured.energy.average_over_second), false, measured};
  }
  else if(error == ERROR_TOO_LARGE_OVERLAY)
  {
    sphere1.make_grid();
    const double there = mean_energy_over_first(sphere1, points1, sphere2, points2, pair.control, pair.execution),
                 back = mean_energy_over_first(sphere2, points2, sphere1, points1, pair.control, pair.execution);
    if(!pair.control.is_stopped())
      energy = {0.5 * (there + back), true, std::nullopt};
  }
  return error != ERROR_NO_1_TO_1_MAPPING;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_MEASURE_MAP_H
