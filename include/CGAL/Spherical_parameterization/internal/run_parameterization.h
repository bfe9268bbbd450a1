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
#include <CGAL/Spherical_parameterization/internal/Guarantee.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/for_each_block.h>
#include <CGAL/Spherical_parameterization/internal/read_mesh.h>
#include <CGAL/Spherical_parameterization/internal/write_map.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// What every parameterizer does around its own work: reads the named parameters, checks and copies the mesh, certifies
// and writes the map, by what the method guarantees. The report is to be a new one. The work itself is
//   Error_code compute(mesh, vertices_of_mesh, positions, radius, control)
// which sets the positions on the unit sphere and the radius in the caller's unit of length.
template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap, class NamedParameters, class Compute>
Error_code run_parameterization(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map, const NamedParameters& np,
                                Parameterization_report& report, Guarantee guarantee, const Compute& compute)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  using Visitor =
      typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters, Default_visitor>::reference;

  Default_visitor default_visitor;
  Visitor visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  const double most_seconds = choose_parameter(get_parameter(np, internal_np::maximum_running_time), 0.);
  Run_control<std::remove_reference_t<Visitor>> control(visitor, most_seconds, report);

  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh));
  // Threads that are not there as yet are made while the mesh is read.
  for_each_block<ConcurrencyTag>(0, 2, 1, [](std::size_t, std::size_t) {});

  Indexed_mesh mesh;
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices_of_mesh;
  Error_code error = read_mesh(tmesh, vpm, mesh, vertices_of_mesh, report);
  report.seconds_for_reading = control.lap();
  if(error != OK)
    return error;

  std::vector<Vector_3d> positions;
  double radius = 1.;
  error = compute(mesh, vertices_of_mesh, positions, radius, control);
  if(error == OK)
    error = write_map<ConcurrencyTag>(mesh, vertices_of_mesh, positions, radius, guarantee, vertex_sphere_map);
  report.radius = radius;
  report.seconds_for_certificate = control.lap();
  return error;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_PARAMETERIZATION_H
