#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// Prints the progress and stops the run early, as a button in a user interface would.
struct Progress : SP::Default_visitor
{
  void on_level(std::size_t number_of_vertices) { std::cout << number_of_vertices << " vertices" << std::endl; }

  void after_iteration(std::size_t iteration, double energy, double radius)
  {
    std::cout << "sweep " << iteration << ": energy " << energy << ", radius " << radius << std::endl;
  }

  bool go_further(std::size_t iteration, double /* energy */) { return iteration < 20; }
};

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/homer.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Invalid input file: " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // The map is bijective, whether the run converges or is stopped by the visitor or the time limit in seconds.
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  Progress progress;
  const SP::Error_code error =
      SP::parameterize(mesh, sphere, CGAL::parameters::visitor(std::ref(progress)).maximum_running_time(10.));
  std::cout << SP::get_error_message(error) << std::endl;
  return (error == SP::OK && SP::is_bijective(mesh, sphere)) ? EXIT_SUCCESS : EXIT_FAILURE;
}
