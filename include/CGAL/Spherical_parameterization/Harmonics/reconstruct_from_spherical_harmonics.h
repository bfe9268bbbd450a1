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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_RECONSTRUCT_FROM_SPHERICAL_HARMONICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_RECONSTRUCT_FROM_SPHERICAL_HARMONICS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/evaluate_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/add_triangles.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// reconstructs a surface from its spherical harmonics: adds a mesh with the triangles of a domain, whose vertices are
/// the values of the three functions at the directions of the domain.
///
/// The result may intersect itself. `measure_distance()` computes its distance to the surface that was expanded. To
/// remove details, call `Spherical_harmonics_3::set_degree()` on a copy.
///
/// The running time is that of `evaluate_spherical_harmonics()`.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \tparam VertexSphereMap a model of `WritablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a \cgal kernel
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param harmonics the three coordinates of the surface
/// \param domain the triangulated directions that sample the sphere
/// \param tmesh the mesh that the new vertices and faces are added to, in the order of the domain
/// \param vertex_sphere_map receives the directions of the new vertices, which are the map of the new mesh to the
///         sphere
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map that receives the points of the new vertices}
///     \cgalParamType{a class model of `WritablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{a visitor whose `go_further()` is called regularly and may stop the run}
///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time in seconds after which the run is stopped}
///     \cgalParamType{double}
///     \cgalParamDefault{no limit, as with any value that is not positive}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; `ERROR_INVALID_DOMAIN` if the domain is empty; `ERROR_WRONG_PARAMETER` if the number of functions is
///         not three; or `ERROR_STOPPED`. On an error, nothing is added.
///
/// \sa `CGAL::Spherical_parameterization::expand_in_spherical_harmonics()`
/// \sa `CGAL::Spherical_parameterization::remesh_through_sphere()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code reconstruct_from_spherical_harmonics(const Spherical_harmonics_3& harmonics, const Sphere_domain_3& domain,
                                                TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  if(domain.is_empty())
    return ERROR_INVALID_DOMAIN;
  if(harmonics.number_of_functions() != 3)
    return ERROR_WRONG_PARAMETER;
  std::vector<double> values;
  if(const Error_code error = evaluate_spherical_harmonics<ConcurrencyTag>(harmonics, domain.directions(), values, np))
    return error;
  internal::add_triangles(
      internal::link_triangles(domain.triangles(), domain.directions().size()), domain.directions().size(), tmesh,
      [&](const auto& new_vertices, const auto&) {
        internal::write_vectors(internal::vertex_point_map_of(tmesh, np), new_vertices, [&](std::size_t k) {
          return internal::Vector_3d{values[3 * k], values[3 * k + 1], values[3 * k + 2]};
        });
        internal::write_vectors(vertex_sphere_map, new_vertices, [&](std::size_t k) { return domain.directions()[k]; });
      });
  return OK;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_RECONSTRUCT_FROM_SPHERICAL_HARMONICS_H
