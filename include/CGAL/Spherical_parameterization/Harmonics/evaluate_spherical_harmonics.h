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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_EVALUATE_SPHERICAL_HARMONICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_EVALUATE_SPHERICAL_HARMONICS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/Visitor_control.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {
namespace internal {

// The same for directions of length 1 or directions that are not finite.
Error_code evaluate_harmonics(const Spherical_harmonics_3& harmonics, const std::vector<Vector_3d>& directions,
                              std::vector<double>& values, Run_control& control, const Execution& execution);

} // namespace internal

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// evaluates functions at directions.
///
/// The values are accurate up to rounding error at all directions, including those near the poles, and for all degrees
/// up to `Spherical_harmonics_3::max_degree`: Legendre functions are computed by the recursion in the degree, which is
/// stable \cgalCite{cgal:hf-uacsh-02}. The running time is \f$ O(k L^2) \f$ for \f$ k \f$ directions and the degree
/// \f$ L \f$.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam DirectionRange a model of `ConstRange` whose value type is `%Point_3` of a \cgal kernel
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param harmonics the functions
/// \param directions points other than the origin, at any distance from it
/// \param values receives the values of all functions at the first direction, then those at the second direction, and
///         so on
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{a visitor whose `go_further()` is called regularly and may stop the run}
///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time in seconds after which the run is stopped}
///     \cgalParamType{double}
///     \cgalParamDefault{no limit, as with any value that is not positive}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; `ERROR_INVALID_DIRECTION` if a direction is zero, infinite or not a number; or `ERROR_STOPPED`. On an
///         error, `values` is unchanged.
///
/// \sa `CGAL::Spherical_parameterization::expand_in_spherical_harmonics()`
template <class ConcurrencyTag = Parallel_if_available_tag, class DirectionRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code evaluate_spherical_harmonics(const Spherical_harmonics_3& harmonics, const DirectionRange& directions,
                                        std::vector<double>& values,
                                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::Visitor_control<CGAL_NP_CLASS> control(np);
  std::vector<internal::Vector_3d> of_length_1;
  for(const auto& q : directions)
    of_length_1.push_back(internal::direction_of(q));
  return internal::evaluate_harmonics(harmonics, of_length_1, values, control,
                                      internal::execution_of<ConcurrencyTag>());
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Harmonics/internal/harmonics_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_EVALUATE_SPHERICAL_HARMONICS_H
