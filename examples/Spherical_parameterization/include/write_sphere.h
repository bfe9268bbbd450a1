#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SPHERE_H

#include "Input_mesh.h"
#include "Program_error.h"
#include "mesh_files.h"
#include "write_soup.h"

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Cortex/fit_rotation_to_surface.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/round_to_float.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <optional>
#include <ostream>
#include <string>

namespace Program {

/// The radius of the spheres of FreeSurfer and of the Connectome Workbench.
constexpr double radius_of_convention = 100.;

/// What is wrong with a file that should be a sphere.
inline const std::string no_sphere =
    "is no one-to-one sphere: not all of its faces are positively oriented as seen from "
    "the origin, or they do not cover the sphere once";

/// turns a sphere such that it lies as its surface does. A surface that does not tell leaves it as it is.
///
/// \throws Program_error if rounding folds a face of a map that is one-to-one
inline void turn_to_surface(Input_mesh& input, const Sphere_map& sphere, bool is_one_to_one)
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
    throw Program_error(
        input.name(), "the sphere cannot be turned: its smallest faces fold by rounding.\n--convention none leaves it "
                      "as it is.");
}

/// writes the faces of a mesh with the images of its vertices on the sphere to the file `path`.
///
/// \param radius the images are moved to, if there is one
///
/// \throws Program_error if the map is one-to-one, and the numbers of the format are too short for that
inline void write_sphere(std::ostream& out, const std::string& path, const std::string& format, Input_mesh& input,
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
      throw Program_error(path,
                          is_cortical(format)
                              ? "cannot hold the map: large parts of the surface have less room on the sphere than "
                                "the numbers of 32 bits of this format tell apart.\nWrite a .off or .ply file, "
                                "which have 64."
                              : "cannot hold the map with another radius: its smallest faces fold by rounding.\n"
                                "--convention none leaves it as it is.");
  }
  write_soup(out, format, input.points_of(written), input.triangles(), inherited(input.origin(), true));
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SPHERE_H
