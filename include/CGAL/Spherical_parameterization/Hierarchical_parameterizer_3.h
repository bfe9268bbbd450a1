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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Newton_update_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Relative_sharpness_3.h>
#include <CGAL/Spherical_parameterization/internal/Initial_map.h>
#include <CGAL/Spherical_parameterization/internal/embed_hierarchically.h>
#include <CGAL/Spherical_parameterization/internal/is_valid_policy.h>
#include <CGAL/Spherical_parameterization/internal/run_parameterization.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>
#include <vector>

/// \file Hierarchical_parameterizer_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Hierarchical_parameterizer_3` maps a surface to the unit sphere through a hierarchy of ever coarser
/// meshes: independent sets of vertices are removed by half-edge collapses until a tetrahedron is left, the tetrahedron
/// is mapped to a regular one, and the sets are inserted again, each vertex into the kernel of the hole that it left.
/// After each set all vertices are moved by some sweeps of block coordinate descent on the energy, as on the finest
/// mesh by `Bijective_low_distortion_parameterizer_3`, of which this class is the default initial parameterizer. By
/// default it lowers the average of angle plus area distortion on every level, as the progressive method that the BLD
/// paper compares with does.
///
/// A one-to-one mapping is guaranteed whenever `OK` is returned, because the map is certified as it has been written. A
/// kernel is never empty, but it may be too small for double precision numbers; in this case the map is computed anew
/// with a guard against small faces, and `ERROR_INSUFFICIENT_PRECISION` is returned only if that fails several times.
///
/// The time is linear in the number of vertices but for the sorting of the candidates for a removal, and so is the
/// memory.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceListGraph`.
/// \tparam Energy_ must be a model of `DistortionEnergy_3`.<br> <b>%Default:</b>
/// \code
///   Isometric_energy_3
/// \endcode
/// \tparam Sharpness_ must be a model of `SharpnessPolicy_3`.<br> <b>%Default:</b>
/// \code
///   Relative_sharpness_3
/// \endcode
/// \tparam VertexUpdate_ must be a model of `VertexUpdate_3`.<br> <b>%Default:</b>
/// \code
///   Newton_update_3
/// \endcode
///
/// \sa `Bijective_low_distortion_parameterizer_3`
template <class TriangleMesh_, class Energy_ = Default, class Sharpness_ = Default, class VertexUpdate_ = Default>
class Hierarchical_parameterizer_3
{
public:
#ifndef DOXYGEN_RUNNING
  using Energy = typename Default::Get<Energy_, Isometric_energy_3>::type;
  using Sharpness = typename Default::Get<Sharpness_, Relative_sharpness_3>::type;
  using Vertex_update = typename Default::Get<VertexUpdate_, Newton_update_3>::type;
#else
  /// Energy type
  using Energy = Energy_;
  /// Sharpness type
  using Sharpness = Sharpness_;
  /// Vertex update type
  using Vertex_update = VertexUpdate_;
#endif
  /// Triangle mesh type
  using Triangle_mesh = TriangleMesh_;
  /// Triangle mesh type
  using TriangleMesh = TriangleMesh_;

  /// constructs the parameterizer.
  ///
  /// \param energy the energy that the sweeps lower
  /// \param sharpness the sharpness policy, by default `Relative_sharpness_3(0.)`, which is eq. 6, or what a policy of
  ///        another type is by default. Which of its functions is asked on which level is told by `SharpnessPolicy_3`.
  /// \param vertex_update how a vertex is moved
  /// \param sweeps_per_level sweeps over each level, at least 1; levels below 500 vertices are swept until they have
  ///        settled, up to ten times as often; those below 2000 get up to twice as many, and those above 500 a quarter
  ///        if they have less than one and a half times as many vertices as the last level that got more
  explicit Hierarchical_parameterizer_3(const Energy& energy = Energy(),
                                        const Sharpness& sharpness = default_sharpness(),
                                        const Vertex_update& vertex_update = Vertex_update(),
                                        std::size_t sweeps_per_level = 20)
    : m_energy(energy)
    , m_sharpness(sharpness)
    , m_vertex_update(vertex_update)
    , m_sweeps_per_level(sweeps_per_level)
  {}

