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

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

// Maps a mesh with one thread. For many meshes, one thread per mesh is faster than all threads for each mesh in turn.
SP::Distortion_summary map_to_sphere(const std::string& filename)
{
  SP::Distortion_summary distortion;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
    return distortion;
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Mesh::Point>("v:sphere").first;
  if(SP::parameterize<CGAL::Sequential_tag>(mesh, sphere) != SP::OK ||
     SP::measure_distortion<CGAL::Sequential_tag>(mesh, sphere, distortion) != SP::OK)
    return {};
  return distortion;
}

int main(int argc, char** argv)
{
  std::vector<std::string> filenames(argv + 1, argv + argc);
  if(filenames.empty())
    for(const char* name : {"meshes/bull.off", "meshes/homer.off", "meshes/man.off"})
      filenames.push_back(CGAL::data_file_path(name));

  std::vector<std::future<SP::Distortion_summary>> runs;
  for(const std::string& filename : filenames)
    runs.push_back(std::async(std::launch::async, map_to_sphere, filename));

  bool are_all_mapped = true;
  for(std::size_t i = 0; i < runs.size(); ++i)
  {
    const SP::Distortion_summary distortion = runs[i].get();
    are_all_mapped = are_all_mapped && distortion.number_of_faces > 0;
    std::cout << filenames[i] << ": ";
    if(distortion.number_of_faces > 0)
      std::cout << "isometric distortion at most " << distortion.isometric.maximum << std::endl;
    else
      std::cout << "no map" << std::endl;
  }
  return are_all_mapped ? EXIT_SUCCESS : EXIT_FAILURE;
}
