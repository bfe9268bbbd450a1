#ifndef PROGRAM_OUTPUT_FILES_H
#define PROGRAM_OUTPUT_FILES_H

#include "text.h"

#include <boost/crc.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>

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

/// Where a name leads to that is taken by a link, or by something else that is no ordinary file, such as a pipe.
enum class Output_policy
{
  follow, ///< to the target of the link, which is replaced, or into the pipe: the user has named it
  replace ///< nowhere: the link itself is replaced, a pipe is an error; the folder may be somebody else's
};

/// removes from a folder the incomplete files that processes of this computer have left that are no more.
void sweep_temporary_files(const std::filesystem::path& folder);

/// All files that a run is to write. They appear together, once all of them are complete. What fails throws a `Program_error`.
class Output_files
{
public:
  /// checks that all of them can be written, and that none of them would replace an input or another output.
  ///
  /// \param names in the order in which they appear; empty ones are left out
  Output_files(const Words& names, const Words& inputs, Output_policy policy);

  ~Output_files();

  /// writes all of a file by `write(stream)`, still under another name; nothing if the name is empty.
  void write(const std::string& name, const std::function<void(std::ostream&)>& write);

  /// returns the checksum of what has been written; there is none if it went elsewhere than to a file.
  std::optional<Checksum> checksum(const std::string& name) const;

  /// gives all files their names, and replaces those that had them. Of several runs that write the same files at the
  /// same time, all are of the last one.
  void commit();

  Words names() const;

private:
  class File;

  File& file_of(const std::string& name) const;

  std::vector<std::unique_ptr<File>> m_files;
};

} // namespace Program

#endif // PROGRAM_OUTPUT_FILES_H
