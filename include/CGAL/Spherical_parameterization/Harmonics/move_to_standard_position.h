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
/// How a surface has come into standard position, and how sure that is: what `move_to_standard_position()` tells.
struct Standard_position
{
  /// Type of the rotations
  using Rotation = Aff_transformation_3<Exact_predicates_inexact_constructions_kernel>;

  Rotation rotation_of_surface;                  ///< A point \f$ p \f$ has come to \f$ R (p - c) \f$.
  Rotation rotation_of_sphere;                   ///< A direction \f$ q \f$ has come to \f$ R q \f$.
  std::array<double, 3> center = {{0., 0., 0.}}; ///< \f$ c \f$, the mean of the surface over the sphere
  /// Half the lengths of the axes of the ellipsoid, the largest one first; the last one is negative if the surface is inside out
  std::array<double, 3> semi_axes = {{0., 0., 0.}};
  /// Third moments of the surface along its axes over the powers 3/2 of the second ones: positive for the first two
  std::array<double, 3> skewness = {{0., 0., 0.}};
  /// Whether no two axes are of the same length, up to a hundredth: otherwise noise turns the surface about the third one
  bool axes_are_determined = false;
  /// Whether the skewness along the first two axes is above a hundredth: otherwise noise turns the surface by half a turn
  bool signs_are_determined = false;
};

namespace internal {

Error_code move_harmonics(Spherical_harmonics_3& harmonics, Standard_position& position, Run_control& control,
                          const Execution& execution);

} // namespace internal

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// moves a surface into standard position \cgalCite{cgal:bgk-psdod-95} - the harmonics of degree 1 make an ellipsoid of it, whose
/// centre comes to the origin and whose axes come to those of space, the longest one to the x-axis and the shortest one to the z-axis; and
/// the sphere is turned such that the directions of the axes are the axes as well. So the coefficients of surfaces of the same kind
/// can be compared, wherever the surfaces were and however their maps were turned. Nothing is scaled.
///
/// An ellipsoid does not tell an axis from its opposite. The surface lies such that its third moments along the first two axes are
/// positive: its far end is where x and y are positive. Where axes are of nearly the same length, or the surface is as long on
/// both sides, noise decides, which the result tells: see `Standard_position::axes_are_determined`. Extremities in different
/// poses are not brought together by any rotation; `map_surface()` does that.
///
/// The running time is that of `rotate_spherical_harmonics()`.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param harmonics the three coordinates of a surface, which are replaced
/// \param position receives what has been done
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{a visitor whose `go_further()`, asked from time to time, may stop the run}
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
/// \return `OK`; `ERROR_WRONG_PARAMETER` if there are not three functions, or the degree is 0; `ERROR_NON_FINITE_COORDINATE` if a
///         coefficient is infinite or not a number; `ERROR_UNDETERMINED_ROTATION` if the ellipsoid is a point or a line; or
///         `ERROR_STOPPED`. All is as it was then.
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
