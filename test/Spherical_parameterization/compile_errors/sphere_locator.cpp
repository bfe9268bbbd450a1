// A class reports the mistake first, and then what follows from it.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/Sphere_locator_3.h>
#include <CGAL/Surface_mesh.h>

namespace SP = CGAL::Spherical_parameterization;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

void call(Mesh& mesh)
{
  SP::Sphere_locator_3(mesh, mesh.add_property_map<Mesh::Vertex_index, Point_3>()); // first error: it is .first
}
