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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Harmonic_map.h>
#include <CGAL/Spherical_parameterization/internal/run/run_parameterization.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Conformal_parameterizer_3` computes the classical global conformal map from a surface to the unit sphere.
/// It minimizes the discrete harmonic energy \f$ \frac{1}{2} \sum w_{ij} | u_i - u_j |^2 \f$ with unmodified cotangent
/// weights. Moebius transformations keep the center of the surface's area at the center of the sphere.
///
/// The iteration is that of `Harmonic_parameterizer_3`, without its measures against inverted faces.
///
/// <b>Guarantee.</b> The map may have inverted faces, which occur at extremities and at obtuse angles. Such a map is
/// written, and `ERROR_NO_1_TO_1_MAPPING` is returned. `OK` is returned only if the map has been certified bijective as
/// it has been written. `Bijective_low_distortion_parameterizer_3` with `Conformal_energy_3` guarantees a bijective
/// map.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam SolverTraits must be a model of `SparseLinearAlgebraWithFactorTraits_d`; the default is that of
///         `Stereographic_parameterizer_3`.
template <class SolverTraits = Default>
class Conformal_parameterizer_3
{
public:
  /// computes a map from `tmesh` to the unit sphere around the origin.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. The default of
  /// `number_of_iterations` is 100. The initial map of `Stereographic_parameterizer_3` is completed in any case.
  /// `vertex_sphere_map` is left unchanged unless `OK` or `ERROR_NO_1_TO_1_MAPPING` is returned.
  ///
  /// \return an error code of `Harmonic_parameterizer_3`; `ERROR_NO_1_TO_1_MAPPING` if the map that has been written
  ///         has inverted faces
  template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    return internal::run_parameterization<ConcurrencyTag, internal::Guarantee::NONE>(
        tmesh, vertex_sphere_map, np, m_report, [&](auto& run) {
          if(run.read_number_of_iterations() && run.read())
            run.error = internal::map_harmonically<SolverTraits>(run, false, run.number_of_iterations.value_or(100));
        });
  }

  /// returns the report of the last run.
  const Parameterization_report& report() const { return m_report; }

private:
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_PARAMETERIZER_3_H
