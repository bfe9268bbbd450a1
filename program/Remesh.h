#ifndef PROGRAM_REMESH_H
#define PROGRAM_REMESH_H

#include "Input_mesh.h"
#include "Options.h"
#include "Run_report.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace Program {

/// The surface, sampled through its map to the sphere.
class Remesh
{
public:
  /// \param domain,n a solid and what its edges are divided into; or a file, and 0
  ///
  /// \throws Program_error if the domain is not in order
  Remesh(Input_mesh& input, const Sphere_map& sphere, const std::string& domain, unsigned int n);

  /// returns what is told of it, with its distances from the surface.
  ///
  /// \throws Program_error if they cannot be measured
  Run_report::Remesh_figures figures(Input_mesh& input) const;

  /// writes the mesh; normals and properties are for PLY files only.
  void write(std::ostream& out, const std::string& format) const;

  /// writes the values that have been carried over to the vertices as a GIFTI file.
  ///
  /// \throws Program_error if a number is too large for it
  void write_values(std::ostream& out, const std::string& format);

  /// writes a geometry image of the points, or of the normals; as an OpenEXR file or a PNG file, as its name says.
  ///
  /// \throws Program_error if that fails
  void write_image(std::ostream& out, const std::string& name, bool shows_normals) const;

  /// carries over the properties of a file.
  ///
  /// \throws Program_error if the file, or the sphere of its surface, is not in order
  void carry_values(const Options& options, Input_mesh& input, const Sphere_map& sphere);

  /// gives the faces the property `filler`: 1 where most of a face is what a hole has been filled with.
  ///
  /// \throws Program_error if that fails
  void mark_filler(Input_mesh& input, const Sphere_map& sphere);

private:
  // Gives values the surface that they are of, if their file has none.
  static void add_surface(File_content& values, const Options& options, Input_mesh& input);

  Mesh m_mesh;
  SP::IO::Surface_origin m_origin;
  Sphere_map m_images;
  std::vector<Values> m_values; // of vertices, without the numbers
  std::vector<SP::IO::Label> m_labels;
  Mesh::Property_map<Vertex_index, Kernel::Vector_3> m_normals;
  std::string m_warnings;
};

} // namespace Program

#endif // PROGRAM_REMESH_H
