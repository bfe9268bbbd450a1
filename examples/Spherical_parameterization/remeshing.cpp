#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/sampling.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Point_3 = Mesh::Point;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/bull.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
    return EXIT_FAILURE;

  // A map that distributes samples evenly over the surface
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  auto parameterizer = SP::Bijective_low_distortion_parameterizer_3<>()
                           .energy(SP::Stretch_energy_3())
                           .sharpness(SP::Sharpness::relative(3.))
                           .radius(SP::Area_preserving_radius_3());
  SP::Error_code error = SP::parameterize(mesh, parameterizer, sphere);

  // An octahedron with each face subdivided into 32 * 32 triangles
  Mesh remesh;
  auto remesh_sphere = remesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  if(error == SP::OK)
    error = SP::remesh_through_sphere(mesh, sphere, SP::Sphere_domain_3::octahedron(32), remesh, remesh_sphere);
  SP::Surface_distance distance;
  if(error == SP::OK)
    error = SP::measure_distance(mesh, remesh, distance);
  if(error != SP::OK)
  {
    std::cerr << SP::get_error_message(error) << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << num_vertices(remesh) << " vertices, " << distance.psnr() << " dB from the surface" << std::endl;
  return CGAL::IO::write_polygon_mesh("remesh.off", remesh, CGAL::parameters::stream_precision(17)) ? EXIT_SUCCESS
                                                                                                    : EXIT_FAILURE;
}
