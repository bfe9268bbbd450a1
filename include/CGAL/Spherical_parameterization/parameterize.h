// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Bijective_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Error_code.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#ifndef CGAL_LINKED_WITH_TBB
#include <type_traits>
#endif

/// \file parameterize.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMainFunction
///
/// computes a one-to-one map from a triangle mesh to a sphere around the origin with a given method.
///
/// The map is linear on each face followed by the projection along the rays from the origin. A face that is
/// counterclockwise seen from outside the surface is counterclockwise seen from outside the sphere. The mesh is not
/// changed.
///
/// If `OK` is returned, the map is a bijection. This has been certified by exact predicates on the points as they are
/// in `vertex_sphere_map`: every face is positively oriented about the origin, and the faces cover the sphere once. The
/// points are rounded and so not exactly on the sphere.
///
/// The result does not depend on the number of threads. Placing the surface elsewhere in space or scaling it changes
/// the result by rounding only. So does renumbering its vertices, unless the shape is so regular that the choice
/// between equals falls to the order.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
///         `Parallel_tag`, and `Parallel_if_available_tag`.
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam Parameterizer a model of `SphericalParameterizer_3`; the object itself is used, so that it can be asked for
///         its report afterwards
/// \tparam VertexSphereMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a triangle mesh that is closed, connected and of genus 0; isolated vertices are skipped, faces without
///        area are allowed
/// \param parameterizer the method
/// \param vertex_sphere_map the map to be written; it is left as it is if an error is returned by a method that
///        promises a bijection
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t`
///                     must be available in `TriangleMesh`.}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the most sweeps over the vertices of `tmesh` itself, or the most steps of a method that
///                           moves all vertices at once}
///     \cgalParamType{unsigned int}
///     \cgalParamDefault{`100`; `2000` for `Published_low_distortion_parameterizer_3`, `500` for
///                       `ARAP_parameterizer_3`}
///     \cgalParamExtra{Not used by `Hierarchical_parameterizer_3`, `Stereographic_parameterizer_3` and
///                     `Precomputed_parameterizer_3`.}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time in seconds after which the map reached by then is certified and returned. The
///                           first map is completed in any case, with the least effort.}
///     \cgalParamType{double}
///     \cgalParamDefault{no limit, as with any value that is not positive}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{a visitor that is told of the progress and may stop it}
///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
///     \cgalParamDefault{`Default_visitor`}
///     \cgalParamExtra{Not used by `Precomputed_parameterizer_3`; `Stereographic_parameterizer_3`, which makes one
///                     step, cannot be stopped, and neither knows `maximum_running_time`.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`, or what is wrong with the mesh or a parameter; see `get_error_message()`
///
/// \pre `tmesh` has fewer than 2^32 halfedges.
///
/// \note Calls at the same time are safe, also for the same mesh, which is only read, as long as they write different
///        maps.
///
/// \sa `CGAL::Spherical_parameterization::is_bijective()`
/// \sa `CGAL::Spherical_parameterization::measure_distortion()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class Parameterizer,
          class VertexSphereMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code parameterize(const TriangleMesh& tmesh, Parameterizer&& parameterizer, VertexSphereMap vertex_sphere_map,
                        const CGAL_NP_CLASS& np = parameters::default_values())
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif
  return parameterizer.template parameterize<ConcurrencyTag>(tmesh, vertex_sphere_map, np);
}

/// \ingroup PkgSphericalParameterizationMainFunction
///
/// computes a one-to-one map of low distortion from a triangle mesh to a sphere around the origin: the same with a
/// `Bijective_low_distortion_parameterizer_3<TriangleMesh>`, whose energy, sharpness and radius are a good choice for
/// most surfaces.
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Spherical_parameterization::parameterize<ConcurrencyTag>(
      tmesh, Bijective_low_distortion_parameterizer_3<TriangleMesh>(), vertex_sphere_map, np);
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H
