#ifndef PROGRAM_WRITE_MESH_H
#define PROGRAM_WRITE_MESH_H

#include "Input_mesh.h"

#include <array>

namespace Program {

/// writes a file of a cortical surface, or of values of vertices if it has no points.
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
void write_mesh(std::ostream& out, const std::string& format, const std::vector<Point_3>& points,
                const std::vector<Polygon>& polygons, const SP::IO::Surface_origin& origin);

/// What is wrong with a file that should be a sphere.
inline const std::string no_sphere =
    "is no one-to-one sphere: not all of its faces are positively oriented as seen from "
    "the origin, or they do not cover the sphere once";

/// turns a sphere such that it lies as its surface does. A surface that does not show how leaves it as it is.
void turn_to_surface(Input_mesh& input, const Sphere_map& sphere);

/// writes the faces of a mesh with the images of its vertices on the sphere to the file `path`.
///
/// \param radius the images are moved to, if there is one
void write_sphere(std::ostream& out, const std::string& path, const std::string& format, Input_mesh& input,
                  const Sphere_map& map, std::optional<double> radius);

/// A distortion of each vertex, and the two that have the darkest colour and the lightest, which larger ones have as well.
struct Colored_distortion
{
  /// gives each vertex the average of its faces. The colours range from `min` to a value that is exceeded by one vertex in a
  /// hundred, because a single bad face would hide all others.
  ///
  /// \param distortions one for each face, at least `min`; those that are infinite are left out
  Colored_distortion(std::size_t number_of_vertices, const std::vector<Polygon>& faces,
                     const std::vector<double>& distortions, double min);

  std::vector<double> values; ///< 0 where there is none
  std::array<double, 2> range;
};

/// writes a PLY file with a colour per vertex: what all viewers of them understand. The distortion is there as a number, too, as
/// MeshLab's "quality".
void write_colored_mesh(std::ostream& out, const std::vector<Point_3>& points, const std::vector<Polygon>& faces,
                        const Colored_distortion& distortion);

} // namespace Program

#endif // PROGRAM_WRITE_MESH_H
