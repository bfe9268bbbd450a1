#ifndef PROGRAM_WRITE_MESH_H
#define PROGRAM_WRITE_MESH_H

#include "File_content.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace Program {

/// writes a file of a cortical surface, or of values of vertices if it has no points.
///
/// \throws Program_error if the format cannot hold it, or the program was built without what it takes
///
/// \param n_triangles of the surface, which files of values of FreeSurfer tell
void write_surface_file(std::ostream& out, const std::string& format, const SP::IO::Surface_file& file,
                        std::size_t n_triangles = 0);

/// returns what is told of a surface that is made of another one.
///
/// \param is_sphere whether that is its image on the sphere
SP::IO::Surface_origin inherited(SP::IO::Surface_origin origin, bool is_sphere);

/// writes a mesh in one of the output formats. Coordinates do not change if they are read again, unless the format has short numbers.
///
/// To a stream, since a stream tells whether the last byte has been written.
///
/// \param origin what files of cortical surfaces tell beside the mesh
///
/// \throws Program_error if the format cannot hold the mesh, or the program was built without what it takes
void write_mesh(std::ostream& out, const std::string& format, const std::vector<Point_3>& points,
                const std::vector<Polygon>& polygons, const SP::IO::Surface_origin& origin);

} // namespace Program

#endif // PROGRAM_WRITE_MESH_H
