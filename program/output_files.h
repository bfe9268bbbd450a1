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

/// Detects accidental changes of a file.
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

/// The treatment of an output name that is a link, or not a regular file, such as a pipe.
enum class Output_policy
{
  follow, ///< replaces the target of the link, or writes into the pipe: the user has named it
  replace ///< replaces the link itself; a pipe is an error: the folder may belong to another user
};

/// removes from a folder the incomplete files of processes of this computer that have ended.
void sweep_temporary_files(const std::filesystem::path& folder);

/// All output files of a run. They appear together, after all of them are complete. Functions throw a `Program_error` on failure.
class Output_files
{
public:
  /// checks that all files can be written, and that none would replace an input or another output.
  ///
  /// \param names in the order in which the files appear; empty ones are ignored
  Output_files(const Words& names, const Words& inputs, Output_policy policy);

  ~Output_files();

  /// writes a file by `write(stream)` under a temporary name; does nothing if the name is empty.
  void write(const std::string& name, const std::function<void(std::ostream&)>& write);

  /// returns the checksum of a written file; none if it is not a regular file.
  std::optional<Checksum> checksum(const std::string& name) const;

  /// renames all files to their names and replaces existing files. If several runs write the same files at the same time, all files are
  /// those of the last run.
  void commit();

  Words names() const;

private:
  class File;

  File& file_of(const std::string& name) const;

  std::vector<std::unique_ptr<File>> m_files;
};

} // namespace Program

#endif // PROGRAM_OUTPUT_FILES_H
