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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SCHNYDER_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SCHNYDER_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/run/run_descent.h>
#include <CGAL/Spherical_parameterization/internal/run/run_parameterization.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Schnyder_parameterizer_3` maps a surface to the unit sphere by its connectivity alone, by Schnyder's
/// drawing \cgalCite{cgal:s-epgg-90}.
///
/// A vertex of minimum degree is removed. The rest is drawn in a triangle, where the barycentric coordinates of a
/// vertex are numbers of faces. The triangle is mapped to an octant of the sphere, and the removed vertex closes the
/// sphere. This takes linear time, some tenths of a second for a million vertices.
///
/// <b>Guarantee.</b> The map is bijective for every closed and connected triangle mesh of genus 0, wherever its points
/// are. With at most 10,000,000 vertices, it remains bijective after rounding to double precision. Both are theorems;
/// the sources contain the proof. Therefore, `Bijective_low_distortion_parameterizer_3` and
/// `Hierarchical_parameterizer_3` use this map where their own initial map fails.
///
/// The distortion is high, because the map ignores all lengths: most faces are far smaller on the sphere than others. A
/// descent from this map takes many sweeps and may converge to a different result than a descent from
/// `Hierarchical_parameterizer_3`.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \sa `Hierarchical_parameterizer_3`
/// \sa `Stereographic_parameterizer_3`
class Schnyder_parameterizer_3
{
public:
  /// computes a bijective map from `tmesh` to the unit sphere around the origin.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`, without `number_of_iterations`.
  /// Since the map is computed in one step, neither the visitor nor `maximum_running_time` can stop it.
  ///
  /// \return `OK`; a defect of the mesh, see `find_defect()`; `ERROR_INSUFFICIENT_PRECISION` if the coordinates of
  ///         `vertex_sphere_map` cannot represent the map: coordinates of type `float` suffice for some hundred
  ///         vertices
  template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    return internal::run_parameterization<ConcurrencyTag>(tmesh, vertex_sphere_map, np, m_report, [&](auto& run) {
      if(run.read())
      {
        run.control.on_initialization_begin(run.surface.number_of_vertices());
        internal::draw_surface(run);
        run.control.on_initialization_end();
        m_report.stop_reason = CONVERGED;
        run.error = OK;
      }
    });
  }

  /// returns the report of the last run.
  const Parameterization_report& report() const { return m_report; }

private:
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SCHNYDER_PARAMETERIZER_3_H
