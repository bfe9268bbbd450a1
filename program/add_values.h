#ifndef PROGRAM_ADD_VALUES_H
#define PROGRAM_ADD_VALUES_H

#include "Input_mesh.h"

#include <vector>

namespace Program {

/// gives a mesh properties of its vertices, or of its faces. The bytes red, green and blue become a colour, with alpha if that is a
/// byte as well. Normals are left out: a remesh has its own.
///
/// \returns the names of the other ones that are left out: CGAL's writer of PLY files uses them itself, or forgets them
Words add_values_of_vertices(Mesh& mesh, const std::vector<Values>& all);
Words add_values_of_faces(Mesh& mesh, const std::vector<Values>& all);

} // namespace Program

#endif // PROGRAM_ADD_VALUES_H
