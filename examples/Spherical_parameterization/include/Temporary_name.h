#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEMPORARY_NAME_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEMPORARY_NAME_H

#include <cerrno>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <random>
#include <string>
#include <system_error>

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
    char host[65] = {}; // a folder may be shared with other computers, whose processes have numbers of their own
    gethostname(host, sizeof host - 1);
    return std::string(".spherical_parameterization.") + host + '.';
  }
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEMPORARY_NAME_H
