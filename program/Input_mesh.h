#ifndef PROGRAM_INPUT_MESH_H
#define PROGRAM_INPUT_MESH_H

#include "read_file.h"

#include <CGAL/Spherical_parameterization/Repair/find_handles.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CGAL/Surface_mesh.h>

#include <optional>
#include <ostream>

namespace Program {

using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex_index = Mesh::Vertex_index;
using Sphere_map = Mesh::Property_map<Vertex_index, Point_3>;
using Distortion_map = Mesh::Property_map<Mesh::Face_index, SP::Face_distortion>;

/// measures a map to the sphere, each face and all together.
SP::Distortion_summary measured_distortion(const Mesh& mesh, const Sphere_map& map, Distortion_map distortions);

/// returns the faces of each part of a surface: those that are connected by edges. The largest part comes first, of several as large
/// that with the first face.
std::vector<std::vector<Polygon>> parts_of(std::vector<Polygon> polygons);

/// returns some polygons of a mesh as a mesh of their own: with no other vertices, in the order of the file.
File_content part_of(const File_content& whole, std::vector<Polygon> polygons);

/// The mesh of a file, if a halfedge data structure can hold it. It keeps the faces as they were in the file, whose first
/// corners `Surface_mesh` forgets.
class Input_mesh
{
public:
  /// A hole of the surface, which has been filled with faces, unless it has too many edges.
  struct Hole
  {
    std::size_t vertex, number_of_edges, number_of_faces;
    double perimeter, share; ///< of all of the area
  };

  using Handle = SP::Handle<Mesh>;

  /// turns the content of the file `path` into a mesh. The indices of vertices and faces are those of the file.
  Input_mesh(const std::string& path, File_content soup);

  /// returns why the mesh has no map, where, and what helps; empty if the mesh is in order. A parameterizer asks the same
  /// before it begins.
  ///
  /// \param advises whether it names the commands that show where handles are
  std::string find_defect(bool advises = true) const;

  /// throws what keeps the mesh from having a map, as a `Program_error`.
  void check() const;

  /// returns a closed path around each handle, at most so many; see `SP::find_handles()`. There are none if anything else is wrong.
  std::vector<Handle> find_handles(std::size_t max_handles) const;

  /// returns the length of a path around a handle, and where it is.
  static std::string describe(const Handle& handle);

  /// writes paths around handles as a PLY file of lines: their vertices with the number that each has in the mesh, and edges
  /// with the number of the handle.
  void write_handles(std::ostream& out, const std::vector<Handle>& handles) const;

  /// fills the holes with at most so many edges; see `SP::fill_holes()`. New vertices and faces come behind those of the file.
  std::vector<Hole> fill_holes(std::size_t max_edges);

  /// returns the name of the file for a message.
  const std::string& name() const { return m_name; }

  /// returns whether the format of the file is one of those for cortical surfaces.
  bool is_of_cortical_format() const { return m_is_of_cortical_format; }

  Mesh& mesh() { return m_mesh; }

  /// returns the mesh without what holes have been filled with. Its vertices and faces have the same indices.
  Mesh& mesh_of_file() { return m_unfilled ? *m_unfilled : m_mesh; }

  bool is_filler(Mesh::Face_index f) const { return f.idx() >= m_polygons.size(); }

  /// returns what a file of a cortical surface says of its origin.
  const SP::IO::Surface_origin& origin() const { return m_origin; }

  /// returns which half of the brain the files are of.
  const Hemispheres& hemispheres() const { return m_hemispheres; }

  /// returns the triangles of the file.
  const std::vector<Polygon>& triangles() const { return m_polygons; }

  /// takes the triangles from the mesh, after edges of it have been split. Those that are still there stay as they were.
  void take_triangles_of_mesh();

  /// returns what vertices have in a property map, but those that holes have been filled with.
  std::vector<Point_3> points_of(const Sphere_map& map);

  /// writes the closed surface. In a PLY file, the property `filler` of its faces is 1 for those that holes have been filled with.
  void write_filled(std::ostream& out, const std::string& format) const;

  /// reads images of the vertices from a file with the faces of this mesh, wherever they are.
  Sphere_map read_images(const std::string& path);

  /// reads a map of this mesh from a file.
  Sphere_map read_map(const std::string& path);

  /// checks that the file `path` has as many vertices as this mesh, and the same faces.
  void check_faces_of(const std::string& path, const std::string& is, std::size_t n_vertices,
                      const std::vector<Polygon>& polygons) const;

private:
  std::string describe_handles(bool advises) const;

  std::string m_name;
  bool m_is_of_cortical_format;
  SP::IO::Surface_origin m_origin;
  Hemispheres m_hemispheres;
  Mesh m_mesh;
  std::optional<Mesh> m_unfilled; // if holes have been filled
  std::vector<Polygon> m_polygons;
};

} // namespace Program

#endif // PROGRAM_INPUT_MESH_H
