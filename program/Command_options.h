#ifndef PROGRAM_COMMAND_OPTIONS_H
#define PROGRAM_COMMAND_OPTIONS_H

#include <map>
#include <string>
#include <vector>

namespace Program {

/// An option of a command.
struct Command_option
{
  std::string names; ///< `-o,--output`, for example
  std::string
      values; ///< what follows it: words with blanks between them, with `...` at the end for more; empty for a flag
  std::string help; ///< one line

  /// returns the long name without hyphens.
  std::string name() const { return names.substr(names.rfind("--") + 2); }

  /// returns its names as they are shown.
  std::string shown() const { return names.front() == '-' && names[1] != '-' ? names.substr(0, 2) : names; }

  int number_of_values() const;
  bool takes_more() const { return values.size() > 3 && values.compare(values.size() - 3, 3, "...") == 0; }
};

struct Command
{
  std::string name, summary, example, usage, text;
  std::size_t min_names, max_names; ///< how many names of files it takes
};

extern const std::vector<Command> commands;

/// The options that an option is of no use without, by both names.
extern const std::map<std::string, std::vector<const char*>> needed_options;

/// returns the options of a command, in the order in which they are explained.
std::vector<Command_option> options_of(const std::string& command);

} // namespace Program

#endif // PROGRAM_COMMAND_OPTIONS_H
