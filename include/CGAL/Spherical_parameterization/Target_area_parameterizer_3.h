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
/// The class `Area_report` describes how well `Target_area_parameterizer_3` has met the prescribed areas. The
/// <i>ratio</i> of a vertex is the area of its cell on the sphere, which is a third of the area of the spherical
/// triangles around the vertex, divided by the prescribed area. It is 1 if the prescribed area is met.
struct Area_report
{
  std::vector<double> ratios;    ///< of each vertex, in the order of `vertices(tmesh)`; 1 for a vertex without a face
  double deviation = 0.;         ///< the standard deviation of the ratios divided by their mean
  double largest_deviation = 0.; ///< the largest difference of a ratio from 1
  std::size_t number_of_off_vertices = 0; ///< number of vertices whose ratio differs from 1 by more than 0.01

  /// number of faces whose area times density is below one millionth of the mean; they get one millionth of the mean
  /// instead, because vertices all of whose faces had no area could not be mapped injectively
  std::size_t number_of_raised_faces = 0;
  std::size_t number_of_steps = 0; ///< number of steps of all vertices together, after the descent

  /// returns whether the deviation is at most 0.001.
  bool is_reached() const { return deviation <= 1e-3; }
};

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Target_area_parameterizer_3` computes bijective maps with prescribed areas (density-equalizing maps) and
/// low distortion. Each part of the surface gets the same fraction of the sphere's area as it has of the surface's
/// area, optionally times a density.
///
/// The areas are prescribed for the <i>cells</i> of the vertices: a third of the area of the spherical triangles around
/// a vertex is the same fraction of the sphere's area as a third of the areas of its faces, times their densities, is
/// of the total. Cells, unlike faces, leave freedom for the angles: the areas of all \f$ 2n - 4 \f$ faces would be
/// \f$ 2n - 5 \f$ independent conditions on the \f$ 2n - 3 \f$ degrees of freedom of a map up to rotations; the areas
/// of the cells leave half of these.
///
/// \code
/// SP::Target_area_parameterizer_3<> equal_areas;
/// SP::parameterize(mesh, equal_areas, map);                                       // equal_areas.area_report() has the deviation
/// SP::parameterize(mesh, SP::Target_area_parameterizer_3<>().target_density(density), map);
/// \endcode
///
/// <b>Method.</b> A descent of `Bijective_low_distortion_parameterizer_3` on faces scaled to their prescribed areas
/// computes an initial map. Newton's method then moves all vertices together. It minimizes the sum of the energies of
/// the faces and a penalty \f$ \mu / 2 \f$ times the sum of the squared differences of all ratios from 1, see
/// `Area_report`, where \f$ \mu \f$ grows from 10 to 10<sup>6</sup>, and to 10<sup>9</sup> if necessary.
/// \ref SphericalParameterizationHowItWorksAreas describes the steps.
///
/// <b>Limits.</b> Not all areas can be realized: a face has less than half of the sphere, whatever its density; the
/// neighbors of a vertex of degree three bound its cell; and slivers leave little room for steps. The result is then
/// the closest map that the steps reach, and `area_report()` has the deviation at each vertex.
///
/// <b>Guarantee.</b> If `OK` is returned, the map is bijective, also after a run that was stopped early. The radius
/// gives the sphere the area of the surface. The result is bitwise identical for any number of threads.
///
/// <b>Complexity.</b> A step takes about \f$ n \sqrt{n} \f$ time and \f$ n \log n \f$ memory, more than the other
/// methods.
///
/// \note The class requires \ref thirdpartyEigen "Eigen".
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam Energy must be a model of `DistortionEnergy_3`.
/// \tparam DensityMap must be a model of `ReadablePropertyMap` from the faces or the vertices of the mesh to
///         numbers.<br> <b>%Default:</b> the density is 1 everywhere
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

  /// sets the distortion energy. `OtherEnergy` must be a model of `DistortionEnergy_3`.
  template <class OtherEnergy>
  [[nodiscard]] Target_area_parameterizer_3<OtherEnergy, DensityMap> energy(const OtherEnergy& energy) const
  {
    return {energy, m_density_map, m_sharpness, m_tolerance};
  }

  /// sets the densities: each part of the surface gets a fraction of the sphere's area in proportion to its own area
  /// times its density. The values of `density_map` are finite and at least 0, in any unit. Densities of vertices are
  /// averaged over the faces. `OtherMap` must be a model of `ReadablePropertyMap` whose key type is the face or the
  /// vertex descriptor of the mesh, and whose value type is a number.
  template <class OtherMap>
  [[nodiscard]] Target_area_parameterizer_3<Energy, OtherMap> target_density(const OtherMap& density_map) const
  {
    return {m_energy, density_map, m_sharpness, m_tolerance};
  }

  /// sets the weight of the worst faces in the objective of the initial descent, by default `Sharpness::balanced()`.
  [[nodiscard]] Target_area_parameterizer_3 sharpness(const Sharpness& sharpness) const
  {
    return {m_energy, m_density_map, sharpness, m_tolerance};
  }

  /// sets the deviation, see `Area_report`, at which the steps end.
  ///
  /// \param tolerance at least 0, by default 5e-4; with 0, the steps end when the deviation no longer decreases
  [[nodiscard]] Target_area_parameterizer_3 area_tolerance(double tolerance) const
  {
    return {m_energy, m_density_map, m_sharpness, tolerance};
  }

  /// returns whether all settings are in their ranges; if not, `parameterize()` returns `ERROR_WRONG_PARAMETER`.
  bool is_valid() const { return internal::is_valid_policy(m_energy) && m_sharpness.is_valid() && m_tolerance >= 0.; }

  /// @}

  /// computes a bijective map from `tmesh` to the sphere around the origin that has the area of the surface.
  ///
  /// The parameters are those of `CGAL::Spherical_parameterization::parameterize()`. The limit `number_of_iterations`
  /// and its default are those of `Bijective_low_distortion_parameterizer_3`; they bound the sweeps before the steps,
  /// of which there are at most 200. The visitor receives the steps as further iterations, with the minimized sum as
  /// energy.
  ///
  /// \return `OK`, whether or not all areas are met; a defect of the mesh, see `find_defect()`; `ERROR_INVALID_DENSITY`
  ///         if a density is negative, infinite or NaN, or if all densities are 0; `ERROR_WRONG_PARAMETER` if
  ///         `is_valid()` is `false` or `number_of_iterations` is negative; `ERROR_INSUFFICIENT_PRECISION` if the
  ///         coordinates of `vertex_sphere_map` cannot represent the map
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
      const auto read_shares = [&](const auto& arrays) {
        return find_target_areas(tmesh, arrays, run.surface, shares);
      };
      if(is_valid() && run.read_number_of_iterations() && run.read(read_shares))
        map(shares, run);
      const Error_code error = run.write(vertex_sphere_map);
      if(error == OK)
        report_areas(tmesh, shares, run);
      return error;
    }
    else
      return ERROR_WRONG_PARAMETER;
  }

  /// returns the report of the last run. It counts the sweeps of the descent and the steps as iterations, and the
  /// energies are those of the descent.
  const Parameterization_report& report() const { return m_report; }

  /// returns how well the last run has met the prescribed areas.
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
  Error_code find_target_areas(const TriangleMesh& tmesh, const Arrays& arrays, const internal::Surface& surface,
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
    const internal::Descent_settings settings;
    internal::embed_surface(m_energy, {internal::default_sweeps_per_level, false, m_sharpness, settings}, run,
                            shares.of_vertices);
    internal::descend<internal::Newton_step>(
        m_energy, nullptr, m_sharpness, settings,
        run.number_of_iterations.value_or(internal::default_number_of_sweeps(run.surface.number_of_vertices())), run,
        shares.of_vertices);
    if(internal::are_safely_positive(run.surface.rings(), run.positions))
      m_area_report.number_of_steps =
          internal::minimize_area_deviation(run.surface, shares, m_energy, m_tolerance, run.positions, run.control);
    run.radius = run.surface.equal_area_radius();
    run.control.on_optimization_end();
  }

  template <class TriangleMesh>
  void report_areas(const TriangleMesh& tmesh, const internal::Area_shares& shares, const internal::Run& run)
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
