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
/// The class `Harmonic_parameterizer_3` maps a surface to the unit sphere with the minimum discrete harmonic energy
/// \f$ \frac{1}{2} \sum w_{ij} | u_i - u_j |^2 \f$, where the weights of the edges are half the sums of the two
/// opposite cotangents, raised to a small positive value where they are below.
///
/// It is the map that \cgalCite{cgal:whfl-bspld-16} starts from. Angles are nearly kept, and areas differ by many
/// orders of magnitude where a surface has extremities. The energy alone would be minimal if all vertices were mapped to one
/// point. So Moebius transformations keep the centre of the area of the surface at the centre of the sphere.
///
/// The iteration starts from the map of `Stereographic_parameterizer_3`, and each step solves a sparse system, whose
/// matrix is factored once; some ten steps are enough. It ends when a step changes the energy by less than 1e-9 of it.
///
/// A one-to-one mapping is guaranteed whenever `OK` is returned: the map is so all the way, as steps that would turn a
/// face over are shortened, and it is certified as it has been written. If extremities would get smaller than double
/// precision numbers resolve, `ERROR_INSUFFICIENT_PRECISION` is returned.
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
  /// computes a one-to-one map from `tmesh` to the unit sphere around the origin.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. The default of
  /// `number_of_iterations` is 100. The map of `Stereographic_parameterizer_3` to start with is completed in any case.
  ///
  /// \return `OK`, or what is wrong with the mesh, see `find_defect()`; `ERROR_WRONG_PARAMETER` if a negative
  ///         `number_of_iterations` is given; `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`; `ERROR_INSUFFICIENT_PRECISION`
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

  /// returns what the last run did.
  const Parameterization_report& report() const { return m_report; }

private:
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_PARAMETERIZER_3_H
