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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_MOVE_TO_STANDARD_POSITION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_MOVE_TO_STANDARD_POSITION_H

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

#include <array>

#include <array>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// The transformation to standard position and how well it is determined, computed by `move_to_standard_position()`.
struct Standard_position
{
  /// Type of the rotations
  using Rotation = Aff_transformation_3<Exact_predicates_inexact_constructions_kernel>;

  Rotation rotation_of_surface;                  ///< A point \f$ p \f$ is moved to \f$ R (p - c) \f$.
  Rotation rotation_of_sphere;                   ///< A direction \f$ q \f$ is moved to \f$ R q \f$.
  std::array<double, 3> center = {{0., 0., 0.}}; ///< \f$ c \f$, the mean of the surface points over the sphere
  /// Half the lengths of the axes of the ellipsoid, in descending order; the last one is negative if the ellipsoid is
  /// oriented inwards
  std::array<double, 3> semi_axes = {{0., 0., 0.}};
  /// Skewness along the axes: third moments divided by the 3/2 power of the second moments; positive for the first two
  /// axes
  std::array<double, 3> skewness = {{0., 0., 0.}};
  /// Whether the lengths of any two axes differ by more than 1 percent; otherwise noise determines the rotation about
  /// the third axis
  bool axes_are_determined = false;
  /// Whether the skewness along the first two axes exceeds 0.01; otherwise noise may cause a half-turn
  bool signs_are_determined = false;
};

namespace internal {

Error_code move_harmonics(Spherical_harmonics_3& harmonics, Standard_position& position, Run_control& control,
                          const Execution& execution);

} // namespace internal

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// moves a surface into standard position \cgalCite{cgal:bgk-psdod-95}, so that coefficients of similar surfaces can be
/// compared irrespective of their poses and of rotations of their maps. Nothing is scaled.
///
/// The harmonics of degree 1 describe an ellipsoid. The surface is moved so that the center of the ellipsoid is the
/// origin, its longest axis is the x-axis, and its shortest axis is the z-axis. The sphere is rotated so that the
/// directions of these axes are the coordinate axes, too. The ellipsoid does not distinguish an axis from its opposite:
/// half-turns make the third moments of the surface along the first two axes positive.
///
/// If axes have nearly the same length, or the surface is nearly symmetric, noise determines the result, see
/// `Standard_position::axes_are_determined` and `Standard_position::signs_are_determined`. A rotation cannot align
/// extremities in different poses; use `map_surface()` for this.
///
/// The running time is that of `rotate_spherical_harmonics()`.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param harmonics the three coordinates of a surface, which are replaced
/// \param position receives the transformation
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
/// \return `OK`; `ERROR_WRONG_PARAMETER` if the number of functions is not three, or the degree is 0;
///         `ERROR_NON_FINITE_COORDINATE` if a coefficient is infinite or not a number; `ERROR_UNDETERMINED_ROTATION` if
///         the ellipsoid is a point or a segment; or `ERROR_STOPPED`. On an error, `harmonics` and `position` are
///         unchanged.
template <class ConcurrencyTag = Parallel_if_available_tag, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code move_to_standard_position(Spherical_harmonics_3& harmonics, Standard_position& position,
                                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::Visitor_control<CGAL_NP_CLASS> control(np);
  return internal::move_harmonics(harmonics, position, control, internal::execution_of<ConcurrencyTag>());
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Harmonics/internal/harmonics_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_MOVE_TO_STANDARD_POSITION_H
