// All functions of meshes on spheres report the mistake first, and then what follows from it.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/Surface_maps/map_surface.h>
#include <CGAL/Surface_mesh.h>

namespace SP = CGAL::Spherical_parameterization;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

SP::Error_code call(Mesh& mesh)
{
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>();
  return SP::map_surface(mesh, sphere.first, mesh, sphere, sphere.first); // first error: it is .first
}
