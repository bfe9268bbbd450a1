// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_DIAGNOSIS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_DIAGNOSIS_H

#include "Polygon_soup.h"
#include "Program_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace Program {

/// Finds out what keeps a polygon soup from being a triangulated surface without border, which a halfedge data
/// structure can hold; about what is one, the library can say itself what is wrong with it. Vertices and faces are
/// counted from 0, as in the file. The running time is linear but for the sorting of the edges at a vertex.
class Mesh_diagnosis
{
public:
  using Triangle = std::array<std::size_t, 3>;

  /// checks `soup`.
  ///
  /// \throws Program_error with what is wrong, where, and what helps
  explicit Mesh_diagnosis(const Polygon_soup& soup)
    : m_points(soup.points)
  {
    collect_triangles(soup.polygons);
    check_number_of_vertices();
    pair_edges();
    check_vertices();
  }

  /// returns the faces, each from its first corner on.
  const std::vector<Triangle>& triangles() const { return m_triangles; }

  /// returns whether all coordinates are numbers, and none of them infinite.
  static bool is_finite(const Point_3& p)
  {
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  }

private:
  // An edge of a face is the number h = 3 * face + k of its first corner k; it leads from there to the next corner.
  struct Edge
  {
    std::size_t other; // the end with the higher number; the lower one has a list of its own
    std::size_t h;
  };

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  [[noreturn]] static void fail(const std::string& what, const std::string& advice)
  {
    throw Program_error(what + ".\n" + advice + "\n(Vertices and faces are counted from 0.)");
  }

  static std::string name(const char* what, std::size_t i) { return what + (' ' + std::to_string(i)); }

  // returns a hint at how often the same occurs elsewhere
  static std::string number_of_more(std::size_t count, const char* what)
  {
    return count > 1 ? " (" + std::to_string(count) + " such " + what + " altogether)" : "";
  }

