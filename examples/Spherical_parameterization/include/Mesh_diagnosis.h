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
#include <limits>
#include <string>
#include <vector>

namespace Program {

/// Finds out what keeps a polygon soup from being a triangulated surface without border, in one piece and without handles.
///
/// The library refuses such meshes too; this class says where the trouble is, which only makes sense in the numbers of
/// the file. Vertices, faces and corners count from 0. The running time is linear, apart from sorting around a vertex.
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
    check_coordinates();
    pair_halfedges();
    check_vertices();
    check_components();
    check_genus();
  }

  /// returns the faces, each beginning with its first corner.
  const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
  static constexpr std::size_t none = std::size_t(-1);

  // an edge of a face, as one of all edges at its vertex of lower number
  struct Edge_use
  {
    std::size_t other;    // the vertex of higher number
    std::size_t halfedge; // 3 * face + corner, from that corner to the next
  };

  static std::string name(const char* what, std::size_t i) { return what + (" " + std::to_string(i)); }

  static std::string count(std::size_t n, const std::string& what)
  {
    return n == 1 ? "1 " + what : std::to_string(n) + " " + what + "s";
  }

  [[noreturn]] static void fail(const std::string& what, const std::string& advice)
  {
    throw Program_error(what + ".\n" + advice + " (Vertices and faces are counted from 0.)");
  }

  std::size_t source(std::size_t h) const { return m_triangles[h / 3][h % 3]; }
  std::size_t target(std::size_t h) const { return m_triangles[h / 3][(h + 1 - h / 3 * 3) % 3]; }
  std::size_t apex(std::size_t h) const { return m_triangles[h / 3][(h + 2 - h / 3 * 3) % 3]; }
  static std::size_t previous(std::size_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

  std::string edge_name(std::size_t h) const
  {
    return "the edge between the vertices " + std::to_string(source(h)) + " and " + std::to_string(target(h));
  }
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_DIAGNOSIS_H
