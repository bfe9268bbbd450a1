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
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Point_3 = Mesh::Point;

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
    return EXIT_FAILURE;

  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  if(SP::parameterize(mesh, sphere) != SP::OK)
    return EXIT_FAILURE;

  std::ofstream out("textured.obj");
  out.precision(17);
  for(const Mesh::Vertex_index v : mesh.vertices())
    out << "v " << mesh.point(v) << '\n';

  // Each corner of a face has coordinates of its own, as a face across the date line has to go on
  // beyond 0 or 1. The texture has to be repeated in the first direction.
  std::size_t n_corners = 0;
  for(const Mesh::Face_index f : mesh.faces())
  {
    const double longitude = texture_coordinates(sphere[target(halfedge(f, mesh), mesh)])[0];
    std::string face = "f";
    for(const Mesh::Vertex_index v : vertices_around_face(halfedge(f, mesh), mesh))
    {
      const std::array<double, 2> uv = texture_coordinates(sphere[v]);
      out << "vt " << uv[0] - std::round(uv[0] - longitude) << ' ' << uv[1] << '\n';
      face += ' ' + std::to_string(v.idx() + 1) + '/' + std::to_string(++n_corners);
    }
    out << face << '\n';
  }
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
