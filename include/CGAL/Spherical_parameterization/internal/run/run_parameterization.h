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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_PARAMETERIZATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_PARAMETERIZATION_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Default_visitor.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/run/Visitor_control.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/run/check_run.h>
#include <CGAL/Spherical_parameterization/internal/run/first_map.h>
#include <CGAL/Spherical_parameterization/internal/run/write_map.h>
#include <CGAL/Spherical_parameterization/internal/surface/Run.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A run from the caller's mesh to the caller's map, common to all parameterizers: read(), the computation of the method
// on the members of Run, and write(). Only this class and write_map() know the caller's types. `error` is the result of
// write(): first that of a setting out of its range, then that of read(), then that of the method.
template <class ConcurrencyTag_, class TriangleMesh, class NamedParameters>
class Parameterization_run : public Run
{
public:
  using Concurrency_tag = ConcurrencyTag_;

  Parameterization_run(const TriangleMesh& mesh, const NamedParameters& np, Parameterization_report& report)
    : Run(m_control, execution_of<Concurrency_tag>())
    , tmesh(mesh)
    , m_np(np)
    , m_control(np, report)
  {
    report = Parameterization_report();
  }

  auto vertex_point_map() const { return vertex_point_map_of(tmesh, m_np); }

  // Reads the named parameter number_of_iterations, if it is given. Returns false if it is negative.
  bool read_number_of_iterations()
  {
    if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::number_of_iterations_t>::value)
    {
      const auto given = parameters::get_parameter(m_np, internal_np::number_of_iterations);
      using Number = std::decay_t<decltype(given)>;
      static_assert(std::is_integral<Number>::value, "The named parameter number_of_iterations has to be an integer.");
      number_of_iterations = static_cast<std::size_t>(given);
      if constexpr(std::is_signed<Number>::value)
        return given >= 0;
    }
    return true;
  }

  // Checks and copies the mesh. Returns whether it has no defect.
  bool read()
  {
    return read([](const auto&) { return OK; });
  }

  // The same, and then calls read_more(arrays) with the arrays of a mesh without defects; it returns a further error
  // code.
  template <class Function>
  bool read(const Function& read_more)
  {
    run_both(
        execution, [] {}, [] {}); // starts the thread pool concurrently
    Mesh_arrays<TriangleMesh> arrays;
    error = read_surface(tmesh, vertex_point_map(), arrays, surface);
    Parameterization_report& report = control.report();
    report.number_of_isolated_vertices = arrays.number_of_isolated_vertices;
    report.number_of_vertices = surface.number_of_vertices();
    report.number_of_faces = arrays.triangles.size();
    report.number_of_flat_faces = surface.number_of_flat_faces();
    if(error == OK)
      error = read_more(arrays);
    report.seconds_for_reading = control.lap();
    m_vertices = std::move(arrays.vertices_of_mesh);
    m_is_read = error == OK;
    return m_is_read;
  }

  // Reads a map of the mesh and projects it to the unit sphere. Returns whether it is a bijection there.
  template <class VertexSphereMap>
  bool read_map(const VertexSphereMap& map)
  {
    return take_map(read_points(m_vertices, map), *this);
  }

  // Certifies and writes the map, according to the guarantee of the method, if reading and the method have succeeded.
  template <class VertexSphereMap>
  Error_code write(VertexSphereMap vertex_sphere_map, Guarantee guarantee = Guarantee::ONE_TO_ONE)
  {
    if(!m_is_read)
      return error;
    Parameterization_report& report = control.report();
    if(control.is_stopped() && report.stop_reason != NON_FINITE_ENERGY)
      report.stop_reason = control.stop_reason();
    if(error == OK)
      error = write_map(m_vertices, surface.callers_triangles(), surface.in_callers_order(positions), radius, guarantee,
                        vertex_sphere_map, execution);
    report.radius = radius;
    report.seconds_for_certificate = control.lap();
    return error;
  }

  const TriangleMesh& tmesh;

private:
  const NamedParameters& m_np;
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> m_vertices;
  bool m_is_read = false;

  Visitor_control<NamedParameters> m_control;

public:
  Error_code error = ERROR_WRONG_PARAMETER;
};

// Implements the function parameterize() of a method: calls method(run), which reads the mesh and computes the map, and
// then writes the map according to the guarantee of the method.
template <class ConcurrencyTag, Guarantee guarantee = Guarantee::ONE_TO_ONE, class TriangleMesh, class VertexSphereMap,
          class NamedParameters, class Method>
Error_code run_parameterization(const TriangleMesh& tmesh, const VertexSphereMap& vertex_sphere_map,
                                const NamedParameters& np, Parameterization_report& report, const Method& method)
{
  if constexpr(check_run<TriangleMesh, VertexSphereMap, NamedParameters>())
  {
    Parameterization_run<ConcurrencyTag, TriangleMesh, NamedParameters> run(tmesh, np, report);
    method(run);
    return run.write(vertex_sphere_map, guarantee);
  }
  else
    return ERROR_WRONG_PARAMETER;
}

// The visitor of an initial parameterizer: passes levels and requests to stop on to the control of the whole run.
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

// Detects parameterizers of the package that can map the surface of a run directly, without reading the mesh again.
template <class Parameterizer>
using Embed_result = decltype(std::declval<const Parameterizer&>().embed(std::declval<Run&>(), false));

// Computes the map of a model of `SphericalParameterizer_3` through its public interface, as positions on the unit
// sphere.
template <class Parameterizer, class Parameterization_run>
Error_code compute_initial_map(Parameterizer& parameterizer, Parameterization_run& run)
{
  using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;

  const auto map = get(CGAL::dynamic_vertex_property_t<Point_3>(), run.tmesh);
  Initial_map_visitor visitor(run.control);
  const auto np = parameters::vertex_point_map(run.vertex_point_map()).visitor(std::ref(visitor));
  constexpr bool is_parameterizer = is_detected<Parameterize_result, Parameterizer, std::decay_t<decltype(run.tmesh)>,
                                                std::decay_t<decltype(map)>, std::decay_t<decltype(np)>>;
  static_assert(is_parameterizer, "The setting initial_parameterizer has to be a model of SphericalParameterizer_3: "
                                  "Precomputed_parameterizer_3(map) for a map.");
  if constexpr(is_parameterizer)
  {
    const Error_code error =
        parameterizer.template parameterize<typename Parameterization_run::Concurrency_tag>(run.tmesh, map, np);
    if(error == ERROR_NO_1_TO_1_MAPPING)
      return ERROR_INVALID_INITIAL_PARAMETERIZATION; // the caller's own map is unchanged
    if(error != OK)
      return error;
    // Rounding errors of the sweeps could invert a face whose orientation is positive by less than these errors.
    const bool is_safe = run.read_map(map) && are_safely_positive(run.surface.rings(), run.positions);
    run.control.report().seconds_for_embedding = run.control.lap();
    return is_safe ? OK : ERROR_INVALID_INITIAL_PARAMETERIZATION;
  }
  else
    return ERROR_WRONG_PARAMETER;
}

// Computes the initial map of a method and calls the visitor.
template <class Parameterizer, class Parameterization_run>
Error_code make_initial_map(Parameterizer& parameterizer, Parameterization_run& run)
{
  if constexpr(is_detected<Embed_result, Parameterizer>)
    return parameterizer.embed(run, false);
  else
  {
    run.control.on_initialization_begin(run.surface.number_of_vertices());
    const Error_code error = compute_initial_map(parameterizer, run);
    if(error == OK)
      run.control.on_initialization_end();
    return error;
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_PARAMETERIZATION_H
