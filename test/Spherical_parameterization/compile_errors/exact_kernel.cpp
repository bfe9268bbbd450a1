// -ffast-math
//
// The predicates of an exact kernel are CGAL's own, and these are wrong with such a flag.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Surface_mesh.h>

bool is_bijective(const CGAL::Surface_mesh<CGAL::Epeck::Point_3>& mesh)
{
  return CGAL::Spherical_parameterization::is_bijective(mesh, mesh.points()); // error: or use points with coordinates
}
