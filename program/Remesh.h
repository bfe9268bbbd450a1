#ifndef PROGRAM_REMESH_H
#define PROGRAM_REMESH_H

#include "Run_report.h"

namespace Program {

/// removes the properties of vertices, or of faces, that a remesh cannot have: normals, because it has its own, and names that CGAL's PLY
/// writer uses itself or does not write. The bytes red, green and blue are a color; alpha is added if it is missing.
///
/// \returns the names of the removed properties, except normals
Words remove_reserved_names(std::vector<Values>& all, bool are_of_vertices);

/// adds properties to the vertices and faces of a mesh.
void add_values(Mesh& mesh, const std::vector<Values>& of_vertices, const std::vector<Values>& of_faces);

/// A remesh of a surface, sampled through its map to the sphere.
class Remesh
{
public:
  /// \param domain,n a solid and the number of segments per edge; or a file, and 0
  Remesh(Input_mesh& input, const Sphere_map& sphere, const std::string& domain, unsigned int n);

  /// returns the figures of the remesh, including its distances from the surface.
  Run_report::Remesh_figures figures(Input_mesh& input) const;

  /// writes the mesh; only PLY files include normals and properties.
  void write(std::ostream& out, const std::string& format) const;

  /// writes the transferred vertex values as a GIFTI file.
  void write_values(std::ostream& out, const std::string& format) const;

  /// writes a geometry image of the points or of the normals, as an OpenEXR or PNG file according to its name.
  void write_image(std::ostream& out, const std::string& name, bool shows_normals) const;

  /// transfers the properties of a file.
  void transfer_values(const Options& options, Input_mesh& input, const Sphere_map& sphere);

  /// adds the face property `patch`: 1 if most of a face belongs to hole patches.
  void mark_patches(Input_mesh& input, const Sphere_map& sphere);

private:
  // Transfers properties from a mesh with a map to the same sphere.
  void transfer(Input_mesh& source, const Sphere_map& sphere, std::vector<Values> of_vertices,
                std::vector<Values> of_faces);

  Mesh m_mesh;
  SP::IO::Surface_origin m_origin;
  Sphere_map m_images;
  std::vector<Values> m_values; // of vertices, transferred
  std::vector<SP::IO::Label> m_labels;
  std::set<std::string> m_label_names; // of the values that are label keys
  Mesh::Property_map<Vertex_index, Kernel::Vector_3> m_normals;
  std::string m_warnings;
};

} // namespace Program

#endif // PROGRAM_REMESH_H
