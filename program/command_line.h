#ifndef PROGRAM_COMMAND_LINE_H
#define PROGRAM_COMMAND_LINE_H

#include "text.h"

#include <map>
#include <string>

namespace Program {

/// What the command line says, as words.
struct Command_line
{
  std::string command; ///< `map`, for example; empty if nothing but `printed` is wanted
  Words names;         ///< of files, in the order in which they were given
  std::map<std::string, Words> options;
  std::string printed; ///< the explanation, the version or the completion that was asked for
};

/// parses the command line.
///
/// \throws Program_error if an option is unknown, or lacks its words
Command_line parse_command_line(int argc, const char* const* argv);

/// returns the name of the program, its version, and that of CGAL.
std::string program_version();

} // namespace Program

#endif // PROGRAM_COMMAND_LINE_H
