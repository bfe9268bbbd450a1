#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_REMESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_REMESH_H

#include "Input_mesh.h"
#include "Polygon_soup.h"
#include "Program_error.h"
#include "Program_options.h"
#include "add_values.h"
#include "mesh_files.h"
#include "read_soup.h"
#include "write_soup.h"

#ifdef PROGRAM_WRITES_EXR
#include <CGAL/Spherical_parameterization/IO/EXR_geometry_image.h>
#endif
#ifdef PROGRAM_WRITES_PNG
#include <CGAL/Spherical_parameterization/IO/PNG_geometry_image.h>
#endif

#include <CGAL/IO/PLY.h>
#include <CGAL/IO/io.h>
#include <CGAL/Spherical_parameterization/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/remesh_through_sphere.h>
#include <CGAL/Spherical_parameterization/transfer.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Program {

/// The surface, sampled through its map to the sphere.
class Remesh
{
public:
  /// \throws Program_error if the domain is not in order
  Remesh(Input_mesh& input, const Sphere_map& sphere, const SP::Sphere_domain_3& domain)
    : m_images(m_mesh.add_property_map<Vertex_index, Point_3>("images of vertices").first) // no name in a PLY file
    , m_normals(m_mesh.add_property_map<Vertex_index, Kernel::Vector_3>("v:normal").first)
  {
    const SP::Error_code error =
        SP::remesh_through_sphere(input.mesh(), sphere, domain, m_mesh, m_images, CGAL::parameters::default_values(),
                                  CGAL::parameters::vertex_normal_map(m_normals));
    if(error != SP::OK)
      throw Program_error(input.name() + ": " + SP::get_error_message(error));
  }

  const Mesh& mesh() const { return m_mesh; }

  /// writes the mesh; normals and properties are for PLY files only.
  void write(std::ostream& out, const std::string& format) const
  {
    if(format == ".ply")
    {
      CGAL::IO::set_binary_mode(out);
      CGAL::IO::write_PLY(out, m_mesh, CGAL::parameters::stream_precision(17));
      return;
    }
    std::vector<Polygon> triangles;
    triangles.reserve(m_mesh.number_of_faces());
    for(const Mesh::Face_index f : m_mesh.faces())
    {
      const Mesh::Halfedge_index h = m_mesh.halfedge(f);
      triangles.emplace_back();
      for(const Vertex_index v : {m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h))})
        triangles.back().push_back(v);
    }
    write_soup(out, format, std::vector<Point_3>(m_mesh.points().begin(), m_mesh.points().end()), triangles);
  }

  /// writes a geometry image of the points, or of the normals; as an OpenEXR file or a PNG file, as its name says.
  ///
  /// \throws Program_error if that fails
  void write_image(std::ostream& out, const std::string& name, bool shows_normals) const
  {
    const std::string format = file_format(name);
    const SP::Error_code error =
        shows_normals ? write_image(out, format, m_normals) : write_image(out, format, m_mesh.points());
    if(error != SP::OK)
      throw Program_error(name, SP::get_error_message(error));
  }

  /// returns the domain that the options name.
  ///
  /// \throws Program_error if it is a file that is not in order
  static SP::Sphere_domain_3 find_domain(const Program_options& options)
  {
    const unsigned int n = options.domain_size;
    if(options.domain == "octahedron")
      return SP::Sphere_domain_3::octahedron(n);
    if(options.domain == "cube")
      return SP::Sphere_domain_3::cube(n);
    if(options.domain == "icosahedron")
      return SP::Sphere_domain_3::icosahedron(n);
    Input_mesh mesh(options.domain, read_soup(options.domain));
    SP::Sphere_domain_3 domain;
    const SP::Error_code error = SP::make_sphere_domain(mesh.mesh(), mesh.mesh().points(), domain);
    if(error == SP::ERROR_NO_1_TO_1_MAPPING)
      throw Program_error(options.domain, "is no mesh of the sphere to sample by: not all of its faces are positively "
                                          "oriented as seen from the origin, or they do not cover the sphere once");
    if(error != SP::OK)
      throw Program_error(mesh.find_defect());
    return domain;
  }

  /// carries over the properties of a file.
  ///
  /// \throws Program_error if the file, or the sphere of its surface, is not in order
  void carry_values(const Program_options& options, const Input_mesh& input, const Sphere_map& sphere)
  {
    const std::string& name = options.values_file;
    const bool is_of_input = options.values_sphere.empty();
    Polygon_soup soup = read_soup(name, true);
    const std::vector<Values> of_vertices = std::move(soup.values_of_vertices),
                              of_faces = std::move(soup.values_of_faces);
    Words left_out = std::move(soup.left_out);
    Input_mesh values(name, std::move(soup));
    if(is_of_input)
      input.check_faces_of(name, "has no values for this mesh", values.mesh().number_of_vertices(), values.triangles());
    for(const std::string& property : add_values<Vertex_index>(values.mesh(), of_vertices))
      left_out.push_back("the property '" + printable(property) + "' of the vertices, whose name is taken");
    for(const std::string& property : add_values<Mesh::Face_index>(values.mesh(), of_faces))
      left_out.push_back("the property '" + printable(property) + "' of the faces, whose name is taken");
    for(const std::string& what : left_out)
      m_warnings += printable(name) + ": not carried over: " + what + '\n';

    const Sphere_map values_sphere = is_of_input ? sphere : values.read_map(options.values_sphere);
    const SP::Error_code error = SP::transfer(values.mesh(), values_sphere, m_mesh, m_images);
    if(error != SP::OK)
      throw Program_error(name, SP::get_error_message(error));
  }

  /// gives the faces the property `filler`: 1 where most of a face is what a hole has been filled with.
  ///
  /// \throws Program_error if that fails
  void mark_filler(Input_mesh& input, const Sphere_map& sphere)
  {
    const auto of_input = input.mesh().add_property_map<Mesh::Face_index, std::uint8_t>("f:filler", 0).first,
               of_remesh = m_mesh.add_property_map<Mesh::Face_index, std::uint8_t>("f:filler", 0).first;
    for(const Mesh::Face_index f : input.mesh().faces())
      of_input[f] = input.is_filler(f) ? 1 : 0;
    const SP::Error_code error = SP::transfer(input.mesh(), sphere, m_mesh, m_images, std::pair(of_input, of_remesh));
    if(error != SP::OK)
      throw Program_error(input.name() + ": " + SP::get_error_message(error));
  }

  /// returns what is to be said of the properties that are not carried over, a line each, empty if there is none.
  const std::string& warnings() const { return m_warnings; }

private:
  template <class Map>
  SP::Error_code write_image([[maybe_unused]] std::ostream& out, const std::string& format,
                             [[maybe_unused]] const Map& map) const
  {
#ifdef PROGRAM_WRITES_EXR
    if(format == ".exr")
      return SP::IO::write_EXR_geometry_image(out, m_mesh, map);
#endif
#ifdef PROGRAM_WRITES_PNG
    if(format == ".png")
      return SP::IO::write_PNG_geometry_image(out, m_mesh, map);
#endif
    throw Program_error("this program was built without the library that writes " + format + " files");
  }

  Mesh m_mesh;
  Sphere_map m_images;
  Mesh::Property_map<Vertex_index, Kernel::Vector_3> m_normals;
  std::string m_warnings;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_REMESH_H
