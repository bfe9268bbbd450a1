#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/surface_maps.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Point_3 = Mesh::Point;
using Vertex = Mesh::Vertex_index;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/homer.off");
  Mesh first;
  if(!CGAL::IO::read_polygon_mesh(filename, first))
    return EXIT_FAILURE;
  Mesh second = first; // with other proportions
  for(const Vertex v : second.vertices())
  {
    const Point_3 p = second.point(v);
    second.point(v) = Point_3(1.5 * p.x(), p.y() + 0.3 * p.x() * p.x(), (0.8 + 0.5 * p.y()) * p.z());
  }

  auto sphere1 = first.add_property_map<Vertex, Point_3>("v:sphere").first;
  auto sphere2 = second.add_property_map<Vertex, Point_3>("v:sphere").first;
  auto directions = first.add_property_map<Vertex, Point_3>("v:directions").first;
  if(SP::parameterize(first, sphere1) != SP::OK || SP::parameterize(second, sphere2) != SP::OK)
    return EXIT_FAILURE;

  // Corresponding vertices: the extreme vertices along the axes
  std::vector<std::pair<Vertex, Vertex>> landmarks;
  for(const int axis : {0, 1, 2})
    for(const double sign : {-1., 1.})
    {
      const Vertex end = *std::max_element(first.vertices().begin(), first.vertices().end(), [&](Vertex v, Vertex w) {
        return sign * first.point(v)[axis] < sign * first.point(w)[axis];
      });
      landmarks.emplace_back(end, end);
    }

  auto mapper = SP::Surface_mapper_3<Mesh>().landmarks(landmarks);
  const SP::Error_code error = SP::map_surface(first, sphere1, second, sphere2, mapper, directions);
  if(error != SP::OK)
  {
    std::cerr << SP::get_error_message(error) << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "energy " << mapper.report().energy << ", " << mapper.report().number_of_missed_landmarks << " of "
            << landmarks.size() << " landmarks are missed" << std::endl;
  return EXIT_SUCCESS;
}
