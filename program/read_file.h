#ifndef PROGRAM_READ_FILE_H
#define PROGRAM_READ_FILE_H

#include "file_names.h"

#include <CGAL/Spherical_parameterization/internal/files/Polygon_soup.h>

#include <CGAL/Simple_cartesian.h>

#include <functional>
#include <set>

namespace Program {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Polygon = SP::internal::Polygon;
using Values = SP::internal::Property_values;

/// What a file holds: a mesh, values of its vertices and faces, or both, and what is known of where they are from.
struct File_content : SP::internal::Polygon_soup
{
  std::vector<std::uint32_t> vertices = {}; ///< that the values are of, or that this part of a surface has; empty: all
  std::vector<std::uint32_t> faces = {};    ///< that this part of a surface has; empty: all
  std::vector<SP::IO::Label> labels = {};   ///< what the values of `label_names` stand for
  std::set<std::string> label_names = {};   ///< of the values that are keys of labels
  SP::IO::Surface_origin origin = {};       ///< what a file of a cortical surface says of its origin
  Hemispheres hemispheres = {};             ///< of the files that this is from
};

/// turns a mesh into what a file of a cortical surface holds, and back, without values.
///
/// \pre all polygons are triangles
SP::IO::Surface_file surface_file_of(const std::vector<Point_3>& points, const std::vector<Polygon>& triangles);
File_content content_of(const SP::IO::Surface_file& file);

/// What a file of a cortical surface is. Many have no extension, so that their first bytes decide.
enum class Surface_file_kind
{
  none, ///< something else
  freesurfer_surface,
  freesurfer_curv,
  freesurfer_annotation,
  freesurfer_label,
  mgh,
  gifti
};

/// checks that a file can be opened.
void check_file(const std::string& path);

/// reads a file as a whole.
std::string read_file(const std::string& path);

/// tells the kind of a file of a cortical surface by its name and its first bytes.
Surface_file_kind kind_of_file(const std::string& path);

/// returns what a file is called without its folder, the hemisphere and the end that tells its format.
std::string name_of_values(const std::string& path);

/// reads a file of this kind. The values of a label are 1, whatever is in the file.
///
/// \param message receives what is said of a file that is in order otherwise, empty if nothing is
SP::IO::Surface_file read_surface_file(Surface_file_kind kind, const std::string& path, std::string& message);

/// reads a mesh file, whose format is that of its name, or told by its first bytes.
///
/// \param keeps_values whether values of vertices and faces are wanted; then the file may have no mesh
File_content read_file_content(const std::string& path, bool keeps_values = false);

/// returns whether a file has values of all vertices, in their order, of its surface, if it has one.
bool has_all_vertices(const std::vector<std::uint32_t>& vertices, std::size_t n_points);

/// checks that the mask `path` can be one: annotations say nothing of which of their labels count.
void check_mask_file(const std::string& path);

/// reads a file with a value for each vertex or face. One with values of some of the vertices is refused.
File_content read_file_of_values(const std::string& path);

/// reads a file with values of vertices, or several, whose names have commas between them. The mesh is that of the first.
///
/// \param read reads one of them
File_content read_values(const std::string& paths,
                         const std::function<File_content(const std::string&)>& read = read_file_of_values);

} // namespace Program

#endif // PROGRAM_READ_FILE_H
