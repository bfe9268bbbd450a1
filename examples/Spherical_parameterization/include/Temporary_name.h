#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEMPORARY_NAME_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEMPORARY_NAME_H

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <system_error>

#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

namespace Program {

/// The names of files that are not complete yet. They are hidden, and tell which process writes them: so those that a
/// process has left which was killed are known.
class Temporary_name
{
public:
  static std::string make()
  {
    return prefix() + std::to_string(getpid()) + '.' + std::to_string(std::random_device()());
  }

  /// removes from a folder what processes of this computer have left that are no more.
  static void sweep(const std::filesystem::path& folder)
  {
    namespace fs = std::filesystem;
    std::error_code error, ignored;
    const std::string begin = prefix();
    for(fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
        entry.increment(error))
    {
      const std::string name = entry->path().filename().string();
      pid_t process = 0;
      if(name.compare(0, begin.size(), begin) == 0 &&
         std::from_chars(name.data() + begin.size(), name.data() + name.size(), process).ec == std::errc() &&
         process > 0 && kill(process, 0) != 0 && errno == ESRCH)
        fs::remove(entry->path(), ignored);
    }
  }

private:
  static std::string prefix()
  {
    // A folder may be shared with other computers and containers, whose processes have numbers of their own.
    char host[65] = {};
    gethostname(host, sizeof host - 1);
    struct stat processes;
    const bool is_known = stat("/proc/self/ns/pid", &processes) == 0;
    return std::string(".spherical_parameterization.") + host + '.' +
           std::to_string(is_known ? std::uintmax_t(processes.st_ino) : 0) + '.';
  }
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEMPORARY_NAME_H
