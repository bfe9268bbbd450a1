#include "write_sphere.h"

#include "write_mesh.h"

#include <CGAL/Spherical_parameterization/Cortex/fit_rotation_to_surface.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/round_to_float.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>

namespace Program {

void turn_to_surface(Input_mesh& input, const Sphere_map& sphere, bool is_one_to_one)
{
  CGAL::Aff_transformation_3<CGAL::Exact_predicates_inexact_constructions_kernel> rotation(CGAL::IDENTITY);
  if(SP::fit_rotation_to_surface(input.mesh(), sphere, rotation) != SP::OK)
    return;
  for(const Vertex_index v : input.mesh().vertices())
  {
    const Point_3 p = sphere[v];
    const auto row = [&](int i) {
      return rotation.m(i, 0) * p.x() + rotation.m(i, 1) * p.y() + rotation.m(i, 2) * p.z();
    };
    sphere[v] = Point_3(row(0), row(1), row(2));
  }
  if(is_one_to_one && !SP::is_bijective(input.mesh(), sphere))
    throw error_in(input.name(),
                   "the sphere cannot be turned: its smallest faces fold by rounding.\n--convention none leaves it "
                   "as it is.");
}

void write_sphere(std::ostream& out, const std::string& path, const std::string& format, Input_mesh& input,
                  const Sphere_map& map, std::optional<double> radius)
{
  Sphere_map written = map;
  if(radius || is_cortical(format))
  {
    Mesh& mesh = input.mesh();
    written = mesh.add_property_map<Vertex_index, Point_3>("v:written", Point_3(0, 0, 0)).first;
    for(const Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v))
      {
        const Point_3& p = map[v];
        const double scale = radius ? *radius / std::hypot(p.x(), p.y(), p.z()) : 1.;
        written[v] = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
      }
    const bool is_held =
        is_cortical(format) ? SP::round_to_float(mesh, written, written) == SP::OK : SP::is_bijective(mesh, written);
    if(!is_held && SP::is_bijective(mesh, map))
      throw error_in(path, is_cortical(format)
                               ? "cannot hold the map: large parts of the surface have less room on the sphere than "
                                 "the numbers of 32 bits of this format tell apart.\nWrite a .off or .ply file, "
                                 "which have 64."
                               : "cannot hold the map with another radius: its smallest faces fold by rounding.\n"
                                 "--convention none leaves it as it is.");
  }
  write_mesh(out, format, input.points_of(written), input.triangles(), inherited(input.origin(), true));
}
} // namespace Program
