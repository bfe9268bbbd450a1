#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/repair.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

// Cures one defect in the simplest way, and returns whether there is one.
bool repair(Mesh& mesh, const SP::Mesh_defect<Mesh>& defect)
{
  switch(defect.error)
  {
  case SP::ERROR_NON_TRIANGULAR_MESH:
    return PMP::triangulate_faces(mesh);
  case SP::ERROR_SEVERAL_COMPONENTS:
    PMP::keep_largest_connected_components(mesh, 1);
    return true;
  case SP::ERROR_NON_CLOSED_MESH: {
    std::vector<SP::Filled_hole<Mesh>> holes;
    return SP::fill_holes(mesh, holes) == SP::OK && !holes.empty();
  }
  default:
    return false;
  }
}

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/nefertiti.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
    return EXIT_FAILURE;

  for(SP::Mesh_defect<Mesh> defect = SP::find_defect(mesh); defect.error != SP::OK; defect = SP::find_defect(mesh))
  {
    std::cout << defect.message << std::endl;
    if(!repair(mesh, defect))
      return EXIT_FAILURE;
    mesh.collect_garbage();
  }

  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Mesh::Point>("v:sphere").first;
  return SP::parameterize(mesh, sphere) == SP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