  std::size_t corner(std::size_t h, std::size_t offset) const { return m_triangles[h / 3][(h % 3 + offset) % 3]; }
  static std::size_t previous(std::size_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

  std::string edge_name(std::size_t h) const
  {
    return "the edge between the vertices " + std::to_string(corner(h, 0)) + " and " + std::to_string(corner(h, 1));
  }

  void collect_triangles(const std::vector<std::vector<std::size_t>>& polygons)
  {
    if(polygons.empty())
      fail("the mesh has no faces",
           "Perhaps the file is truncated, or a point cloud, which has to be turned into a surface first.");
    m_triangles.reserve(polygons.size());
    m_degrees.assign(m_points.size(), 0);
    std::size_t first = none, number_of_others = 0;
    for(std::size_t f = 0; f < polygons.size(); ++f)
    {
      const std::vector<std::size_t>& polygon = polygons[f];
      for(const std::size_t v : polygon)
        if(v >= m_points.size())
          fail(name("face", f) + " has a corner that does not exist: the file has " + std::to_string(m_points.size()) +
                   " vertices",
               "Repair the file, or the program that wrote it.");
      if(polygon.size() != 3)
      {
        first = (std::min)(first, f);
        ++number_of_others;
        continue;
      }
      m_triangles.push_back({polygon[0], polygon[1], polygon[2]});
      const Triangle& t = m_triangles.back();
      if(t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
        fail(name("face", f) + " has the vertex " + std::to_string(t[0] == t[1] ? t[1] : t[2]) + " twice",
             "Remove the face, for example with CGAL::Polygon_mesh_processing::repair_polygon_soup().");
      for(const std::size_t v : t)
        ++m_degrees[v];
    }
    if(number_of_others > 0)
      fail(name("face", first) + " is not a triangle but has " + std::to_string(polygons[first].size()) + " corners" +
               number_of_more(number_of_others, "faces"),
           polygons[first].size() < 3
               ? "Remove the face, for example with CGAL::Polygon_mesh_processing::repair_polygon_soup()."
               : "Triangulate the mesh first, for example with CGAL::Polygon_mesh_processing::triangulate_faces().");
  }

  // Two triangles back to back are duplicates as well, but that is not what helps.
  void check_number_of_vertices() const
  {
    const auto n_unused = std::count(m_degrees.begin(), m_degrees.end(), std::size_t(0));
    const std::size_t n_used = m_points.size() - static_cast<std::size_t>(n_unused);
    if(n_used < 4)
      fail("only " + std::to_string(n_used) + " vertices have a face",
           "The smallest closed surface is a tetrahedron, with four vertices.");
  }

  // finds the other face of each edge
  void pair_edges()
  {
    const std::size_t number_of_edges = 3 * m_triangles.size();
    std::vector<std::size_t> ends(m_points.size() + 1, 0);
    for(std::size_t h = 0; h < number_of_edges; ++h)
      ++ends[lower_end(h) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Edge> edges(number_of_edges);
    for(std::size_t h = 0; h < number_of_edges; ++h) // leaves in ends[v] where the edges of v end
      edges[ends[lower_end(h)]++] = {(std::max)(corner(h, 0), corner(h, 1)), h};

    m_opposites.assign(number_of_edges, none);
    std::vector<std::size_t> borders;
    auto begin = edges.begin();
    for(std::size_t v = 0; v < m_points.size(); ++v)
    {
      const auto end = edges.begin() + static_cast<std::ptrdiff_t>(ends[v]);
      std::sort(begin, end,
                [](const Edge& a, const Edge& b) { return a.other != b.other ? a.other < b.other : a.h < b.h; });
      while(begin != end)
      {
        const auto next = std::find_if(begin, end, [&](const Edge& e) { return e.other != begin->other; });
        check_edge(begin, next);
        if(next - begin == 1)
          borders.push_back(begin->h);
        else
        {
          m_opposites[begin[0].h] = begin[1].h;
          m_opposites[begin[1].h] = begin[0].h;
        }
        begin = next;
      }
    }
    if(!borders.empty())
      fail_with_borders(borders);
  }

  std::size_t lower_end(std::size_t h) const { return (std::min)(corner(h, 0), corner(h, 1)); }

  // checks the faces of one edge
  template <class Iterator>
  void check_edge(Iterator begin, Iterator end) const
  {
    if(end - begin == 2 && corner(begin[0].h, 2) == corner(begin[1].h, 2))
      fail_with_duplicates(begin[0].h, begin[1].h);
    if(end - begin > 2)
    {
      std::vector<Edge> faces(begin, end);
      std::sort(faces.begin(), faces.end(), [this](const Edge& a, const Edge& b) {
        return std::make_pair(corner(a.h, 2), a.h) < std::make_pair(corner(b.h, 2), b.h);
      });
      const auto duplicate = std::adjacent_find(faces.begin(), faces.end(), [this](const Edge& a, const Edge& b) {
        return corner(a.h, 2) == corner(b.h, 2);
      });
      if(duplicate != faces.end())
        fail_with_duplicates(duplicate[0].h, duplicate[1].h);
      fail(edge_name(begin->h) + " has " + std::to_string(end - begin) + " faces, among them the faces " +
               std::to_string(begin[0].h / 3) + ", " + std::to_string(begin[1].h / 3) + " and " +
               std::to_string(begin[2].h / 3),
           "An edge of a closed surface has two: remove the others, or duplicate the edge, for example with "
           "CGAL::Polygon_mesh_processing::orient_polygon_soup().");
    }
    if(end - begin == 2 && corner(begin[0].h, 0) == corner(begin[1].h, 0))
      fail("the faces " + std::to_string(begin[0].h / 3) + " and " + std::to_string(begin[1].h / 3) +
               " are oriented against each other: both use " + edge_name(begin->h) + " in the same direction",
           "Orient the faces alike, for example with CGAL::Polygon_mesh_processing::orient_polygon_soup().");
  }

  [[noreturn]] static void fail_with_duplicates(std::size_t h, std::size_t g)
  {
    fail("the faces " + std::to_string(h / 3) + " and " + std::to_string(g / 3) + " have the same corners",
         "Remove one of them, for example with CGAL::Polygon_mesh_processing::repair_polygon_soup().");
  }

  [[noreturn]] void fail_with_borders(const std::vector<std::size_t>& borders) const
  {
    const std::size_t number_of_duplicates = number_of_duplicate_points();
    fail("the mesh has a border: " + edge_name(borders.front()) + " belongs to one face only, " +
             name("face", borders.front() / 3) + number_of_more(borders.size(), "edges"),
         number_of_duplicates > 0
             ? std::to_string(number_of_duplicates) +
                   " vertices repeat the position of another one: perhaps the faces do not share their vertices. Merge "
                   "them first, for example with "
                   "CGAL::Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup()."
             : "Close the holes first, for example with CGAL::Polygon_mesh_processing::triangulate_hole().");
  }

  std::size_t number_of_duplicate_points() const
  {
    std::vector<Point_3> points;
    for(std::size_t v = 0; v < m_points.size(); ++v)
      if(m_degrees[v] > 0 && is_finite(m_points[v])) // NaN has no place in an order
        points.push_back(m_points[v]);
    std::sort(points.begin(), points.end());
    return static_cast<std::size_t>(points.end() - std::unique(points.begin(), points.end()));
  }

  // checks that the faces at each vertex form one fan
  void check_vertices() const
  {
    std::vector<bool> is_seen(m_points.size(), false);
    for(std::size_t first = 0; first < m_opposites.size(); ++first)
    {
      const std::size_t v = corner(first, 0);
      if(is_seen[v])
        continue;
      is_seen[v] = true;
      std::size_t size = 0, h = first;
      do
      {
        ++size;
        h = m_opposites[previous(h)];
      } while(h != first);
      if(size < m_degrees[v])
        fail("the surface touches itself in " + name("vertex", v) + ": a fan of " + std::to_string(size) +
                 " faces and others, " + std::to_string(m_degrees[v]) + " in total, meet in nothing but this vertex",
             "Duplicate the vertex, for example with "
             "CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices(); if the mesh falls into several parts, "
             "map each of them on its own.");
    }
  }

  const std::vector<Point_3>& m_points;
  std::vector<Triangle> m_triangles;
  std::vector<std::size_t> m_degrees;   // the number of faces at each vertex
  std::vector<std::size_t> m_opposites; // the same edge in the other face
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_DIAGNOSIS_H
