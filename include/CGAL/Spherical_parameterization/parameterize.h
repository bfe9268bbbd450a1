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
/// computes a bijective map from a triangle mesh to a sphere around the origin with a given method.
///
/// The map is linear on each face, followed by the projection along the rays from the origin. A face that is
/// counterclockwise seen from outside the surface is counterclockwise seen from outside the sphere. The mesh is not
/// changed.
///
/// <b>Guarantee.</b> If `OK` is returned, the map is bijective. Exact predicates have certified the points in
/// `vertex_sphere_map`: every face is positively oriented about the origin, and the faces cover the sphere once.
/// Because of rounding, the points are not exactly on the sphere.
///
/// - The points are certified before they are written. If the property map can be read and then holds other values, for
///   example because it rounds them, these values are certified as well. If they have inverted faces,
///   `ERROR_INSUFFICIENT_PRECISION` is returned, and the property map has been overwritten. A property map that can
///   only be written must store the points as they are.
/// - The certificate is correct with any compile flags. With flags that change floating-point arithmetic, such as
///   `-ffast-math`, points with coordinates of type `double` or `float` are certified by integer arithmetic, and exact
///   kernels do not compile.
///
/// <b>Existence.</b> The default method returns `OK` for every mesh without a defect, see `find_defect()`, whatever its
/// shape. Degenerate faces, needles, coincident vertices, self-intersections and both orientations are allowed. This is
/// a theorem for meshes of up to 10,000,000 vertices, unless the radius of the sphere is below 1e-289: if all other
/// attempts fail, the descent starts from the map of `Schnyder_parameterizer_3`, which exists for every mesh. If the
/// coordinates in `vertex_sphere_map` are of type `float`, adjacent values differ by about 10<sup>-7</sup> radii, and
/// `ERROR_INSUFFICIENT_PRECISION` is returned if rounding to them inverts a face; see `round_to_float()`.
///
/// <b>Stopping early.</b> The initial map is completed in any case, with minimum effort. Afterwards, the run can be
/// stopped at any time, with the same guarantee.
///
/// <b>Exceptions.</b> Exceptions of the visitor, a property map or an allocation reach the caller. `tmesh` is never
/// changed. `vertex_sphere_map` is written last, so it is unchanged unless the exception occurs while it is written or
/// read back; then it may be partly written.
///
/// <b>Invariance.</b> Moving or scaling the surface changes the result only by rounding errors. The same holds for
/// renumbering its vertices, unless the shape is so regular that ties are broken by the order of the vertices.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam Parameterizer a model of `SphericalParameterizer_3`; the object itself is used, so that its report is
///         available afterwards
/// \tparam VertexSphereMap a model of `WritablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a
///         \cgal kernel; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a triangle mesh that is closed, connected and of genus 0; isolated vertices are skipped, faces without
///        area are allowed
/// \param parameterizer the method
/// \param vertex_sphere_map the map to be written. If a method that guarantees a bijection returns an error, the map is
///        left unchanged, with the exception above. If the category of the property map is convertible to
///        `boost::readable_property_map_tag`, its values are read after all have been written.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t` must be
///                     available in `TriangleMesh`.}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the maximum number of sweeps over the vertices of `tmesh` itself, not over coarse levels, or of global steps}
///     \cgalParamType{unsigned int; a negative number is rejected with `ERROR_WRONG_PARAMETER`}
///     \cgalParamDefault{`250` for \f$ n \geq 2000 \f$ vertices, \f$ 1 + \lfloor 2000 / (n + 1) \rfloor \f$ times as
///                       many for fewer; other methods document their own defaults or ignore the parameter}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time in seconds after which the current map, at least the initial one, is certified
///                           and returned}
///     \cgalParamType{`double`}
///     \cgalParamDefault{no limit, as with any value that is not positive}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{a visitor that observes the progress and may stop the run}
///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`, or an error of the mesh or of a parameter; `get_error_message()` returns a description, and
///         `find_defect()` locates the defects of a mesh
///
/// \note Concurrent calls are safe, also for the same mesh, which is only read, and from within tasks of TBB. Each call
///       needs its own map, parameterizer and visitor, and the number type of the coordinates must allow concurrent
///       reading.
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
/// computes a bijective map of low distortion from a triangle mesh to a sphere around the origin.
///
/// The method is a `Bijective_low_distortion_parameterizer_3` with its default settings, which suit most surfaces.
/// Parameters, guarantee, exceptions and concurrency are as for the function above.
///
/// \return the same error codes as the function above
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
