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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_FIT_ROTATION_TO_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_FIT_ROTATION_TO_SURFACE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>

#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

namespace internal {

// The same for images of length 1, in the order of the surface.
Error_code fit_rotation_to_surface(const Surface& surface, const std::vector<Vector_3d>& images,
                                   Aff_transformation_3<Exact_predicates_inexact_constructions_kernel>& rotation);

} // namespace internal

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// computes the rotation that matches a sphere to the pose of its surface.
///
/// The rotation minimizes the sum of the squared distances between the directions of the images and the directions from
/// the centroid of the surface to the vertices \cgalCite{cgal:h-csaouq-87}. The weight of a vertex is a third of the
/// area of its faces. The front of the rotated sphere then corresponds to the front of the surface, as programs for
/// cortical surfaces expect. The result is never a reflection.
///
/// The running time is linear in the number of faces.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a \cgal kernel
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a closed triangle mesh of genus 0
/// \param vertex_sphere_map the images of its vertices, at any distance from the origin
/// \param rotation receives the rotation to apply to the sphere
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; an error of the mesh, see `find_defect()`; `ERROR_NON_FINITE_COORDINATE` if a point is not finite;
///         `ERROR_INVALID_DIRECTION` if an image is zero or not finite; or `ERROR_UNDETERMINED_ROTATION` if several
///         rotations are optimal. On an error, `rotation` is unchanged.
///
/// \sa `CGAL::Spherical_parameterization::fit_rotation()`
template <class TriangleMesh, class VertexSphereMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code fit_rotation_to_surface(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                   CGAL::Aff_transformation_3<Exact_predicates_inexact_constructions_kernel>& rotation,
                                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  if constexpr(internal::check_mesh_and_readable_map<TriangleMesh, VertexSphereMap>() &&
               internal::check_vertex_point_map<TriangleMesh, CGAL_NP_CLASS>())
  {
    internal::Mesh_arrays<TriangleMesh> mesh;
    internal::Surface surface;
    if(const Error_code error = internal::read_surface(tmesh, internal::vertex_point_map_of(tmesh, np), mesh, surface))
      return error;
    const auto images = surface.in_own_order(internal::read_values(
        mesh.vertices_of_mesh, vertex_sphere_map, [](const auto& p) { return internal::direction_of(p); }));
    if(!internal::are_finite(images))
      return ERROR_INVALID_DIRECTION;
    return internal::fit_rotation_to_surface(surface, images, rotation);
  }
  else
    return ERROR_WRONG_PARAMETER;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Cortex/internal/sulcal_measures_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_FIT_ROTATION_TO_SURFACE_H
