#include "write_sphere.h"

#include "write_mesh.h"

#include <CGAL/Spherical_parameterization/Cortex/rotate_to_surface.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/round_to_float.h>

#include <cmath>

namespace Program {

void turn_to_surface(Input_mesh& input, const Sphere_map& sphere)
{
  if(SP::rotate_to_surface(input.mesh(), sphere) == SP::ERROR_INSUFFICIENT_PRECISION)
    throw error_in(input.name(), "the sphere cannot be turned: its smallest faces fold by rounding.\n--convention none "
                                 "leaves it as it is.");
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
