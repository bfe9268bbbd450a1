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

/// The content of a file: a mesh, values of its vertices and faces, or both, with metadata.
struct File_content : SP::internal::Polygon_soup
{
  std::vector<std::uint32_t> vertices = {}; ///< of the values, or of this part of a surface; empty: all
  std::vector<std::uint32_t> faces = {};    ///< of this part of a surface; empty: all
  std::vector<SP::IO::Label> labels = {};   ///< the meaning of the values of `label_names`
  std::set<std::string> label_names = {};   ///< of the values that are label keys
  SP::IO::Surface_origin origin = {};       ///< metadata of a file of a cortical surface
  Hemispheres hemispheres = {};             ///< of the source files
};

/// converts a mesh to the content of a file of a cortical surface, and back, without values.
///
/// \pre all polygons are triangles
SP::IO::Surface_file surface_file_of(const std::vector<Point_3>& points, const std::vector<Polygon>& triangles);
File_content content_of(const SP::IO::Surface_file& file);

/// The kind of a file of a cortical surface. Many have no extension, so that it is recognized by the first bytes.
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

/// reads a whole file.
std::string read_file(const std::string& path);

/// returns the kind of a file of a cortical surface, according to its name and its first bytes.
Surface_file_kind kind_of_file(const std::string& path);

/// returns the file name without folder, hemisphere and extension.
std::string name_of_values(const std::string& path);

/// reads a file of this kind. The values of a label are 1, whatever the file contains.
///
/// \param message receives a remark about a valid file, or is empty
SP::IO::Surface_file read_surface_file(Surface_file_kind kind, const std::string& path, std::string& message);

/// reads a mesh file, whose format follows from its name or its first bytes.
///
/// \param keeps_values whether to read values of vertices and faces; then the file may have no mesh
File_content read_file_content(const std::string& path, bool keeps_values = false);

/// returns whether a file has values of all vertices of its surface, if it has one, in their order.
bool has_all_vertices(const std::vector<std::uint32_t>& vertices, std::size_t n_points);

/// checks that the file `path` can be a mask: an annotation does not specify which of its labels to include.
void check_mask_file(const std::string& path);

/// reads a file with a value for each vertex or face. A file with values of only some vertices is an error.
File_content read_file_of_values(const std::string& path);

/// reads one or several comma-separated files of vertex values. The mesh is that of the first file.
///
/// \param read reads one file
File_content read_values(const std::string& paths,
                         const std::function<File_content(const std::string&)>& read = read_file_of_values);

} // namespace Program

#endif // PROGRAM_READ_FILE_H
