#ifndef PROGRAM_TEXT_H
#define PROGRAM_TEXT_H

#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>
#include <CGAL/Spherical_parameterization/internal/files/printable_text.h>

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace Program {

namespace SP = CGAL::Spherical_parameterization;

using SP::internal::printable;
using SP::internal::valid_utf8;

using Words = std::vector<std::string>;

/// An error that ends the program with exit status 1. The message says what is wrong, where, and what helps. All functions throw it on
/// failure.
using Program_error = SP::internal::File_error;

/// returns an error whose message begins with the file name.
template <class... What>
Program_error error_in(const std::string& file_name, const What&... what)
{
  return Program_error(printable(file_name), ": ", what...);
}

/// calls `read()` and adds the file name `path` to its errors.
template <class Read>
auto read_named(const std::string& path, const Read& read)
{
  try
  {
    return read();
  }
  catch(const Program_error& error)
  {
    throw error_in(path, error.what());
  }
}

/// returns the concatenated stream output of the arguments.
template <class... Part>
std::string joined(const Part&... parts)
{
  return Program_error::join(parts...);
}

/// throws the message of an error code, with the file name, unless it is `OK`.
inline void check(SP::Error_code error, const std::string& file_name)
{
  if(error != SP::OK)
    throw error_in(file_name, SP::get_error_message(error));
}

/// converts between names and paths. Names are UTF-8, with slashes, on every system, unlike the strings of `std::filesystem::path`.
std::filesystem::path path_of(const std::string& name);
std::string name_of(const std::filesystem::path& path);

/// returns the message of an error for the user.
std::string message_of(const std::exception& error);

bool is_among(const std::string& word, const Words& words);

/// returns "a, b, c", optionally with another separator before the last word.
std::string list_of(const Words& words, const std::string& last_separator = ", ");

/// returns the candidate that differs from a word by the fewest inserted, deleted and replaced characters, at most 2 and fewer than the
/// word has; empty if there is none.
std::string nearest_of(const std::string& word, const Words& candidates);

/// splits comma-separated file names; an existing file whose name contains commas is one file.
Words split_list(const std::string& names);

/// returns whether a text is a number, and its value.
bool is_number(const std::string& text, double& x);

/// returns a number with the given digits after the point, or significant digits.
std::string fixed_text(double x, int digits, bool is_fixed = true);

} // namespace Program

#endif // PROGRAM_TEXT_H
