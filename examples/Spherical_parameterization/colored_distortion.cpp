#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/homer.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Invalid input file: " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const SP::Error_code error = SP::parameterize(mesh, sphere);
  if(error != SP::OK)
  {
    std::cerr << SP::get_error_message(error) << std::endl;
    return EXIT_FAILURE;
  }

  auto distortion = mesh.add_property_map<Mesh::Face_index, SP::Face_distortion>("f:distortion").first;
  const double worst = SP::measure_distortion(mesh, sphere, distortion).isometric.maximum;

  // From blue, no distortion, to yellow, the largest one; PLY keeps the colours of the faces.
  auto colors = mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for(Mesh::Face_index f : mesh.faces())
  {
    const double t = (std::min)((distortion[f].isometric - 1.) / (worst - 1.), 1.);
    const unsigned char warm = static_cast<unsigned char>(255. * t), cold = static_cast<unsigned char>(255 - warm);
    colors[f] = CGAL::IO::Color(warm, warm, cold);
  }
  std::ofstream out("colored_distortion.ply", std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  return CGAL::IO::write_PLY(out, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
