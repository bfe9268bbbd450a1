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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H

#if !defined(DOXYGEN_RUNNING) && __cplusplus < 201703L && !(_MSVC_LANG >= 201703L)
#error "Spherical_parameterization needs C++17: compile with -std=c++17 or newer."
#else

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Bijective_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMainFunction
///
/// computes a one-to-one map from a triangle mesh to a sphere around the origin with a given method.
///
/// The map is linear on each face followed by the projection along the rays from the origin. A face that is
/// counterclockwise seen from outside the surface is so from outside the sphere. The mesh is not changed.
///
/// <b>Guarantee.</b> If `OK` is returned, the map is a bijection. This has been certified by exact predicates on the
/// points as they are in `vertex_sphere_map`: every face is positively oriented about the origin, and the faces cover
/// the sphere once. The points are rounded and so not exactly on the sphere. They are certified before they are
/// written, and if the map can be read and holds other values, for example because it rounds numbers once more, these
/// are certified as well: if they fold, `ERROR_INSUFFICIENT_PRECISION` is returned, and the map has been overwritten. A
/// map that can only be written has to hold the points as they are. The certificate is right for any compile flags:
/// with those that change floating-point arithmetic, such as `-ffast-math`, points with coordinates of type `double` or
/// `float` are certified by integer arithmetic, and exact kernels do not compile.
///
/// The default method returns `OK` for every mesh that `find_defect()` finds nothing wrong with, whatever its shape:
/// faces without area, needles, vertices in one place, self-intersections and any orientation included. Up to 10,000,000
/// vertices there is a theorem behind this, unless the sphere is smaller than 1e-289. The points of a sphere that are stored as floating-point numbers are about 10<sup>-16</sup> radii
/// apart, and a vertex at the tip of many nested triangles must be mapped into all of them. The method spends the area of the
/// sphere such that chains of tens of thousands fit, and starts again with more room for the smallest faces if doubles do not
/// hold a map; if none of this helped, it would start from the map of `Schnyder_parameterizer_3`, which exists for every mesh
/// and whose determinants are above rounding. If the coordinates in `vertex_sphere_map` are of type `float`, whose numbers are
/// 10<sup>-7</sup> radii apart, `ERROR_INSUFFICIENT_PRECISION` is returned where the rounding to them turns a face over.
///
/// <b>Stopping early.</b> Once the first map is there, which is completed in any case, with minimum effort, the run may be
/// stopped at any time, and `OK` means the same.
///
/// <b>Exceptions.</b> What the visitor, a property map or an allocation throws reaches the caller. `tmesh` is as it
/// was, and so is `vertex_sphere_map`, which is written at the very end, unless something is thrown while it is written
/// or read back: then it may be partly written.
///
/// Placing the surface elsewhere in space or scaling it changes the result by rounding only. So does renumbering its
/// vertices, unless the shape is so regular that the choice between equals falls to the order.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam Parameterizer a model of `SphericalParameterizer_3`; the object itself is used, so that it can be asked for
///         its report afterwards
/// \tparam VertexSphereMap a model of `WritablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a
///         \cgal kernel; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a triangle mesh that is closed, connected and of genus 0; isolated vertices are skipped, faces without
///        area are allowed
/// \param parameterizer the method
/// \param vertex_sphere_map the map to be written; it is left as it is if an error is returned by a method that
///        promises a bijection, with the exception above. If its category is convertible to
///        `boost::readable_property_map_tag`, its values are read when all have been written.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///     \cgalParamExtra{without it, `TriangleMesh` has to have an internal property map for `CGAL::vertex_point_t`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the maximum number of sweeps over the vertices of `tmesh` itself, or of global steps}
///     \cgalParamType{unsigned int; a negative number is refused with `ERROR_WRONG_PARAMETER`}
///     \cgalParamDefault{`250` for \f$ n \f$ = 2000 vertices and more, \f$ 1 + \lfloor 2000 / (n + 1) \rfloor \f$ times as
///                       many for fewer; other methods name theirs, or do not use it}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the seconds after which the map of then, at least the first one, is certified and returned}
///     \cgalParamType{`double`}
///     \cgalParamDefault{no limit, as with any value that is not positive}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{a visitor that is told of the progress and may stop it}
///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`, or what is wrong with the mesh or a parameter; `get_error_message()` puts it into words, and
///         `find_defect()` tells where the mesh is wrong
///
/// \note Calls at the same time are safe, also for the same mesh, which is only read, as long as each has a map, a
///       parameterizer and a visitor of its own, and so are calls from within tasks of TBB. (The coordinates must be of
///       a type that several threads may read at once.)
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class Parameterizer,
          class VertexSphereMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code parameterize(const TriangleMesh& tmesh, Parameterizer&& parameterizer, VertexSphereMap vertex_sphere_map,
                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  if constexpr(internal::check_arguments<TriangleMesh, std::remove_reference_t<Parameterizer>, VertexSphereMap,
                                         CGAL_NP_CLASS>())
    return parameterizer.template parameterize<ConcurrencyTag>(tmesh, vertex_sphere_map, np);
  else
    return ERROR_WRONG_PARAMETER;
}

/// \ingroup PkgSphericalParameterizationMainFunction
///
/// computes a one-to-one map of low distortion from a triangle mesh to a sphere around the origin.
///
/// The method is a `Bijective_low_distortion_parameterizer_3` with its defaults, whose energy, sharpness and radius are
/// a good choice for most surfaces. Parameters, guarantee, exceptions and threads are as for the function above.
///
/// \return as the function above
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Spherical_parameterization::parameterize<ConcurrencyTag>(tmesh, Bijective_low_distortion_parameterizer_3<>(),
                                                                  vertex_sphere_map, np);
}

} // namespace CGAL::Spherical_parameterization

#endif // C++17

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H
