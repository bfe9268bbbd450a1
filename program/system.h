#ifndef PROGRAM_SYSTEM_H
#define PROGRAM_SYSTEM_H

#include "text.h"

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace Program {

// Functions that differ between POSIX and Windows. File names are UTF-8 on every system, and bytes are written unchanged.

/// prepares standard streams, signals and the heap, and returns the words of the command line after the name of the program.
Words start_process(int argc, char** argv);

/// The signal that a closed terminal sends.
#ifdef _WIN32
constexpr int signal_of_hangup = SIGBREAK;
#else
constexpr int signal_of_hangup = SIGHUP;
#endif

/// returns whether the standard error stream is a terminal.
bool has_terminal();

/// returns a name of this computer and its process namespace: a folder may be shared with other computers and containers.
std::string name_of_computer();

std::int64_t number_of_process();
bool is_running(std::int64_t process);

/// returns whether the user may write to an existing file; sets `errno`.
bool is_writable(const std::filesystem::path& path);

/// opens a file for writing; a new file must not exist, not even as a link. Returns null and sets `errno` on failure.
std::FILE* open_to_write(const std::filesystem::path& path, bool is_new);

/// renames a file and replaces an existing one.
void rename_file(const std::filesystem::path& path, const std::filesystem::path& new_path, std::error_code& error);

/// sets the permissions of an open file, if the file system supports them.
void set_permissions(std::FILE* file, std::filesystem::perms permissions);

/// Locks a folder against other runs during its lifetime. Has no effect on file systems without locks.
class Folder_lock
{
public:
  explicit Folder_lock(const std::filesystem::path& folder);
  ~Folder_lock();

  Folder_lock(const Folder_lock&) = delete;
  Folder_lock& operator=(const Folder_lock&) = delete;

private:
  std::filesystem::path m_path;
  std::intptr_t m_file = -1;
};

} // namespace Program

#endif // PROGRAM_SYSTEM_H
