#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/homer.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Invalid input file: " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Equivalent to parameterize(mesh, sphere), but the parameterizer provides a report.
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Mesh::Point>("v:sphere").first;
  SP::Bijective_low_distortion_parameterizer_3 method;
  const SP::Error_code error = SP::parameterize(mesh, method, sphere);
  const SP::Parameterization_report& report = method.report();
  std::cout << SP::get_error_message(error) << '\n'
            << report.number_of_vertices << " vertices, " << report.number_of_levels << " levels\n"
            << report.number_of_iterations() << " sweeps over the mesh, " << SP::get_stop_message(report.stop_reason)
            << "\naverage energy " << report.initial_energy << " at first, " << report.average_energy
            << " at last; largest " << report.largest_energy << "\nradius " << report.radius << '\n'
            << report.seconds() << " seconds, " << report.seconds_for_optimization << " of them for the sweeps"
            << std::endl;
  return error == SP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
