// What compiles and links fast and still needs all that the target brings along.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point_3>(mesh);
  return CGAL::Spherical_parameterization::is_bijective(mesh, mesh.points()) ? EXIT_SUCCESS : EXIT_FAILURE;
}
