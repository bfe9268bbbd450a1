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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_SOUP_DEFECT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_SOUP_DEFECT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/find_defect.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Why vertices and faces cannot be mapped, and where the defect is.
struct Soup_defect
{
  Error_code error;
  std::string message; // the defect, its location, and a remedy
  std::optional<std::size_t> vertex, other_vertex, face;
};

// Calls `visit(from, to)` for each edge of a face, in its direction.
template <class Polygon, class Visit>
void for_each_side(const Polygon& polygon, const Visit& visit)
{
  for(std::size_t k = 0; k < polygon.size(); ++k)
    visit(std::size_t(polygon[k]), std::size_t(polygon[k + 1 < polygon.size() ? k + 1 : 0]));
}

inline std::string with_advice(const std::string& what, const std::string& advice)
{
  return what + ".\n" + advice + "\n(Vertices and faces are counted from 0.)";
}

// Describes the defect of the edge between v and w, v < w, that two faces use in the same direction.
template <class Polygon>
Soup_defect explain_edge(const std::vector<Polygon>& polygons, std::size_t v, std::size_t w)
{
  std::vector<std::size_t> faces;                      // of the edge
  std::vector<std::pair<Polygon, std::size_t>> sorted; // the same, after their sorted corners
  for(std::size_t f = 0; f < polygons.size(); ++f)
    for_each_side(polygons[f], [&](std::size_t from, std::size_t to) {
      if((std::min)(from, to) != v || (std::max)(from, to) != w)
        return;
      faces.push_back(f);
      sorted.emplace_back(polygons[f], f);
      std::sort(sorted.back().first.begin(), sorted.back().first.end());
    });
  std::sort(sorted.begin(), sorted.end());
  const auto duplicate =
      std::adjacent_find(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  const auto defect = [&](std::size_t face, const std::string& what, const std::string& advice) {
    return Soup_defect{ERROR_NO_SIMPLICIAL_COMPLEX, with_advice(what, advice), v, w, face};
  };
  if(duplicate != sorted.end())
    return defect(duplicate[1].second,
                  "the faces " + std::to_string(duplicate[0].second) + " and " + std::to_string(duplicate[1].second) +
                      " have the same corners",
                  "repair_surface() removes one of them.");
  const auto number = [&](std::size_t i) { return std::to_string(faces[i]); };
  const std::string edge = "the edge between the vertices " + std::to_string(v) + " and " + std::to_string(w);
  if(faces.size() > 2)
    return defect(faces[2],
                  edge + " has " + std::to_string(faces.size()) + " faces, among them the faces " + number(0) + ", " +
                      number(1) + " and " + number(2),
                  "An edge of a closed surface has two: repair_surface() makes several edges of it.");
  return defect(faces[1],
                "the faces " + number(0) + " and " + number(1) + " are oriented against each other: both use " + edge +
                    " in the same direction",
                "repair_surface() orients them alike.");
}

// Faces that do not share their vertices are the most frequent reason for a border.
template <class Mesh>
std::string explain_border(const Mesh& mesh)
{
  std::vector<typename Mesh::Point> points;
  for(const auto v : mesh.vertices())
  {
    const auto& p = mesh.point(v);
    if(!mesh.is_isolated(v) && std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())) // NaN has no order
      points.push_back(p);
  }
  std::sort(points.begin(), points.end());
  const auto n_repeated = points.end() - std::unique(points.begin(), points.end());
  return n_repeated == 0 ? ""
                         : "\n" + std::to_string(n_repeated) +
                               " vertices repeat the position of another one: perhaps the faces do not share them.";
}

// Returns why no halfedge data structure can represent the faces, if so. Their corners are below `n_vertices`.
template <class Polygon>
std::optional<Soup_defect> find_defect_of_soup(std::size_t n_vertices, const std::vector<Polygon>& polygons)
{
  constexpr std::size_t limit = (std::numeric_limits<std::int32_t>::max)(); // Surface_mesh has 32-bit indices
  if(n_vertices >= limit || polygons.size() >= limit / 3)
    return Soup_defect{ERROR_TOO_LARGE_MESH, get_error_message(ERROR_TOO_LARGE_MESH), {}, {}, {}};
  const auto defect_of = [](std::size_t f, Error_code error, const std::string& what) {
    return Soup_defect{
        error, with_advice("face " + std::to_string(f) + what, "repair_surface() removes the face."), {}, {}, f};
  };
  for(std::size_t f = 0; f < polygons.size(); ++f)
  {
    Polygon corners = polygons[f];
    if(corners.size() < 3)
      return defect_of(f, ERROR_NON_TRIANGULAR_MESH,
                       " is not a triangle but has " + std::to_string(corners.size()) + " corners");
    std::sort(corners.begin(), corners.end());
    const auto repeated = std::adjacent_find(corners.begin(), corners.end());
    if(repeated == corners.end())
      continue;
    Soup_defect defect =
        defect_of(f, ERROR_NO_SIMPLICIAL_COMPLEX, " has the vertex " + std::to_string(*repeated) + " twice");
    defect.vertex = *repeated;
    return defect;
  }

  // No two faces may use an edge in the same direction, as is the case for any edge with three faces.
  std::vector<std::uint64_t> edges; // one vertex in the upper half, the other one in the lower
  edges.reserve(3 * polygons.size());
  for(const Polygon& polygon : polygons)
    for_each_side(polygon, [&](std::size_t from, std::size_t to) { edges.push_back(std::uint64_t(from) << 32 | to); });
  boost::sort::spreadsort::integer_sort(edges.begin(), edges.end());
  const auto repeated = std::adjacent_find(edges.begin(), edges.end());
  if(repeated == edges.end())
    return std::nullopt;
  const auto [v, w] =
      std::minmax({static_cast<std::size_t>(*repeated >> 32), static_cast<std::size_t>(*repeated & 0xffffffff)});
  return explain_edge(polygons, v, w);
}

// Returns the defect that `find_defect()` finds in a `Surface_mesh`, if any.
template <class Mesh>
std::optional<Soup_defect> find_defect_of_mesh(const Mesh& mesh)
{
  const Mesh_defect<Mesh> found = find_defect(mesh);
  if(found.error == OK)
    return std::nullopt;
  const auto number = [](auto index) {
    return index == decltype(index)() ? std::optional<std::size_t>() : std::optional<std::size_t>(index);
  };
  return Soup_defect{found.error, found.message + (found.error == ERROR_NON_CLOSED_MESH ? explain_border(mesh) : ""),
                     number(found.vertex), number(found.other_vertex), number(found.face)};
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_SOUP_DEFECT_H
