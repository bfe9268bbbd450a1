#ifdef _WIN32

#include "system.h"

#ifndef NOMINMAX
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <shellapi.h>
#include <sys/stat.h>

namespace Program {

namespace {

std::string to_utf8(const wchar_t* text)
{
  const int size = WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
  std::string result(static_cast<std::size_t>(size), '\0');
  WideCharToMultiByte(CP_UTF8, 0, text, -1, &result[0], size, nullptr, nullptr);
  result.pop_back(); // the zero at the end
  return result;
}

} // namespace

Words start_process(int, char**)
{
  SetConsoleOutputCP(CP_UTF8);
  for(std::FILE* stream : {stdin, stdout, stderr})
    _setmode(_fileno(stream), _O_BINARY);
  Words words;
  int n = 0;
  wchar_t** const arguments = CommandLineToArgvW(GetCommandLineW(), &n);
  for(int k = 1; k < n; ++k)
    words.push_back(to_utf8(arguments[k]));
  LocalFree(arguments);
  return words;
}

bool has_terminal()
{
  return _isatty(_fileno(stderr)) != 0;
}

std::string name_of_computer()
{
  wchar_t name[MAX_COMPUTERNAME_LENGTH + 1] = {};
  DWORD size = MAX_COMPUTERNAME_LENGTH + 1;
  GetComputerNameW(name, &size);
  return to_utf8(name);
}

std::int64_t number_of_process()
{
  return GetCurrentProcessId();
}

bool is_running(std::int64_t process)
{
  const HANDLE handle = OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(process));
  if(handle == nullptr)
    return GetLastError() != ERROR_INVALID_PARAMETER;
  const bool result = WaitForSingleObject(handle, 0) == WAIT_TIMEOUT;
  CloseHandle(handle);
  return result;
}

bool is_writable(const std::filesystem::path& path)
{
  constexpr int to_write = 2;
  return _waccess(path.c_str(), to_write) == 0;
}

std::FILE* open_to_write(const std::filesystem::path& path, bool is_new)
{
  const int mode = _O_WRONLY | _O_BINARY | _O_CREAT | _O_NOINHERIT | (is_new ? _O_EXCL : _O_TRUNC);
  const int file = _wopen(path.c_str(), mode, _S_IREAD | _S_IWRITE);
  return file == -1 ? nullptr : _fdopen(file, "wb");
}

// A file that another process reads cannot be replaced.
void rename_file(const std::filesystem::path& path, const std::filesystem::path& new_path, std::error_code& error)
{
  constexpr DWORD pause = 10; // milliseconds
  constexpr int max_attempts = 200;
  for(int k = 0; k < max_attempts; ++k, Sleep(pause))
  {
    std::filesystem::rename(path, new_path, error);
    if(error != std::errc::permission_denied)
      return;
  }
}

void set_permissions(std::FILE*, std::filesystem::perms) {} // files inherit permissions from their folder

// No other process can open the file while it is open; it is deleted when it is closed, however the process ends.
Folder_lock::Folder_lock(const std::filesystem::path& folder)
  : m_path(folder / ".spherical_parameterization.lock")
{
  constexpr DWORD pause = 10; // milliseconds
  constexpr int max_denied =
      100; // access is denied while the file is being deleted, and always without write permission
  for(int n_denied = 0; n_denied < max_denied; Sleep(pause))
  {
    const HANDLE file = CreateFileW(m_path.c_str(), GENERIC_READ | GENERIC_WRITE | DELETE, 0, nullptr, OPEN_ALWAYS,
                                    FILE_FLAG_DELETE_ON_CLOSE | FILE_FLAG_OPEN_REPARSE_POINT, nullptr);
    if(file != INVALID_HANDLE_VALUE)
    {
      m_file = reinterpret_cast<std::intptr_t>(file);
      return;
    }
    const DWORD error = GetLastError();
    if(error == ERROR_ACCESS_DENIED)
      ++n_denied;
    else if(error != ERROR_SHARING_VIOLATION)
      return;
  }
}

Folder_lock::~Folder_lock()
{
  if(m_file != -1)
    CloseHandle(reinterpret_cast<HANDLE>(m_file));
}

} // namespace Program

#endif
