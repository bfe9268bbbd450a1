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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_MAP_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_MAP_SURFACE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Surface_mapper_3.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// maps a surface one-to-one onto another one, with low distortion in both directions, by means of their maps to the sphere.
/// What it finds is a direction for each vertex of the first surface. As a map to the sphere of the second one, the
/// directions are as certified as any map of this package, and so is the map between the surfaces that they make: from a
/// face of the first one to the sphere, and from there by the inverse of the second map. What lies in a direction is found
/// with `Sphere_locator_3`; `remesh_through_sphere()` gives the second surface with the connectivity of the first one,
/// `transfer()` carries properties over, and `overlay()` is the common refinement.
/// Schmidt et al. have maps of the same form \cgalCite{cgal:scbk-ismccm-20}.
///
/// Features rotate the spheres against each other, see `align_spheres()`, and so do extremities that may correspond, by the
/// distances of their tips along the surfaces. Unless the surfaces are copies, several such starts are taken through
/// the descent on coarse levels, led by the features and by the distances from those tips. The start that agrees best and
/// stretches least is lowered further, led by eigenfunctions of the Laplacian of both surfaces, and taken to the finest level; if
/// others are nearly as good, a finer level chooses among them first. The symmetric
/// Dirichlet energy of the map \cgalCite{cgal:ss-bpfb-15}, integrated over both surfaces, is lowered by the steps that
/// `Bijective_low_distortion_parameterizer_3` makes, level by level of a hierarchy \cgalCite{cgal:saph-ism-04}, together with
/// terms for soft landmarks and for features. What a face sees of the second surface is the metric that this gives to its
/// sphere. If the spheres agree as they are, the result is the rotation itself, unless the descent has lowered the energy of
/// the common refinement.
///
/// An atlas that is a sphere with features, and no surface otherwise, is one whose vertices lie on it: the `vertex_point_map` of
/// the second mesh is its map to the sphere. The distortion that is lowered then is that of the first surface on
/// the atlas; if the `vertex_point_map` of the first mesh is its map to the sphere as well, that between the spheres.
///
/// A visitor or a time limit may end a run at any time, in the alignment as well: the map that has been reached is certified
/// and written. Landmarks may be missed then that more sweeps would have met.
///
/// The running time is nearly linear in the size of the meshes: for 26,000 vertices each, some four seconds on two threads.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh1,TriangleMesh2 models of `FaceListGraph`
/// \tparam VertexSphereMap1,VertexSphereMap2 models of `ReadablePropertyMap` from the vertices of the meshes to `%Point_3`
///         of a \cgal kernel; the coordinates are of type `double` or `float`
/// \tparam SurfaceMapper `Surface_mapper_3<TriangleMesh1, TriangleMesh2>`
/// \tparam VertexDirectionMap a model of `WritablePropertyMap` from the vertices of `TriangleMesh1` to `%Point_3` of a
///         \cgal kernel
/// \tparam NamedParameters1,NamedParameters2 sequences of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh1,tmesh2 the first surface and the second one
/// \param vertex_sphere_map1,vertex_sphere_map2 the images of their vertices, at any distance from the origin
/// \param mapper the method: landmarks and features, if any. Its report has the results.
/// \param vertex_direction_map receives for each vertex of the first surface its direction on the sphere of the second
///        one, a point at distance 1 of the origin. It may be `vertex_sphere_map1`.
/// \param np1,np2 optional sequences of \ref bgl_namedparameters "Named Parameters" among the ones listed below; of
///        `np2`, only `vertex_point_map` is used
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh1`, or `tmesh2`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh1)`, or of `tmesh2`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{a visitor that follows the progress, and may end the run}
///     \cgalParamType{a class model of `SphericalParameterizationVisitor`, or `std::ref()` of one}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time limit in seconds; none if it is not positive}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`: the map is certified, whether all landmarks are met or not; the defect of the first mesh, or else of the
///         second one, see `find_defect()`, or with its map: `ERROR_NO_1_TO_1_MAPPING` if that is no bijection;
///         `ERROR_NON_FINITE_COORDINATE` if a point is not finite; `ERROR_INVALID_LANDMARK` if a vertex has two landmarks,
///         or a landmark is no vertex of a face; `ERROR_WRONG_PARAMETER` if the weight of landmarks is not positive, one of
///         features negative, weights are not as many as features or all 0, a value of a feature is not finite, or a mask leaves
///         nothing; or `ERROR_INSUFFICIENT_PRECISION` if doubles, or the numbers
///         of the map, cannot hold the result. Nothing is written then.
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh1, class VertexSphereMap1,
          class TriangleMesh2, class VertexSphereMap2, class SurfaceMapper, class VertexDirectionMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS_1, typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Error_code map_surface(const TriangleMesh1& tmesh1, VertexSphereMap1 vertex_sphere_map1, const TriangleMesh2& tmesh2,
                       VertexSphereMap2 vertex_sphere_map2, SurfaceMapper&& mapper,
                       VertexDirectionMap vertex_direction_map,
                       const CGAL_NP_CLASS_1& np1 = parameters::default_values(),
                       const CGAL_NP_CLASS_2& np2 = parameters::default_values())
{
  return mapper.template map_surface<ConcurrencyTag>(tmesh1, vertex_sphere_map1, tmesh2, vertex_sphere_map2,
                                                     vertex_direction_map, np1, np2);
}

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// maps a surface one-to-one onto another one, with nothing known of them but their shapes and their maps to the sphere;
/// otherwise as the function above.
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh1, class VertexSphereMap1,
          class TriangleMesh2, class VertexSphereMap2, class VertexDirectionMap, typename CGAL_NP_TEMPLATE_PARAMETERS_1,
          typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Error_code map_surface(const TriangleMesh1& tmesh1, VertexSphereMap1 vertex_sphere_map1, const TriangleMesh2& tmesh2,
                       VertexSphereMap2 vertex_sphere_map2, VertexDirectionMap vertex_direction_map,
                       const CGAL_NP_CLASS_1& np1 = parameters::default_values(),
                       const CGAL_NP_CLASS_2& np2 = parameters::default_values())
{
  return Spherical_parameterization::map_surface<ConcurrencyTag>(tmesh1, vertex_sphere_map1, tmesh2, vertex_sphere_map2,
                                                                 Surface_mapper_3<TriangleMesh1, TriangleMesh2>(),
                                                                 vertex_direction_map, np1, np2);
}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_MAP_SURFACE_H
