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
/// The class `Bijective_low_distortion_parameterizer_3` implements the method BLD \cgalCite{cgal:whfl-bspld-16}. It
/// starts from a one-to-one map onto the sphere, however distorted, and lowers one objective of the map, the radius and a
/// level, see `Sharpness`, by block coordinate descent over the vertices (eq. 8), the radius and the level, and by smooth
/// steps of all of them together. The vertices of one colour of a graph colouring are moved in parallel. No step ever inverts
/// a face, and, without a radius policy, none raises the objective for good: \ref SphericalParameterizationSharpness says why.
///
/// It is used with its defaults by `parameterize()`. Settings are chained, here with `SP` for the namespace:
/// \code
/// SP::parameterize(mesh, SP::Bijective_low_distortion_parameterizer_3().sharpness(SP::Sharpness::fixed(5.)), map);
/// \endcode
///
/// Sweeps go on until the objective, the average energy and the radius have settled. Each is preceded by steps of the level and the
/// radius, every other one by a smooth step where that is worth its time, and followed by sweeps over the neighborhoods of the
/// worst faces. A dial beyond that of `Sharpness::balanced()` starts from the map that has settled for that one.
/// \ref SphericalParameterizationSharpness says how it works. The report counts sweeps over all vertices only.
///
/// A one-to-one mapping is guaranteed whenever `OK` is returned, by exact predicates on the points as they have been
/// written, for a run that was stopped early as well. A sweep takes linear time. The result is the same to the last bit
/// for any number of threads.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam Energy must be a model of `DistortionEnergy_3`.
/// \tparam Radius must be a model of `SphereRadiusPolicy_3`.<br> <b>%Default:</b> no policy; the radius is a variable of
///         the objective
/// \tparam InitialParameterizer must be a model of `SphericalParameterizer_3`.<br> <b>%Default:</b>
///         `Hierarchical_parameterizer_3` with the energy of this class
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

  /// sets the energy that is lowered. `OtherEnergy` must be a model of `DistortionEnergy_3`.
  template <class OtherEnergy>
  [[nodiscard]] Bijective_low_distortion_parameterizer_3<OtherEnergy, Radius, InitialParameterizer> energy(
      const OtherEnergy& energy) const
  {
    return {energy, m_radius, m_initial_parameterizer, m_sharpness, m_settings};
  }

  /// sets a radius policy. By default there is none: the radius is a variable of the objective. `OtherRadius` must be a
  /// model of `SphereRadiusPolicy_3`.
  template <class OtherRadius>
  [[nodiscard]] Bijective_low_distortion_parameterizer_3<Energy, OtherRadius, InitialParameterizer> radius(
      const OtherRadius& radius) const
  {
    return {m_energy, radius, m_initial_parameterizer, m_sharpness, m_settings};
  }

  /// sets the parameterizer that makes the map to start with. `OtherParameterizer` must be a model of
  /// `SphericalParameterizer_3`.
  template <class OtherParameterizer>
  [[nodiscard]] Bijective_low_distortion_parameterizer_3<Energy, Radius, OtherParameterizer> initial_parameterizer(
      const OtherParameterizer& initial_parameterizer) const
  {
    return {m_energy, m_radius, initial_parameterizer, m_sharpness, m_settings};
  }

  /// sets how much the worst faces count, by default `Sharpness::balanced()`.
  [[nodiscard]] Bijective_low_distortion_parameterizer_3 sharpness(const Sharpness& sharpness) const
  {
    return {m_energy, m_radius, m_initial_parameterizer, sharpness, m_settings};
  }

  /// sets the tolerances of the stopping rule: a run has converged when two sweeps and a smooth step change the objective and
  /// the average energy by at most `energy_tolerance` and the radius by at most `radius_tolerance`, all relative, and the
  /// sharpness has come to its end. For meshes of
  /// \f$ n \leq 2000 \f$ vertices, these are the changes over \f$ 2 + \lfloor 2000 / n \rfloor \f$ sweeps, but over 100 at
  /// most. Changes of energies are relative to what an energy is above that of an isometric map, or to twice the excess of the
  /// largest over the average, if that is less, since a nearly isometric map has hardly more energy than the best one; but
  /// no less than a millionth of the energy. With 0, a run ends when nothing changes any more.
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

  /// computes a one-to-one map from `tmesh` to a sphere around the origin.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. The default of
  /// `number_of_iterations` is 250, and for meshes below 2000 vertices as many times more as they are smaller.
  ///
  /// \return `OK`, or what is wrong with the mesh, see `find_defect()`; `ERROR_WRONG_PARAMETER` if `is_valid()` is
  ///         `false` or a negative `number_of_iterations` is given; what the initial parameterizer returns if it
  ///         fails, or `ERROR_INVALID_INITIAL_PARAMETERIZATION` if its map is not one-to-one by more than rounding
  ///         can change; `ERROR_INSUFFICIENT_PRECISION` if the map cannot be held by the coordinates of
  ///         `vertex_sphere_map`
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

  /// returns what the last run did.
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
      internal::embed_surface(m_energy, internal::default_sweeps_per_level, false, run);
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
