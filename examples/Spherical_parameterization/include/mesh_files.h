#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_FILES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_FILES_H

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace Program {

using Words = std::vector<std::string>;

/// The formats that are read and told by the end of the name. Those of cortical surfaces are told by what is in the file.
inline const Words input_formats = {".off", ".obj", ".ply", ".stl", ".ts"};

/// The formats that are written and told by the end of the name. An STL file is not among them: it repeats the vertices and
/// forgets their order.
inline const Words output_formats = {".off", ".obj", ".ply", ".ts", ".gii", ".gii.gz"};

/// What a surface can be compared by without a file: how it is folded.
inline const Words own_feature_names = {"depth", "height", "curvature", "inflated"};

/// The format of FreeSurfer, whose files are called `lh.sphere`, say.
inline const std::string freesurfer_format = "freesurfer";

inline bool is_among(const std::string& word, const Words& words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// returns whether a format is GIFTI, perhaps packed by gzip.
inline bool is_gifti(const std::string& format)
{
  return format == ".gii" || format == ".gii.gz";
}

/// returns whether a format is one of cortical surfaces; the numbers of these have 32 bits.
inline bool is_cortical(const std::string& format)
{
  return is_gifti(format) || format == freesurfer_format;
}

/// What the names of meshes that are read, and written, have to be like.
inline const std::string input_names =
    ".off, .obj, .ply, .stl, .ts, .gii or .gii.gz, or the file has to be a surface of FreeSurfer";
inline const std::string output_names =
    ".off, .obj, .ply, .ts, .gii or .gii.gz, or begin with lh. or rh. for the format of FreeSurfer";

/// returns the end of a file's name in lower case, with the dot, and with `.gii` before `.gz`.
inline std::string file_format(const std::string& path)
{
  const std::filesystem::path name(path);
  std::string extension = name.extension().string();
  for(char& c : extension)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".gz" && file_format(name.stem().string()) == ".gii" ? ".gii.gz" : extension;
}

/// returns "a, b, c", with another word before the last one if wanted.
inline std::string list_of(const Words& words, const std::string& last_separator = ", ")
{
  std::string list;
  for(std::size_t i = 0; i < words.size(); ++i)
    list += (i == 0 ? "" : (i + 1 < words.size() ? ", " : last_separator)) + words[i];
  return list;
}

/// returns the names of several files that have commas between them; one file if there is one that is called so.
inline Words split_list(const std::string& names)
{
  std::error_code ignored;
  if(std::filesystem::exists(names, ignored))
    return {names};
  Words result;
  for(std::size_t begin = 0; begin <= names.size();)
  {
    const std::size_t end = (std::min)(names.find(',', begin), names.size());
    result.push_back(names.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

/// returns whether a name begins with what FreeSurfer calls the half of the brain.
inline bool has_hemisphere(const std::string& name)
{
  return name.compare(0, 3, "lh.") == 0 || name.compare(0, 3, "rh.") == 0;
}

/// returns the format that a mesh with this name is written in; empty if the name does not tell.
inline std::string output_format(const std::string& path)
{
  const std::string format = file_format(path);
  if(is_among(format, output_formats))
    return format;
  return has_hemisphere(std::filesystem::path(path).filename().string()) ? freesurfer_format : "";
}

/// returns the end of a name that tells what is in the file: the extension; that and `.surf`, say, of a GIFTI file; nothing of a file
/// of FreeSurfer.
inline std::string ending_of(const std::string& path)
{
  const std::string format = file_format(path);
  if(output_format(path) == freesurfer_format && !is_among(format, {".json", ".html", ".png", ".exr", ".stl"}))
    return "";
  const std::string beginning = path.substr(0, path.size() - format.size()),
                    before = std::filesystem::path(beginning).extension().string();
  const bool is_double = is_gifti(format) && is_among(before, {".surf", ".shape", ".func", ".label"});
  return (is_double ? before : "") + path.substr(beginning.size());
}

/// returns the name with something put before its end.
inline std::string with_suffix(const std::string& path, const std::string& suffix)
{
  const std::string ending = ending_of(path);
  return path.substr(0, path.size() - ending.size()) + suffix + ending;
}

/// The names of all files of a mesh.
struct File_names
{
  std::string input;
  std::string sphere, handles, filled, remesh, values, image, page, json; ///< empty if not wanted
  std::string onto, target_sphere, overlay, morph; ///< of a map onto another surface, empty if not wanted
  std::string subject;                             ///< of a study that the mesh is of, empty otherwise
  std::string colored; ///< what the names of the coloured meshes begin with, empty if they are not wanted

  /// returns the names for a part of a surface: all that are written get its number, from 1 on.
  File_names of_part(std::size_t part) const
  {
    const std::string number = "_" + std::to_string(part + 1);
    File_names result = *this;
    for(std::string* name :
        {&result.sphere, &result.handles, &result.filled, &result.remesh, &result.values, &result.image, &result.page,
         &result.json, &result.onto, &result.target_sphere, &result.overlay, &result.morph})
      if(!name->empty())
        *name = with_suffix(*name, number);
    if(!result.colored.empty())
      result.colored += number;
    return result;
  }
};

/// returns the absolute path behind dots and links, those that lead to nothing yet included, which `weakly_canonical()` takes as
/// they are; and so it does with paths that are not absolute, if they begin with what is not there.
inline std::filesystem::path place_of(std::filesystem::path path, std::error_code& error)
{
  namespace fs = std::filesystem;
  constexpr int max_links = 40; // as the system does
  for(int k = 0; k < max_links && fs::is_symlink(fs::symlink_status(path, error)); ++k)
    path = path.parent_path() / fs::read_symlink(path, error);
  error.clear();
  path = fs::absolute(path, error);
  return error ? path : fs::weakly_canonical(path, error);
}

/// The size of a file and when it was last changed: what tells, as for many build tools, whether it is as it was.
struct File_stamp
{
  File_stamp() = default;

  /// takes the stamp of a file; it is empty if there is no such file, or nothing is known of it.
  explicit File_stamp(const std::string& name)
  {
    std::error_code size_error, time_error;
    const std::uintmax_t size = std::filesystem::file_size(name, size_error);
    const std::filesystem::file_time_type time = std::filesystem::last_write_time(name, time_error);
    if(size_error || time_error)
      return;
    bytes = size;
    changed = std::to_string(time.time_since_epoch().count());
  }

  bool is_empty() const { return changed.empty(); }

  std::uintmax_t bytes = 0;
  std::string changed; ///< in ticks of the clock of the file system, of which nothing but equality is meant
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_FILES_H
