#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <cstdlib>
#include <future>
#include <iostream>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

struct Outcome
{
  SP::Error_code error = SP::ERROR_EMPTY_MESH;
  SP::Distortion_summary distortion;
};

// One thread for each mesh: if there are many, this takes less time than all threads for one mesh
// after the other.
Outcome map_to_sphere(const std::string& filename)
{
  Outcome outcome;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
    return outcome;
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  outcome.error = SP::parameterize<CGAL::Sequential_tag>(mesh, sphere);
  if(outcome.error == SP::OK)
    outcome.distortion = SP::measure_distortion(mesh, sphere);
  return outcome;
}

int main(int argc, char** argv)
{
  std::vector<std::string> filenames(argv + 1, argv + argc);
  if(filenames.empty())
    for(const char* name : {"meshes/bull.off", "meshes/homer.off", "meshes/man.off"})
      filenames.push_back(CGAL::data_file_path(name));

  std::vector<std::future<Outcome>> runs;
  for(const std::string& filename : filenames)
    runs.push_back(std::async(std::launch::async, map_to_sphere, filename));

  bool are_all_mapped = true;
  for(std::size_t i = 0; i < runs.size(); ++i)
  {
    const Outcome outcome = runs[i].get();
    are_all_mapped = are_all_mapped && outcome.error == SP::OK;
    std::cout << filenames[i] << ": ";
    if(outcome.error == SP::OK)
      std::cout << "isometric distortion at most " << outcome.distortion.isometric.maximum << std::endl;
    else
      std::cout << SP::get_error_message(outcome.error) << std::endl;
  }
  return are_all_mapped ? EXIT_SUCCESS : EXIT_FAILURE;
}
