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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ARAP_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ARAP_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/initializers/ARAP_map.h>
#include <CGAL/Spherical_parameterization/internal/run/run_parameterization.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `ARAP_parameterizer_3` maps a surface to a sphere as rigidly as possible. It minimizes the sum over the
/// faces of \f$ ( \sigma_1 - 1 )^2 + ( \sigma_2 - 1 )^2 \f$, weighted by area.
///
/// Each step fits a rotation to every face and the radius of the sphere to all faces. It then moves all vertices to the
/// solution of a sparse linear system, whose matrix is factorized once. The iteration ends when a step decreases the
/// energy by less than one millionth of it, or when no step decreases it. The latter happens where faces are about to
/// be inverted, because the energy is not smooth there.
///
/// The average distortion is low. However, the energy penalizes shrinking a face only weakly, and inverting it only
/// slightly more.
///
/// <b>Guarantee.</b> The map may have inverted faces, which is common at extremities. Such a map is written, and
/// `ERROR_NO_1_TO_1_MAPPING` is returned. `OK` is returned only if the map has been certified bijective as it has been
/// written. `Bijective_low_distortion_parameterizer_3` guarantees a bijective map.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam InitialParameterizer must be a model of `SphericalParameterizer_3`.
/// \tparam SolverTraits must be a model of `SparseLinearAlgebraWithFactorTraits_d`; the default is that of
///         `Stereographic_parameterizer_3`.
template <class InitialParameterizer = Hierarchical_parameterizer_3<>, class SolverTraits = Default>
class ARAP_parameterizer_3
{
public:
  /// constructs the parameterizer; `initial_parameterizer` computes the initial map.
  explicit ARAP_parameterizer_3(const InitialParameterizer& initial_parameterizer = InitialParameterizer())
    : m_initial_parameterizer(initial_parameterizer)
  {}

  /// computes a map from `tmesh` to a sphere around the origin, whose radius is part of the result.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. The default of
  /// `number_of_iterations` is 500. `vertex_sphere_map` is left unchanged unless `OK` or `ERROR_NO_1_TO_1_MAPPING` is
  /// returned.
  ///
  /// \return an error code of `Bijective_low_distortion_parameterizer_3`; `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`;
  ///         `ERROR_NO_1_TO_1_MAPPING` if the map that has been written has inverted faces
  template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    return internal::run_parameterization<ConcurrencyTag, internal::Guarantee::NONE>(
        tmesh, vertex_sphere_map, np, m_report, [&](auto& run) {
          if(is_valid() && run.read_number_of_iterations() && run.read())
            run.error = internal::make_initial_map(m_initial_parameterizer, run);
          if(run.error == OK)
            run.error = internal::lower_energy<SolverTraits>(internal::ARAP_map(run.surface, run.execution),
                                                             run.number_of_iterations.value_or(500), run);
        });
  }

  /// returns the report of the last run.
  const Parameterization_report& report() const { return m_report; }

  /// returns whether the initial parameterizer is valid.
  bool is_valid() const { return internal::is_valid_policy(m_initial_parameterizer); }

private:
  InitialParameterizer m_initial_parameterizer;
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ARAP_PARAMETERIZER_3_H
