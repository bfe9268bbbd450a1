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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_STEREOGRAPHIC_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_STEREOGRAPHIC_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Stereographic_embedding.h>
#include <CGAL/Spherical_parameterization/internal/run/run_parameterization.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Stereographic_parameterizer_3` maps a surface to the unit sphere by a planar Tutte embedding and the
/// inverse stereographic projection.
///
/// A vertex in the middle of the surface is removed. Its neighbors are mapped to a circle, and the rest gets a Tutte
/// embedding with cotangent weights, which are raised where they are not positive. A Moebius transformation moves the
/// center of the surface's area to the center of the sphere. One sparse matrix is factorized and used for two
/// solutions. The first one determines where most of the surface is mapped; the second one has its origin there.
///
/// Angles are preserved, apart from the effect of the circle. Areas differ by many orders of magnitude on surfaces with
/// extremities.
///
/// <b>Guarantee.</b> If `OK` is returned, the map is bijective: it is certified as it has been written. In exact
/// arithmetic, the map exists for every mesh: where the inverse stereographic projection would invert a large face, the
/// plane is projected from the center of the sphere instead. If double precision cannot represent the images of
/// extremities, `ERROR_INSUFFICIENT_PRECISION` is returned.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam SolverTraits must be a model of `SparseLinearAlgebraWithFactorTraits_d`.<br> <b>%Default:</b> if
///         \ref thirdpartyEigen "Eigen" 3.1 or greater is available and `CGAL_EIGEN3_ENABLED` is defined, a Cholesky
///         factorization of the package, in an elimination order chosen by Eigen, with bitwise identical results on
///         every machine
///
/// \sa `Harmonic_parameterizer_3`
/// \sa `Hierarchical_parameterizer_3`
template <class SolverTraits = Default>
class Stereographic_parameterizer_3
{
public:
  /// computes a bijective map from `tmesh` to the unit sphere around the origin.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`, without `number_of_iterations`.
  /// Since the map is computed in one step, neither the visitor nor `maximum_running_time` can stop it.
  ///
  /// \return `OK`; a defect of the mesh, see `find_defect()`; `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`;
  ///         `ERROR_INSUFFICIENT_PRECISION`
  template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    return internal::run_parameterization<ConcurrencyTag>(tmesh, vertex_sphere_map, np, m_report, [&](auto& run) {
      if(run.read())
        run.error = internal::embed_stereographically<SolverTraits>(run, true);
    });
  }

  /// returns the report of the last run.
  const Parameterization_report& report() const { return m_report; }

private:
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_STEREOGRAPHIC_PARAMETERIZER_3_H
