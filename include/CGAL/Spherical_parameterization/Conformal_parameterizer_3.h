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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/Solver_traits.h>
#include <CGAL/Spherical_parameterization/internal/map_harmonically.h>
#include <CGAL/Spherical_parameterization/internal/read_number_of_iterations.h>
#include <CGAL/Spherical_parameterization/internal/run_parameterization.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

/// \file Conformal_parameterizer_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Conformal_parameterizer_3` maps a surface to the unit sphere by the classical global conformal map: it
/// lowers the discrete harmonic energy \f$ \frac{1}{2} \sum w_{ij} | u_i - u_j |^2 \f$ with the cotangent weights as
/// they are, while Moebius transformations keep the centre of the area of the surface at the centre of the sphere.
///
/// Nothing prevents faces from turning over, which happens at limbs and at obtuse angles. A map that folds is written
/// nevertheless, and `ERROR_NO_1_TO_1_MAPPING` is returned. `OK` is only returned if the map has been certified to be
/// one-to-one as it has been written. `Bijective_low_distortion_parameterizer_3` with `Conformal_energy_3` is the
/// method that never folds.
///
/// The iteration starts from the map of `Stereographic_parameterizer_3`, and each step solves a sparse system, whose
/// matrix is factored once; some ten steps are enough. It ends when a step changes the energy by less than 1e-9 of it.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceListGraph`.
/// \tparam SolverTraits_ must be a model of `SparseLinearAlgebraWithFactorTraits_d`.<br> <b>%Default:</b> if
///         \ref thirdpartyEigen "Eigen" 3.1 or greater is available and `CGAL_EIGEN3_ENABLED` is defined,
/// \code
///   CGAL::Eigen_solver_traits<
///           Eigen::SimplicialLDLT<Eigen_sparse_symmetric_matrix<double>::EigenType> >
/// \endcode
///
/// \sa `Harmonic_parameterizer_3`
/// \sa `Conformal_energy_3`
template <class TriangleMesh_, class SolverTraits_ = Default>
class Conformal_parameterizer_3
{
public:
#ifndef DOXYGEN_RUNNING
  using Solver_traits = typename internal::Solver_traits<SolverTraits_>::type;
#else
  /// Solver traits type
  using Solver_traits = SolverTraits_;
#endif
  /// Triangle mesh type
  using Triangle_mesh = TriangleMesh_;
  /// Triangle mesh type
  using TriangleMesh = TriangleMesh_;

  /// computes a map from `tmesh` to the unit sphere around the origin.
  ///
  /// \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
  ///         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
  /// \tparam VertexSphereMap must be a model of `WritablePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as
  ///         value type; its coordinates are of type `double` or `float`, or of an exact number type.
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param tmesh a triangle mesh that is closed, connected and of genus 0
  /// \param vertex_sphere_map the map to be written; it is left as it is unless `OK` or `ERROR_NO_1_TO_1_MAPPING` is
  ///        returned
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
  ///   \cgalParamNBegin{number_of_iterations}
  ///     \cgalParamDescription{the most steps, each of which moves all vertices}
  ///     \cgalParamType{unsigned int}
  ///     \cgalParamDefault{`100`}
  ///     \cgalParamExtra{A negative number is refused with `ERROR_WRONG_PARAMETER`.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_running_time}
  ///     \cgalParamDescription{the time in seconds after which the map reached by then is checked and returned.
  ///                           The map of `Stereographic_parameterizer_3` to start with is completed in any
  ///                           case.}
  ///     \cgalParamType{double}
  ///     \cgalParamDefault{no limit, as with any value that is not positive}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{visitor}
  ///     \cgalParamDescription{a visitor that is told of the progress and may stop it}
  ///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
  ///     \cgalParamDefault{`Default_visitor`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \return `OK`, `ERROR_NO_1_TO_1_MAPPING` if the map that has been written folds, or what is wrong with the mesh,
  ///         see `find_defect()`; `ERROR_WRONG_PARAMETER` if a negative `number_of_iterations` is given;
  ///         `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`; `ERROR_INSUFFICIENT_PRECISION` if the map cannot be held by the
  ///         coordinates of `vertex_sphere_map`
  ///
  /// \pre `num_halfedges(tmesh) < 2147483647`, that is, 2<sup>31</sup> - 1
  template <class ConcurrencyTag = Parallel_if_available_tag, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const Triangle_mesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    m_report = Parameterization_report();
    std::size_t most_iterations = 100;
    if(!internal::read_number_of_iterations(np, most_iterations))
      return ERROR_WRONG_PARAMETER;
    return internal::run_parameterization<ConcurrencyTag>(
        tmesh, vertex_sphere_map, np, m_report, internal::Guarantee::NONE,
        [&](const internal::Indexed_mesh& mesh, const auto&, std::vector<internal::Vector_3d>& positions, double&,
            auto& control) {
          return internal::map_harmonically<Solver_traits, ConcurrencyTag>(mesh, internal::Guarantee::NONE,
                                                                           most_iterations, positions, control);
        });
  }

  /// returns what the last run did.
  const Parameterization_report& report() const
  {
    return m_report;
  }

private:
  Parameterization_report m_report;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_PARAMETERIZER_3_H
