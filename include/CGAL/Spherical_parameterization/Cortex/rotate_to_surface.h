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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_ROTATE_TO_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_ROTATE_TO_SURFACE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Cortex/fit_rotation_to_surface.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// The radius of the spheres of FreeSurfer and Connectome Workbench. These spheres are also rotated to the pose of
/// their surfaces, see `rotate_to_surface()`, and have single precision coordinates, see `round_to_float()`.
constexpr double cortical_sphere_radius = 100.;

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// rotates a sphere to match the pose of its surface, see `fit_rotation_to_surface()`. The front of the sphere then
/// corresponds to the front of the surface, as programs for cortical surfaces expect.
///
/// If the map is bijective, the rotated map is so, too; both are decided by exact predicates.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadWritePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a \cgal kernel with
///         coordinates of type `double`
///
/// \param tmesh a closed triangle mesh of genus 0
/// \param vertex_sphere_map the images of its vertices, which are rotated
///
/// \return `OK`; `ERROR_INSUFFICIENT_PRECISION` if rounding inverts a face of a bijective map; or an error code of
///         `fit_rotation_to_surface()`, such as `ERROR_UNDETERMINED_ROTATION`. On an error, the map is unchanged.
template <class TriangleMesh, class VertexSphereMap>
[[nodiscard]] Error_code rotate_to_surface(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map)
{
  using Point_3 = typename boost::property_traits<VertexSphereMap>::value_type;
  Aff_transformation_3<Exact_predicates_inexact_constructions_kernel> rotation(IDENTITY);
  if(const Error_code error = fit_rotation_to_surface(tmesh, vertex_sphere_map, rotation))
    return error;
  const auto rotated = get(dynamic_vertex_property_t<Point_3>(), tmesh);
  for(const auto v : vertices(tmesh))
  {
    const Point_3 p = get(vertex_sphere_map, v);
    const auto row = [&](int i) {
      return rotation.m(i, 0) * p.x() + rotation.m(i, 1) * p.y() + rotation.m(i, 2) * p.z();
    };
    put(rotated, v, Point_3(row(0), row(1), row(2)));
  }
  if(!is_bijective(tmesh, rotated) && is_bijective(tmesh, vertex_sphere_map))
    return ERROR_INSUFFICIENT_PRECISION;
  for(const auto v : vertices(tmesh))
    put(vertex_sphere_map, v, get(rotated, v));
  return OK;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_ROTATE_TO_SURFACE_H
