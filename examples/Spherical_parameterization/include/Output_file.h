#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H

#include "Program_error.h"
#include "Temporary_name.h"
#include "mesh_files.h"

#include <boost/crc.hpp>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <ios>
#include <memory>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace Program {

/// What tells whether a file is as it was written, unless somebody wants to deceive.
struct Checksum
{
  std::uintmax_t bytes = 0;
  boost::crc_32_type crc;

  void add(const char* data, std::size_t size)
  {
    bytes += size;
    crc.process_bytes(data, size);
  }
};

/// A file that appears complete or not at all: it is written under another name in the same folder, and renamed in the end.
class Output_file
{
public:
  /// Where a name leads to that is taken by a link, or by something else that is no ordinary file, such as a pipe.
  enum class Policy
  {
    follow, ///< to the target of the link, which is replaced, or into the pipe: the user has named it
    replace ///< nowhere: the link itself is replaced, a pipe is an error; the folder may be somebody else's
  };

  /// checks that the file can be written, and leaves no trace of the check.
  ///
  /// \throws Program_error if it cannot
  Output_file(const std::string& name, Policy policy)
    : m_name(name)
    , m_path(name)
  {
    namespace fs = std::filesystem;
    const bool follows = policy == Policy::follow;
    const fs::file_status status = follows ? fs::status(m_path, m_error) : fs::symlink_status(m_path, m_error);
    if(fs::is_directory(status))
      fail("it is a directory");
    if(fs::exists(status) && !fs::is_symlink(status))
    {
      // Renaming would replace a write-protected file as well, against the will of its owner.
      if(access(m_path.c_str(), W_OK) != 0)
        fail_by_errno();
      m_is_direct = !fs::is_regular_file(status);
      if(m_is_direct && !follows)
        fail("it is a pipe or a device, not a file; remove it, or choose another folder");
      if(m_is_direct)
        return;
      m_permissions = status.permissions() & fs::perms::all;
    }
    if(follows)
    {
      m_path = place_of(m_path, m_error);
      if(m_error)
        fail(m_error.message());
      Temporary_name::sweep(fs::absolute(m_path).parent_path());
    }
    m_temporary_path = m_path.parent_path() / Temporary_name::make();
    open();
    close();
    remove_temporary();
  }

  ~Output_file() { remove_temporary(); }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  /// returns the name as it was given.
  const std::string& name() const { return m_name; }

  /// returns the path of the file itself, behind links if these are followed.
  const std::filesystem::path& path() const { return m_path; }

  /// writes all of the file by `write(stream)`, still under the other name.
  ///
  /// \throws Program_error if that fails, for example because the disk is full
  template <class Write>
  void write(const Write& write)
  {
    open();
    Buffer buffer(*m_file);
    std::ostream out(&buffer);
    errno = 0;
    write(out);
    if(!out)
      fail_by_errno();
    close();
    if(!m_is_direct)
      m_checksum = buffer.checksum();
  }

  /// returns the checksum of what has been written; there is none if it went elsewhere than to a file.
  const std::optional<Checksum>& checksum() const { return m_checksum; }

  /// removes the file that has the name now.
  ///
  /// \throws Program_error if that fails
  void remove_earlier()
  {
    if(!m_is_direct && !std::filesystem::remove(m_path, m_error) && m_error)
      fail(m_error.message());
  }

  /// gives the file its name, and replaces the one that had it.
  ///
  /// \throws Program_error if that fails
  void commit()
  {
    if(m_is_direct)
      return;
    std::filesystem::rename(m_temporary_path, m_path, m_error);
    if(m_error)
      fail(m_error.message());
  }

private:
  // Writes to a file, which has a buffer of its own, and adds up the checksum.
  class Buffer : public std::streambuf
  {
  public:
    explicit Buffer(std::FILE& file)
      : m_file(&file)
    {}

    const Checksum& checksum() const { return m_checksum; }

  protected:
    std::streamsize xsputn(const char* data, std::streamsize size) override
    {
      const std::size_t n = std::fwrite(data, 1, static_cast<std::size_t>(size), m_file);
      m_checksum.add(data, n);
      return static_cast<std::streamsize>(n);
    }

    int_type overflow(int_type c) override
    {
      const char character = traits_type::to_char_type(c);
      return xsputn(&character, 1) == 1 ? traits_type::not_eof(c) : traits_type::eof();
    }

  private:
    std::FILE* m_file;
    Checksum m_checksum;
  };

  struct Closing
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  [[noreturn]] void fail(const std::string& reason) const
  {
    throw Program_error(m_name, "cannot be written: " + reason);
  }

  [[noreturn]] void fail_by_errno() const
  {
    fail(std::error_code(errno != 0 ? errno : EIO, std::generic_category()).message());
  }

  // Makes the other file, which must not be there, not even as a link, or opens the pipe. A file that is replaced hands
  // down who may read it before there is anything to read.
  void open()
  {
    errno = 0;
    m_file.reset(m_is_direct ? std::fopen(m_path.c_str(), "wb") : std::fopen(m_temporary_path.c_str(), "wbx"));
    if(!m_file)
      fail_by_errno();
    if(m_permissions)
      fchmod(fileno(m_file.get()), static_cast<mode_t>(*m_permissions)); // some file systems have none
  }

  void close()
  {
    if(std::fclose(m_file.release()) != 0)
      fail_by_errno();
  }

  void remove_temporary()
  {
    if(!m_temporary_path.empty())
      std::filesystem::remove(m_temporary_path, m_error);
  }

  std::string m_name;
  std::filesystem::path m_path, m_temporary_path;
  bool m_is_direct = false; // written under its own name, at once
  std::optional<std::filesystem::perms> m_permissions;
  std::unique_ptr<std::FILE, Closing> m_file; // while it is open
  std::optional<Checksum> m_checksum;
  std::error_code m_error;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILE_H
