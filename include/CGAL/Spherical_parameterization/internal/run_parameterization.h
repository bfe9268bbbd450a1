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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_PARAMETERIZATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_PARAMETERIZATION_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Default_visitor.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/surface/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>
#include <CGAL/Spherical_parameterization/internal/run/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/write_map.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

template <class Visitor, class = void>
struct Is_visitor : std::false_type
{};

template <class Visitor>
struct Is_visitor<Visitor, std::void_t<decltype(std::declval<Visitor&>().on_initialization_begin(std::size_t())),
                                       decltype(std::declval<Visitor&>().on_level(std::size_t())),
                                       decltype(std::declval<Visitor&>().on_initialization_end()),
                                       decltype(std::declval<Visitor&>().after_iteration(std::size_t(), 0., 0.)),
                                       decltype(std::declval<Visitor&>().on_optimization_end())>>
  : std::is_convertible<decltype(std::declval<Visitor&>().go_further(std::size_t(), 0.)), bool>
{};

// for a mesh that is one; without the parameter, the mesh has to have points of its own
template <class TriangleMesh, class NamedParameters>
constexpr bool check_vertex_point_map()
{
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value)
  {
    using Map = std::decay_t<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(),
                                                                internal_np::vertex_point))>;
    if constexpr(Is_property_map<Map>::value)
    {
      using Traits = boost::property_traits<Map>;
      constexpr bool has_points = Is_point_3<typename Traits::value_type>::value;
      constexpr bool has_vertices = std::is_convertible<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
                                                        typename Traits::key_type>::value;
      static_assert(has_points && has_vertices,
                    "The named parameter vertex_point_map has to be a property map for the vertices of the mesh that "
                    "holds points: Point_3 of a CGAL kernel.");
      return has_points && has_vertices;
    }
    else
    {
      static_assert(Is_property_map<Map>::value,
                    "The named parameter vertex_point_map has to be a property map: of the pair that "
                    "add_property_map() returns, it is .first; of an std::map, boost::make_assoc_property_map() makes "
                    "one.");
      return false;
    }
  }
  return true;
}

// for the parameterizers
template <class TriangleMesh, class VertexSphereMap, class NamedParameters>
constexpr bool check_run()
{
  if constexpr(check_mesh<TriangleMesh>())
    if constexpr(check_map<TriangleMesh, VertexSphereMap>())
    {
      using Visitor =
          std::remove_reference_t<typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters,
                                                                               Default_visitor>::reference>;
      using Time = typename internal_np::Lookup_named_param_def<internal_np::maximum_running_time_t, NamedParameters,
                                                                double>::type;
      constexpr bool is_visitor = Is_visitor<Visitor>::value;
      static_assert(
          is_visitor,
          "The named parameter visitor has to be a model of SphericalParameterizationVisitor, such as a class "
          "derived from Default_visitor, or std::ref() of one.");
      constexpr bool is_time = std::is_convertible<Time, double>::value;
      static_assert(is_time, "The named parameter maximum_running_time has to be a number, the seconds.");
      return is_visitor && is_time && check_vertex_point_map<TriangleMesh, NamedParameters>();
    }
  return false;
}

// Sets `number` to the named parameter `number_of_iterations` if it is given; returns false if that is negative.
template <class NamedParameters>
bool read_number_of_iterations(const NamedParameters& np, std::size_t& number)
{
  const auto given =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::number_of_iterations), number);
  static_assert(std::is_integral<std::decay_t<decltype(given)>>::value,
                "The named parameter number_of_iterations has to be an integer.");
  if constexpr(std::is_signed<std::decay_t<decltype(given)>>::value)
    if(given < 0)
      return false;
  number = static_cast<std::size_t>(given);
  return true;
}

// The caller's visitor as the stages of a run see it.
template <class Visitor>
class Visitor_control : public Run_control
{
public:
  Visitor_control(Visitor& visitor, double max_seconds, Parameterization_report& report)
    : Run_control(max_seconds, report)
    , m_visitor(visitor)
  {}

  void on_initialization_begin(std::size_t number_of_vertices) override
  {
    m_visitor.on_initialization_begin(number_of_vertices);
  }
  void on_level(std::size_t number_of_vertices) override { m_visitor.on_level(number_of_vertices); }
  void on_initialization_end() override { m_visitor.on_initialization_end(); }
  void after_iteration(std::size_t iteration, double energy, double radius) override
  {
    m_visitor.after_iteration(iteration, energy, radius);
  }
  void on_optimization_end() override { m_visitor.on_optimization_end(); }

private:
  bool visitor_goes_further(std::size_t iteration, double energy) override
  {
    return m_visitor.go_further(iteration, energy);
  }

  Visitor& m_visitor;
};

// A run from the caller's mesh to the caller's map: what the work of a method is given and what it fills in.
template <class ConcurrencyTag_, class TriangleMesh, class VertexPointMap>
struct Parameterization_run
{
  using Concurrency_tag = ConcurrencyTag_;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  const TriangleMesh& tmesh;
  VertexPointMap vertex_point_map;
  Run_control& control;
  Execution execution = execution_of<Concurrency_tag>();

