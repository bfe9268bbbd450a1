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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BIJECTIVE_LOW_DISTORTION_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BIJECTIVE_LOW_DISTORTION_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/run/run_descent.h>
#include <CGAL/Spherical_parameterization/internal/run/run_parameterization.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Bijective_low_distortion_parameterizer_3` computes a bijective map with low distortion from a surface to
/// a sphere, by an extension of the method BLD \cgalCite{cgal:whfl-bspld-16}.
///
/// It is the default method of `parameterize()`. Each setting is a function that returns a changed parameterizer, so
/// that calls can be chained, here with `SP` for the namespace:
/// \code
/// SP::parameterize(mesh, SP::Bijective_low_distortion_parameterizer_3().sharpness(SP::Sharpness::fixed(5.)), map);
/// \endcode
///
/// <b>Objective.</b> The parameterizer minimizes one function \f$ \Phi \f$ that combines the average and a soft maximum
/// of the energies of the faces, see `Sharpness`. The variables of \f$ \Phi \f$ are the map, the radius of the sphere
/// and the level of the soft maximum. If a radius policy is set, the policy determines the radius instead.
///
/// <b>Method.</b> The descent starts from any bijective map. Sweeps move each vertex by a Newton step, where the paper
/// uses gradient steps (eq. 8). They alternate with steps of all variables together. By default, a mesh of more than
/// about 10,000 vertices starts from a map that minimizes \f$ \Phi \f$ on a coarser mesh with at most a quarter of them,
/// unless the sharpness follows a schedule.
/// \ref SphericalParameterizationHowItWorksDescent has the details.
///
/// <b>Guarantee.</b> If `OK` is returned, the map is bijective, also after a run that was stopped early. Exact
/// predicates certify the points as they have been written. No step inverts a face. Without a radius policy, no step
/// increases \f$ \Phi \f$ by more than rounding error, see \ref SphericalParameterizationHowItWorksMonotonic. The
/// result is bitwise identical for any number of threads.
///
/// <b>Complexity.</b> A sweep takes linear time. `report()` counts the sweeps over all vertices only, not those around
/// the worst faces.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam Energy must be a model of `DistortionEnergy_3`.
/// \tparam Radius must be a model of `SphereRadiusPolicy_3`.<br> <b>%Default:</b> no policy; the radius is a variable
///         of the objective
/// \tparam InitialParameterizer must be a model of `SphericalParameterizer_3`.<br> <b>%Default:</b>
///         the levels of `Hierarchical_parameterizer_3` with the energy of this class, on some of which \f$ \Phi \f$ is
///         minimized
///
/// \sa `Precomputed_parameterizer_3`
/// \sa `Published_low_distortion_parameterizer_3`
template <class Energy = Symmetric_Dirichlet_energy_3, class Radius = Default, class InitialParameterizer = Default>
class Bijective_low_distortion_parameterizer_3
{
public:
  /// \name Settings
  /// Each function returns a parameterizer with one setting changed, so that they can be chained.
  /// @{

  /// constructs the parameterizer with the default settings.
  Bijective_low_distortion_parameterizer_3() = default;

  /// sets the distortion energy. `OtherEnergy` must be a model of `DistortionEnergy_3`.
  template <class OtherEnergy>
  [[nodiscard]] Bijective_low_distortion_parameterizer_3<OtherEnergy, Radius, InitialParameterizer> energy(
      const OtherEnergy& energy) const
  {
    return {energy, m_radius, m_initial_parameterizer, m_sharpness, m_settings};
  }

  /// sets a radius policy. By default there is none, and the radius is a variable of the objective. `OtherRadius` must
  /// be a model of `SphereRadiusPolicy_3`.
  template <class OtherRadius>
  [[nodiscard]] Bijective_low_distortion_parameterizer_3<Energy, OtherRadius, InitialParameterizer> radius(
      const OtherRadius& radius) const
  {
    return {m_energy, radius, m_initial_parameterizer, m_sharpness, m_settings};
  }

  /// sets the parameterizer that computes the initial map. `OtherParameterizer` must be a model of
  /// `SphericalParameterizer_3`.
  template <class OtherParameterizer>
  [[nodiscard]] Bijective_low_distortion_parameterizer_3<Energy, Radius, OtherParameterizer> initial_parameterizer(
      const OtherParameterizer& initial_parameterizer) const
  {
    return {m_energy, m_radius, initial_parameterizer, m_sharpness, m_settings};
  }

  /// sets the weight of the worst faces in the objective, by default `Sharpness::balanced()`.
  [[nodiscard]] Bijective_low_distortion_parameterizer_3 sharpness(const Sharpness& sharpness) const
  {
    return {m_energy, m_radius, m_initial_parameterizer, sharpness, m_settings};
  }

