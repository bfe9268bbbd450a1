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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BIJECTIVE_LOW_DISTORTION_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BIJECTIVE_LOW_DISTORTION_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Determinant_barrier_3.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Newton_update_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Relative_sharpness_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/Two_phase_radius_3.h>
#include <CGAL/Spherical_parameterization/internal/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/Initial_map.h>
#include <CGAL/Spherical_parameterization/internal/is_finite.h>
#include <CGAL/Spherical_parameterization/internal/is_valid_policy.h>
#include <CGAL/Spherical_parameterization/internal/next_phase.h>
#include <CGAL/Spherical_parameterization/internal/read_number_of_iterations.h>
#include <CGAL/Spherical_parameterization/internal/run_both.h>
#include <CGAL/Spherical_parameterization/internal/run_parameterization.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

/// \file Bijective_low_distortion_parameterizer_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Bijective_low_distortion_parameterizer_3` implements the method BLD \cgalCite{cgal:whfl-bspld-16}. It
/// starts from a one-to-one map onto the sphere, however distorted, and lowers \f$ \sum E \f$ (eq. 6) or
/// \f$ \sum \exp( s E ) \f$ (eq. 7) by block coordinate descent over the vertices (eq. 8) and the radius of the sphere
/// (eq. 9 to 11). The vertices of one colour of a graph colouring are moved in parallel. No step ever inverts a face.
///
/// If the sharpness is positive, each sweep over all vertices is followed by some over those around the worst faces, as
/// long as they are not more than a fifth: they settle slowest, and the largest distortion is theirs. If they are more,
/// they are looked for again five sweeps later. The report does not count these sweeps.
///
/// A one-to-one mapping is guaranteed whenever `OK` is returned: the orientation of every face and the degree of the
/// map are computed by exact predicates on the points as they have been written. This holds for a run that was stopped
/// early as well.
///
/// A sweep takes linear time. The result is the same to the last bit for any number of threads.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceListGraph`.
/// \tparam InitialParameterizer_ must be a model of `SphericalParameterizer_3`.<br> <b>%Default:</b>
/// \code
///   Hierarchical_parameterizer_3<TriangleMesh_, Energy, Sharpness, Vertex_update>
/// \endcode
/// \tparam Energy_ must be a model of `DistortionEnergy_3`.<br> <b>%Default:</b>
/// \code
///   Symmetric_Dirichlet_energy_3
/// \endcode
/// \tparam Sharpness_ must be a model of `SharpnessPolicy_3`.<br> <b>%Default:</b>
/// \code
///   Relative_sharpness_3
/// \endcode
/// \tparam Radius_ must be a model of `SphereRadiusPolicy_3`.<br> <b>%Default:</b>
/// \code
///   Two_phase_radius_3<>
/// \endcode
/// \tparam VertexUpdate_ must be a model of `VertexUpdate_3`.<br> <b>%Default:</b>
/// \code
///   Newton_update_3
/// \endcode
/// \tparam Barrier_ must be `Determinant_barrier_3` or `Flat_area_barrier_3`.<br> <b>%Default:</b>
/// \code
///   Determinant_barrier_3
/// \endcode
///
/// \sa `Hierarchical_parameterizer_3`
/// \sa `Precomputed_parameterizer_3`
/// \sa `Published_low_distortion_parameterizer_3`
template <class TriangleMesh_, class InitialParameterizer_ = Default, class Energy_ = Default,
          class Sharpness_ = Default, class Radius_ = Default, class VertexUpdate_ = Default, class Barrier_ = Default>
