#include "output_files.h"

#include "file_names.h"
#include "system.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <ios>
#include <mutex>
#include <random>
#include <set>
#include <streambuf>

namespace Program {

namespace {

std::string beginning_of_temporary_names()
{
  return ".spherical_parameterization." + name_of_computer() + '.';
}

// The name of an incomplete file is hidden and contains the number of the writing process, so that files of killed processes are
// recognized.
std::string temporary_name()
{
  return beginning_of_temporary_names() + std::to_string(number_of_process()) + '.' +
         std::to_string(std::random_device()());
}

// Writes to a file, which has its own buffer, and updates the checksum.
class Summing_buffer : public std::streambuf
{
public:
  explicit Summing_buffer(std::FILE* file)
    : m_file(file)
  {}

  Checksum checksum;

protected:
  std::streamsize xsputn(const char* data, std::streamsize size) override
  {
    const std::size_t n = std::fwrite(data, 1, static_cast<std::size_t>(size), m_file);
    checksum.add(data, n);
    return static_cast<std::streamsize>(n);
  }

  int_type overflow(int_type c) override
  {
    const char character = traits_type::to_char_type(c);
    return xsputn(&character, 1) == 1 ? traits_type::not_eof(c) : traits_type::eof();
  }

private:
  std::FILE* m_file;
};

} // namespace

void sweep_temporary_files(const std::filesystem::path& folder)
{
  namespace fs = std::filesystem;
  std::error_code error, ignored;
  static std::set<fs::path> swept; // a process may write thousands of files to a folder, on several threads
  static std::mutex mutex;
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if(!swept.insert(folder).second)
      return;
  }
  const std::string begin = beginning_of_temporary_names();
  for(fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
  {
    const std::string name = name_of(entry->path().filename());
    std::int64_t process = 0;
    if(name.compare(0, begin.size(), begin) == 0 &&
       std::from_chars(name.data() + begin.size(), name.data() + name.size(), process).ec == std::errc() &&
       !is_running(process))
      fs::remove(entry->path(), ignored);
  }
}

// A file that appears complete or not at all: it is written under a temporary name in the same folder, and finally renamed.
class Output_files::File
{
public:
  // checks that the file can be written, without a lasting effect.
  File(const std::string& name_as_given, Output_policy policy)
    : name(name_as_given)
    , path(path_of(name_as_given))
  {
    namespace fs = std::filesystem;
    const bool follows = policy == Output_policy::follow;
    const fs::file_status status = follows ? fs::status(path, m_error) : fs::symlink_status(path, m_error);
    if(fs::is_directory(status))
      fail("it is a directory");
    if(fs::exists(status) && !fs::is_symlink(status))
    {
      // Renaming would replace even a write-protected file.
      check(is_writable(path));
      m_is_direct = !fs::is_regular_file(status);
      if(m_is_direct && !follows)
        fail("it is a pipe or a device, not a regular file; remove it, or choose another folder");
      if(m_is_direct)
        return;
      m_permissions = status.permissions() & fs::perms::all;
    }
    if(follows)
    {
      path = resolved(path, m_error);
      check_error();
      sweep_temporary_files(fs::absolute(path).parent_path());
    }
    m_temporary_path = path.parent_path() / temporary_name();
    write([](std::ostream&) {});
    checksum.reset();
    fs::remove(m_temporary_path, m_error);
  }

  ~File()
  {
    if(!m_temporary_path.empty())
      std::filesystem::remove(m_temporary_path, m_error);
  }

  File(const File&) = delete;
  File& operator=(const File&) = delete;

  // Creates the temporary file, which must not exist, not even as a link, or opens the pipe. The file gets the permissions of the
  // replaced file before it has any content.
  void write(const std::function<void(std::ostream&)>& write_to)
  {
    errno = 0;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
        m_is_direct ? open_to_write(path, false) : open_to_write(m_temporary_path, true), &std::fclose);
    check(file != nullptr);
    if(m_permissions)
      set_permissions(file.get(), *m_permissions);
    Summing_buffer buffer(file.get());
    std::ostream out(&buffer);
    errno = 0;
    write_to(out);
    check(out.good());
    check(std::fclose(file.release()) == 0);
    if(!m_is_direct)
      checksum = buffer.checksum;
  }

  void commit()
  {
    if(m_is_direct)
      return;
    rename_file(m_temporary_path, path, m_error);
    check_error();
  }

  bool is_direct() const { return m_is_direct; }

  std::string name;                 // as given
  std::filesystem::path path;       // of the file itself; links are resolved if they are followed
  std::optional<Checksum> checksum; // of the written content

private:
  [[noreturn]] void fail(const std::string& reason) const { throw error_in(name, "cannot be written: ", reason); }

  void check_error() const
  {
    if(m_error)
      fail(m_error.message());
  }

  // Reports the error of the system unless the last call has succeeded.
  void check(bool has_succeeded) const
  {
    if(!has_succeeded)
      fail(std::error_code(errno != 0 ? errno : EIO, std::generic_category()).message());
  }

  std::filesystem::path m_temporary_path;
  bool m_is_direct = false; // written directly under its own name
  std::optional<std::filesystem::perms> m_permissions;
  std::error_code m_error;
};

Output_files::Output_files(const Words& names, const Words& inputs, Output_policy policy)
{
  std::error_code ignored;
  for(const std::string& name : names)
    if(!name.empty())
      m_files.push_back(std::make_unique<File>(name, policy));
  for(auto file = m_files.begin(); file != m_files.end(); ++file)
  {
    const std::filesystem::path& path = (*file)->path;
    for(const std::string& input : inputs)
      if(!std::filesystem::is_symlink(path, ignored) && std::filesystem::equivalent(path, path_of(input), ignored))
        throw error_in((*file)->name, "would replace an input; choose another name");
    if(std::any_of(m_files.begin(), file, [&](const auto& other) { return other->path == path; }))
      throw error_in((*file)->name, "would be written twice; choose another name");
  }
}

Output_files::~Output_files() = default;

void Output_files::write(const std::string& name, const std::function<void(std::ostream&)>& write)
{
  if(!name.empty())
    file_of(name).write(write);
}

std::optional<Checksum> Output_files::checksum(const std::string& name) const
{
  return file_of(name).checksum;
}

void Output_files::commit()
{
  std::optional<Folder_lock> lock;
  if(m_files.size() > 1 && !m_files.front()->is_direct())
    lock.emplace(m_files.front()->path.parent_path());
  for(const auto& file : m_files)
    file->commit();
}

Words Output_files::names() const
{
  Words result;
  for(const auto& file : m_files)
    result.push_back(file->name);
  return result;
}

Output_files::File& Output_files::file_of(const std::string& name) const
{
  return **std::find_if(m_files.begin(), m_files.end(), [&](const auto& file) { return file->name == name; });
}

} // namespace Program
