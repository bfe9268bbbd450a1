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
/// maps a surface bijectively onto another one, with low distortion in both directions, by means of their maps to the sphere.
///
/// The result is a direction on the sphere of the second surface for each vertex of the first surface. The directions are a
/// map of the first surface to this sphere. Its composition with the inverse of the second map is the map between the
/// surfaces. To evaluate it, use `Sphere_locator_3` for the point of the second surface in a given direction,
/// `remesh_through_sphere()` for the second surface with the connectivity of the first one, `transfer()` for properties, and
/// `overlay()` for the common refinement. Schmidt et al. represent maps in the same way \cgalCite{cgal:scbk-ismccm-20}.
///
/// <b>Guarantee.</b> If `OK` is returned, the map to the sphere is certified bijective like all maps of this package, and so
/// is the map between the surfaces. A visitor or a time limit may stop a run at any time, including the alignment: the current
/// map is certified and written. Landmarks that further sweeps would have met may then be missed.
///
/// <b>Method.</b> Several alignments of the spheres are proposed by features and by extremities, and compared by descents on
/// coarse levels. The best one is refined: the symmetric Dirichlet energy of the map \cgalCite{cgal:ss-bpfb-15}, integrated over
/// both surfaces, is minimized on the levels of a hierarchy \cgalCite{cgal:saph-ism-04}, together with terms for soft landmarks
/// and features. If the spheres of copies differ by a rotation, this is the result, unless the descent lowers the energy on the
/// common refinement. See \ref PkgSphericalParameterizationHowItWorks for details.
///
/// <b>Atlases.</b> For an atlas that consists of a sphere with features and has no other surface, use its map to the sphere as
/// `vertex_point_map` of the second mesh. The minimized distortion is then that of the map from the first surface to the
/// atlas. If the `vertex_point_map` of the first mesh is also its map to the sphere, it is the distortion between the spheres.
///
/// <b>Complexity.</b> The running time is nearly linear in the size of the meshes: about four seconds on two threads for
/// 26,000 vertices each.
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
/// \param tmesh1,tmesh2 the first and the second surface
/// \param vertex_sphere_map1,vertex_sphere_map2 the images of their vertices, at any distance from the origin
/// \param mapper the method, with its landmarks and features, if any; its report receives the results
/// \param vertex_direction_map receives for each vertex of the first surface its direction on the sphere of the second
///        one, a point at distance 1 from the origin. It may be `vertex_sphere_map1`.
/// \param np1,np2 optional sequences of \ref bgl_namedparameters "Named Parameters" among the ones listed below; for
///        `np2`, only `vertex_point_map` is used
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh1`, or `tmesh2`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh1)`, or of `tmesh2`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{a visitor that follows the progress, and may stop the run}
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
/// \return `OK`: the map is certified bijective, whether or not all landmarks are met; the defect of the first mesh, or of the
///         second one if the first one has none, see `find_defect()`, or the defect of its map: `ERROR_NO_1_TO_1_MAPPING` if
///         it is not bijective; `ERROR_NON_FINITE_COORDINATE` if a point is not finite; `ERROR_INVALID_LANDMARK` if a vertex
///         belongs to two landmarks, or a landmark is not a vertex of a face; `ERROR_WRONG_PARAMETER` if the weight of
///         landmarks is not positive, a weight of features is negative, the number of weights differs from the number of
///         features, all weights are 0, the value of a feature is not finite, or a mask excludes all vertices; or
///         `ERROR_INSUFFICIENT_PRECISION` if the result cannot be represented in double precision, or in the number type of
///         the map. Nothing is written if an error is returned.
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
/// maps a surface bijectively onto another one as the function above does, without landmarks and with default settings.
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