class Bijective_low_distortion_parameterizer_3
{
public:
#ifndef DOXYGEN_RUNNING
  using Energy = typename Default::Get<Energy_, Symmetric_Dirichlet_energy_3>::type;
  using Sharpness = typename Default::Get<Sharpness_, Relative_sharpness_3>::type;
  using Radius = typename Default::Get<Radius_, Two_phase_radius_3<>>::type;
  using Vertex_update = typename Default::Get<VertexUpdate_, Newton_update_3>::type;
  using Barrier = typename Default::Get<Barrier_, Determinant_barrier_3>::type;
  using Initial_parameterizer =
      typename Default::Get<InitialParameterizer_,
                            Hierarchical_parameterizer_3<TriangleMesh_, Energy, Sharpness, Vertex_update>>::type;
#else
  /// Energy type
  using Energy = Energy_;
  /// Sharpness type
  using Sharpness = Sharpness_;
  /// Radius policy type
  using Radius = Radius_;
  /// Vertex update type
  using Vertex_update = VertexUpdate_;
  /// Barrier tag
  using Barrier = Barrier_;
  /// Initial parameterizer type
  using Initial_parameterizer = InitialParameterizer_;
#endif
  /// Triangle mesh type
  using Triangle_mesh = TriangleMesh_;
  /// Triangle mesh type
  using TriangleMesh = TriangleMesh_;

  /// constructs the parameterizer with an initial parameterizer of the type given: one of the default type is made with
  /// the energy, the sharpness and the vertex update, any other one is default constructed.
  ///
  /// \param energy the energy that is lowered
  /// \param sharpness the sharpness policy
  /// \param radius the radius policy
  /// \param vertex_update how a vertex is moved
  explicit Bijective_low_distortion_parameterizer_3(const Energy& energy = Energy(),
                                                    const Sharpness& sharpness = Sharpness(),
                                                    const Radius& radius = Radius(),
                                                    const Vertex_update& vertex_update = Vertex_update())
    : Bijective_low_distortion_parameterizer_3(default_initial_parameterizer(energy, sharpness, vertex_update), energy,
                                               sharpness, radius, vertex_update)
  {}

  /// constructs the parameterizer with the given initial parameterizer.
  ///
  /// \param initial_parameterizer makes the map to start with
  /// \param energy the energy that is lowered
  /// \param sharpness the sharpness policy
  /// \param radius the radius policy
  /// \param vertex_update how a vertex is moved
  explicit Bijective_low_distortion_parameterizer_3(const Initial_parameterizer& initial_parameterizer,
                                                    const Energy& energy = Energy(),
                                                    const Sharpness& sharpness = Sharpness(),
                                                    const Radius& radius = Radius(),
                                                    const Vertex_update& vertex_update = Vertex_update())
    : m_initial_parameterizer(initial_parameterizer)
    , m_energy(energy)
    , m_sharpness(sharpness)
    , m_radius(radius)
    , m_vertex_update(vertex_update)
  {}

  /// sets the tolerances of the stopping rule: a run has converged when a sweep changes the energy by at most
  /// `energy_tolerance` and the radius by at most `radius_tolerance`, both relative, and the sharpness is final. As the
  /// sharpness may move with the map, energies are compared that do so little or not at all, and all have to settle:
  /// the mean \f$ \log( \frac{1}{n} \sum \exp( s E ) ) / s \f$, the average, and, up to ten times the tolerance, the
  /// largest one. If the largest exceeds the average by less than half of their size, changes are relative to
  /// twice that excess instead, since a nearly isometric map has hardly more energy than the best one.
  ///
  /// \param energy_tolerance at least 0, by default 4e-5
  /// \param radius_tolerance at least 0, by default 1e-3
  void set_tolerances(double energy_tolerance, double radius_tolerance)
  {
    m_energy_tolerance = energy_tolerance;
    m_radius_tolerance = radius_tolerance;
  }

  /// sets the most sweeps over the vertices of the mesh that are made if the named parameter `number_of_iterations` is
  /// not given, by default 90.
  void set_number_of_iterations(unsigned int number_of_iterations)
  {
    m_number_of_iterations = number_of_iterations;
  }

