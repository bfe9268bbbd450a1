#ifndef PROGRAM_SYSTEM_H
#define PROGRAM_SYSTEM_H

#include "text.h"

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace Program {

// What POSIX and Windows have different functions for. All else goes through the standard library. The names of files are UTF-8 on
// every system, and bytes are written as they are.

/// makes standard streams and signals alike, and returns the words of the command line behind the name of the program.
Words start_process(int argc, char** argv);

/// The signal of a terminal that is closed.
#ifdef _WIN32
constexpr int signal_of_hangup = SIGBREAK;
#else
constexpr int signal_of_hangup = SIGHUP;
#endif

/// returns whether the standard error stream is shown at once to somebody.
bool has_terminal();

/// returns what this computer is called, and where its processes have numbers of their own: a folder may be shared with other
/// computers and containers.
std::string name_of_computer();

std::int64_t number_of_process();
bool is_running(std::int64_t process);

/// returns whether the user may write to a file that is there; sets `errno`.
bool is_writable(const std::filesystem::path& path);

/// opens a file, which must not be there if it is to be new, not even as a link; returns null and sets `errno` if that fails.
std::FILE* open_to_write(const std::filesystem::path& path, bool is_new);

/// gives a file another name, and replaces the file that has it.
void rename_file(const std::filesystem::path& path, const std::filesystem::path& new_path, std::error_code& error);

/// gives an open file the permissions of another one, where the file system has them.
void set_permissions(std::FILE* file, std::filesystem::perms permissions);

/// As long as it lives, no other run has such a lock on the folder. Where the file system has no locks, there is none.
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
