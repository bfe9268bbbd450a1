#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/sampling.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/bull.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
    return EXIT_FAILURE;
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:sphere").first;
  SP::Error_code error = SP::parameterize(mesh, sphere);

  // The north pole is in the direction of the y-axis of the sphere, and the image center in that of the z-axis.
  Mesh textured;
  auto uv = textured.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  if(error == SP::OK)
    error = SP::compute_texture_coordinates(mesh, sphere, textured, uv, {0., 1., 0.}, {0., 0., 1.});
  std::ofstream out("textured.obj");
  if(error == SP::OK)
    error = SP::IO::write_OBJ(out, textured, uv);
  if(error != SP::OK)
  {
    std::cerr << SP::get_error_message(error) << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << num_vertices(textured) - num_vertices(mesh) << " vertices are new" << std::endl;
  return EXIT_SUCCESS;
}
