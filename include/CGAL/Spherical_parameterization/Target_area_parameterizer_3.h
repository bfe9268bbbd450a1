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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TARGET_AREA_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TARGET_AREA_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/areas/Area_descent.h>
#include <CGAL/Spherical_parameterization/internal/areas/Area_shares.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/run/run_descent.h>
#include <CGAL/Spherical_parameterization/internal/run/run_parameterization.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// How near `Target_area_parameterizer_3` has come to the areas that were wanted. The <i>ratio</i> of a vertex is the area of its
/// cell on the sphere, a third of that of the spherical triangles around it, over the area that was wanted; 1 is what was
/// wanted.
struct Area_report
{
  std::vector<double> ratios;    ///< of each vertex, in the order of `vertices(tmesh)`; 1 for one without a face
  double deviation = 0.;         ///< the standard deviation of the ratios over their mean
  double largest_deviation = 0.; ///< the largest difference of a ratio from 1
  std::size_t number_of_off_vertices = 0; ///< vertices whose ratio differs from 1 by more than 0.01

  /// faces whose area times density is below a millionth of the mean, which was wanted for them instead: the sphere has no place for
  /// vertices all of whose faces have nothing
  std::size_t number_of_raised_faces = 0;
  std::size_t number_of_steps = 0; ///< the steps of all vertices together, after the descent

