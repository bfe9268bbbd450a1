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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TWO_PHASE_RADIUS_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TWO_PHASE_RADIUS_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Area_balancing_radius_3.h>
#include <CGAL/Spherical_parameterization/Area_preserving_radius_3.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>

#include <cmath>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationRadius
///
/// The class `Two_phase_radius_3` follows one radius policy until the radius has converged, and a second one from then
/// on.
///
/// By default, it is the scheme of the BLD paper \cgalCite{cgal:whfl-bspld-16} and of
/// `Published_low_distortion_parameterizer_3`: first eq. 9, which is robust for strongly distorted initial maps, then
/// eq. 11, which gives the lower distortion.
///
/// \cgalModels{SphereRadiusPolicy_3}
///
/// \tparam FirstRadius,SecondRadius must be models of `SphereRadiusPolicy_3`.
template <class FirstRadius = Area_preserving_radius_3, class SecondRadius = Area_balancing_radius_3>
class Two_phase_radius_3
{
public:
  /// constructs the policy from the policies of the two phases.
  ///
  /// \param first,second the policies of the first and of the second phase
  /// \param tolerance the relative change of the radius at which the first phase ends, at least 0; with 0 it lasts
  ///        until the energy has converged as well, as in the paper
  explicit Two_phase_radius_3(const FirstRadius& first = FirstRadius(), const SecondRadius& second = SecondRadius(),
                              double tolerance = 1e-3)
    : m_first(first)
    , m_second(second)
    , m_tolerance(tolerance)
  {}

  /// returns whether both policies are valid and the tolerance is at least 0.
  bool is_valid() const
  {
    return internal::is_valid_policy(m_first) && internal::is_valid_policy(m_second) && m_tolerance >= 0.;
  }

  /// returns the initial radius of the first phase, given the radius `equal_area_radius` at which the sphere has the
  /// area of the surface.
  double initial_radius(double equal_area_radius) const { return m_first.initial_radius(equal_area_radius); }

  /// returns the radius that follows `radius`, in linear time.
  template <class Energy>
  double operator()(const Energy& energy, const Face_range_3& faces, double radius)
  {
    if(m_is_settled)
      return m_second(energy, faces, radius);
    const double next = m_first(energy, faces, radius);
    m_is_settled = m_tolerance > 0. && !(std::abs(next - radius) > m_tolerance * radius);
    return next;
  }

  /// starts the second phase, or the next phase of a policy that has phases itself, and returns whether there was one.
  /// It is called when the map has converged. With a positive tolerance, the first policy ends as soon as the radius
  /// has converged, even if that policy has further phases.
  bool next_phase()
  {
    if(m_is_settled)
      return internal::next_phase(m_second);
    m_is_settled = !internal::next_phase(m_first);
    return true;
  }

private:
  FirstRadius m_first;
  SecondRadius m_second;
  double m_tolerance;
  bool m_is_settled = false;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TWO_PHASE_RADIUS_3_H
