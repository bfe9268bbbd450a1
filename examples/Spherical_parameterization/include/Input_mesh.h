#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INPUT_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INPUT_MESH_H

#include "Polygon_soup.h"
#include "Program_error.h"
#include "read_soup.h"

#include <CGAL/Spherical_parameterization/find_defect.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/container/small_vector.hpp>
#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace Program {

namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex_index = Mesh::Vertex_index;
using Sphere_map = Mesh::Property_map<Vertex_index, Point_3>;
using Distortion_map = Mesh::Property_map<Mesh::Face_index, SP::Face_distortion>;

/// The mesh of a file, if a halfedge data structure can hold it. It keeps the faces as they were in the file, whose first
/// corners `Surface_mesh` forgets.
class Input_mesh
{
public:
  /// turns the content of the file `path` into a mesh. The indices of vertices and faces are those of the file.
  ///
  /// \throws Program_error with what is wrong, where, and what helps
  Input_mesh(const std::string& path, Polygon_soup soup)
    : m_name(printable(path))
    , m_polygons(std::move(soup.polygons))
  {
    check_faces(soup.points.size());
    check_edges();
    using Index = Mesh::size_type;
    m_mesh.reserve(static_cast<Index>(soup.points.size()), static_cast<Index>(m_polygons.size() / 2 * 3),
                   static_cast<Index>(m_polygons.size()));
    for(const Point_3& p : soup.points)
      m_mesh.add_vertex(p);
    // All at once: one by one, the faces at a vertex take time that is quadratic in their number.
    std::vector<boost::container::small_vector<Vertex_index, 3>> faces(m_polygons.size());
    for(std::size_t f = 0; f < faces.size(); ++f)
      for(const std::size_t v : m_polygons[f])
        faces[f].emplace_back(static_cast<Index>(v));
    CGAL::Euler::add_faces(faces, m_mesh);
  }

  /// returns why the mesh has no map, where, and what helps; empty if the mesh is in order. A parameterizer asks the same
  /// before it begins.
  std::string find_defect() const
  {
    const SP::Mesh_defect<Mesh> defect = SP::find_defect(m_mesh);
    if(defect.error == SP::OK)
      return "";
    return m_name + ": " + defect.message + (defect.error == SP::ERROR_NON_CLOSED_MESH ? explain_border() : "");
  }

  /// returns the name of the file for a message.
  const std::string& name() const { return m_name; }

  Mesh& mesh() { return m_mesh; }
  const std::vector<Polygon>& triangles() const { return m_polygons; }

  /// reads a map of this mesh from a file.
  ///
  /// \throws Program_error if this mesh has no map, or the file cannot be read, is of another mesh, or turns faces over
  Sphere_map read_map(const std::string& path)
  {
    const std::string defect = find_defect();
    if(!defect.empty())
      throw Program_error(defect);
    const Polygon_soup soup = read_soup(path);
    check_faces_of(path, "is no map of this mesh", soup.points.size(), soup.polygons);
    const Sphere_map map = m_mesh.add_property_map<Vertex_index, Point_3>("v:initial").first;
    for(const Vertex_index v : m_mesh.vertices())
    {
      map[v] = soup.points[v];
      if(!m_mesh.is_isolated(v) && !is_finite(map[v]))
        throw Program_error(path,
                            "is no map: vertex " + std::to_string(v) +
                                " has a coordinate that is infinite or not a number. (Vertices are counted from 0.)");
    }

    const Distortion_map distortions =
        m_mesh.add_property_map<Mesh::Face_index, SP::Face_distortion>("f:initial").first;
    const std::size_t n_inverted = SP::measure_distortion(m_mesh, map, distortions).number_of_inverted_faces;
    for(const Mesh::Face_index f : m_mesh.faces())
      if(distortions[f].is_inverted)
        throw Program_error(
            path, "is no one-to-one map: face " + std::to_string(std::size_t(f)) +
                      " is not positively oriented as seen from the origin (" + std::to_string(n_inverted) +
                      " such faces in total).\nTake another start, such as --initial harmonic. (Faces are counted "
                      "from 0.)");
    return map;
  }

  /// checks that the file `path` has as many vertices as this mesh, and the same faces.
  ///
  /// \throws Program_error with what the file `is`, and why
  void check_faces_of(const std::string& path, const std::string& is, std::size_t n_vertices,
                      const std::vector<Polygon>& polygons) const
  {
    const auto compare = [&](const std::string& what, std::size_t count, std::size_t expected) {
      if(count != expected)
        throw Program_error(path, is + ": it has " + std::to_string(count) + " " + what + ", the mesh has " +
                                      std::to_string(expected));
    };
    compare("vertices", n_vertices, m_mesh.number_of_vertices());
    compare("faces", polygons.size(), m_polygons.size());
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
      if(!is_same(polygons[f], m_polygons[f]))
        throw Program_error(path, is + ": face " + std::to_string(f) +
                                      " has other corners, or another orientation. (Faces are counted from 0.)");
  }

private:
  [[noreturn]] void fail(const std::string& what, const std::string& advice) const
  {
    throw Program_error(m_name + ": " + what + ".\n" + advice + "\n(Vertices and faces are counted from 0.)");
  }

  static bool is_finite(const Point_3& p)
  {
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  }

  // What follows checks what no halfedge data structure can hold; of all else, find_defect() says what is wrong.

