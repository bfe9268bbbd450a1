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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PRECOMPUTED_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PRECOMPUTED_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/run/run_parameterization.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Precomputed_parameterizer_3` projects a given map to the unit sphere. It serves as the initial
/// parameterizer of another method, for example to continue a run that was stopped.
///
/// <b>Guarantee.</b> If `OK` is returned, the map is bijective. If the given map is not,
/// `ERROR_INVALID_INITIAL_PARAMETERIZATION` is returned.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam PrecomputedMap must be a model of `ReadablePropertyMap` from the vertices of the mesh to `%Point_3` of a
///         \cgal kernel, whose coordinates are of type `double` or `float`, or of an exact number type.
template <class PrecomputedMap>
class Precomputed_parameterizer_3
{
public:
  /// constructs the parameterizer from a copy of `map`, the images of the vertices, at any distance from the origin.
  explicit Precomputed_parameterizer_3(const PrecomputedMap& map)
    : m_map(map)
  {}

  /// checks the given map and writes its projection to the unit sphere.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. Nothing is iterated: the visitor
  /// is not called, and limits have no effect.
  ///
  /// \return `OK`; a defect of the mesh, see `find_defect()`; `ERROR_INVALID_INITIAL_PARAMETERIZATION` if the given map
  ///         is not bijective; `ERROR_INSUFFICIENT_PRECISION` if rounding to the coordinates of `vertex_sphere_map`
  ///         inverts a face
  template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    return internal::run_parameterization<ConcurrencyTag>(tmesh, vertex_sphere_map, np, m_report, [&](auto& run) {
      if(run.read())
      {
        run.error = run.read_map(m_map) ? OK : ERROR_INVALID_INITIAL_PARAMETERIZATION;
        m_report.seconds_for_embedding = run.control.lap();
        if(run.error == OK)
          m_report.stop_reason = CONVERGED; // since there is nothing to improve
      }
    });
  }

  /// returns the report of the last run.
  const Parameterization_report& report() const { return m_report; }

private:
  PrecomputedMap m_map;
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PRECOMPUTED_PARAMETERIZER_3_H
