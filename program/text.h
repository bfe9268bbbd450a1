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

/// What the user has to know before the program ends with exit status 1: what is wrong, where, and what helps. All functions that
/// cannot do what they say throw it.
using Program_error = SP::internal::File_error;

/// returns the error that tells what is wrong with a file.
template <class... What>
Program_error error_in(const std::string& file_name, const What&... what)
{
  return Program_error(printable(file_name), ": ", what...);
}

/// calls `read()`, and names the file `path` in its errors.
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

/// returns what a stream prints of these, one behind the other.
template <class... Part>
std::string joined(const Part&... parts)
{
  return Program_error::join(parts...);
}

/// throws what the code says of a file, unless that is in order.
inline void check(SP::Error_code error, const std::string& file_name)
{
  if(error != SP::OK)
    throw error_in(file_name, SP::get_error_message(error));
}

/// returns the path with a name, and the name of a path. Names are UTF-8, with slashes, on every system; what `std::filesystem::path`
/// takes and returns is not.
std::filesystem::path path_of(const std::string& name);
std::string name_of(const std::filesystem::path& path);

/// returns what the user is told of an error.
std::string message_of(const std::exception& error);

bool is_among(const std::string& word, const Words& words);

/// returns "a, b, c", with another word before the last one if wanted.
std::string list_of(const Words& words, const std::string& last_separator = ", ");

/// returns the names of several files that have commas between them; one file if there is one that is called so.
Words split_list(const std::string& names);

/// returns whether a text is a number, and which.
bool is_number(const std::string& text, double& x);

/// returns a number with so many digits behind the point, or so many at all.
std::string fixed_text(double x, int digits, bool is_fixed = true);

} // namespace Program

#endif // PROGRAM_TEXT_H
