#ifndef PROGRAM_WRITE_SPHERE_H
#define PROGRAM_WRITE_SPHERE_H

#include "Input_mesh.h"

#include <optional>
#include <ostream>
#include <string>

namespace Program {

/// What is wrong with a file that should be a sphere.
inline const std::string no_sphere =
    "is no one-to-one sphere: not all of its faces are positively oriented as seen from "
    "the origin, or they do not cover the sphere once";

/// turns a sphere such that it lies as its surface does. A surface that does not tell leaves it as it is.
///
/// \throws Program_error if rounding folds a face of a map that is one-to-one
void turn_to_surface(Input_mesh& input, const Sphere_map& sphere);

/// writes the faces of a mesh with the images of its vertices on the sphere to the file `path`.
///
/// \param radius the images are moved to, if there is one
///
/// \throws Program_error if the map is one-to-one, and the numbers of the format are too short for that
void write_sphere(std::ostream& out, const std::string& path, const std::string& format, Input_mesh& input,
                  const Sphere_map& map, std::optional<double> radius);

} // namespace Program

#endif // PROGRAM_WRITE_SPHERE_H
