#ifndef PROGRAM_WRITE_MESH_H
#define PROGRAM_WRITE_MESH_H

#include "Input_mesh.h"

#include <array>

namespace Program {

/// writes a file of a cortical surface, or of vertex values if it has no points.
///
/// \param n_triangles of the surface, which FreeSurfer files of values contain
void write_surface_file(std::ostream& out, const std::string& format, const SP::IO::Surface_file& file,
                        std::size_t n_triangles = 0);

/// returns the metadata of a surface that is derived from another one.
///
/// \param is_sphere whether the derived surface is its image on the sphere
SP::IO::Surface_origin inherited(SP::IO::Surface_origin origin, bool is_sphere);

/// writes a mesh in one of the output formats. Coordinates are the same after reading, unless the format has single precision.
///
/// Writes to a stream, whose state shows whether the last byte has been written.
///
/// \param origin metadata for files of cortical surfaces
void write_mesh(std::ostream& out, const std::string& format, const std::vector<Point_3>& points,
                const std::vector<Polygon>& polygons, const SP::IO::Surface_origin& origin);

/// The message about a file that should be a sphere.
inline const std::string no_sphere =
    "is not a sphere: not all of its faces are positively oriented as seen from the origin, or they do not cover the "
    "sphere exactly once";

/// rotates a sphere to the pose of its surface; leaves it unchanged if no rotation is determined.
void rotate_sphere_to_surface(Input_mesh& input, const Sphere_map& sphere);

/// writes the faces of a mesh with the images of its vertices on the sphere to the file `path`.
///
/// \param radius to which the sphere is scaled, if given
void write_sphere(std::ostream& out, const std::string& path, const std::string& format, Input_mesh& input,
                  const Sphere_map& map, std::optional<double> radius);

/// writes a surface as an OBJ file with longitude and latitude as texture coordinates. In the pose of the surface, the north pole is in the
/// direction of the y-axis, and the center of the image in that of the z-axis.
///
/// \returns a warning, one line, if texture triangles are inverted; empty otherwise
std::string write_texture(std::ostream& out, Input_mesh& input, const Sphere_map& sphere);

/// A distortion of each vertex, and the range of the colors from darkest to lightest; larger distortions also have the lightest.
struct Colored_distortion
{
  /// computes the average over the faces of each vertex. The colors range from `min` to the 99th percentile, because a single bad face
  /// would hide all others.
  ///
  /// \param distortions of the faces, at least `min`; infinite ones are ignored
  Colored_distortion(std::size_t number_of_vertices, const std::vector<Polygon>& faces,
                     const std::vector<double>& distortions, double min);

  std::vector<double> values; ///< 0 if undefined
  std::array<double, 2> range;
};

/// writes a PLY file with a color per vertex, which all viewers support, and with the distortion as the property `quality` of MeshLab.
void write_colored_mesh(std::ostream& out, const std::vector<Point_3>& points, const std::vector<Polygon>& faces,
                        const Colored_distortion& distortion);

} // namespace Program

#endif // PROGRAM_WRITE_MESH_H
