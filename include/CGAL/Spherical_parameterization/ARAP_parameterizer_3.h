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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ARAP_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ARAP_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/ARAP_map.h>
#include <CGAL/Spherical_parameterization/internal/Initial_map.h>
#include <CGAL/Spherical_parameterization/internal/Solver_traits.h>
#include <CGAL/Spherical_parameterization/internal/is_valid_policy.h>
#include <CGAL/Spherical_parameterization/internal/read_number_of_iterations.h>
#include <CGAL/Spherical_parameterization/internal/run_parameterization.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

/// \file ARAP_parameterizer_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `ARAP_parameterizer_3` maps a surface to a sphere as rigidly as possible: it lowers the sum over the faces
/// of \f$ ( \sigma_1 - 1 )^2 + ( \sigma_2 - 1 )^2 \f$, weighted with the areas. Each round fits a rotation to every
/// face and the radius of the sphere to all of them, and then moves all vertices by the solution of a sparse system,
/// whose matrix is factored once. The average distortion is low, but shrinking a face costs little, and turning it over
/// not much more.
///
/// Nothing prevents faces from turning over, and at limbs they do. A map that folds is written nevertheless, and
/// `ERROR_NO_1_TO_1_MAPPING` is returned. `OK` is only returned if the map has been certified to be one-to-one as it
/// has been written. `Bijective_low_distortion_parameterizer_3` is the method that never folds.
///
/// The rounds end when one lowers the energy by less than a millionth of it, or when none lowers it at all, which
/// happens where faces are about to fold: there the energy is not smooth.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceListGraph`.
/// \tparam InitialParameterizer_ must be a model of `SphericalParameterizer_3`.<br> <b>%Default:</b>
/// \code
///   Hierarchical_parameterizer_3<TriangleMesh_>
/// \endcode
/// \tparam SolverTraits_ must be a model of `SparseLinearAlgebraWithFactorTraits_d`.<br> <b>%Default:</b> if
///         \ref thirdpartyEigen "Eigen" 3.1 or greater is available and `CGAL_EIGEN3_ENABLED` is defined,
/// \code
///   CGAL::Eigen_solver_traits<
///           Eigen::SimplicialLDLT<Eigen_sparse_symmetric_matrix<double>::EigenType> >
/// \endcode
///
/// \sa `Bijective_low_distortion_parameterizer_3`
template <class TriangleMesh_, class InitialParameterizer_ = Default, class SolverTraits_ = Default>
class ARAP_parameterizer_3
{
public:
#ifndef DOXYGEN_RUNNING
  using Solver_traits = typename internal::Solver_traits<SolverTraits_>::type;
  using Initial_parameterizer =
      typename Default::Get<InitialParameterizer_, Hierarchical_parameterizer_3<TriangleMesh_>>::type;
#else
  /// Solver traits type
  using Solver_traits = SolverTraits_;
  /// Initial parameterizer type
  using Initial_parameterizer = InitialParameterizer_;
#endif
  /// Triangle mesh type
  using Triangle_mesh = TriangleMesh_;
  /// Triangle mesh type
  using TriangleMesh = TriangleMesh_;

  /// constructs the parameterizer.
  ///
  /// \param initial_parameterizer makes the map to start with
  explicit ARAP_parameterizer_3(const Initial_parameterizer& initial_parameterizer = Initial_parameterizer())
    : m_initial_parameterizer(initial_parameterizer)
  {}

  /// computes a map from `tmesh` to a sphere around the origin, whose radius is a part of the result.
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
  ///     \cgalParamDescription{the most rounds, each of which moves all vertices}
  ///     \cgalParamType{unsigned int}
  ///     \cgalParamDefault{`500`}
  ///     \cgalParamExtra{A negative number is refused with `ERROR_WRONG_PARAMETER`.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_running_time}
  ///     \cgalParamDescription{the time in seconds after which the map reached by then is checked and returned.
  ///                           The initial map is completed in any case, with the least effort.}
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
  ///         see `find_defect()`; `ERROR_WRONG_PARAMETER` if `is_valid()` is `false` or a negative
  ///         `number_of_iterations` is given; what the initial parameterizer returns if it fails, or
  ///         `ERROR_INVALID_INITIAL_PARAMETERIZATION` if its map is not one-to-one by more than rounding can change;
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
    if(!is_valid())
      return ERROR_WRONG_PARAMETER;
    std::size_t most_iterations = 500;
    if(!internal::read_number_of_iterations(np, most_iterations))
      return ERROR_WRONG_PARAMETER;
    return internal::run_parameterization<ConcurrencyTag>(
        tmesh, vertex_sphere_map, np, m_report, internal::Guarantee::NONE,
        [&](const internal::Indexed_mesh& mesh, const auto& vertices_of_mesh,
            std::vector<internal::Vector_3d>& positions, double& radius, auto& control) {
          const Error_code error = internal::make_initial_map<ConcurrencyTag>(m_initial_parameterizer, tmesh, mesh,
                                                                              vertices_of_mesh, np, positions, control);
          if(error != OK)
            return error;
          internal::ARAP_map<Solver_traits, ConcurrencyTag> map(mesh);
          if(!map.run(positions, radius, most_iterations, control))
            return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
          m_report.seconds_for_optimization = control.lap();
          control.visitor().on_optimization_end();
          return OK;
        });
  }

  /// returns what the last run did.
  const Parameterization_report& report() const
  {
    return m_report;
  }

  /// returns whether the initial parameterizer is valid.
  bool is_valid() const
  {
    return internal::is_valid_policy(m_initial_parameterizer);
  }

private:
  Initial_parameterizer m_initial_parameterizer;
  Parameterization_report m_report;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ARAP_PARAMETERIZER_3_H
