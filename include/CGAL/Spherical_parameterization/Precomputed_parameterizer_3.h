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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PRECOMPUTED_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PRECOMPUTED_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/read_map.h>
#include <CGAL/Spherical_parameterization/internal/run_parameterization.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <vector>

/// \file Precomputed_parameterizer_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Precomputed_parameterizer_3` hands out a map that the caller has already, projected to the unit sphere,
/// so that it can start another parameterizer, for example one that was stopped.
///
/// The visitor is not called. A one-to-one mapping is guaranteed: if the caller's map is none,
/// `ERROR_INVALID_INITIAL_PARAMETERIZATION` is returned.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceListGraph`.
/// \tparam VertexSphereMap_ must be a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh_>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as
///         value type, whose coordinates are of type `double` or `float`, or of an exact number type. The images may be
///         at any distance from the origin.
template <class TriangleMesh_, class VertexSphereMap_>
class Precomputed_parameterizer_3
{
public:
  /// Triangle mesh type
  using Triangle_mesh = TriangleMesh_;
  /// Triangle mesh type
  using TriangleMesh = TriangleMesh_;

  /// constructs the parameterizer from a map, a copy of which is kept.
  ///
  /// \param map the images of the vertices, at any distance from the origin
  explicit Precomputed_parameterizer_3(const VertexSphereMap_& map)
    : m_map(map)
  {}

  /// checks the caller's map, and writes its projection to the unit sphere.
  ///
  /// \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
  ///         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
  /// \tparam VertexSphereMap must be a model of `WritablePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as
  ///         value type; its coordinates are of type `double` or `float`, or of an exact number type.
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param tmesh a triangle mesh that is closed, connected and of genus 0
  /// \param vertex_sphere_map the map to be written; it is left as it is unless `OK` is returned
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{vertex_point_map}
  ///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
  ///     \cgalParamType{a class model of `ReadablePropertyMap` with
  ///                    `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and `%Point_3` as
  ///                    value type}
  ///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  ///     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t`
  ///                     must be available in `Triangle_mesh`.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_running_time}
  ///     \cgalParamDescription{without effect: there is nothing to stop}
  ///     \cgalParamType{double}
  ///     \cgalParamDefault{no limit, as with any value that is not positive}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{visitor}
  ///     \cgalParamDescription{without effect: the visitor is not called}
  ///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
  ///     \cgalParamDefault{`Default_visitor`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \return `OK`, or what is wrong with the mesh, see `find_defect()`; `ERROR_INVALID_INITIAL_PARAMETERIZATION` if
  ///         the caller's map is not one-to-one; `ERROR_INSUFFICIENT_PRECISION` if rounding to the coordinates of
  ///         `vertex_sphere_map` turns a face over
  ///
  /// \pre `num_halfedges(tmesh) < 2147483647`, that is, 2<sup>31</sup> - 1
  template <class ConcurrencyTag = Parallel_if_available_tag, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const Triangle_mesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    m_report = Parameterization_report();
    return internal::run_parameterization<ConcurrencyTag>(
        tmesh, vertex_sphere_map, np, m_report, internal::Guarantee::ONE_TO_ONE,
        [&](const internal::Indexed_mesh& mesh, const auto& vertices_of_mesh,
            std::vector<internal::Vector_3d>& positions, double&, auto& control) {
          const bool is_bijective = internal::read_map<ConcurrencyTag>(mesh, vertices_of_mesh, m_map, positions);
          m_report.seconds_for_embedding = control.lap();
          if(!is_bijective)
            return ERROR_INVALID_INITIAL_PARAMETERIZATION;
          m_report.stop_reason = CONVERGED; // as there is nothing to improve
          return OK;
        });
  }

  /// returns what the last run did.
  const Parameterization_report& report() const { return m_report; }

private:
  VertexSphereMap_ m_map;
  Parameterization_report m_report;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PRECOMPUTED_PARAMETERIZER_3_H
