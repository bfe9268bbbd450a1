#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/sampling.h>
#include <CGAL/Spherical_parameterization/surface_maps.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Point_3 = Mesh::Point;
using Vertex = Mesh::Vertex_index;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/homer.off");
  Mesh first, second;
  if(!CGAL::IO::read_polygon_mesh(filename, first) ||
     !CGAL::IO::read_polygon_mesh((argc > 2) ? argv[2] : filename, second))
    return EXIT_FAILURE;
  if(argc <= 2) // use a twisted copy of the surface
    for(const Vertex v : second.vertices())
    {
      const Point_3 p = second.point(v);
      const double angle = 0.8 * p.y();
      second.point(v) = Point_3(std::cos(angle) * p.x() + std::sin(angle) * p.z(), p.y(),
                                std::cos(angle) * p.z() - std::sin(angle) * p.x());
    }

  auto sphere1 = first.add_property_map<Vertex, Point_3>("v:sphere").first;
  auto sphere2 = second.add_property_map<Vertex, Point_3>("v:sphere").first;
  auto directions = first.add_property_map<Vertex, Point_3>("v:directions").first; // images on the second sphere
  SP::Surface_mapper_3<Mesh> mapper;
  if(SP::parameterize(first, sphere1) != SP::OK || SP::parameterize(second, sphere2) != SP::OK ||
     SP::map_surface(first, sphere1, second, sphere2, mapper, directions) != SP::OK)
    return EXIT_FAILURE;
  std::cout << "energy " << mapper.report().energy << ", 2 for an isometry; margin of the alignment "
            << mapper.report().margin << std::endl;

  // Remesh the second surface with the faces of the first one.
  SP::Sphere_domain_3 domain;
  Mesh result;
  auto result_sphere = result.add_property_map<Vertex, Point_3>("v:sphere").first;
  if(SP::make_sphere_domain(first, directions, domain) != SP::OK ||
     SP::remesh_through_sphere(second, sphere2, domain, result, result_sphere) != SP::OK)
    return EXIT_FAILURE;
  CGAL::IO::write_polygon_mesh("first_on_second.off", result);

  // Compute the halfway morph, t = 0.5.
  for(const Vertex v : first.vertices())
    first.point(v) = CGAL::midpoint(first.point(v), result.point(v));
  CGAL::IO::write_polygon_mesh("half_way.off", first);
  return EXIT_SUCCESS;
}