  void check_faces(std::size_t n_vertices) const
  {
    if(m_polygons.empty())
      throw Program_error(m_name +
                          ": the mesh has no faces.\nPerhaps the file is truncated, or a point cloud, which has "
                          "to be turned into a surface first.");
    constexpr std::size_t limit = (std::numeric_limits<std::int32_t>::max)(); // as Surface_mesh counts in 32 bits
    if(n_vertices >= limit || m_polygons.size() >= limit / 3)
      throw Program_error(m_name + ": " + SP::get_error_message(SP::ERROR_TOO_LARGE_MESH));
    const char* const advice =
        "Remove the face, for example with CGAL::Polygon_mesh_processing::repair_polygon_soup().";
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
    {
      Polygon corners = m_polygons[f];
      if(corners.size() < 3)
        fail("face " + std::to_string(f) + " is not a triangle but has " + std::to_string(corners.size()) + " corners",
             advice);
      std::sort(corners.begin(), corners.end());
      const auto repeated = std::adjacent_find(corners.begin(), corners.end());
      if(repeated != corners.end())
        fail("face " + std::to_string(f) + " has the vertex " + std::to_string(*repeated) + " twice", advice);
    }
  }

  // calls `visit(from, to)` for each edge of a face, in its direction
  template <class Visit>
  static void for_each_edge(const Polygon& polygon, const Visit& visit)
  {
    for(std::size_t k = 0; k < polygon.size(); ++k)
      visit(polygon[k], polygon[k + 1 < polygon.size() ? k + 1 : 0]);
  }

  // checks that no two faces use an edge in the same direction, as they do wherever an edge has three
  void check_edges() const
  {
    std::vector<std::uint64_t> edges; // one vertex in the upper half, the other one in the lower
    edges.reserve(3 * m_polygons.size());
    for(const Polygon& polygon : m_polygons)
      for_each_edge(polygon,
                    [&](std::size_t from, std::size_t to) { edges.push_back(std::uint64_t(from) << 32 | to); });
    boost::sort::spreadsort::integer_sort(edges.begin(), edges.end());
    const auto repeated = std::adjacent_find(edges.begin(), edges.end());
    if(repeated != edges.end())
      explain_edge(static_cast<std::size_t>(*repeated >> 32), static_cast<std::size_t>(*repeated & 0xffffffff));
  }

  [[noreturn]] void explain_edge(std::size_t v, std::size_t w) const
  {
    if(w < v)
      std::swap(v, w);
    std::vector<std::size_t> faces;                      // of the edge
    std::vector<std::pair<Polygon, std::size_t>> sorted; // the same, behind their corners in order
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
      for_each_edge(m_polygons[f], [&](std::size_t from, std::size_t to) {
        if((std::min)(from, to) != v || (std::max)(from, to) != w)
          return;
        faces.push_back(f);
        sorted.emplace_back(m_polygons[f], f);
        std::sort(sorted.back().first.begin(), sorted.back().first.end());
      });
    std::sort(sorted.begin(), sorted.end());
    const auto duplicate = std::adjacent_find(sorted.begin(), sorted.end(),
                                              [](const auto& a, const auto& b) { return a.first == b.first; });
    if(duplicate != sorted.end())
      fail("the faces " + std::to_string(duplicate[0].second) + " and " + std::to_string(duplicate[1].second) +
               " have the same corners",
           "Remove one of them, for example with CGAL::Polygon_mesh_processing::repair_polygon_soup().");
    const auto number = [&](std::size_t i) { return std::to_string(faces[i]); };
    const std::string edge = "the edge between the vertices " + std::to_string(v) + " and " + std::to_string(w);
    if(faces.size() > 2)
      fail(edge + " has " + std::to_string(faces.size()) + " faces, among them the faces " + number(0) + ", " +
               number(1) + " and " + number(2),
           "An edge of a closed surface has two: remove the others, or duplicate the edge, for example with "
           "CGAL::Polygon_mesh_processing::orient_polygon_soup().");
    fail("the faces " + number(0) + " and " + number(1) + " are oriented against each other: both use " + edge +
             " in the same direction",
         "Orient the faces alike, for example with CGAL::Polygon_mesh_processing::orient_polygon_soup().");
  }

  // Faces that do not share their vertices are the most frequent reason for a border.
  std::string explain_border() const
  {
    std::vector<Point_3> points;
    for(const Vertex_index v : m_mesh.vertices())
      if(!m_mesh.is_isolated(v) && is_finite(m_mesh.point(v))) // NaN has no place in an order
        points.push_back(m_mesh.point(v));
    std::sort(points.begin(), points.end());
    const auto n_repeated = points.end() - std::unique(points.begin(), points.end());
    return n_repeated == 0 ? ""
                           : "\n" + std::to_string(n_repeated) +
                                 " vertices repeat the position of another one: perhaps the faces do not share them.";
  }

  // returns whether both polygons are the same triangle, from any of its corners on
  static bool is_same(Polygon polygon, const Polygon& triangle)
  {
    for(std::size_t k = 0; k < 3 && polygon != triangle; ++k)
      std::rotate(polygon.begin(), polygon.begin() + (polygon.empty() ? 0 : 1), polygon.end());
    return polygon == triangle;
  }

  std::string m_name;
  Mesh m_mesh;
  std::vector<Polygon> m_polygons;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INPUT_MESH_H
