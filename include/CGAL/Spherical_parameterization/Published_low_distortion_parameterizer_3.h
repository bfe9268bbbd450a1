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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PUBLISHED_LOW_DISTORTION_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PUBLISHED_LOW_DISTORTION_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Area_balancing_radius_3.h>
#include <CGAL/Spherical_parameterization/Area_preserving_radius_3.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Harmonic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/Two_phase_radius_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/run/run_descent.h>
#include <CGAL/Spherical_parameterization/internal/run/run_parameterization.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <type_traits>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Published_low_distortion_parameterizer_3` implements the method BLD as it was published
/// \cgalCite{cgal:whfl-bspld-16}. It is a baseline for comparisons with `Bijective_low_distortion_parameterizer_3`,
/// which is faster and reaches a lower distortion.
///
/// The method starts from a harmonic map. It makes 100 sweeps of eq. 6 with the isometric energy, where a face has the
/// area of its flat image. Then it makes sweeps of eq. 7, in which \f$ s \f$ grows from 0.1 to 10, with at most 2000
/// sweeps in total. In a sweep, each vertex makes one step of gradient descent (eq. 8). The trial step is as long as
/// the shortest edge at the vertex. It is multiplied by 0.8 until the energy decreases and no face of the star is
/// inverted. It is given up below 1e-10 of that edge.
///
/// The flat area of an inverted face is positive, so only the test for inverted faces prevents inversions, and faces
/// may get stuck across a great circle. The radius follows eq. 9 until, in one sweep, the sum changes by at most 1e-5
/// and the radius by at most 1e-3, both relative. Then it follows eq. 11 until the same criterion is met again.
///
/// The guarantee is that of `Bijective_low_distortion_parameterizer_3`.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam Radius must be a model of `SphereRadiusPolicy_3`.
/// \tparam InitialParameterizer must be a model of `SphericalParameterizer_3`.
template <class Radius = Two_phase_radius_3<>, class InitialParameterizer = Harmonic_parameterizer_3<>>
class Published_low_distortion_parameterizer_3
{
public:
  /// \name Settings
  /// Each function returns a parameterizer with one setting changed, so that they can be chained.
  /// @{

  /// constructs the parameterizer with the settings of the paper. The default radius policy has the tolerance 0: eq. 9
  /// is used until the energy has converged as well.
  Published_low_distortion_parameterizer_3() = default;

  /// sets the radius policy. `OtherRadius` must be a model of `SphereRadiusPolicy_3`.
  template <class OtherRadius>
  [[nodiscard]] Published_low_distortion_parameterizer_3<OtherRadius, InitialParameterizer> radius(
      const OtherRadius& radius) const
  {
    return {radius, m_initial_parameterizer, m_sharpness};
  }

  /// sets the parameterizer that computes the initial map. `OtherParameterizer` must be a model of
  /// `SphericalParameterizer_3`.
  template <class OtherParameterizer>
  [[nodiscard]] Published_low_distortion_parameterizer_3<Radius, OtherParameterizer> initial_parameterizer(
      const OtherParameterizer& initial_parameterizer) const
  {
    return {m_radius, initial_parameterizer, m_sharpness};
  }

  /// sets the weight of the worst faces in the objective, by default `Sharpness::schedule(0.1, 10., 100)`.
  [[nodiscard]] Published_low_distortion_parameterizer_3 sharpness(const Sharpness& sharpness) const
  {
    return {m_radius, m_initial_parameterizer, sharpness};
  }

  /// returns whether all settings are in their ranges; if not, `parameterize()` returns `ERROR_WRONG_PARAMETER`.
  bool is_valid() const
  {
    return internal::is_valid_policy(m_initial_parameterizer) && internal::is_valid_policy(m_radius) &&
           m_sharpness.is_valid();
  }

  /// @}

  /// computes a bijective map from `tmesh` to a sphere around the origin.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. The default of
  /// `number_of_iterations` is 2000.
  ///
  /// \return an error code of `Bijective_low_distortion_parameterizer_3`
  template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    if constexpr(internal::check_settings<Isometric_energy_3, Radius>())
      return internal::run_parameterization<ConcurrencyTag>(tmesh, vertex_sphere_map, np, m_report, [&](auto& run) {
        if(is_valid() && run.read_number_of_iterations() && run.read())
          run.error = internal::make_initial_map(m_initial_parameterizer, run);
        if(run.error == OK)
          internal::run_descent<internal::Gradient_step>(Isometric_energy_3(), m_radius, m_sharpness,
                                                         {1e-5, 1e-3, false}, run.number_of_iterations.value_or(2000),
                                                         run);
      });
    else
      return ERROR_WRONG_PARAMETER;
  }

  /// returns the report of the last run.
  const Parameterization_report& report() const { return m_report; }

private:
  template <class OtherRadius, class OtherParameterizer>
  friend class Published_low_distortion_parameterizer_3;

  Published_low_distortion_parameterizer_3(const Radius& radius, const InitialParameterizer& initial_parameterizer,
                                           const Sharpness& sharpness)
    : m_radius(radius)
    , m_initial_parameterizer(initial_parameterizer)
    , m_sharpness(sharpness)
  {}

  static Radius default_radius()
  {
    if constexpr(std::is_same<Radius, Two_phase_radius_3<>>::value)
      return Radius(Area_preserving_radius_3(), Area_balancing_radius_3(), 0.);
    else
      return Radius();
  }

  Radius m_radius = default_radius();
  InitialParameterizer m_initial_parameterizer;
  Sharpness m_sharpness = Sharpness::schedule(0.1, 10., 100);
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PUBLISHED_LOW_DISTORTION_PARAMETERIZER_3_H
