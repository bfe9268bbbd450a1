#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILES_H

#include "Polygon_soup.h"
#include "mesh_files.h"

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <optional>
#include <random>
#include <string>
#include <system_error>
#include <vector>

namespace Program {

/// A file that appears complete or not at all: it is written under another name in the same folder, and renamed in the end.
///
/// Something that is no ordinary file, such as a pipe, is written directly.
class Output_file
{
public:
  /// checks that the file can be written, and leaves no trace of the check.
  ///
  /// \throws Program_error if it cannot
  explicit Output_file(const std::string& name)
    : m_name(name)
    , m_path(name)
  {
    namespace fs = std::filesystem;
    if(fs::is_directory(m_path, m_error))
      fail("it is a directory");
    const bool exists = fs::exists(m_path, m_error);
    if(exists) // renaming would replace a write-protected file as well, against the will of its owner
      open(m_path, std::ios::app);
    if(exists && !fs::is_regular_file(m_path, m_error))
    {
      m_temporary_path = m_path;
      return;
    }
    m_path = fs::weakly_canonical(m_path, m_error); // a link stays, and its target is replaced
    if(m_error)
      fail(m_error.message());
    m_temporary_path =
        m_path.parent_path() / ("." + m_path.filename().string() + "." + std::to_string(std::random_device()()));
    open(m_temporary_path, std::ios::out);
    remove_temporary();
  }

  ~Output_file() { remove_temporary(); }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  /// returns the name as it was given.
  const std::string& name() const { return m_name; }

  /// returns the path of the file itself, behind links.
  const std::filesystem::path& path() const { return m_path; }

  /// writes all of the file by `write(stream)`, still under the other name.
  ///
  /// \throws Program_error if that fails, for example because the disk is full
  template <class Write>
  void write(const Write& write)
  {
    std::ofstream out = open(m_temporary_path, std::ios::out);
    errno = 0;
    write(out);
    out.close();
    if(!out)
      fail_by_errno();
    if(m_temporary_path != m_path)
      m_size = std::filesystem::file_size(m_temporary_path);
  }

  /// returns how many bytes have been written, 0 if that is not known.
  std::uintmax_t size() const { return m_size; }

  /// removes the file that has the name now.
  ///
  /// \throws Program_error if that fails
  void remove_earlier()
  {
    if(m_temporary_path != m_path && !std::filesystem::remove(m_path, m_error) && m_error)
      fail(m_error.message());
  }

  /// gives the file its name, and replaces the one that had it.
  ///
  /// \throws Program_error if that fails
  void commit()
  {
    if(m_temporary_path == m_path)
      return;
    std::filesystem::rename(m_temporary_path, m_path, m_error);
    if(m_error)
      fail(m_error.message());
  }

private:
  [[noreturn]] void fail(const std::string& reason) const
  {
    throw Program_error(m_name + ": cannot be written: " + reason);
  }

  [[noreturn]] void fail_by_errno() const
  {
    fail(std::error_code(errno != 0 ? errno : EIO, std::generic_category()).message());
  }

  std::ofstream open(const std::filesystem::path& path, std::ios::openmode mode) const
  {
    errno = 0;
    std::ofstream out(path, mode | std::ios::binary);
    if(!out)
      fail_by_errno();
    return out;
  }

  void remove_temporary()
  {
    if(m_temporary_path != m_path)
      std::filesystem::remove(m_temporary_path, m_error);
  }

  std::string m_name;
  std::filesystem::path m_path, m_temporary_path;
  std::uintmax_t m_size = 0;
  std::error_code m_error;
};

/// All files that a run is to write. They appear together, once all of them are complete.
class Output_files
{
public:
  /// checks that all of them can be written, and that none of them would replace an input or another output.
  ///
  /// \throws Program_error otherwise
  ///
  /// \param start_file another input; empty if there is none
  Output_files(const File_names& names, const std::string& start_file)
  {
    const auto add = [this](std::optional<Output_file>& file, const std::string& name) {
      m_wanted.push_back(&file.emplace(name));
    };
    if(!names.sphere.empty())
      add(sphere, names.sphere);
    if(!names.colored.empty())
    {
      add(colored_surface, names.colored + "_surface.ply");
      add(colored_sphere, names.colored + "_sphere.ply");
    }
    if(!names.json.empty())
      add(json, names.json);

    std::error_code ignored;
    for(auto file = m_wanted.begin(); file != m_wanted.end(); ++file)
    {
      for(const std::string& input : {names.input, start_file})
        if(std::filesystem::equivalent((*file)->path(), input, ignored))
          throw Program_error((*file)->name() + ": would replace the input; choose another name");
      for(auto other = m_wanted.begin(); other != file; ++other)
        if((*file)->path() == (*other)->path())
          throw Program_error((*file)->name() + ": would be written twice; choose another name");
    }
  }

  /// removes the files that have these names now, the report first: it is never beside the map of another run.
  ///
  /// \throws Program_error if that fails
  void remove_earlier()
  {
    for(auto file = m_wanted.rbegin(); file != m_wanted.rend(); ++file)
      (*file)->remove_earlier();
  }

  /// gives all files their names, once all of them are complete, the report last.
  void commit()
  {
    for(Output_file* file : m_wanted)
      file->commit();
  }

  Words names() const
  {
    Words result;
    for(const Output_file* file : m_wanted)
      result.push_back(file->name());
    return result;
  }

  std::optional<Output_file> sphere, colored_surface, colored_sphere, json;

private:
  std::vector<Output_file*> m_wanted;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILES_H
