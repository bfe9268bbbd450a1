#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/spherical_parameterization.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Polyhedron_3<Kernel>;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/homer.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Invalid input file: " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Any property map can be used. A dynamic property map works for all mesh types and is destroyed with its last copy.
  auto sphere = get(CGAL::dynamic_vertex_property_t<Point_3>(), mesh);
  const SP::Error_code error = SP::parameterize(mesh, sphere);
  if(error != SP::OK)
  {
    std::cerr << SP::get_error_message(error) << std::endl;
    return EXIT_FAILURE;
  }

  // Move the vertices of the mesh to their images on the sphere.
  for(auto v : vertices(mesh))
    v->point() = get(sphere, v);
  return CGAL::IO::write_polygon_mesh("polyhedron_on_sphere.off", mesh, CGAL::parameters::stream_precision(17))
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
