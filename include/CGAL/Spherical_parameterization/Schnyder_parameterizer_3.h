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
/// The class `Schnyder_parameterizer_3` maps a surface to the unit sphere by its connectivity alone: a vertex of least degree is
/// removed, the rest gets Schnyder's drawing \cgalCite{cgal:s-epgg-90} in a triangle, whose barycentric coordinates are numbers of
/// faces, and the triangle is taken to an octant of the sphere. The removed vertex is put where it closes the sphere. This takes
/// linear time, some tenths of a second for a million vertices.
///
/// It is a theorem that this is a one-to-one mapping for every closed and connected triangle mesh of genus 0, whatever its
/// points are, and that it still is one in numbers of type `double` up to 10,000,000 vertices; the proof is in the sources.
/// So the default method falls back to this map where its own fails. As a map it is a bad one: it knows no lengths, and most faces
/// are far smaller on the sphere than others. A descent from it takes many sweeps, and may end far from where one from
/// `Hierarchical_parameterizer_3` ends.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \sa `Hierarchical_parameterizer_3`
/// \sa `Stereographic_parameterizer_3`
class Schnyder_parameterizer_3
{
public:
  /// computes a one-to-one map from `tmesh` to the unit sphere around the origin.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. As all is done in one step,
  /// neither the visitor nor `maximum_running_time` can stop it, and there is no `number_of_iterations`.
  ///
  /// \return `OK`, or what is wrong with the mesh, see `find_defect()`; `ERROR_INSUFFICIENT_PRECISION` if the map cannot be
  ///         held by the coordinates of `vertex_sphere_map`: those of type `float` suffice for some hundred vertices
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

  /// returns what the last run did.
  const Parameterization_report& report() const { return m_report; }

private:
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SCHNYDER_PARAMETERIZER_3_H
