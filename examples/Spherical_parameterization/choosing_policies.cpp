#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/bunny00.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Invalid input file: " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Sharpness values from the lowest average distortion to the lowest maximum distortion
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  for(const double beta : {0., 3., 20., 40.})
  {
    auto parameterizer = SP::Bijective_low_distortion_parameterizer_3().sharpness(SP::Sharpness::relative(beta));
    SP::Distortion_summary distortion;
    SP::Error_code error = SP::parameterize(mesh, parameterizer, sphere);
    if(error == SP::OK)
      error = SP::measure_distortion(mesh, sphere, distortion);
    if(error != SP::OK)
    {
      std::cerr << SP::get_error_message(error) << std::endl;
      return EXIT_FAILURE;
    }

    std::cout << "beta " << beta << ": isometric distortion " << distortion.isometric.average << " on average and "
              << distortion.isometric.maximum << " at most, " << parameterizer.report().number_of_iterations()
              << " sweeps, " << SP::get_stop_message(parameterizer.report().stop_reason) << std::endl;
  }
  return EXIT_SUCCESS;
}
