// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INPUT_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INPUT_MESH_H

#include "Mesh_diagnosis.h"
#include "Polygon_soup.h"
#include "Program_error.h"
#include "read_soup.h"

#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Program {

using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex_index = Mesh::Vertex_index;
using Sphere_map = Mesh::Property_map<Vertex_index, Point_3>;

/// A mesh that can be mapped to a sphere. It keeps the faces as they were in the file, whose first corners `Surface_mesh`
/// forgets.
class Input_mesh
{
public:
  using Triangle = Mesh_diagnosis::Triangle;

  /// turns the content of the file `path` into a mesh. The indices of vertices and faces are those of the file.
  ///
  /// \throws Program_error if it is no surface of genus 0
  Input_mesh(const std::string& path, const Polygon_soup& soup)
  {
    try
    {
      m_triangles = Mesh_diagnosis(soup).triangles();
    }
    catch(const Program_error& error)
    {
      throw Program_error(path + ": " + error.what());
    }
    m_mesh.reserve(static_cast<Mesh::size_type>(soup.points.size()),
                   static_cast<Mesh::size_type>(m_triangles.size() / 2 * 3),
                   static_cast<Mesh::size_type>(m_triangles.size()));
    for(const Point_3& p : soup.points)
      m_mesh.add_vertex(p);
    for(const Triangle& t : m_triangles)
      m_mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  }

  Mesh& mesh() { return m_mesh; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }

  /// reads a map of this mesh from a file.
  ///
  /// \throws Program_error if the file cannot be read, or is of another mesh
  Sphere_map read_map(const std::string& path)
  {
    const Polygon_soup soup = read_soup(path);
    compare("vertices", path, soup.points.size(), m_mesh.number_of_vertices());
    compare("faces", path, soup.polygons.size(), m_triangles.size());
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      if(!is_same(soup.polygons[f], m_triangles[f]))
        throw Program_error(path + ": is no map of this mesh: face " + std::to_string(f) +
                            " has other corners, or another orientation. (Faces are counted from 0.)");
    const Sphere_map map = m_mesh.add_property_map<Vertex_index, Point_3>("v:initial").first;
    for(const Vertex_index v : m_mesh.vertices())
    {
      map[v] = soup.points[v];
      if(!m_mesh.is_isolated(v) && !Mesh_diagnosis::is_finite(map[v]))
        throw Program_error(path + ": is no map: vertex " + std::to_string(v) +
                            " has a coordinate that is infinite or not a number. (Vertices are counted from 0.)");
    }
    return map;
  }

private:
  static Vertex_index vertex(std::size_t i) { return Vertex_index(static_cast<Mesh::size_type>(i)); }

  static void compare(const std::string& what, const std::string& path, std::size_t count, std::size_t expected)
  {
    if(count != expected)
      throw Program_error(path + ": is no map of this mesh: it has " + std::to_string(count) + " " + what +
                          ", the mesh has " + std::to_string(expected));
  }

  // returns whether the polygon is the triangle, from any of its corners on
  static bool is_same(const std::vector<std::size_t>& polygon, const Triangle& t)
  {
    for(std::size_t k = 0; k < 3; ++k)
      if(polygon == std::vector<std::size_t>{t[k], t[(k + 1) % 3], t[(k + 2) % 3]})
        return true;
    return false;
  }

  Mesh m_mesh;
  std::vector<Triangle> m_triangles;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INPUT_MESH_H
