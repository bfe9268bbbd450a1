#ifndef PROGRAM_INPUT_MESH_H
#define PROGRAM_INPUT_MESH_H

#include "Surface_repair.h"

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

/// returns the faces of each component of a surface: those that are connected by edges. The largest comes first, of several as large
/// that with the first face.
///
/// \param joins_borders whether vertices of borders at the same point count as one
std::vector<std::vector<std::size_t>> components_of(const File_content& surface, bool joins_borders);

/// returns some faces of a surface as one of their own: with no other vertices, in the order of the file.
File_content part_of(const File_content& whole, const std::vector<std::size_t>& faces);

/// The mesh of a file, if a halfedge data structure can hold it. It keeps the faces as they were in the file, whose first
/// corners `Surface_mesh` forgets.
class Input_mesh
{
public:
  using Handle = SP::Handle<Mesh>;

  /// turns the content of the file `path` into a mesh. The indices of vertices and faces are those of the file, unless it is repaired,
  /// and needs that.
  Input_mesh(const std::string& path, File_content surface, const std::optional<Repair_settings>& repair = {});

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

  /// writes cycles around handles, by their vertices in the file, as a PLY file of lines: vertices with the number that each has in
  /// the file, and edges with the number of the handle.
  void write_cycles(std::ostream& out, const std::vector<std::vector<std::size_t>>& cycles) const;

  /// returns the name of the file for a message.
  const std::string& name() const { return m_name; }

  /// returns whether the format of the file is one of those for cortical surfaces.
  bool is_of_cortical_format() const { return m_is_of_cortical_format; }

  Mesh& mesh() { return m_mesh; }
  const Mesh& mesh() const { return m_mesh; }

  /// returns what the repair has done; nothing if none was wanted.
  const std::optional<Surface_repair>& repair() const { return m_repair; }

  /// returns whether a face is new, as it closes a hole, or one side of a cut through a handle.
  bool is_patch(Mesh::Face_index f) const { return m_repair && m_repair->is_patch(f); }

  /// returns whether any face is.
  bool has_patches() const { return m_repair && !m_repair->report().patches.empty(); }

  /// returns how many vertices the file has.
  std::size_t number_of_vertices_of_file() const;

  /// returns the vertex that one of the file has become, the first if there are several; `Mesh::null_vertex()` if it is gone.
  Vertex_index vertex_of(std::size_t vertex_of_file) const;

  /// turns values of the vertices and faces of the file into those of the mesh.
  File_content carried(File_content values) const;

  /// measures a map of the mesh, each face, and all together but patches.
  SP::Distortion_summary measured(const Sphere_map& map, Distortion_map distortions) const;

  /// returns what a file of a cortical surface says of its origin.
  const SP::IO::Surface_origin& origin() const { return m_origin; }

  /// returns which half of the brain the files are of.
  const Hemispheres& hemispheres() const { return m_hemispheres; }

  /// returns the triangles, with the corners in the order that they have in the file.
  const std::vector<Polygon>& triangles() const { return m_polygons; }

  /// takes the triangles from the mesh, after edges of it have been split. Those that are still there stay as they were.
  void take_triangles_of_mesh();

  /// returns the mesh with its points alone, to be written with other properties.
  Mesh mesh_without_properties() const;

  /// writes the repaired surface. In a PLY file, the properties `source_vertex` and `source_face` say which vertex or face of the file
  /// each is from, -1 for new ones, and `patch` is 1 for faces that close it.
  void write_repaired(std::ostream& out, const std::string& format) const;

  /// reads images of the vertices, wherever they are, from a file with the faces of this mesh or of its file.
  Sphere_map read_images(const std::string& path);

  /// reads a map of this mesh from a file.
  Sphere_map read_map(const std::string& path);

  /// checks that the file `path` has as many vertices as this mesh, or its file, and the same faces.
  void check_faces_of(const std::string& path, const std::string& is, std::size_t n_vertices,
                      const std::vector<Polygon>& polygons) const;

private:
  std::string describe_handles(bool advises) const;
  bool is_of_file(std::size_t n_vertices, const std::vector<Polygon>& polygons) const;

  std::string m_name;
  bool m_is_of_cortical_format;
  SP::IO::Surface_origin m_origin;
  Hemispheres m_hemispheres;
  Mesh m_mesh;
  std::vector<Polygon> m_polygons;
  std::optional<Surface_repair> m_repair;
  std::vector<std::size_t> m_vertices, m_faces; // in the file, of a part of it; empty for all of it
};

} // namespace Program

#endif // PROGRAM_INPUT_MESH_H