  /// sets whether the descent is accelerated beyond what the paper describes, as it is by default.
  ///
  /// If not, no sweeps are spent on the worst faces alone, the radius makes full steps, and the run has converged when
  /// the sum of eq. 6 or 7 itself and the radius have settled. The other differences to the paper are those of the
  /// policies; see `Published_low_distortion_parameterizer_3`.
  ///
  /// \param is_accelerated `true` by default
  void set_acceleration(bool is_accelerated)
  {
    m_is_accelerated = is_accelerated;
  }

  /// computes a one-to-one map from `tmesh` to a sphere around the origin.
  ///
  /// \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
  ///         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
  /// \tparam VertexSphereMap must be a model of `WritablePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as
  ///         value type; its coordinates are of type `double` or `float`, or of an exact number type.
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param tmesh a triangle mesh that is closed, connected and of genus 0
  /// \param vertex_sphere_map the map to be written; it is left as it is unless `OK` is returned
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{vertex_point_map}
  ///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
  ///     \cgalParamType{a class model of `ReadablePropertyMap` with
  ///                    `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and `%Point_3` as
  ///                    value type}
  ///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  ///     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t`
  ///                     must be available in `Triangle_mesh`.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_iterations}
  ///     \cgalParamDescription{the most sweeps over the vertices of `tmesh` itself}
  ///     \cgalParamType{unsigned int}
  ///     \cgalParamDefault{`90`, or what `set_number_of_iterations()` was given}
  ///     \cgalParamExtra{A negative number is refused with `ERROR_WRONG_PARAMETER`.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_running_time}
  ///     \cgalParamDescription{the time in seconds after which the map reached by then is certified and
  ///                           returned. The initial map is completed in any case, with the least effort.}
  ///     \cgalParamType{double}
  ///     \cgalParamDefault{no limit, as with any value that is not positive}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{visitor}
  ///     \cgalParamDescription{a visitor that is told of the progress and may stop it}
  ///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
  ///     \cgalParamDefault{`Default_visitor`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \return `OK`, or what is wrong with the mesh, see `find_defect()`; `ERROR_WRONG_PARAMETER` if `is_valid()` is
  ///         `false` or a negative `number_of_iterations` is given; what the initial parameterizer returns if it
  ///         fails, or `ERROR_INVALID_INITIAL_PARAMETERIZATION` if its map is not one-to-one by more than rounding
  ///         can change; `ERROR_INSUFFICIENT_PRECISION` if the map cannot be held by the coordinates of
  ///         `vertex_sphere_map`
  ///
  /// \pre `num_halfedges(tmesh) < 2147483647`, that is, 2<sup>31</sup> - 1
  template <class ConcurrencyTag = Parallel_if_available_tag, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const Triangle_mesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    m_report = Parameterization_report();
    if(!is_valid())
      return ERROR_WRONG_PARAMETER;
    std::size_t most_iterations = m_number_of_iterations;
    if(!internal::read_number_of_iterations(np, most_iterations))
      return ERROR_WRONG_PARAMETER;
    return internal::run_parameterization<ConcurrencyTag>(
        tmesh, vertex_sphere_map, np, m_report, internal::Guarantee::ONE_TO_ONE,
        [&](const internal::Indexed_mesh& mesh, const auto& vertices_of_mesh,
            std::vector<internal::Vector_3d>& positions, double& radius, auto& control) {
          const Error_code error = internal::make_initial_map<ConcurrencyTag>(m_initial_parameterizer, tmesh, mesh,
                                                                              vertices_of_mesh, np, positions, control);
          if(error != OK)
            return error;
          optimize<ConcurrencyTag>(mesh, most_iterations, positions, radius, control);
          control.visitor().on_optimization_end();
          return OK;
        });
  }

  /// returns what the last run did.
  const Parameterization_report& report() const
  {
    return m_report;
  }

  /// returns whether all policies and parameters are in their ranges; if not, `parameterize()` returns
  /// `ERROR_WRONG_PARAMETER`.
  bool is_valid() const
  {
    return internal::is_valid_policy(m_initial_parameterizer) && internal::is_valid_policy(m_energy) &&
           internal::is_valid_policy(m_sharpness) && internal::is_valid_policy(m_radius) &&
           internal::is_valid_policy(m_vertex_update) && m_energy_tolerance >= 0. && m_radius_tolerance >= 0.;
  }

