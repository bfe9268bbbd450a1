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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_BUILD_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_BUILD_MESH_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/files/Soup_defect.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/add_triangles.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Builds a mesh with n vertices from polygons, if a halfedge data structure can represent them; otherwise returns the
// defect. Triangles of a closed surface are linked to their neighbors and added at once, which is faster.
template <class Polygon, class Mesh>
std::optional<Soup_defect> build_mesh(const std::vector<Polygon>& polygons, std::size_t n, Mesh& mesh)
{
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  constexpr std::size_t max_size = (std::numeric_limits<std::int32_t>::max)();
  if(n < max_size && polygons.size() < max_size / 3 &&
     std::all_of(polygons.begin(), polygons.end(), [](const Polygon& p) { return p.size() == 3; }))
  {
    Index_triangles triangles(polygons.size()); // starting at their last corners, where the halfedge of a face begins
    for(std::size_t f = 0; f < polygons.size(); ++f)
      for(std::size_t k = 0; k < 3; ++k)
        triangles[f][(k + 1) % 3] = static_cast<std::uint32_t>(polygons[f][k]);
    const std::vector<Linked_triangle> linked = link_triangles(triangles, n);
    // A triangle that shares two sides with another one is not part of a simplicial complex.
    if(!linked.empty() && std::none_of(linked.begin(), linked.end(), [](const Linked_triangle& t) {
         return t.neighbors[0] == t.neighbors[1] || t.neighbors[1] == t.neighbors[2] ||
                t.neighbors[2] == t.neighbors[0];
       }))
    {
      add_triangles(linked, n, mesh, [](const auto&, const auto&) {});
      return std::nullopt;
    }
  }
  if(auto defect = find_defect_of_soup(n, polygons))
    return defect;
  std::vector<vertex_descriptor> vertices;
  for(std::size_t v = 0; v < n; ++v)
    vertices.push_back(add_vertex(mesh));
  std::vector<std::vector<vertex_descriptor>> faces(polygons.size());
  for(std::size_t f = 0; f < polygons.size(); ++f)
    for(const auto v : polygons[f])
      faces[f].push_back(vertices[static_cast<std::size_t>(v)]);
  // All at once: adding faces one by one takes time quadratic in the degree of a vertex.
  Euler::add_faces(faces, mesh);
  return std::nullopt;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_BUILD_MESH_H
