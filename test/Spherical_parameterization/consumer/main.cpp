#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/spherical_parameterization.h>

#include <cstdlib>
#include <iostream>

namespace SP = CGAL::Spherical_parameterization;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point_3>(mesh);

  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const SP::Error_code result = SP::parameterize(mesh, sphere);
  if(result != SP::OK)
  {
    std::cerr << SP::get_error_message(result) << std::endl;
    return EXIT_FAILURE;
  }
  if(!SP::is_bijective(mesh, sphere))
  {
    std::cerr << "The map is not bijective." << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "OK" << std::endl;
  return EXIT_SUCCESS;
}