private:
  // The vertices around faces above this share of the largest energy are swept some times more: as often as takes the
  // time of a sweep over all vertices, if that is not too seldom to be worth it.
  static constexpr double focus_energy = 0.6;
  static constexpr std::size_t least_focus_sweeps = 5;
  static constexpr std::size_t most_focus_sweeps = 10;
  // If it is, they are too many, and stay so for a while: these sweeps do without.
  static constexpr std::size_t sweeps_without_focus = 4;

  // Whether a type is the default initial parameterizer, however its arguments are written.
  template <class Parameterizer>
  struct Is_default : std::false_type
  {};
  template <class E, class S, class U>
  struct Is_default<Hierarchical_parameterizer_3<TriangleMesh_, E, S, U>>
  {
    using Hierarchical = Hierarchical_parameterizer_3<TriangleMesh_, E, S, U>;
    static constexpr bool value = std::is_same<typename Hierarchical::Energy, Energy>::value &&
                                  std::is_same<typename Hierarchical::Sharpness, Sharpness>::value &&
                                  std::is_same<typename Hierarchical::Vertex_update, Vertex_update>::value;
  };

  static Initial_parameterizer default_initial_parameterizer(const Energy& energy, const Sharpness& sharpness,
                                                             const Vertex_update& vertex_update)
  {
    if constexpr(Is_default<Initial_parameterizer>::value)
      return Initial_parameterizer(energy, sharpness, vertex_update);
    else
      return Initial_parameterizer();
  }

  // A policy of the caller's may return anything.
  static bool is_positive_and_finite(double radius)
  {
    return radius > 0. && internal::is_finite(radius);
  }

  static bool is_settled(double value, double last_value, double tolerance)
  {
    return std::abs(value - last_value) <= tolerance * last_value;
  }

  // Whether a sweep has changed nothing that matters. As the sharpness may move with the map, the accelerated descent
  // compares energies that do so little or not at all, and all have to settle; the paper's rule is about the sum alone,
  // whose relative change is that of exp(s mean()).
  bool has_converged(const internal::Energy_summary& summary, const internal::Energy_summary& last_summary,
                     double radius, double last_radius, double sharpness) const
  {
    if(!is_settled(radius, last_radius, m_radius_tolerance))
      return false;
    if(!m_is_accelerated && sharpness > 0.)
      return std::abs(std::expm1(sharpness * (summary.mean() - last_summary.mean()))) <= m_energy_tolerance;
    if(!m_is_accelerated)
      return is_settled(summary.average(), last_summary.average(), m_energy_tolerance);
    const auto is_settled_with = [&](double value, double last_value, double tolerance) {
      return std::abs(value - last_value) <= tolerance * summary.scale_of_changes(last_value);
    };
    return is_settled_with(summary.mean(), last_summary.mean(), m_energy_tolerance) &&
           is_settled_with(summary.average(), last_summary.average(), m_energy_tolerance) &&
           is_settled_with(summary.largest(), last_summary.largest(), 10. * m_energy_tolerance);
  }

  // Lowers the energy of the positions on the unit sphere; `radius` is set to that of the sphere.
  template <class ConcurrencyTag, class RunControl>
  void optimize(const internal::Indexed_mesh& mesh, std::size_t most_iterations,
                std::vector<internal::Vector_3d>& positions, double& radius, RunControl& control)
  {
    using Descent = internal::Block_coordinate_descent<Energy, Vertex_update, ConcurrencyTag, Barrier>;

    Sharpness next_sharpness = m_sharpness; // policies may keep a state: each run has its own
    Radius next_radius = m_radius;
    radius = next_radius.initial_radius(mesh.equal_area_radius());
    if(!is_positive_and_finite(radius))
      radius = mesh.equal_area_radius();
    // the radius in the unit of the mesh, kept where its powers are finite
    const auto scaled = [&](double r) { return (std::min)((std::max)(mesh.scaled_radius(r), 1e-50), 1e50); };

    Descent descent(mesh.rings(), mesh.points(), m_energy, m_vertex_update);
    internal::Energy_summary summary = descent.measure(positions, scaled(radius), 0.);
    m_report.initial_energy = summary.average();
    const std::size_t largest_focus = mesh.number_of_vertices() / least_focus_sweeps;
    std::size_t next_focus = 0; // the first sweep that may have one
    bool is_final = false;      // whether the sharpness was final in the last sweep already
    bool has_phases = true;     // whether the radius policy may have further ones
    m_report.stop_reason = ITERATION_LIMIT;
    for(std::size_t i = 0; i < most_iterations; ++i)
    {
      const double last_radius = radius;
      const internal::Energy_summary last_summary = summary;
      // Half the way, but for the first time: over-relaxed vertices answer a full step with more than their share, and
      // the two never settle.
      const double aim = next_radius(m_energy, descent.faces(), radius);
      if(is_positive_and_finite(aim))
        radius = i == 0 || !m_is_accelerated ? aim : radius * std::sqrt(aim / radius);
      const double sharpness = next_sharpness(i, summary.average(), summary.largest());
      const auto sweep = [&] { descent.sweep(positions, scaled(radius), sharpness); };
      std::size_t focus = 0;
      // One thread looks for the worst faces, while the others have begun with the sweep.
      if(sharpness > 0. && m_is_accelerated && i >= next_focus)
      {
        descent.reserve_focus(largest_focus);
        internal::run_both<ConcurrencyTag>(
            sweep, [&] { focus = descent.focus_on_faces_above(focus_energy * summary.largest(), largest_focus); });
      }
      else
        sweep();
      if(focus > largest_focus)
        next_focus = i + 1 + sweeps_without_focus;
      else if(focus > 0)
      {
        const std::size_t n_sweeps = (std::min)(mesh.number_of_vertices() / focus, most_focus_sweeps);
        for(std::size_t k = 0; k < n_sweeps; ++k)
          descent.sweep_focus(positions, scaled(radius), sharpness);
      }

      summary = descent.measure(positions, scaled(radius), sharpness);
      const double energy = summary.mean();
      ++(sharpness > 0. ? m_report.number_of_sharp_iterations : m_report.number_of_average_iterations);
      m_report.sharpness = sharpness;
      control.visitor().after_iteration(i + 1, energy, radius);
      if(!control.go_further(i + 1, energy))
        break;
      if(is_final && has_converged(summary, last_summary, radius, last_radius, sharpness))
      {
        has_phases = internal::next_phase(next_radius);
        if(!has_phases)
        {
          m_report.stop_reason = CONVERGED;
          break;
        }
      }
      is_final = next_sharpness.is_final();
    }
    if(control.stop_reason() != NOT_RUN)
      m_report.stop_reason = control.stop_reason();
    while(has_phases) // a run that was ended early gets the last radius as well
      has_phases = internal::next_phase(next_radius);
    const double last_radius = next_radius(m_energy, descent.faces(), radius);
    if(is_positive_and_finite(last_radius))
      radius = last_radius;
    summary = descent.measure(positions, scaled(radius), 0.);
    m_report.average_energy = summary.average();
    m_report.largest_energy = summary.largest();
    m_report.seconds_for_optimization = control.lap();
  }

  Initial_parameterizer m_initial_parameterizer;
  Energy m_energy;
  Sharpness m_sharpness;
  Radius m_radius;
  Vertex_update m_vertex_update;
  double m_energy_tolerance = 4e-5, m_radius_tolerance = 1e-3;
  unsigned int m_number_of_iterations = 90;
  bool m_is_accelerated = true;
  Parameterization_report m_report;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BIJECTIVE_LOW_DISTORTION_PARAMETERIZER_3_H