  /// computes a one-to-one map from `tmesh` to the unit sphere around the origin.
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
  ///   \cgalParamNBegin{maximum_running_time}
  ///     \cgalParamDescription{the time in seconds after which the remaining levels get one sweep each, the least
  ///                           effort, before the map is certified and returned}
  ///     \cgalParamType{double}
  ///     \cgalParamDefault{no limit, as with any value that is not positive}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{visitor}
  ///     \cgalParamDescription{a visitor that is told of the levels and may stop the sweeps over them, with the
  ///                           same effect}
  ///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
  ///     \cgalParamDefault{`Default_visitor`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \return `OK`, or what is wrong with the mesh, see `find_defect()`; `ERROR_WRONG_PARAMETER` if `is_valid()` is
  ///         `false`; `ERROR_INSUFFICIENT_PRECISION`
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
    return internal::run_parameterization<ConcurrencyTag>(
        tmesh, vertex_sphere_map, np, m_report, internal::Guarantee::ONE_TO_ONE,
        [&](const internal::Indexed_mesh& mesh, const auto&, std::vector<internal::Vector_3d>& positions, double&,
            auto& control) {
          control.visitor().on_initialization_begin(mesh.number_of_vertices());
          if(!embed<ConcurrencyTag>(mesh, positions, true, control))
            return ERROR_INSUFFICIENT_PRECISION;
          control.visitor().on_initialization_end();
          if(control.stop_reason() != NOT_RUN)
            m_report.stop_reason = control.stop_reason();
          return OK;
        });
  }

  /// returns what the last run did. The reason for its end is `CONVERGED` if the mesh has fewer than 500 vertices and
  /// has settled, `ITERATION_LIMIT` if all sweeps have been made.
  const Parameterization_report& report() const
  {
    return m_report;
  }

  /// returns whether all policies and parameters are in their ranges.
  bool is_valid() const
  {
    return internal::is_valid_policy(m_energy) && internal::is_valid_policy(m_sharpness) &&
           internal::is_valid_policy(m_vertex_update) && m_sweeps_per_level > 0;
  }

private:
  friend struct internal::Initial_map<Hierarchical_parameterizer_3>;

  static Sharpness default_sharpness()
  {
    if constexpr(std::is_same<Sharpness, Relative_sharpness_3>::value)
      return Sharpness(0.);
    else
      return Sharpness();
  }

  template <class ConcurrencyTag, class RunControl>
  bool embed(const internal::Indexed_mesh& mesh, std::vector<internal::Vector_3d>& positions, bool sweeps_finest_level,
             RunControl& control) const
  {
    return internal::embed_hierarchically<ConcurrencyTag>(mesh, m_energy, m_sharpness, m_vertex_update,
                                                          m_sweeps_per_level, sweeps_finest_level, positions, control);
  }

  Energy m_energy;
  Sharpness m_sharpness;
  Vertex_update m_vertex_update;
  std::size_t m_sweeps_per_level;
  Parameterization_report m_report;
};

namespace internal {

template <class TriangleMesh, class Energy, class Sharpness, class VertexUpdate>
struct Initial_map<Hierarchical_parameterizer_3<TriangleMesh, Energy, Sharpness, VertexUpdate>>
{
  using Parameterizer = Hierarchical_parameterizer_3<TriangleMesh, Energy, Sharpness, VertexUpdate>;

  template <class ConcurrencyTag, class VertexDescriptor, class NamedParameters, class RunControl>
  static Error_code compute(Parameterizer& parameterizer, const TriangleMesh& /* tmesh */, const Indexed_mesh& mesh,
                            const std::vector<VertexDescriptor>& /* vertices_of_mesh */,
                            const NamedParameters& /* np */, std::vector<Vector_3d>& positions, RunControl& control)
  {
    if(!parameterizer.is_valid())
      return ERROR_WRONG_PARAMETER;
    return parameterizer.template embed<ConcurrencyTag>(mesh, positions, false, control) ? OK
                                                                                         : ERROR_INSUFFICIENT_PRECISION;
  }
};

} // namespace internal

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
