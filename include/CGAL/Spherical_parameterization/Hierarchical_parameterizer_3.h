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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/descent/Descent_settings.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/run/run_descent.h>
#include <CGAL/Spherical_parameterization/internal/run/run_parameterization.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <optional>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Hierarchical_parameterizer_3` maps a surface to the unit sphere through a hierarchy of coarser meshes.
///
/// Half-edge collapses remove independent sets of vertices until a tetrahedron is left, which is mapped to a regular
/// one. The sets are then inserted again, each vertex into the kernel of the hole that its removal left. After each
/// set, some sweeps of block coordinate descent decrease the average energy of the level. The default energy combines
/// angle and area distortion.
///
/// By default, `Bijective_low_distortion_parameterizer_3` starts from such a map for its own energy, except that some
/// levels also minimize its objective.
///
/// <b>Guarantee.</b> If `OK` is returned, the map is bijective: it is certified as it has been written. If double
/// precision cannot represent the map, it is computed again with a penalty on small faces. If several such attempts
/// fail, the map is that of `Schnyder_parameterizer_3`, and `Parameterization_report::used_last_resort` is set.
///
/// <b>Complexity.</b> Time and memory are linear in the number of vertices, except for sorting the candidates for
/// removal.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam Energy must be a model of `DistortionEnergy_3`.
///
/// \sa `Schnyder_parameterizer_3`
template <class Energy = Isometric_energy_3>
class Hierarchical_parameterizer_3
{
public:
  /// \name Settings
  /// Each function returns a parameterizer with one setting changed, so that they can be chained.
  /// @{

  /// constructs the parameterizer with the default settings.
  Hierarchical_parameterizer_3() = default;

  /// sets the distortion energy. `OtherEnergy` must be a model of `DistortionEnergy_3`.
  template <class OtherEnergy>
  [[nodiscard]] Hierarchical_parameterizer_3<OtherEnergy> energy(const OtherEnergy& energy) const
  {
    return Hierarchical_parameterizer_3<OtherEnergy>(energy, m_sweeps_per_level);
  }

  /// sets the number of sweeps over each level, at least 1, by default 5. Levels below 2000 vertices are swept until
  /// they have converged, at most 300 times.
  [[nodiscard]] Hierarchical_parameterizer_3 sweeps_per_level(std::size_t sweeps_per_level) const
  {
    return Hierarchical_parameterizer_3(m_energy, sweeps_per_level);
  }

  /// returns whether all settings are in their ranges.
  bool is_valid() const { return internal::is_valid_policy(m_energy) && m_sweeps_per_level > 0; }

  /// @}

  /// computes a bijective map from `tmesh` to the unit sphere around the origin.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`, without `number_of_iterations`.
  /// After `maximum_running_time`, or if the visitor stops the run, each remaining level gets one sweep, the minimum,
  /// before the map is certified and returned.
  ///
  /// \return `OK`; a defect of the mesh, see `find_defect()`; `ERROR_WRONG_PARAMETER` if `is_valid()` is `false`;
  ///         `ERROR_INSUFFICIENT_PRECISION` if the coordinates of `vertex_sphere_map` cannot represent the map
  template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    if constexpr(internal::check_energy<Energy>())
      return internal::run_parameterization<ConcurrencyTag>(tmesh, vertex_sphere_map, np, m_report, [&](auto& run) {
        if(is_valid() && run.read())
          run.error = embed(run, true);
      });
    else
      return ERROR_WRONG_PARAMETER;
  }

  /// returns the report of the last run. The stop reason is `CONVERGED` if the mesh has fewer than 2000 vertices and
  /// the sweeps have converged, and `ITERATION_LIMIT` if all sweeps have been made.
  const Parameterization_report& report() const { return m_report; }

#ifndef DOXYGEN_RUNNING
  // maps the surface of a run; see internal::make_initial_map()
  Error_code embed(internal::Run& run, bool sweeps_finest_level) const
  {
    internal::embed_surface(m_energy, {m_sweeps_per_level, sweeps_finest_level, std::nullopt, {}}, run);
    return OK;
  }
#endif

private:
  template <class OtherEnergy>
  friend class Hierarchical_parameterizer_3;

  Hierarchical_parameterizer_3(const Energy& energy, std::size_t sweeps_per_level)
    : m_energy(energy)
    , m_sweeps_per_level(sweeps_per_level)
  {}

  Energy m_energy;
  std::size_t m_sweeps_per_level = internal::default_sweeps_per_level;
  Parameterization_report m_report;
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
