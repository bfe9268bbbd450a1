#include "read_file.h"

#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/surface_file_checks.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/files/read_mesh_file.h>
#ifdef PROGRAM_READS_GIFTI
#include <CGAL/Spherical_parameterization/Cortex/GIFTI.h>
#endif
#ifdef PROGRAM_READS_MGH
#include <CGAL/Spherical_parameterization/Cortex/MGH.h>
#endif

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <ios>
#include <iterator>
#include <set>
#include <string_view>

namespace Program {

namespace {

// Opens a regular file.
std::ifstream open_file(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path_of(path), error);
  if(fs::is_directory(status))
    throw Program_error("it is a directory, not a file");
  if(fs::exists(status) && !fs::is_regular_file(status))
    throw Program_error("it is a pipe or a device, not a regular file"); // it might never end
  errno = 0;
  std::ifstream in(path_of(path), std::ios::binary);
  if(!in)
    throw Program_error(std::generic_category().message(errno));
  return in;
}

// Converts a file of this kind to the content of a mesh file. A file of values has no points.
File_content content_of_surface_file(Surface_file_kind kind, const std::string& path, bool keeps_values)
{
  std::string message;
  SP::IO::Surface_file file = read_surface_file(kind, path, message);
  File_content soup = content_of(file);
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
    const auto is_not_allowed = [](char c) { return c <= ' ' || c > '~' || c == '#'; }; // in names of a PLY file
    std::replace_if(name.begin(), name.end(), is_not_allowed, '_');
    while(!names.insert(name).second)
      name += '_' + std::to_string(k + 1);
    if(column.intent == "NIFTI_INTENT_LABEL")
      soup.label_names.insert(name);
    soup.values_of_vertices.push_back({name,
                                       column.type == Type::uint8   ? SP::internal::File_number(std::uint8_t())
                                       : column.type == Type::int32 ? SP::internal::File_number(std::int32_t())
                                                                    : SP::internal::File_number(float()),
                                       std::move(column.values)});
  }
  return soup;
}

} // namespace

SP::IO::Surface_file surface_file_of(const std::vector<Point_3>& points, const std::vector<Polygon>& triangles)
{
  SP::IO::Surface_file file;
  file.points.reserve(points.size());
  for(const Point_3& p : points)
    file.points.push_back({{p.x(), p.y(), p.z()}});
  file.triangles.resize(triangles.size());
  for(std::size_t f = 0; f < triangles.size(); ++f)
    std::transform(triangles[f].begin(), triangles[f].end(), file.triangles[f].begin(),
                   [](std::size_t v) { return static_cast<std::uint32_t>(v); });
  return file;
}

File_content content_of(const SP::IO::Surface_file& file)
{
  File_content content;
  content.points.reserve(file.points.size());
  for(const auto& p : file.points)
    content.points.emplace_back(p[0], p[1], p[2]);
  content.polygons.reserve(file.triangles.size());
  for(const auto& t : file.triangles)
    content.polygons.emplace_back(t.begin(), t.end());
  return content;
}

void check_file(const std::string& path)
{
  read_named(path, [&] { open_file(path); });
}

std::string read_file(const std::string& path)
{
  std::ifstream in = open_file(path);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path_of(path), error);
  if(error)
    throw Program_error(error.message());
  std::string content;
  constexpr std::uintmax_t size_of_beginning = 4096;
  for(const std::uintmax_t end : {(std::min)(size, size_of_beginning), size})
  {
    const std::size_t begin = content.size();
    content.resize(static_cast<std::size_t>(end));
    if(!in.read(&content[begin], static_cast<std::streamsize>(end - begin)))
      throw Program_error("the file cannot be read completely");
    if(size > 0 && content.find_first_not_of('\0') == std::string::npos) // before gigabytes are read
      throw Program_error("the file begins with zeros only: it was not written completely");
  }
  return content;
}

Surface_file_kind kind_of_file(const std::string& path)
{
  using Kind = Surface_file_kind;
  std::ifstream in = open_file(path);
  std::string beginning(4096, '\0');
  in.read(&beginning[0], static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(in.gcount()));
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path_of(path), error);
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

std::string name_of_values(const std::string& path)
{
  std::string name = name_of(path_of(path).filename());
  if(!structure_of(path).empty())
    name.erase(0, 3);
  for(const char* ending : {".gz", ".gii", ".mgz", ".mgh", ".annot", ".shape", ".func", ".label"})
    if(const std::size_t n = std::string(ending).size();
       name.size() > n && name.compare(name.size() - n, n, ending) == 0)
      name.erase(name.size() - n);
  return name;
}

