#ifndef _WIN32

#include "system.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <fstream>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__ // as GCC does
#endif
#endif
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) // which observes another heap, page by page
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#endif

namespace Program {

namespace {

// Lets all threads allocate from one heap in huge pages, of 2 MiB, where the system has them, and use freed memory again.
// By default, arrays are requested from the system one by one in pages of 4 KiB, the first accesses to which took up to a
// third of the time of a map. The heap is reserved, but takes no memory before it is used; so there is none where the
// reservation counts.
void prepare_heap()
{
#if defined(M_MMAP_MAX) && defined(MADV_HUGEPAGE)
  constexpr std::size_t page = 4096, huge_page = std::size_t(1) << 21;
  constexpr int default_mmap_max = 65536, max_mmap_threshold = 32 << 20;
  for(const auto resource : {RLIMIT_AS, RLIMIT_DATA})
    if(rlimit limit; getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY)
      return;
  char overcommit = '2'; // strict
  std::ifstream("/proc/sys/vm/overcommit_memory") >> overcommit;
  if(overcommit == '2' || sysconf(_SC_PAGESIZE) != page) // with other pages, huge ones are much larger
    return;
  const std::size_t half_of_memory = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) / 2 * page,
                    size = half_of_memory / huge_page * huge_page;
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_TRIM_THRESHOLD, -1); // never
  mallopt(M_MMAP_MAX, 0);        // so that this array is at the end of the heap and stays there when it is freed
  if(void* const heap = std::aligned_alloc(huge_page, size))
  {
    madvise(heap, size, MADV_HUGEPAGE);
    std::free(heap);
  }
  mallopt(M_MMAP_MAX, default_mmap_max);
  mallopt(M_MMAP_THRESHOLD, max_mmap_threshold);
#endif
}

} // namespace

Words start_process(int argc, char** argv)
{
  prepare_heap();
  // Without this, output to a closed standard stream would go to the next opened file.
  for(const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if(fcntl(stream, F_GETFD) == -1)
      open("/dev/null", O_RDONLY);
  // a file that exceeds its size limit, and a pipe without a reader, cause ordinary write errors
  for(const int signal : {SIGXFSZ, SIGPIPE})
    std::signal(signal, SIG_IGN);
  return Words(argv + (std::min)(argc, 1), argv + argc);
}

bool has_terminal()
{
  return isatty(STDERR_FILENO) != 0;
}

std::string name_of_computer()
{
  char host[65] = {};
  gethostname(host, sizeof host - 1);
  struct stat processes;
  const bool is_known = stat("/proc/self/ns/pid", &processes) == 0;
  return host + ('.' + std::to_string(is_known ? std::uintmax_t(processes.st_ino) : 0));
}

std::int64_t number_of_process()
{
  return getpid();
}

bool is_running(std::int64_t process)
{
  const pid_t number = static_cast<pid_t>(process);
  return number != process || number <= 0 || kill(number, 0) == 0 || errno != ESRCH;
}

bool is_writable(const std::filesystem::path& path)
{
  return access(path.c_str(), W_OK) == 0;
}

std::FILE* open_to_write(const std::filesystem::path& path, bool is_new)
{
  return std::fopen(path.c_str(), is_new ? "wbx" : "wb");
}

void rename_file(const std::filesystem::path& path, const std::filesystem::path& new_path, std::error_code& error)
{
  std::filesystem::rename(path, new_path, error);
}

void set_permissions(std::FILE* file, std::filesystem::perms permissions)
{
  fchmod(fileno(file), static_cast<mode_t>(permissions)); // some file systems have no permissions
}

Folder_lock::Folder_lock(const std::filesystem::path& folder)
  : m_path(folder / ".spherical_parameterization.lock")
{
  constexpr int max_attempts = 1000; // on file systems without persistent inode numbers
  for(int k = 0; k < max_attempts; ++k)
  {
    const int file = open(m_path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    m_file = file;
    if(file == -1 || flock(file, LOCK_EX) != 0)
      return;
    struct stat locked, named;
    if(fstat(file, &locked) == 0 && lstat(m_path.c_str(), &named) == 0 && locked.st_dev == named.st_dev &&
       locked.st_ino == named.st_ino)
      return;
    close(file); // the previous owner of the lock has removed the file
    m_file = -1;
  }
}

Folder_lock::~Folder_lock()
{
  if(m_file == -1)
    return;
  unlink(m_path.c_str());
  close(static_cast<int>(m_file));
}

} // namespace Program

#endif
