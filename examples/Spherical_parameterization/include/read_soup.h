#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_READ_SOUP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_READ_SOUP_H

#include "Polygon_soup.h"
#include "Program_error.h"
#include "mesh_files.h"
#include "readers/Scanner.h"
#include "readers/read_ply.h"
#include "readers/read_stl.h"
#include "readers/read_surface_files.h"
#include "readers/read_text_formats.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace Program {

/// reads the content of a mesh file of one of the input formats.
///
/// Files come from anywhere. The readers of CGAL do not say where a file is damaged, take some damaged files for other
/// meshes than they are, and ask for any amount of memory; doc/upstreaming.md has examples. Hence the folder `readers`.
///
/// \param keeps_values whether the properties of vertices and faces are wanted, which only the format PLY has
///
/// \throws Program_error with what is wrong, and what helps
inline Polygon_soup parse_soup(const std::string& format, std::string content, bool keeps_values = false)
{
  if(content.compare(0, 2, "\x1F\x8B") == 0)
    throw Program_error("the file is compressed.\nUnpack it first.");
  Scanner in(std::move(content));
  try
  {
    if(format == ".off")
      return read_off(in);
    if(format == ".obj")
      return read_obj(in);
    if(format == ".ply")
      return Ply_reader(in, keeps_values)();
    if(format == ".stl")
      return Stl_reader(in)();
    return read_gocad(in);
  }
  catch(const Program_error& error)
  {
    throw Program_error(error.what() + std::string(".\nRepair the file, or the program that wrote it."));
  }
}

/// calls `read()`, and names the file `path` in its errors.
template <class Read>
auto read_named(const std::string& path, const Read& read)
{
  try
  {
    return read();
  }
  catch(const Program_error& error)
  {
    throw Program_error(path, error.what());
  }
}

/// opens a file.
///
/// \throws Program_error if it is no ordinary file, or cannot be read
inline std::ifstream open_file(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if(fs::is_directory(status))
    throw Program_error("this is a directory, not a file");
  if(fs::exists(status) && !fs::is_regular_file(status))
    throw Program_error("this is a pipe or a device, not a file"); // it might never end
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if(!in)
    throw Program_error(std::generic_category().message(errno));
  return in;
}

/// reads a file as a whole.
///
/// \throws Program_error if it is no ordinary file, or cannot be read
inline std::string read_file(const std::string& path)
{
  std::ifstream in = open_file(path);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if(error)
    throw Program_error(error.message());
  std::string content;
  constexpr std::uintmax_t size_of_beginning = 4096;
  for(const std::uintmax_t end : {(std::min)(size, size_of_beginning), size})
  {
    const std::size_t begin = content.size();
    content.resize(static_cast<std::size_t>(end));
    if(!in.read(&content[begin], static_cast<std::streamsize>(end - begin)))
      throw Program_error("the file cannot be read to its end");
    if(size > 0 && content.find_first_not_of('\0') == std::string::npos) // before gigabytes of them
      throw Program_error("the file begins with nothing but zeros: it has never been written completely");
  }
  return content;
}

/// tells the kind of a file of a cortical surface by its name and its first bytes.
///
/// \throws Program_error if it is no ordinary file, or cannot be read
inline Surface_file_kind kind_of_file(const std::string& path)
{
  std::ifstream in = open_file(path);
  std::string beginning(4096, '\0');
  in.read(&beginning[0], static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(in.gcount()));
  std::error_code error;
  return kind_of(path, beginning, std::filesystem::file_size(path, error));
}

/// reads a mesh file, whose format is that of its name, or told by its first bytes.
///
/// \param keeps_values whether values of vertices and faces are wanted; then the file may have no mesh
///
/// \throws Program_error with the name of the file, what is wrong with it, and what helps
inline Polygon_soup read_soup(const std::string& path, bool keeps_values = false)
{
  const std::string format = file_format(path);
  Polygon_soup soup = read_named(path, [&] {
    if(is_among(format, input_formats))
      return parse_soup(format, read_file(path), keeps_values);
    const Surface_file_kind kind = kind_of_file(path);
    std::error_code ignored;
    if(std::filesystem::file_size(path, ignored) == 0)
      throw Program_error("the file is empty");
    if(kind == Surface_file_kind::none)
      throw Program_error(keeps_values ? "this is no file with values of vertices: those are .ply, .gii, .mgh and .mgz "
                                         "files, and files of FreeSurfer such as lh.sulc"
                                       : "the name of a mesh file has to end with one of " + input_names);
    std::ifstream in = open_file(path);
    Polygon_soup result = parse_surface_file(kind, path, in, keeps_values);
    if(result.points.empty() && !keeps_values)
      throw Program_error("the file has no surface, but values of the vertices of one");
    // FreeSurfer says by the name which half of the brain a surface is.
    const std::string name = std::filesystem::path(path).filename().string();
    if(kind == Surface_file_kind::freesurfer_surface && has_hemisphere(name))
      result.origin.metadata_of_points = {
          {"AnatomicalStructurePrimary", name[0] == 'l' ? "CortexLeft" : "CortexRight"}};
    return result;
  });
  soup.hemispheres = hemispheres_of(path, soup.origin);
  return soup;
}

/// reads a file with values of vertices, or several, whose names have commas between them. The mesh is that of the first.
///
/// \param read reads one of them
///
/// \throws Program_error if that fails, or they are values of surfaces that differ in the number of their vertices
template <class Read>
Polygon_soup read_values(const std::string& paths, const Read& read)
{
  Polygon_soup result;
  std::set<std::string> names;
  const Words files = split_list(paths);
  for(const std::string& path : files)
  {
    Polygon_soup soup = read(path);
    if(!soup.vertices.empty())
      throw Program_error(path, "has values of " + std::to_string(soup.vertices.size()) +
                                    " vertices of a surface, not of all.\nWrite a file with a value for each vertex.");
    if(result.number_of_vertices() > 0 && soup.number_of_vertices() != result.number_of_vertices())
      throw Program_error(path, "has values of " + std::to_string(soup.number_of_vertices()) + " vertices, but " +
                                    printable(files.front()) + " of " + std::to_string(result.number_of_vertices()));
    for(const Values& values : soup.values_of_vertices)
      if(!names.insert(values.name).second)
        throw Program_error(path, "has values of the name " + printable(values.name) + ", as a file before it");
    if(path == files.front())
      result = std::move(soup);
    else
    {
      std::move(soup.values_of_vertices.begin(), soup.values_of_vertices.end(),
                std::back_inserter(result.values_of_vertices));
      std::move(soup.hemispheres.begin(), soup.hemispheres.end(), std::back_inserter(result.hemispheres));
      if(result.labels.empty())
        result.labels = std::move(soup.labels);
      else if(!soup.labels.empty())
        result.left_out.push_back("the names and colours of the labels of " + printable(path) +
                                  ", as a file before it has some");
      std::move(soup.left_out.begin(), soup.left_out.end(), std::back_inserter(result.left_out));
    }
  }
  return result;
}

inline Polygon_soup read_values(const std::string& paths)
{
  return read_values(paths, [](const std::string& path) { return read_soup(path, true); });
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_READ_SOUP_H