SP::IO::Surface_file read_surface_file(Surface_file_kind kind, const std::string& path, std::string& message)
{
  std::ifstream in = open_file(path);
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
    throw Program_error(kind == Kind::mgh ? "this program was built without zlib, which MGH files need"
                                          : "this program was built without expat and zlib, which GIFTI files need");
  if(error != SP::OK)
    throw Program_error(message);
  // A label selects its vertices, whatever their values, which are 0 in files of most programs.
  if(kind == Kind::freesurfer_label)
    for(SP::IO::Vertex_values& column : file.columns)
      std::fill(column.values.begin(), column.values.end(), 1.);
  return file;
}

bool has_all_vertices(const std::vector<std::uint32_t>& vertices, std::size_t n_points)
{
  return SP::internal::are_consecutive(vertices) && (vertices.empty() || n_points == 0 || vertices.size() == n_points);
}

void check_mask_file(const std::string& path)
{
  if(!is_among(file_format(path), input_formats) && kind_of_file(path) == Surface_file_kind::freesurfer_annotation)
    throw error_in(
        path, "is an annotation, which does not specify which of its labels to include.\nUse a FreeSurfer label, or "
              "a file with a number for each vertex.");
}

File_content read_file_content(const std::string& path, bool keeps_values)
{
  const std::string format = file_format(path);
  File_content soup = read_named(path, [&] {
    if(is_among(format, input_formats))
      return File_content{SP::internal::read_mesh_file(format, read_file(path), keeps_values)};
    const Surface_file_kind kind = kind_of_file(path);
    std::error_code ignored;
    if(std::filesystem::file_size(path_of(path), ignored) == 0)
      throw Program_error("the file is empty");
    if(kind == Surface_file_kind::none)
      throw Program_error(keeps_values
                              ? "it is not a file of vertex values, such as .ply, .gii, .mgh and .mgz files, and "
                                "FreeSurfer files such as lh.sulc"
                              : "the name of a mesh file must end with one of " + input_names);
    File_content result = content_of_surface_file(kind, path, keeps_values);
    if(result.points.empty() && !keeps_values)
      throw Program_error("the file contains vertex values, but no surface");
    if(!result.points.empty())
      add_structure(result.origin.metadata_of_points, path);
    return result;
  });
  soup.hemispheres = hemispheres_of(path, soup.origin);
  return soup;
}

File_content read_file_of_values(const std::string& path)
{
  File_content content = read_file_content(path, true);
  if(!has_all_vertices(content.vertices, content.points.size()))
    throw error_in(path, "has values of ", content.vertices.size(),
                   " vertices only.\nUse a file with a value for each vertex of the surface.");
  content.vertices.clear();
  return content;
}

File_content read_values(const std::string& paths, const std::function<File_content(const std::string&)>& read)
{
  File_content result;
  std::set<std::string> names;
  const Words files = split_list(paths);
  for(const std::string& path : files)
  {
    File_content soup = read(path);
    if(result.number_of_vertices() > 0 && soup.number_of_vertices() != result.number_of_vertices())
      throw error_in(path, "has values of ", soup.number_of_vertices(), " vertices, but ", printable(files.front()),
                     " of ", result.number_of_vertices());
    for(const Values& values : soup.values_of_vertices)
      if(!names.insert(values.name).second)
        throw error_in(path, "has values named ", printable(values.name), ", like an earlier file");
    if(path == files.front())
      result = std::move(soup);
    else
    {
      std::move(soup.values_of_vertices.begin(), soup.values_of_vertices.end(),
                std::back_inserter(result.values_of_vertices));
      std::move(soup.hemispheres.begin(), soup.hemispheres.end(), std::back_inserter(result.hemispheres));
      if(result.labels.empty())
      {
        result.labels = std::move(soup.labels);
        result.label_names = std::move(soup.label_names);
      }
      else if(!soup.labels.empty())
        result.left_out.push_back("the names and colors of the labels of " + printable(path) +
                                  ", because an earlier file has labels");
      std::move(soup.left_out.begin(), soup.left_out.end(), std::back_inserter(result.left_out));
    }
  }
  return result;
}

} // namespace Program