  /// sets the tolerances of the stopping criterion.
  ///
  /// A run has converged when, over two sweeps and one smooth step, the objective and the average energy change by at
  /// most `energy_tolerance`, and the radius changes by at most `radius_tolerance`. The changes are relative. A mesh of
  /// \f$ n \leq 2000 \f$ vertices is compared over \f$ 2 + \lfloor 2000 / n \rfloor \f$ sweeps, at most 100. A
  /// sharpness that changes during the run must have reached its final value.
  ///
  /// The changes of the objective and of the average are relative to the smaller one of two numbers: the amount by
  /// which the value exceeds the energy of an isometry, and twice the difference between the largest and the average
  /// energy. They are relative to at least one millionth of the value. With tolerances of 0, a run ends when nothing
  /// changes any more. On coarse levels, tolerances below the defaults are the defaults.
  ///
  /// \param energy_tolerance at least 0, by default 1e-3
  /// \param radius_tolerance at least 0, by default 2e-3
  [[nodiscard]] Bijective_low_distortion_parameterizer_3 tolerances(double energy_tolerance,
                                                                    double radius_tolerance) const
  {
    return {m_energy, m_radius, m_initial_parameterizer, m_sharpness, {energy_tolerance, radius_tolerance, true}};
  }

  /// returns whether all settings are in their ranges; if not, `parameterize()` returns `ERROR_WRONG_PARAMETER`.
  bool is_valid() const
  {
    return internal::is_valid_policy(m_initial_parameterizer) && internal::is_valid_policy(m_energy) &&
           internal::is_valid_policy(m_radius) && m_sharpness.is_valid() && m_settings.energy_tolerance >= 0. &&
           m_settings.radius_tolerance >= 0.;
  }

  /// @}

  /// computes a bijective map from `tmesh` to a sphere around the origin.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. The default of
  /// `number_of_iterations` is 250 for meshes of 2000 vertices and more. For \f$ n < 2000 \f$ vertices, it is
  /// multiplied by \f$ 1 + \lfloor 2000 / (n + 1) \rfloor \f$.
  ///
  /// \return `OK`; a defect of the mesh, see `find_defect()`; `ERROR_WRONG_PARAMETER` if `is_valid()` is `false` or
  ///         `number_of_iterations` is negative; the error code of the initial parameterizer if it fails;
  ///         `ERROR_INVALID_INITIAL_PARAMETERIZATION` if the initial map is not bijective, or if rounding errors could
  ///         invert one of its faces; `ERROR_INSUFFICIENT_PRECISION` if the coordinates of `vertex_sphere_map` cannot
  ///         represent the map
  template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    if constexpr(internal::check_settings<Energy, Radius>())
      return internal::run_parameterization<ConcurrencyTag>(tmesh, vertex_sphere_map, np, m_report, [&](auto& run) {
        if(is_valid() && run.read_number_of_iterations() && run.read())
          run.error = make_initial_map(run);
        if(run.error == OK)
          internal::run_descent<internal::Newton_step>(
              m_energy, m_radius, m_sharpness, m_settings,
              run.number_of_iterations.value_or(internal::default_number_of_sweeps(run.surface.number_of_vertices())),
              run);
      });
    else
      return ERROR_WRONG_PARAMETER;
  }

  /// returns the report of the last run.
  const Parameterization_report& report() const { return m_report; }

private:
  template <class OtherEnergy, class OtherRadius, class OtherParameterizer>
  friend class Bijective_low_distortion_parameterizer_3;

  Bijective_low_distortion_parameterizer_3(const Energy& energy, const Radius& radius,
                                           const InitialParameterizer& initial_parameterizer,
                                           const Sharpness& sharpness, const internal::Descent_settings& settings)
    : m_energy(energy)
    , m_radius(radius)
    , m_initial_parameterizer(initial_parameterizer)
    , m_sharpness(sharpness)
    , m_settings(settings)
  {}

  template <class Run>
  Error_code make_initial_map(Run& run)
  {
    if constexpr(std::is_same<InitialParameterizer, Default>::value)
    {
      internal::embed_surface(m_energy, {internal::default_sweeps_per_level, false, m_sharpness, m_settings}, run);
      return OK;
    }
    else
      return internal::make_initial_map(m_initial_parameterizer, run);
  }

  Energy m_energy;
  Radius m_radius;
  InitialParameterizer m_initial_parameterizer;
  Sharpness m_sharpness;
  internal::Descent_settings m_settings;
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BIJECTIVE_LOW_DISTORTION_PARAMETERIZER_3_H
