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

#include <CGAL/Spherical_parameterization/find_defect.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace Program {

namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex_index = Mesh::Vertex_index;
using Sphere_map = Mesh::Property_map<Vertex_index, Point_3>;

/// A mesh that can be mapped to a sphere. It keeps the faces as they were in the file, whose first corners
/// `Surface_mesh` forgets.
class Input_mesh
{
public:
  using Triangle = Mesh_diagnosis::Triangle;

  /// turns the content of the file `path` into a mesh. The indices of vertices and faces are those of the file.
  ///
  /// \throws Program_error if it is no surface of genus 0
  Input_mesh(const std::string& path, const Polygon_soup& soup)
    : m_path(path)
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
    // All at once: one by one, the faces at a vertex take time that is quadratic in their number.
    std::vector<std::array<Vertex_index, 3>> faces;
    faces.reserve(m_triangles.size());
    for(const Triangle& t : m_triangles)
      faces.push_back({vertex(t[0]), vertex(t[1]), vertex(t[2])});
    CGAL::Euler::add_faces(faces, m_mesh);
    const SP::Mesh_defect<Mesh> defect = SP::find_defect(m_mesh);
    if(defect.error != SP::OK)
      throw Program_error(path + ": " + defect.message);
  }

  const std::string& path() const { return m_path; }
  Mesh& mesh() { return m_mesh; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }

  /// reads a map of this mesh from a file.
  ///
  /// \throws Program_error if the file cannot be read, is of another mesh, or turns faces over
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
    check_orientations(path, map);
    return map;
  }

private:
  void check_orientations(const std::string& path, const Sphere_map& map)
  {
    auto distortions = m_mesh.add_property_map<Mesh::Face_index, SP::Face_distortion>("f:initial").first;
    const std::size_t n_inverted = SP::measure_distortion(m_mesh, map, distortions).number_of_inverted_faces;
    for(const Mesh::Face_index f : m_mesh.faces())
      if(distortions[f].is_inverted)
        throw Program_error(
            path + ": is no one-to-one map: face " + std::to_string(std::size_t(f)) +
            " is not positively oriented as seen from the origin (" + std::to_string(n_inverted) +
            " such faces altogether).\nTake another start, such as --initial harmonic. (Faces are counted "
            "from 0.)");
    m_mesh.remove_property_map(distortions);
  }

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

  std::string m_path;
  Mesh m_mesh;
  std::vector<Triangle> m_triangles;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INPUT_MESH_H
