#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Point_3 = Mesh::Point;
using Location = PMP::Face_location<Mesh, double>;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/homer.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
    return EXIT_FAILURE;
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  if(SP::parameterize(mesh, sphere) != SP::OK)
    return EXIT_FAILURE;

  // The surface points along a meridian of the sphere, from pole to pole
  std::vector<Point_3> directions;
  for(int degrees = -90; degrees <= 90; ++degrees)
    directions.push_back(Point_3(std::cos(degrees * CGAL_PI / 180.), 0., std::sin(degrees * CGAL_PI / 180.)));

  const SP::Sphere_locator_3 locator(mesh, sphere);
  std::vector<Location> locations;
  const SP::Error_code error = locator.locate(directions, std::back_inserter(locations));
  if(error != SP::OK)
  {
    std::cerr << SP::get_error_message(error) << std::endl;
    return EXIT_FAILURE;
  }

  std::ofstream out("meridian.xyz");
  for(const Location& location : locations)
    out << PMP::construct_point(location, mesh) << '\n';

  // Locate single directions; the center of the sphere is not a direction.
  std::cout << "the north pole is in face " << locator.locate(Point_3(0., 0., 1.)).first << std::endl;
  return locator.locate(Point_3(0., 0., 0.)).first == Mesh::null_face() && out ? EXIT_SUCCESS : EXIT_FAILURE;
}
