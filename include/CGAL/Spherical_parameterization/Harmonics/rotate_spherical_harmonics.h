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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_ROTATE_SPHERICAL_HARMONICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_ROTATE_SPHERICAL_HARMONICS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/run/Visitor_control.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

namespace CGAL::Spherical_parameterization {
namespace internal {

Error_code rotate_harmonics(Spherical_harmonics_3& harmonics,
                            const Aff_transformation_3<Exact_predicates_inexact_constructions_kernel>& rotation,
                            Run_control& control, const Execution& execution);

} // namespace internal

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// rotates functions on the sphere: the new functions have the value at \f$ R q \f$ that the old functions have at
/// \f$ q \f$. If the functions represent a surface, the surface does not move; only its map to the sphere is rotated.
///
/// The functions are evaluated at the nodes of a rotated grid on which sums of harmonics are integrated exactly. The
/// coefficients are accurate up to rounding error, about \f$ 10^{-13} \f$ of the largest one. The running time is
/// \f$ O(L^4) \f$ for the degree \f$ L \f$: about 0.1 and 2 seconds in one thread for the degrees 100 and 200.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param harmonics the functions, which are replaced
/// \param rotation the rotation \f$ R \f$
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
/// \return `OK`; `ERROR_WRONG_PARAMETER` if `rotation` is not a rotation up to rounding error; or `ERROR_STOPPED`. On
///         an error, `harmonics` is unchanged.
///
/// \sa `CGAL::Spherical_parameterization::align_spheres()`
/// \sa `CGAL::Spherical_parameterization::move_to_standard_position()`
template <class ConcurrencyTag = Parallel_if_available_tag, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code rotate_spherical_harmonics(
    Spherical_harmonics_3& harmonics,
    const Aff_transformation_3<Exact_predicates_inexact_constructions_kernel>& rotation,
    const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::Visitor_control<CGAL_NP_CLASS> control(np);
  return internal::rotate_harmonics(harmonics, rotation, control, internal::execution_of<ConcurrencyTag>());
}

} // namespace CGAL::Spherical_parameterization

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Harmonics/internal/harmonics_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_ROTATE_SPHERICAL_HARMONICS_H
