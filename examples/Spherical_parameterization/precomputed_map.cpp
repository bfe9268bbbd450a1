#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Point_3 = Mesh::Point;
using Sphere_map = Mesh::Property_map<Mesh::Vertex_index, Point_3>;

auto going_on_from(const Sphere_map& map)
{
  return SP::Bijective_low_distortion_parameterizer_3().initial_parameterizer(SP::Precomputed_parameterizer_3(map));
}

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/homer.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
    return EXIT_FAILURE;

  // A first map, stopped early, and a second map that continues from it
  Sphere_map first = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:first").first;
  Sphere_map second = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:second").first;
  if(SP::parameterize(mesh, first, CGAL::parameters::number_of_iterations(5)) != SP::OK ||
     SP::parameterize(mesh, going_on_from(first), second) != SP::OK)
    return EXIT_FAILURE;
  SP::Distortion_summary of_first, of_second;
  if(SP::measure_distortion(mesh, first, of_first) != SP::OK ||
     SP::measure_distortion(mesh, second, of_second) != SP::OK)
    return EXIT_FAILURE;
  std::cout << "isometric distortion at most " << of_first.isometric.maximum << ", then " << of_second.isometric.maximum
            << std::endl;

  // Another pose of the surface with the same faces: slightly bent
  Mesh pose = mesh;
  for(const Mesh::Vertex_index v : pose.vertices())
  {
    const Point_3 p = mesh.point(v);
    pose.point(v) = Point_3(p.x() + 0.2 * std::sin(2. * p.y()), p.y(), p.z());
  }

  // A map that starts from the map of the first pose stays close to it, so that corresponding vertices have nearby
  // images.
  Sphere_map bent = pose.add_property_map<Mesh::Vertex_index, Point_3>("v:bent").first;
  if(SP::parameterize(pose, going_on_from(second), bent) != SP::OK)
    return EXIT_FAILURE;
  double largest_angle = 0.;
  for(const Mesh::Vertex_index v : mesh.vertices())
    largest_angle =
        (std::max)(largest_angle, CGAL::approximate_angle(second[v] - CGAL::ORIGIN, bent[v] - CGAL::ORIGIN));
  std::cout << "no image moved by more than " << largest_angle << " degrees" << std::endl;
  return EXIT_SUCCESS;
}
