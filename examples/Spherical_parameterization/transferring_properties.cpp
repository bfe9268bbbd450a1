#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/sampling.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <tuple>
#include <utility>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/homer.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
    return EXIT_FAILURE;
  auto sphere = mesh.add_property_map<Vertex, Mesh::Point>("v:sphere").first;
  if(SP::parameterize(mesh, sphere) != SP::OK)
    return EXIT_FAILURE;

  // A measured value at each vertex, and a label of each face
  auto height = mesh.add_property_map<Vertex, double>("v:height").first;
  for(const Vertex v : mesh.vertices())
    height[v] = mesh.point(v).z();
  auto part = mesh.add_property_map<Face, int>("f:part").first;
  for(const Face f : mesh.faces())
    part[f] = mesh.point(mesh.target(mesh.halfedge(f))).x() > 0. ? 1 : 0;

  // Transfer from the surface to a mesh of the sphere that is common to all surfaces, and back.
  Mesh standard;
  const SP::Sphere_domain_3 domain = SP::Sphere_domain_3::icosahedron(20);
  PMP::polygon_soup_to_polygon_mesh(domain.directions(), domain.triangles(), standard);
  auto standard_height = standard.add_property_map<Vertex, double>("v:height").first;
  auto standard_part = standard.add_property_map<Face, int>("f:part").first;
  auto height_again = mesh.add_property_map<Vertex, double>("v:height_again").first;
  if(SP::transfer(mesh, sphere, standard, standard.points(),
                  std::tuple(std::pair(height, standard_height), std::pair(part, standard_part))) != SP::OK ||
     SP::transfer(standard, standard.points(), mesh, sphere, std::pair(standard_height, height_again)) != SP::OK)
    return EXIT_FAILURE;

  double sum = 0.;
  for(const Vertex v : mesh.vertices())
    sum += std::abs(height_again[v] - height[v]);
  std::cout << "through " << num_vertices(standard) << " vertices and back, the mean change is "
            << sum / static_cast<double>(num_vertices(mesh)) << std::endl;
  return EXIT_SUCCESS;
}