  /// returns whether the deviation is at most 0.001.
  bool is_reached() const { return deviation <= 1e-3; }
};

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Target_area_parameterizer_3` makes maps that give each part of the surface a share of the sphere: its share of the
/// area of the surface, or of that times a density, and as little distortion besides as can be had then.
///
/// What is met is the area of the <i>cell</i> of each vertex: a third of the areas of the spherical triangles around it. It has to
/// be the same share of the sphere as a third of the areas of its faces, times their densities, is of the surface. The areas of
/// all \f$ 2n - 4 \f$ faces would be \f$ 2n - 5 \f$ independent conditions on the \f$ 2n - 3 \f$ unknowns that turning the sphere leaves
/// of a map; those of the cells leave half of these for the angles.
///
/// \code
/// SP::Target_area_parameterizer_3<> equal_areas;
/// SP::parameterize(mesh, equal_areas, map);                                       // equal_areas.area_report() tells how near
/// SP::parameterize(mesh, SP::Target_area_parameterizer_3<>().target_density(density), map);
/// \endcode
///
/// The method is that of `Bijective_low_distortion_parameterizer_3` for the faces scaled to the areas that they are to have, in the
/// hierarchy and on the mesh. Then all vertices are moved together, by steps of Newton's method for the sum of the energies of the
/// faces and \f$ \mu / 2 \f$ times that of the squared differences of all ratios of areas from 1, see `Area_report`, while
/// \f$ \mu \f$ grows from 10 to 10<sup>6</sup>, and to 10<sup>9</sup> if that is not enough. The Hessian of the energy is made positive definite face by face, and the equations
/// are solved with multipliers for the areas by a sparse factorisation. Steps that would turn a face over, or do not lower the
/// sum, are halved, and damped.
///
/// Not all areas can be had: a face has less than half of the sphere, whatever density it has, the neighbours of a vertex of degree
/// three bound its cell, and where slivers meet, the room for steps is little. The map is then as near as the steps came, and
/// `area_report()` tells this for each vertex.
///
/// A one-to-one mapping is guaranteed whenever `OK` is returned, also for a run that was stopped early. The radius is that of the
/// sphere with the area of the surface. The result is the same to the last bit for any number of threads. A step takes a time of
/// some \f$ n \sqrt{n} \f$ and memory of some \f$ n \log n \f$, which is more than what other methods take: see the manual.
///
/// \note The class takes \ref thirdpartyEigen "Eigen".
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam Energy must be a model of `DistortionEnergy_3`.
/// \tparam DensityMap must be a model of `ReadablePropertyMap` from the faces or the vertices of the mesh to numbers.<br>
///         <b>%Default:</b> the density is 1 everywhere
///
/// \sa `Bijective_low_distortion_parameterizer_3`
template <class Energy = Symmetric_Dirichlet_energy_3, class DensityMap = Default>
class Target_area_parameterizer_3
{
public:
  /// \name Settings
  /// Each function returns a parameterizer with one setting changed, so that they can be chained.
  /// @{

  /// constructs the parameterizer with the default settings.
  Target_area_parameterizer_3() = default;

  /// sets the energy that is lowered besides. `OtherEnergy` must be a model of `DistortionEnergy_3`.
  template <class OtherEnergy>
  [[nodiscard]] Target_area_parameterizer_3<OtherEnergy, DensityMap> energy(const OtherEnergy& energy) const
  {
    return {energy, m_density_map, m_sharpness, m_tolerance};
  }

  /// sets how much of the sphere each part of the surface gets in relation to its area: the values of `density_map`, which are
  /// finite and at least 0, in any unit. Those of vertices are averaged to faces. `OtherMap` must be a model of
  /// `ReadablePropertyMap` whose key type is the face or the vertex descriptor of the mesh, and whose value type is a number.
  template <class OtherMap>
  [[nodiscard]] Target_area_parameterizer_3<Energy, OtherMap> target_density(const OtherMap& density_map) const
  {
    return {m_energy, density_map, m_sharpness, m_tolerance};
  }

  /// sets how much the worst faces count in the descent that the steps start from, by default `Sharpness::balanced()`.
  [[nodiscard]] Target_area_parameterizer_3 sharpness(const Sharpness& sharpness) const
  {
    return {m_energy, m_density_map, sharpness, m_tolerance};
  }

  /// sets the deviation, see `Area_report`, at which the steps end.
  ///
  /// \param tolerance at least 0, by default 5e-4; with 0, as near as can be
  [[nodiscard]] Target_area_parameterizer_3 area_tolerance(double tolerance) const
  {
    return {m_energy, m_density_map, m_sharpness, tolerance};
  }

  /// returns whether all settings are in their ranges; if not, `parameterize()` returns `ERROR_WRONG_PARAMETER`.
  bool is_valid() const { return internal::is_valid_policy(m_energy) && m_sharpness.is_valid() && m_tolerance >= 0.; }

  /// @}

  /// computes a one-to-one map from `tmesh` to the sphere around the origin that has the area of the surface.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. The limit `number_of_iterations` and its default
  /// are those of `Bijective_low_distortion_parameterizer_3`, and bound the sweeps before the steps, of which there are 200 at
  /// most. Steps are told to the visitor as further iterations, with the sum that they lower as energy.
  ///
  /// \return `OK`, whether or not all areas could be had; or what is wrong with the mesh, see `find_defect()`;
  ///         `ERROR_INVALID_DENSITY` if a density is negative, infinite or NaN, or all are 0; `ERROR_WRONG_PARAMETER` if
  ///         `is_valid()` is `false` or a negative `number_of_iterations` is given; `ERROR_INSUFFICIENT_PRECISION` if the map
  ///         cannot be held by the coordinates of `vertex_sphere_map`
  template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                          const CGAL_NP_CLASS& np = parameters::default_values())
  {
    if constexpr(internal::check_energy<Energy>() && check_density<TriangleMesh>() &&
                 internal::check_run<TriangleMesh, VertexSphereMap, CGAL_NP_CLASS>())
    {
      m_area_report = Area_report();
      internal::Parameterization_run<ConcurrencyTag, TriangleMesh, CGAL_NP_CLASS> run(tmesh, np, m_report);
      internal::Area_shares shares;
      const auto read_shares = [&](const auto& arrays) { return find_shares(tmesh, arrays, run.surface, shares); };
      if(is_valid() && run.read_number_of_iterations() && run.read(read_shares))
        map(shares, run);
      const Error_code error = run.write(vertex_sphere_map);
      if(error == OK)
        tell_of_areas(tmesh, shares, run);
      return error;
    }
    else
      return ERROR_WRONG_PARAMETER;
  }

  /// returns what the last run did. The sweeps of the descent and the steps are iterations, and the energies are those of the
  /// descent.
  const Parameterization_report& report() const { return m_report; }

  /// returns how near the last run has come to the areas that were wanted.
  const Area_report& area_report() const { return m_area_report; }

private:
  template <class OtherEnergy, class OtherMap>
  friend class Target_area_parameterizer_3;

  Target_area_parameterizer_3(const Energy& energy, const DensityMap& density_map, const Sharpness& sharpness,
                              double tolerance)
    : m_energy(energy)
    , m_density_map(density_map)
    , m_sharpness(sharpness)
    , m_tolerance(tolerance)
  {}

  template <class TriangleMesh>
  static constexpr bool check_density()
  {
    if constexpr(std::is_same<DensityMap, Default>::value)
      return true;
    else
    {
      constexpr bool is_map = internal::is_property_map<DensityMap>;
      static_assert(is_map, "The setting target_density has to be a property map: of the pair that add_property_map() "
                            "returns, it is .first; of an std::map, boost::make_assoc_property_map() makes one.");
      if constexpr(is_map)
      {
        constexpr bool has_numbers =
            std::is_convertible<typename boost::property_traits<DensityMap>::value_type, double>::value;
        constexpr bool is_of_mesh =
            internal::is_for_vertices<DensityMap, TriangleMesh> || internal::is_for_faces<DensityMap, TriangleMesh>;
        static_assert(has_numbers, "The property map for the densities has to hold numbers.");
        static_assert(is_of_mesh,
                      "The property map for the densities has to be one for the faces or the vertices of the mesh.");
        return has_numbers && is_of_mesh;
      }
      return false;
    }
  }

  template <class TriangleMesh, class Arrays>
  Error_code find_shares(const TriangleMesh& tmesh, const Arrays& arrays, const internal::Surface& surface,
                         internal::Area_shares& shares) const
  {
    std::vector<double> densities; // of the triangles
    if constexpr(!std::is_same<DensityMap, Default>::value)
    {
      const auto to_double = [](const auto& x) { return static_cast<double>(x); };
      const auto are_valid = [](const std::vector<double>& values) {
        return std::all_of(values.begin(), values.end(), [](double x) { return x >= 0. && internal::is_finite(x); }) &&
               std::any_of(values.begin(), values.end(), [](double x) { return x > 0.; });
      };
      if constexpr(internal::is_for_faces<DensityMap, TriangleMesh>)
      {
        densities.reserve(arrays.triangles.size());
        for(const auto f : faces(tmesh))
          densities.push_back(to_double(get(m_density_map, f)));
        if(!are_valid(densities))
          return ERROR_INVALID_DENSITY;
      }
      else
      {
        const std::vector<double> values = internal::read_values(arrays.vertices_of_mesh, m_density_map, to_double);
        if(!are_valid(values))
          return ERROR_INVALID_DENSITY;
        densities.reserve(arrays.triangles.size());
        for(const auto& t : arrays.triangles)
          densities.push_back(values[t[0]] / 3. + values[t[1]] / 3. + values[t[2]] / 3.);
      }
    }
    shares = internal::find_area_shares(surface, arrays.triangles, densities);
    return OK;
  }

  void map(const internal::Area_shares& shares, internal::Run& run)
  {
    internal::embed_surface(m_energy, internal::default_sweeps_per_level, false, run, shares.of_vertices);
    const internal::Descent_settings settings;
    internal::descend<internal::Newton_step>(
        m_energy, nullptr, m_sharpness, settings,
        run.number_of_iterations.value_or(internal::default_number_of_sweeps(run.surface.number_of_vertices())), run,
        shares.of_vertices);
    if(internal::are_safely_positive(run.surface.rings(), run.positions))
      m_area_report.number_of_steps =
          internal::lower_area_differences(run.surface, shares, m_energy, m_tolerance, run.positions, run.control);
    run.radius = run.surface.equal_area_radius();
    run.control.on_optimization_end();
  }

  template <class TriangleMesh>
  void tell_of_areas(const TriangleMesh& tmesh, const internal::Area_shares& shares, const internal::Run& run)
  {
    std::vector<double> ratios;
    internal::find_area_ratios(run.surface.rings(), run.positions, shares.of_vertices, ratios);
    Area_report& report = m_area_report;
    report.deviation = internal::relative_deviation(ratios);
    for(const double ratio : ratios)
    {
      report.largest_deviation = (std::max)(report.largest_deviation, std::abs(ratio - 1.));
      report.number_of_off_vertices += std::abs(ratio - 1.) > 0.01 ? 1u : 0u;
    }
    report.number_of_raised_faces = shares.number_of_raised_faces;
    auto ratio = run.surface.in_callers_order(ratios);
    auto next = ratio.begin();
    report.ratios.reserve(num_vertices(tmesh));
    for(const auto v : vertices(tmesh))
      report.ratios.push_back(halfedge(v, tmesh) == boost::graph_traits<TriangleMesh>::null_halfedge() ? 1. : *next++);
  }

  Energy m_energy;
  DensityMap m_density_map;
  Sharpness m_sharpness;
  double m_tolerance = 5e-4;
  Parameterization_report m_report;
  Area_report m_area_report;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TARGET_AREA_PARAMETERIZER_3_H
