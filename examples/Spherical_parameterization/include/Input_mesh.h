#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INPUT_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INPUT_MESH_H

#include "Input_defect.h"
#include "Polygon_soup.h"
#include "Program_error.h"
#include "read_soup.h"

#include <CGAL/Spherical_parameterization/Repair/fill_holes.h>
#include <CGAL/Spherical_parameterization/Repair/find_handles.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Program {

using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex_index = Mesh::Vertex_index;
using Sphere_map = Mesh::Property_map<Vertex_index, Point_3>;
using Distortion_map = Mesh::Property_map<Mesh::Face_index, SP::Face_distortion>;

/// measures a map to the sphere, each face and all together.
///
/// \throws Program_error if that cannot be measured
inline SP::Distortion_summary measured_distortion(const Mesh& mesh, const Sphere_map& map, Distortion_map distortions)
{
  SP::Distortion_summary summary;
  const SP::Error_code error = SP::measure_distortion(mesh, map, summary, distortions);
  if(error != SP::OK)
    throw Program_error(SP::get_error_message(error));
  return summary;
}

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
    , m_is_of_cortical_format(!is_among(file_format(path), input_formats))
    , m_origin(std::move(soup.origin))
    , m_hemispheres(std::move(soup.hemispheres))
    , m_polygons(std::move(soup.polygons))
  {
    if(m_polygons.empty())
      throw Program_error(m_name +
                          ": the mesh has no faces.\nPerhaps the file is truncated, or a point cloud, which has "
                          "to be turned into a surface first.");
    if(const auto defect = find_defect_of_faces(soup.points.size(), m_polygons))
      throw Program_error(m_name + ": " + defect->message);
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
    const auto defect = find_defect_of_mesh(m_mesh);
    if(!defect)
      return "";
    const char* const cure = defect->error == SP::ERROR_NON_CLOSED_MESH ? "\n--fill-holes all fills them."
                             : defect->error == SP::ERROR_SEVERAL_COMPONENTS
                                 ? "\n--components largest maps the largest one, --components each all of them."
                                 : "";
    return m_name + ": " + defect->message + cure +
           (defect->error == SP::ERROR_NO_TOPOLOGICAL_SPHERE ? describe_handles() : "");
  }

  /// returns a closed path around each handle, at most so many; see `SP::find_handles()`. There are none if anything else is wrong.
  std::vector<SP::Handle<Mesh>> find_handles(std::size_t max_handles) const
  {
    std::vector<SP::Handle<Mesh>> handles;
    if(SP::find_handles(m_mesh, handles, CGAL::parameters::maximum_number(max_handles)) != SP::OK)
      handles.clear();
    return handles;
  }

  /// returns the length of a path around a handle, and where it is.
  static std::string describe(const SP::Handle<Mesh>& handle)
  {
    std::ostringstream text;
    text << handle.path.size() << " edges around a handle, of length " << handle.length << ", at vertex "
         << handle.path.front().idx();
    return text.str();
  }

  /// writes paths around handles as a PLY file of lines: their vertices with the number that each has in the mesh, and edges
  /// with the number of the handle.
  void write_handles(std::ostream& out, const std::vector<SP::Handle<Mesh>>& handles) const
  {
    std::size_t n = 0;
    for(const SP::Handle<Mesh>& handle : handles)
      n += handle.path.size();
    out << "ply\nformat ascii 1.0\nelement vertex " << n
        << "\nproperty double x\nproperty double y\nproperty double z\nproperty int vertex\nelement edge " << n
        << "\nproperty int vertex1\nproperty int vertex2\nproperty int handle\nend_header\n";
    out.precision(17);
    for(const SP::Handle<Mesh>& handle : handles)
      for(const Vertex_index v : handle.path)
        out << m_mesh.point(v) << ' ' << v.idx() << '\n';
    std::size_t first = 0;
    for(std::size_t k = 0; k < handles.size(); ++k)
    {
      const std::size_t size = handles[k].path.size();
      for(std::size_t i = 0; i < size; ++i)
        out << first + i << ' ' << first + (i + 1) % size << ' ' << k << '\n';
      first += size;
    }
  }

  /// fills the holes with at most so many edges; see `SP::fill_holes()`. New vertices and faces come behind those of the file.
  ///
  /// \throws Program_error if a border touches itself or another one, or a coordinate is not finite
  std::vector<SP::Filled_hole<Mesh>> fill_holes(std::size_t max_edges)
  {
    m_unfilled = m_mesh;
    std::vector<SP::Filled_hole<Mesh>> holes;
    const SP::Error_code error = SP::fill_holes(m_mesh, holes, CGAL::parameters::maximum_number(max_edges));
    if(error == SP::ERROR_NO_SIMPLICIAL_COMPLEX)
      throw Program_error(
          m_name + ": the border touches itself in vertex " + std::to_string(holes.back().vertex) +
          ", so that it is not clear what its holes are.\nSplit the vertex, for example with "
          "CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices(). (Vertices are counted from 0.)");
    if(error == SP::ERROR_NON_FINITE_COORDINATE)
    {
      const auto is_wrong = [&](Vertex_index v) { return !m_mesh.is_isolated(v) && !is_finite(m_mesh.point(v)); };
      const Vertex_index v = *std::find_if(m_mesh.vertices().begin(), m_mesh.vertices().end(), is_wrong);
      throw Program_error(m_name + ": vertex " + std::to_string(v) +
                          " has a coordinate that is infinite or not a number. (Vertices are counted from 0.)");
    }
    return holes;
  }

  /// returns the name of the file for a message.
  const std::string& name() const { return m_name; }

  /// returns whether the format of the file is one of those for cortical surfaces.
  bool is_of_cortical_format() const { return m_is_of_cortical_format; }

  Mesh& mesh() { return m_mesh; }

  /// returns the mesh without what holes have been filled with. Its vertices and faces have the same indices.
  Mesh& mesh_of_file() { return m_unfilled ? *m_unfilled : m_mesh; }

  bool is_filler(Mesh::Face_index f) const { return f.idx() >= m_polygons.size(); }

  /// returns what a file of a cortical surface tells of where that is from.
  const SP::IO::Surface_origin& origin() const { return m_origin; }

  /// returns which half of the brain the files are of.
  const Hemispheres& hemispheres() const { return m_hemispheres; }

  /// returns the triangles of the file.
  const std::vector<Polygon>& triangles() const { return m_polygons; }

  /// takes the triangles from the mesh, after edges of it have been split. Those that are still there stay as they were.
  void take_triangles_of_mesh()
  {
    m_polygons.resize(m_mesh.number_of_faces());
    for(const Mesh::Face_index f : m_mesh.faces())
    {
      Polygon corners;
      for(const Vertex_index v : CGAL::vertices_around_face(m_mesh.halfedge(f), m_mesh))
        corners.push_back(v);
      if(!is_same(corners, m_polygons[f]))
        m_polygons[f] = corners;
    }
  }

  /// returns what vertices have in a property map, but those that holes have been filled with.
  template <class Map>
  std::vector<Point_3> points_of(const Map& map)
  {
    const auto n = static_cast<std::ptrdiff_t>(mesh_of_file().number_of_vertices());
    return std::vector<Point_3>(map.begin(), map.begin() + n);
  }

  /// writes the closed surface as a PLY file. The property `filler` of its faces is 1 for those that holes have been filled
  /// with.
  void write_filled(std::ostream& out) const
  {
    Mesh filled;
    filled.reserve(m_mesh.number_of_vertices(), m_mesh.number_of_edges(), m_mesh.number_of_faces());
    for(const Vertex_index v : m_mesh.vertices())
      filled.add_vertex(m_mesh.point(v));
    const auto label = filled.add_property_map<Mesh::Face_index, std::uint8_t>("f:filler", 1).first;
    std::vector<boost::container::small_vector<Vertex_index, 3>> faces;
    for(const Polygon& polygon : m_polygons)
    {
      faces.emplace_back();
      for(const std::size_t v : polygon)
        faces.back().emplace_back(static_cast<Mesh::size_type>(v));
    }
    for(const Mesh::Face_index f : m_mesh.faces())
      if(is_filler(f))
      {
        const auto corners = CGAL::vertices_around_face(m_mesh.halfedge(f), m_mesh);
        faces.emplace_back(corners.begin(), corners.end());
      }
    CGAL::Euler::add_faces(faces, filled);
    for(const Mesh::Face_index f : filled.faces())
      label[f] = is_filler(f) ? 1 : 0;
    CGAL::IO::set_binary_mode(out);
    CGAL::IO::write_PLY(out, filled, CGAL::parameters::stream_precision(17));
  }

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
    const std::size_t n_inverted = measured_distortion(m_mesh, map, distortions).number_of_inverted_faces;
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
    compare("vertices", n_vertices, (m_unfilled ? *m_unfilled : m_mesh).number_of_vertices());
    compare("faces", polygons.size(), m_polygons.size());
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
      if(!is_same(polygons[f], m_polygons[f]))
        throw Program_error(path, is + ": face " + std::to_string(f) +
                                      " has other corners, or another orientation. (Faces are counted from 0.)");
  }

private:
  std::string describe_handles() const
  {
    constexpr std::size_t max_named = 5; // each takes time
    std::ostringstream text;
    for(const SP::Handle<Mesh>& handle : find_handles(max_named))
      text << "\nA path of " << describe(handle) << '.';
    text << "\n--handles FILE writes such a path for each, --page FILE shows where they are. (Vertices are counted "
            "from 0.)";
    return text.str();
  }

  static bool is_finite(const Point_3& p)
  {
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  }

  // returns whether both polygons are the same triangle, from any of its corners on
  static bool is_same(Polygon polygon, const Polygon& triangle)
  {
    for(std::size_t k = 0; k < 3 && polygon != triangle; ++k)
      std::rotate(polygon.begin(), polygon.begin() + (polygon.empty() ? 0 : 1), polygon.end());
    return polygon == triangle;
  }

  std::string m_name;
  bool m_is_of_cortical_format;
  SP::IO::Surface_origin m_origin;
  Hemispheres m_hemispheres;
  Mesh m_mesh;
  std::optional<Mesh> m_unfilled; // if holes have been filled
  std::vector<Polygon> m_polygons;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_INPUT_MESH_H
