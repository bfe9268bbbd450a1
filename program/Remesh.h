#ifndef PROGRAM_REMESH_H
#define PROGRAM_REMESH_H

#include "Run_report.h"

namespace Program {

/// leaves out the properties of vertices, or of faces, that a remesh cannot have: normals, as it has its own, and names that CGAL's
/// writer of PLY files uses itself, or forgets. The bytes red, green and blue are a colour, which gets an alpha if there is none.
///
/// \returns the names that are left out, but for normals
Words leave_out_taken_names(std::vector<Values>& all, bool are_of_vertices);

/// gives a mesh properties of its vertices and faces.
void add_values(Mesh& mesh, const std::vector<Values>& of_vertices, const std::vector<Values>& of_faces);

/// The surface, sampled through its map to the sphere.
class Remesh
{
public:
  /// \param domain,n a solid and what its edges are divided into; or a file, and 0
  Remesh(Input_mesh& input, const Sphere_map& sphere, const std::string& domain, unsigned int n);

  /// returns what is told of it, with its distances from the surface.
  Run_report::Remesh_figures figures(Input_mesh& input) const;

  /// writes the mesh; normals and properties are for PLY files only.
  void write(std::ostream& out, const std::string& format) const;

  /// writes the values that have been carried over to the vertices as a GIFTI file.
  void write_values(std::ostream& out, const std::string& format) const;

  /// writes a geometry image of the points, or of the normals; as an OpenEXR file or a PNG file, as its name says.
  void write_image(std::ostream& out, const std::string& name, bool shows_normals) const;

  /// carries over the properties of a file.
  void carry_values(const Options& options, Input_mesh& input, const Sphere_map& sphere);

  /// gives the faces the property `patch`: 1 where most of a face is of what closes the surface.
  void mark_patches(Input_mesh& input, const Sphere_map& sphere);

private:
  // Carries properties over from a mesh that has a map to the same sphere.
  void carry(Input_mesh& source, const Sphere_map& sphere, std::vector<Values> of_vertices,
             std::vector<Values> of_faces);

  Mesh m_mesh;
  SP::IO::Surface_origin m_origin;
  Sphere_map m_images;
  std::vector<Values> m_values; // of vertices, as they have been carried over
  std::vector<SP::IO::Label> m_labels;
  std::set<std::string> m_label_names; // of the values that are keys of them
  Mesh::Property_map<Vertex_index, Kernel::Vector_3> m_normals;
  std::string m_warnings;
};

} // namespace Program

#endif // PROGRAM_REMESH_H
