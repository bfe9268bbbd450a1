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
/// A vertex makes one damped Newton step a sweep, on an energy that measures the image of a face by the determinant of
/// its corners: twice its flat area times the distance of its plane from the centre. This agrees with the flat area for
/// small faces, and is 0 exactly where a face turns over, so that the energy is infinite there. Without a radius policy,
/// it is multiplied by 1 + \f$ q / 18 \f$, where \f$ q \f$ is the sum of the squared edges of the face, in a unit in which
/// the surface has the area of the unit sphere, so that isometric faces of coarse meshes count as such. The step is tried at
/// 1.9 times its length first, which carries changes over the surface many times faster. Where the compiler and the
/// processor have vector registers, several vertices are moved at once, with the same result.
///
/// Before each sweep, the level moves to where the objective is lowest, and the radius makes half a Newton step,
/// shortened until it does not raise the objective. The last radius minimises the same sum over the flat areas of the
/// images, by which distortion is measured.
///
/// Sweeps carry what is smooth over the surface slowly, the more so the finer the mesh. From the fourth on, every other sweep
/// is preceded by a <i>smooth step</i>: the sphere is deformed, and all images go along. The deformation is linear in the
/// cells of a grid on the sphere with a node for 64 vertices, but no more than 20,000. It is a step of Newton's method for
/// the objective in the nodes, the level and the radius together, whose Hessian is made positive definite cell by cell, and
/// whose equations are solved by conjugate gradients, up to a tenth. It is halved until no face is inverted and the objective
/// falls, up to four times, or is not made. It takes about the time of a sweep; where it gains less than one, the next one
/// comes after twice as many sweeps, up to 16.
///
/// Slivers, faces whose height is below a hundredth of their longest edge, get a shape near their own in no map of low
/// distortion, and would decide on radius and level for all. Unless they and all faces that touch them are more than a
/// quarter of the faces, these have a level of their own, which is not lowered below that of the others. They do not move
/// the radius: they are measured on a sphere that follows it.
///
/// Each sweep over all vertices is followed by up to 500 over those around the worst faces, whose energy is above 0.6 of
/// the largest, with steps of 1.4 times their length. They settle slowest, and the largest distortion is theirs. All of
/// these sweeps together move at most 0.4 times as many vertices as the mesh has. If that is not enough for two of them,
/// they go over the faces above 0.8, or 0.95, of the largest energy; if it is not enough for these either, there are none,
/// nor with the next four sweeps. The report counts neither these sweeps nor smooth steps.
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
///         `Hierarchical_parameterizer_3` with the energy and the sharpness of this class, and 14 sweeps per level, or
///         20 with a radius policy
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
  /// the average energy by at most `energy_tolerance`, the largest energy by at most 20 times as much, and the radius by at
  /// most `radius_tolerance`, all relative, and a schedule of the sharpness has come to its end. For meshes of
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
      // Where the radius is free, the areas are right from the beginning. Else they may have far to go, which they do on
      // coarse levels.
      constexpr std::size_t sweeps_per_level = std::is_same<Radius, Default>::value ? 14 : 20;
      internal::embed_surface(m_energy, m_sharpness, sweeps_per_level, false, run);
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
