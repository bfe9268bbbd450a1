#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_READERS_READ_SURFACE_FILES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_READERS_READ_SURFACE_FILES_H

#include "../Polygon_soup.h"
#include "../Program_error.h"
#include "../mesh_files.h"

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#ifdef PROGRAM_READS_GIFTI
#include <CGAL/Spherical_parameterization/Cortex/GIFTI.h>
#endif
#ifdef PROGRAM_READS_MGH
#include <CGAL/Spherical_parameterization/Cortex/MGH.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Program {

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

/// tells the kind of a file.
///
/// \param beginning its first bytes, some thousands
/// \param size the number of all of them
inline Surface_file_kind kind_of(const std::string& path, std::string_view beginning, std::uintmax_t size)
{
  using Kind = Surface_file_kind;
  const auto number = [&](std::size_t begin, std::size_t length) {
    std::uint32_t result = 0;
    for(std::size_t k = begin; k < begin + length; ++k)
      result = result << 8 | static_cast<unsigned char>(beginning[k]);
    return result;
  };
  const std::string format = file_format(path);
  if(is_gifti(format) ||
     (beginning.substr(0, 16).find('<') != beginning.npos && beginning.find("<GIFTI") != beginning.npos))
    return Kind::gifti;
  if(format == ".mgz" || format == ".mgh")
    return Kind::mgh;
  if(beginning.substr(0, 7) == "#!ascii")
    return Kind::freesurfer_label;
  constexpr std::size_t size_of_two_vertices = 20, size_of_old_header = 6; // of annotations, and of curv files
  if(beginning.size() < size_of_old_header)
    return Kind::none;
  const std::uint32_t magic = number(0, 3);
  if(magic == 0xFFFFFE || magic == 0xFFFFFD)
    return Kind::freesurfer_surface;
  if(magic == 0xFFFFFF || size == size_of_old_header + 2 * std::uintmax_t(magic))
    return Kind::freesurfer_curv;
  const bool has_vertices = beginning.size() >= size_of_two_vertices && number(4, 4) == 0 && number(12, 4) == 1;
  if(format == ".annot" || (has_vertices && size >= 8 * std::uintmax_t(number(0, 4))))
    return Kind::freesurfer_annotation;
  return Kind::none;
}

/// returns what a file is called without its folder, the hemisphere and the end that tells its format.
inline std::string name_of_values(const std::string& path)
{
  std::string name = std::filesystem::path(path).filename().string();
  if(has_hemisphere(name))
    name.erase(0, 3);
  for(const char* ending : {".gz", ".gii", ".mgz", ".mgh", ".annot", ".shape", ".func", ".label"})
    if(const std::size_t n = std::string(ending).size();
       name.size() > n && name.compare(name.size() - n, n, ending) == 0)
      name.erase(name.size() - n);
  return name;
}

/// reads a file of this kind.
///
/// \param message receives what is said of a file that is in order otherwise, empty if nothing is
///
/// \throws Program_error with what is wrong, and what helps
inline SP::IO::Surface_file read_surface_file(Surface_file_kind kind, std::istream& in, std::string& message)
{
  using Kind = Surface_file_kind;
  SP::IO::Surface_file file;
  SP::Error_code error = SP::OK;
  if(kind == Kind::freesurfer_surface)
    error = SP::IO::read_FreeSurfer_surface(in, file, message);
  else if(kind == Kind::freesurfer_curv)
    error = SP::IO::read_FreeSurfer_curv(in, file, message);
  else if(kind == Kind::freesurfer_annotation)
    error = SP::IO::read_FreeSurfer_annotation(in, file, message);
  else if(kind == Kind::freesurfer_label)
    error = SP::IO::read_FreeSurfer_label(in, file, message);
#ifdef PROGRAM_READS_MGH
  else if(kind == Kind::mgh)
    error = SP::IO::read_MGH(in, file, message);
#endif
#ifdef PROGRAM_READS_GIFTI
  else if(kind == Kind::gifti)
    error = SP::IO::read_GIFTI(in, file, message);
#endif
  else
    throw Program_error(kind == Kind::mgh ? "this program was built without zlib, which reads MGH files"
                                          : "this program was built without expat and zlib, which read GIFTI files");
  if(error != SP::OK)
    throw Program_error(message);
  return file;
}

/// reads a file of this kind as what a mesh file holds. A file of values has no points.
///
/// \param keeps_values whether the values of vertices are wanted
///
/// \throws Program_error with what is wrong, and what helps
inline Polygon_soup parse_surface_file(Surface_file_kind kind, const std::string& path, std::istream& in,
                                       bool keeps_values)
{
  std::string message;
  SP::IO::Surface_file file = read_surface_file(kind, in, message);
  Polygon_soup soup;
  soup.points.reserve(file.points.size());
  for(const auto& p : file.points)
    soup.points.emplace_back(p[0], p[1], p[2]);
  soup.polygons.reserve(file.triangles.size());
  for(const auto& t : file.triangles)
    soup.polygons.emplace_back(t.begin(), t.end());
  soup.origin = std::move(file.origin);
  if(!keeps_values)
    return soup;
  soup.vertices = std::move(file.vertices);
  if(!message.empty())
    soup.left_out.push_back(message.substr(0, message.find(':')));
  soup.labels = std::move(file.labels);
  std::set<std::string> names;
  const std::string usual_name = name_of_values(path);
  for(std::size_t k = 0; k < file.columns.size(); ++k)
  {
    SP::IO::Vertex_values& column = file.columns[k];
    using Type = SP::IO::Vertex_values::Type;
    std::string name = !column.name.empty()       ? column.name
                       : file.columns.size() == 1 ? usual_name
                                                  : usual_name + '_' + std::to_string(k + 1);
    const auto is_no_letter = [](char c) { return c <= ' ' || c > '~'; }; // for a PLY file
    std::replace_if(name.begin(), name.end(), is_no_letter, '_');
    while(!names.insert(name).second)
      name += '_' + std::to_string(k + 1);
    soup.values_of_vertices.push_back({name,
                                       column.type == Type::uint8   ? Number(std::uint8_t())
                                       : column.type == Type::int32 ? Number(std::int32_t())
                                                                    : Number(float()),
                                       std::move(column.values)});
  }
  return soup;
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_READERS_READ_SURFACE_FILES_H
