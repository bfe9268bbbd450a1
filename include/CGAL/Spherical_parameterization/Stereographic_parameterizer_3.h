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
/// The class `Stereographic_parameterizer_3` maps a surface to the unit sphere through the plane: a vertex in the
/// middle of the surface is removed, and the rest gets a Tutte embedding with the neighbours of that vertex on a circle
/// and with cotangent weights, raised where they would not be positive. The plane goes to the sphere by the inverse of
/// the stereographic projection, and a Moebius transformation balances the two sides: it brings the centre of the area
/// of the surface to the centre of the sphere. Angles are kept but for what the roundness of the circle costs, and
/// areas differ by many orders of magnitude where a surface has extremities. One sparse matrix is factorised, and used twice: to
/// learn where most of the surface is, and to place it there.
///
/// A one-to-one mapping is guaranteed whenever `OK` is returned, because the map is certified as it has been written.
/// It exists for every mesh: where the inverse stereographic projection would turn a large face over, the plane is
/// projected from the centre of the sphere. But extremities may get smaller than double precision numbers resolve; then
/// `ERROR_INSUFFICIENT_PRECISION` is returned.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam SolverTraits must be a model of `SparseLinearAlgebraWithFactorTraits_d`.<br> <b>%Default:</b> if
///         \ref thirdpartyEigen "Eigen" 3.1 or greater is available and `CGAL_EIGEN3_ENABLED` is defined, a Cholesky factorization
///         of the package, in an order of elimination that Eigen chooses, with the same bits on every machine
///
/// \sa `Harmonic_parameterizer_3`
/// \sa `Hierarchical_parameterizer_3`
template <class SolverTraits = Default>
class Stereographic_parameterizer_3
{
public:
  /// computes a one-to-one map from `tmesh` to the unit sphere around the origin.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. As all is done in one step,
  /// neither the visitor nor `maximum_running_time` can stop it, and there is no `number_of_iterations`.
  ///
  /// \return `OK`, or what is wrong with the mesh, see `find_defect()`; `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`;
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

  /// returns what the last run did.
  const Parameterization_report& report() const { return m_report; }

private:
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_STEREOGRAPHIC_PARAMETERIZER_3_H
