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

/// The formats that are read, by the end of the name.
inline const Words input_formats = {".off", ".obj", ".ply", ".stl", ".ts"};

/// The formats that are written. An STL file is not among them: it repeats the vertices and forgets their order.
inline const Words output_formats = {".off", ".obj", ".ply", ".ts"};

/// returns the end of a file's name in lower case, with the dot.
inline std::string file_format(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for(char& c : extension)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

inline bool is_among(const std::string& word, const Words& words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// returns "a, b, c", with another word before the last one if wanted.
inline std::string list_of(const Words& words, const std::string& last_separator = ", ")
{
  std::string list;
  for(std::size_t i = 0; i < words.size(); ++i)
    list += (i == 0 ? "" : (i + 1 < words.size() ? ", " : last_separator)) + words[i];
  return list;
}

/// The names of all files of a mesh.
struct File_names
{
  std::string input;
  std::string sphere, handles, filled, remesh, image, page, json; ///< empty if not wanted
  std::string onto, target_sphere, overlay, morph; ///< of a map onto another surface, empty if not wanted
  std::string colored; ///< what the names of the coloured meshes begin with, empty if they are not wanted

  /// returns the names for a part of a surface: all that are written get its number, from 1 on.
  File_names of_part(std::size_t part) const
  {
    const std::string number = "_" + std::to_string(part + 1);
    File_names result = *this;
    for(std::string* name :
        {&result.sphere, &result.handles, &result.filled, &result.remesh, &result.image, &result.page, &result.json,
         &result.onto, &result.target_sphere, &result.overlay, &result.morph})
      if(!name->empty())
      {
        const std::filesystem::path path(*name);
        *name = (path.parent_path() / path.stem()).string() + number + path.extension().string();
      }
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
