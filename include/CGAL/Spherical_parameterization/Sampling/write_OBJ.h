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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_WRITE_OBJ_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_WRITE_OBJ_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/io/ios_state.hpp>
#include <boost/unordered_map.hpp>

#include <cstddef>
#include <limits>
#include <locale>
#include <ostream>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::IO {

/// \ingroup PkgSphericalParameterizationSampling
///
/// writes a mesh with texture coordinates in the OBJ format: vertices (`v`) and faces (`f`) in the order of the mesh, and each
/// distinct pair of texture coordinates (`vt`) once. Numbers have 17 digits, so that reading them restores the same values of
/// type `double`.
///
/// <b>Complexity.</b> The expected running time is linear in the size of the mesh.
///
/// \tparam Graph a model of `FaceListGraph`
/// \tparam HalfedgeTextureMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<Graph>::%halfedge_descriptor` as key type and `%Point_2` of a \cgal kernel as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param out the output stream, with default formatting flags; its locale and precision are restored afterwards
/// \param g the mesh
/// \param halfedge_texture_map for a halfedge, the texture coordinates of its target in its face, for example computed by
///        `compute_texture_coordinates()`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `g`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, g)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`, or `ERROR_CANNOT_WRITE_FILE` if the stream fails
template <class Graph, class HalfedgeTextureMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code write_OBJ(std::ostream& out, const Graph& g, HalfedgeTextureMap halfedge_texture_map,
                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                      get_const_property_map(vertex_point, g));
  const boost::io::ios_precision_saver saver(out);
  const boost::io::ios_locale_saver locale_saver(out, std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);

  const auto vertex_number = get(CGAL::dynamic_vertex_property_t<std::size_t>(), g);
  std::size_t n_vertices = 0;
  for(const auto v : vertices(g))
  {
    put(vertex_number, v, ++n_vertices);
    const auto& p = get(point_map, v);
    out << "v " << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' ' << CGAL::to_double(p.z()) << '\n';
  }

  boost::unordered_map<std::pair<double, double>, std::size_t> numbers;
  std::vector<std::size_t> corners; // the indices of their texture coordinates, face by face
  for(const auto f : faces(g))
    for(const auto h : halfedges_around_face(halfedge(f, g), g))
    {
      const auto& p = get(halfedge_texture_map, h);
      const std::pair<double, double> uv(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
      const auto [entry, is_new] = numbers.emplace(uv, numbers.size() + 1);
      if(is_new)
        out << "vt " << uv.first << ' ' << uv.second << '\n';
      corners.push_back(entry->second);
    }

  auto corner = corners.begin();
  for(const auto f : faces(g))
  {
    out << 'f';
    for(const auto h : halfedges_around_face(halfedge(f, g), g))
      out << ' ' << get(vertex_number, target(h, g)) << '/' << *corner++;
    out << '\n';
  }
  return out.flush() ? OK : ERROR_CANNOT_WRITE_FILE;
}

} // namespace CGAL::Spherical_parameterization::IO

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_WRITE_OBJ_H
