#ifndef PROGRAM_INPUT_MESH_H
#define PROGRAM_INPUT_MESH_H

#include "Repair_step.h"

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

/// measures the distortion of a map to the sphere: of each face and the summary.
SP::Distortion_summary measured_distortion(const Mesh& mesh, const Sphere_map& map, Distortion_map distortions);

/// returns the faces of each edge-connected component of a surface, in the order of decreasing size; components of the same size are in
/// the order of their first faces.
///
/// \param joins_borders whether border vertices at the same point are identified
std::vector<std::vector<std::size_t>> components_of(const File_content& surface, bool joins_borders);

/// returns the surface of some faces of a surface: with only their vertices, in the order of the file.
File_content part_of(const File_content& whole, const std::vector<std::size_t>& faces);

/// The mesh of a file, if a halfedge data structure can represent it. It also stores the faces as in the file, because `Surface_mesh` does
/// not preserve their first corners.
class Input_mesh
{
public:
  using Handle = SP::Handle<Mesh>;

  /// constructs the mesh from the content of the file `path`. The indices of vertices and faces are those of the file, unless `repair` is
  /// given and the surface needs repair.
  Input_mesh(const std::string& path, File_content surface, const std::optional<Repair_settings>& repair = {});

  /// returns the defect that prevents a map, its location, and what helps; empty if there is none. Parameterizers make the same check.
  ///
  /// \param advises whether the message names the commands that show handles
  std::string find_defect(bool advises = true) const;

  /// throws the defect that prevents a map as a `Program_error`.
  void check() const;

  /// returns a handle cycle of each handle, at most `max_handles`; see `SP::find_handles()`. Empty if the mesh has another defect.
  std::vector<Handle> find_handles(std::size_t max_handles) const;

  /// returns the length and the location of a handle cycle in words.
  static std::string describe(const Handle& handle);

  /// writes handle cycles, given by vertices of the file, as lines in a PLY file: vertices have their index in the file as a property, and
  /// edges the index of their handle.
  void write_cycles(std::ostream& out, const std::vector<std::vector<std::size_t>>& cycles) const;

  /// returns the file name for messages.
  const std::string& name() const { return m_name; }

  /// returns whether the file has a format of cortical surfaces.
  bool is_of_cortical_format() const { return m_is_of_cortical_format; }

  Mesh& mesh() { return m_mesh; }
  const Mesh& mesh() const { return m_mesh; }

  /// returns the repair; empty if none was requested.
  const std::optional<Repair_step>& repair() const { return m_repair; }

  /// returns whether a face belongs to a hole patch: of a hole, or of one side of a cut handle.
  bool is_patch(Mesh::Face_index f) const { return m_repair && m_repair->is_patch(f); }

  /// returns whether there are hole patches.
  bool has_patches() const { return m_repair && !m_repair->report().patches.empty(); }

  /// returns the number of vertices of the file.
  std::size_t number_of_vertices_of_file() const;

  /// returns the vertex for a vertex of the file, the first if there are several; `Mesh::null_vertex()` if it was removed.
  Vertex_index vertex_of(std::size_t vertex_of_file) const;

  /// transfers values of the vertices and faces of the file to the mesh.
  File_content transferred(File_content values) const;

  /// measures the distortion of a map of the mesh: of each face, and the summary without hole patches.
  SP::Distortion_summary measured(const Sphere_map& map, Distortion_map distortions) const;

  /// returns the metadata of a file of a cortical surface.
  const SP::IO::Surface_origin& origin() const { return m_origin; }

  /// returns the hemispheres of the files.
  const Hemispheres& hemispheres() const { return m_hemispheres; }

  /// returns the triangles, with corners in the order of the file.
  const std::vector<Polygon>& triangles() const { return m_polygons; }

  /// updates the triangles after edges of the mesh have been split. Existing triangles are unchanged.
  void take_triangles_of_mesh();

  /// returns the mesh with only its points, for writing with other properties.
  Mesh mesh_without_properties() const;

  /// writes the repaired surface. In a PLY file, the properties `source_vertex` and `source_face` are indices of vertices and faces of
  /// the file, -1 for new ones, and `patch` is 1 for faces of hole patches.
  void write_repaired(std::ostream& out, const std::string& format) const;

  /// reads arbitrary images of the vertices from a file with the faces of this mesh or of its file.
  Sphere_map read_images(const std::string& path);

  /// reads a bijective map of this mesh from a file.
  Sphere_map read_map(const std::string& path);

  /// checks that the file `path` has the number of vertices and the faces of this mesh, or of its file.
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
  std::optional<Repair_step> m_repair;
  std::vector<std::size_t> m_vertices, m_faces; // in the file, if the mesh is a part of it; else empty
};

} // namespace Program

#endif // PROGRAM_INPUT_MESH_H
