#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Color = CGAL::IO::Color;

namespace SP = CGAL::Spherical_parameterization;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/bull.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Invalid input file: " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Mesh::Point>("v:sphere").first;
  auto distortion = mesh.add_property_map<Mesh::Face_index, SP::Face_distortion>("f:distortion").first;
  SP::Distortion_summary summary;
  SP::Error_code error = SP::parameterize(mesh, sphere);
  if(error == SP::OK)
    error = SP::measure_distortion(mesh, sphere, summary, distortion);
  if(error != SP::OK)
  {
    std::cerr << SP::get_error_message(error) << std::endl;
    return EXIT_FAILURE;
  }

  // Colors from white (isometry) to dark red (at least four standard deviations above the average, or infinite)
  const double largest = summary.isometric.average + 4. * summary.isometric.deviation;
  auto color = mesh.add_property_map<Mesh::Face_index, Color>("f:color").first;
  for(const Mesh::Face_index f : mesh.faces())
  {
    const double t = (std::min)((distortion[f].isometric - 1.) / (largest - 1.), 1.);
    const auto channel = [t](double end) { return static_cast<unsigned char>(255. + t * (end - 255.)); };
    color[f] = Color(channel(140.), channel(0.), channel(20.));
  }

  CGAL::IO::write_PLY("surface.ply", mesh);
  for(const Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = sphere[v];
  CGAL::IO::write_PLY("sphere.ply", mesh);
  std::cout << "surface.ply, sphere.ply: isometric distortion from 1 to " << largest << std::endl;
  return EXIT_SUCCESS;
}
