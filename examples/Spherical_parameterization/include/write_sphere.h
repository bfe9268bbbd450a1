#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SPHERE_H

#include "Input_mesh.h"
#include "write_soup.h"

#include <ostream>
#include <string>

namespace Program {

/// writes the faces of a mesh with the images of its vertices on the sphere to the file `path`.
///
/// \throws Program_error if the numbers of the format are too short for the map
inline void write_sphere(std::ostream& out, const std::string& path, const std::string& format, Input_mesh& input,
                         const Sphere_map& map)
{
  if(has_short_numbers(format))
    input.check_rounded(path, map);
  write_soup(out, format, input.points_of(map), input.triangles(), inherited(input.origin(), true));
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SPHERE_H
