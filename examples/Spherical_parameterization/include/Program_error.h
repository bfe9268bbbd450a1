#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_ERROR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_ERROR_H

#include <boost/locale/utf.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

namespace Program {

/// returns a text with `\xHH` for each byte that is no UTF-8. The name of a file may be any bytes, JSON may not.
///
/// \param keeps_controls whether newlines and other control characters, such as those that move the cursor of a terminal
///        or hide text, stay as they are
inline std::string valid_utf8(const std::string& text, bool keeps_controls = true)
{
  using Utf8 = boost::locale::utf::utf_traits<char>;
  constexpr boost::locale::utf::code_point first_printable = 0x20, first_above_ascii = 0x7f, last_control = 0x9f;
  std::string result;
  const char* const end = text.data() + text.size();
  for(const char *c = text.data(), *next = c; c != end; c = next)
  {
    const boost::locale::utf::code_point code = Utf8::decode(next, end);
    const bool is_valid = boost::locale::utf::is_valid_codepoint(code);
    const bool is_control = code < first_printable || (code >= first_above_ascii && code <= last_control);
    if(!is_valid)
      next = c + 1;
    if(is_valid && (keeps_controls || !is_control))
      result.append(c, next);
    else
      for(; c != next; ++c)
      {
        char escape[8];
        std::snprintf(escape, sizeof escape, "\\x%02x", static_cast<unsigned int>(static_cast<unsigned char>(*c)));
        result += escape;
      }
  }
  return result;
}

/// returns the name of a file as a terminal or a log can show it: in one line, and with nothing that they obey.
inline std::string printable(const std::string& name)
{
  return valid_utf8(name, false);
}

/// What the user has to be told before the program ends with exit status 1.
class Program_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;

  /// tells what is wrong with a file.
  Program_error(const std::string& file_name, const std::string& what)
    : std::runtime_error(printable(file_name) + ": " + what)
  {}
};

/// returns what the user is told of an error.
inline std::string message_of(const std::exception& error)
{
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "the memory does not suffice" : error.what();
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_ERROR_H
