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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIAL_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIAL_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Default_visitor.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/read_map.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// What the initial parameterizer sees of the caller's visitor and of the time: it may be stopped, and its levels show.
template <class RunControl>
class Initial_map_visitor : public Default_visitor
{
public:
  explicit Initial_map_visitor(RunControl& control)
    : m_control(control)
  {}

  void on_level(std::size_t number_of_vertices) { m_control.visitor().on_level(number_of_vertices); }
  bool go_further(std::size_t /* iteration */, double energy) { return m_control.go_further(0, energy); }

private:
  RunControl& m_control;
};

// Gets the map that a parameterizer makes as positions on the unit sphere. This is the general way, through the public
// interface of any model of `SphericalParameterizer_3`; a parameterizer of the package that works on an Indexed_mesh
// specialises the class and spares the mesh a second reading.
template <class Parameterizer>
struct Initial_map
{
  template <class ConcurrencyTag, class TriangleMesh, class VertexDescriptor, class NamedParameters, class RunControl>
  static Error_code compute(Parameterizer& parameterizer, const TriangleMesh& tmesh, const Indexed_mesh& mesh,
                            const std::vector<VertexDescriptor>& vertices_of_mesh, const NamedParameters& np,
                            std::vector<Vector_3d>& positions, RunControl& control)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;

    const auto map = get(CGAL::dynamic_vertex_property_t<Point_3>(), tmesh);
    const auto vpm =
        choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh));
    Initial_map_visitor<RunControl> visitor(control);
    const Error_code error = parameterizer.template parameterize<ConcurrencyTag>(
        tmesh, map, parameters::vertex_point_map(vpm).visitor(std::ref(visitor)));
    if(error == ERROR_NO_1_TO_1_MAPPING)
      return ERROR_INVALID_INITIAL_PARAMETERIZATION; // the caller's own map is untouched
    if(error != OK)
      return error;
    // The sweeps compute with rounding, so a face that is positive by less than that would not be safe with them.
    const bool is_safe = read_map<ConcurrencyTag>(mesh, vertices_of_mesh, map, positions) &&
                         are_safely_positive(mesh.rings(), positions);
    control.report().seconds_for_embedding = control.lap();
    return is_safe ? OK : ERROR_INVALID_INITIAL_PARAMETERIZATION;
  }
};

// Makes the map that a method starts from, and tells the visitor of it.
template <class ConcurrencyTag, class Parameterizer, class TriangleMesh, class VertexDescriptor, class NamedParameters,
          class RunControl>
Error_code make_initial_map(Parameterizer& parameterizer, const TriangleMesh& tmesh, const Indexed_mesh& mesh,
                            const std::vector<VertexDescriptor>& vertices_of_mesh, const NamedParameters& np,
                            std::vector<Vector_3d>& positions, RunControl& control)
{
  control.visitor().on_initialization_begin(mesh.number_of_vertices());
  const Error_code error = Initial_map<Parameterizer>::template compute<ConcurrencyTag>(
      parameterizer, tmesh, mesh, vertices_of_mesh, np, positions, control);
  if(error == OK)
    control.visitor().on_initialization_end();
  return error;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIAL_MAP_H
