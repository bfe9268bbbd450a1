#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/number_type_config.h>
#include <CGAL/spherical_parameterization.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// Longitude and latitude, each from 0 to 1: where an image of the whole globe shows the point.
std::array<double, 2> texture_coordinates(const Point_3& p)
{
  return {0.5 + std::atan2(p.y(), p.x()) / (2. * CGAL_PI), 0.5 + std::atan2(p.z(), std::hypot(p.x(), p.y())) / CGAL_PI};
}

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/bull.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Invalid input file: " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const SP::Error_code error = SP::parameterize(mesh, sphere);
  if(error != SP::OK)
  {
    std::cerr << SP::get_error_message(error) << std::endl;
    return EXIT_FAILURE;
  }

  std::ofstream out("textured.obj");
  out.precision(17);
  for(const Mesh::Vertex_index v : mesh.vertices())
    out << "v " << mesh.point(v) << '\n';

  // Each corner of a face has coordinates of its own, as a face across the date line has to go on
  // beyond 0 or 1. The texture has to be repeated in the first direction.
  std::size_t n_corners = 0, n_across = 0;
  for(const Mesh::Face_index f : mesh.faces())
  {
    const double longitude = texture_coordinates(sphere[target(halfedge(f, mesh), mesh)])[0];
    bool is_across = false;
    std::string face = "f";
    for(const Mesh::Vertex_index v : vertices_around_face(halfedge(f, mesh), mesh))
    {
      std::array<double, 2> uv = texture_coordinates(sphere[v]);
      const double turns = std::round(uv[0] - longitude);
      is_across = is_across || turns != 0.;
      out << "vt " << uv[0] - turns << ' ' << uv[1] << '\n';
      face += ' ' + std::to_string(v.idx() + 1) + '/' + std::to_string(++n_corners);
    }
    out << face << '\n';
    n_across += is_across;
  }
  std::cout << "textured.obj: " << mesh.number_of_faces() << " faces, " << n_across << " across the date line"
            << std::endl;
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
