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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_PARAMETERIZER_3_H

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
/// The class `Harmonic_parameterizer_3` maps a surface to the unit sphere with minimum discrete harmonic energy
/// \f$ \frac{1}{2} \sum w_{ij} | u_i - u_j |^2 \f$. The weight of an edge is half the sum of the two opposite
/// cotangents, raised to a small positive value if it is smaller.
///
/// This is the initial map of \cgalCite{cgal:whfl-bspld-16}. Angles are nearly preserved. Areas differ by many orders
/// of magnitude on surfaces with extremities. Since the energy alone is minimal for a map to a single point, Moebius
/// transformations keep the center of the surface's area at the center of the sphere.
///
/// The iteration starts from the map of `Stereographic_parameterizer_3`. Each step solves a sparse linear system whose
/// matrix is factorized once. The iteration ends when a step changes the energy by less than 1e-9 of it, usually after
/// about ten steps.
///
/// <b>Guarantee.</b> If `OK` is returned, the map is bijective. Steps that would invert a face are shortened, and the
/// map is certified as it has been written. If double precision cannot represent the images of extremities,
/// `ERROR_INSUFFICIENT_PRECISION` is returned.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam SolverTraits must be a model of `SparseLinearAlgebraWithFactorTraits_d`; the default is that of
///         `Stereographic_parameterizer_3`.
///
/// \sa `Conformal_parameterizer_3`
/// \sa `Published_low_distortion_parameterizer_3`
template <class SolverTraits = Default>
class Harmonic_parameterizer_3
{
public:
  /// computes a bijective map from `tmesh` to the unit sphere around the origin.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. The default of
  /// `number_of_iterations` is 100. The initial map of `Stereographic_parameterizer_3` is completed in any case.
  ///
  /// \return `OK`; a defect of the mesh, see `find_defect()`; `ERROR_WRONG_PARAMETER` if `number_of_iterations` is
  ///         negative; `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`; `ERROR_INSUFFICIENT_PRECISION`
  template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    return internal::run_parameterization<ConcurrencyTag>(tmesh, vertex_sphere_map, np, m_report, [&](auto& run) {
      if(run.read_number_of_iterations() && run.read())
        run.error = internal::map_harmonically<SolverTraits>(run, true, run.number_of_iterations.value_or(100));
    });
  }

  /// returns the report of the last run.
  const Parameterization_report& report() const { return m_report; }

private:
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_PARAMETERIZER_3_H
