#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/sampling.h>
#include <CGAL/Spherical_parameterization/surface_maps.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Point_3 = Mesh::Point;
using Vertex = Mesh::Vertex_index;

// Remeshes all surfaces with the faces of the first one: vertex i is the corresponding point on each of them.
int main(int argc, char** argv)
{
  std::vector<std::string> filenames(argv + 1, argv + argc);
  if(filenames.empty())
    filenames = {CGAL::data_file_path("meshes/bull.off"), CGAL::data_file_path("meshes/bull.off")};

  Mesh model;
  auto model_sphere = model.add_property_map<Vertex, Point_3>("v:sphere").first;
  if(!CGAL::IO::read_polygon_mesh(filenames.front(), model) || SP::parameterize(model, model_sphere) != SP::OK)
    return EXIT_FAILURE;
  auto directions = model.add_property_map<Vertex, Point_3>("v:directions").first;

  for(std::size_t k = 1; k < filenames.size(); ++k)
  {
    Mesh mesh, result;
    auto sphere = mesh.add_property_map<Vertex, Point_3>("v:sphere").first;
    auto result_sphere = result.add_property_map<Vertex, Point_3>("v:sphere").first;
    SP::Surface_mapper_3<Mesh> mapper;
    SP::Sphere_domain_3 domain;
    if(!CGAL::IO::read_polygon_mesh(filenames[k], mesh) || SP::parameterize(mesh, sphere) != SP::OK ||
       SP::map_surface(model, model_sphere, mesh, sphere, mapper, directions) != SP::OK ||
       SP::make_sphere_domain(model, directions, domain) != SP::OK ||
       SP::remesh_through_sphere(mesh, sphere, domain, result, result_sphere) != SP::OK)
    {
      std::cerr << filenames[k] << " is left out" << std::endl;
      continue;
    }
    std::cout << filenames[k] << ": energy " << mapper.report().energy << ", margin " << mapper.report().margin
              << std::endl;
    const std::string stem = std::filesystem::path(filenames[k]).stem().string();
    CGAL::IO::write_polygon_mesh(stem + "_" + std::to_string(k) + ".off", result);
  }
  return EXIT_SUCCESS;
}
