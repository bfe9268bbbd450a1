// A fuzzer for the way from a file to a mesh in the command line program. The first byte chooses the format, the others
// are the file. Whatever they are, they are refused with a message for a person, or are a mesh that can be mapped, or one
// with a defect that the library reports.

#include "Fuzzed_bytes.h"
#include "require.h"

#include "Input_mesh.h"
#include "Remesh.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Spherical_parameterization/internal/files/read_mesh_file.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/tags.h>

namespace SP = CGAL::Spherical_parameterization;

namespace {

void check_mesh(Program::Input_mesh& input)
{
  const std::string defect = input.find_defect();
  require(defect.empty() || is_message(defect), defect.c_str());
  Program::Mesh& mesh = input.mesh();
  constexpr std::size_t max_vertices = 200; // more take too long
  if(mesh.number_of_vertices() > max_vertices)
    return;
  const Program::Sphere_map sphere =
      mesh.add_property_map<Program::Vertex_index, Program::Point_3>("v:sphere", Program::Point_3(0, 0, 0)).first;
  const SP::Error_code error =
      SP::parameterize<CGAL::Sequential_tag>(mesh, sphere, CGAL::parameters::number_of_iterations(2));
  // doubles may not suffice for the size of the mesh
  require(defect.empty() == (error == SP::OK || error == SP::ERROR_INSUFFICIENT_PRECISION),
          SP::get_error_message(error));
  require(!defect.empty() || SP::is_bijective(mesh, sphere) == (error == SP::OK), "the map is not one-to-one");
}

Program::File_content read(const std::string& format, const std::string& content, bool keeps_values = false)
{
  return {SP::internal::read_mesh_file(format, content, keeps_values)};
}

// the properties of its vertices and faces, which are carried over
void check_values(Program::File_content soup)
{
  std::vector<Program::Values> of_vertices = std::move(soup.values_of_vertices),
                               of_faces = std::move(soup.values_of_faces);
  for(const Program::Values& values : of_vertices)
    require(values.numbers.size() == soup.points.size(), "a property has not as many numbers as there are vertices");
  for(const Program::Values& values : of_faces)
    require(values.numbers.size() == soup.polygons.size(), "a property has not as many numbers as there are faces");
  Program::Input_mesh input("file", std::move(soup));
  Program::remove_reserved_names(of_vertices, true);
  Program::remove_reserved_names(of_faces, false);
  Program::add_values(input.mesh(), of_vertices, of_faces);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Fuzzed_bytes bytes(data, size);
  const std::string format = Program::input_formats[bytes.below(Program::input_formats.size())];
  const std::string content = bytes.rest();
  require_message_or_nothing([&] {
    Program::Input_mesh input("file" + format, read(format, content));
    check_mesh(input);
  });
  if(format == ".ply")
    require_message_or_nothing([&] { check_values(read(format, content, true)); });
  return 0;
}