  Indexed_mesh mesh = {};
  std::vector<vertex_descriptor> vertices_of_mesh = {};

  std::vector<Vector_3d> positions = {}; // on the unit sphere
  double radius = 1.;                    // in the caller's unit of length
};

// What every parameterizer does around its own work: reads the named parameters, checks and copies the mesh, certifies
// and writes the map, by what the method guarantees. The work itself is `Error_code compute(Parameterization_run&)`.
template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap, class NamedParameters, class Compute>
Error_code run_parameterization(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map, const NamedParameters& np,
                                Parameterization_report& report, Guarantee guarantee, const Compute& compute)
{
  if constexpr(!check_run<TriangleMesh, VertexSphereMap, NamedParameters>())
    return ERROR_WRONG_PARAMETER;
  else
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    using parameters::get_parameter_reference;
    using Visitor = typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters,
                                                                 Default_visitor>::reference;

    Default_visitor default_visitor;
    Visitor visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
    const double max_seconds = choose_parameter(get_parameter(np, internal_np::maximum_running_time), 0.);
    Visitor_control<std::remove_reference_t<Visitor>> control(visitor, max_seconds, report);
    const auto vpm =
        choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh));
    Parameterization_run<ConcurrencyTag, TriangleMesh, std::decay_t<decltype(vpm)>> run{tmesh, vpm, control};

    run_both(
        run.execution, [] {}, [] {}); // the thread pool starts meanwhile
    Error_code error = read_mesh(tmesh, vpm, run.mesh, run.vertices_of_mesh, report);
    report.seconds_for_reading = control.lap();
    if(error != OK)
      return error;
    error = compute(run);
    if(control.is_stopped() && report.stop_reason != NON_FINITE_ENERGY)
      report.stop_reason = control.stop_reason();
    if(error == OK)
      error = write_map(run.mesh, run.vertices_of_mesh, run.positions, run.radius, guarantee, vertex_sphere_map,
                        run.execution);
    report.radius = run.radius;
    report.seconds_for_certificate = control.lap();
    return error;
  }
}

// What the initial parameterizer sees of the caller's visitor and of the time: it may be stopped, and its levels show.
class Initial_map_visitor : public Default_visitor
{
public:
  explicit Initial_map_visitor(Run_control& control)
    : m_control(control)
  {}

  void on_level(std::size_t number_of_vertices) { m_control.on_level(number_of_vertices); }
  bool go_further(std::size_t /* iteration */, double energy) { return m_control.go_further(0, energy); }

private:
  Run_control& m_control;
};

// Gets the map that a parameterizer makes as positions on the unit sphere. This is the general way, through the public
// interface of any model of `SphericalParameterizer_3`; a parameterizer of the package that works on an Indexed_mesh
// overloads the function and spares the mesh a second reading.
template <class Parameterizer, class Run>
Error_code compute_initial_map(Parameterizer& parameterizer, Run& run)
{
  using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;

  const auto map = get(CGAL::dynamic_vertex_property_t<Point_3>(), run.tmesh);
  Initial_map_visitor visitor(run.control);
  const auto np = parameters::vertex_point_map(run.vertex_point_map).visitor(std::ref(visitor));
  constexpr bool is_parameterizer = Is_parameterizer<Parameterizer, std::decay_t<decltype(run.tmesh)>,
                                                     std::decay_t<decltype(map)>, std::decay_t<decltype(np)>>::value;
  static_assert(is_parameterizer, "The setting initial_parameterizer has to be a model of SphericalParameterizer_3: "
                                  "Precomputed_parameterizer_3(map) for a map.");
  if constexpr(is_parameterizer)
  {
    const Error_code error = parameterizer.template parameterize<typename Run::Concurrency_tag>(run.tmesh, map, np);
    if(error == ERROR_NO_1_TO_1_MAPPING)
      return ERROR_INVALID_INITIAL_PARAMETERIZATION; // the caller's own map is untouched
    if(error != OK)
      return error;
    // The sweeps compute with rounding, so a face that is positive by less than that would not be safe with them.
    const bool is_safe = read_map(run.mesh, run.vertices_of_mesh, map, run.positions, run.execution) &&
                         are_safely_positive(run.mesh.rings(), run.positions);
    run.control.report().seconds_for_embedding = run.control.lap();
    return is_safe ? OK : ERROR_INVALID_INITIAL_PARAMETERIZATION;
  }
  else
    return ERROR_WRONG_PARAMETER;
}

// Makes the map that a method starts from, and tells the visitor of it.
template <class Parameterizer, class Run>
Error_code make_initial_map(Parameterizer& parameterizer, Run& run)
{
  run.control.on_initialization_begin(run.mesh.number_of_vertices());
  const Error_code error = compute_initial_map(parameterizer, run);
  if(error == OK)
    run.control.on_initialization_end();
  return error;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_PARAMETERIZATION_H
