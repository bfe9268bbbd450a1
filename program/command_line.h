#ifndef PROGRAM_COMMAND_LINE_H
#define PROGRAM_COMMAND_LINE_H

#include "text.h"

#include <cstddef>
#include <map>

namespace Program {

/// An option of a command.
struct Command_option
{
  std::string names;      ///< `-o,--output`, for example
  std::string values;     ///< placeholders of its values, separated by blanks; empty for a flag
  std::string help;       ///< without line breaks
  std::string group = {}; ///< the heading under which the help lists it; empty for the first group

  /// returns the long name without hyphens.
  std::string name() const { return names.substr(names.rfind("--") + 2); }
};

struct Command
{
  std::string name, summary, example, usage, text;
  std::size_t min_names, max_names; ///< number of file names that it takes
};

extern const std::vector<Command> commands;

/// The option that another option requires.
extern const std::map<std::string, std::string> needed_options;

/// returns the options of a command in the order of its help.
std::vector<Command_option> options_of(const std::string& command);

/// The parsed words of the command line.
struct Command_line
{
  std::string command;                  ///< `map`, for example; empty if only `printed` is requested
  std::string printed;                  ///< the help, version, completion or manual page that was requested
  Words names;                          ///< of files, in the order of the command line
  std::map<std::string, Words> options; ///< values by the long names of the options

  bool is(const char* name) const { return command == name; }
  bool has(const std::string& option) const { return options.count(option) > 0; }

  /// returns the values of an option, or the first of them; empty if the option is not given.
  Words words(const std::string& option) const { return has(option) ? options.at(option) : Words(); }
  std::string text(const std::string& option) const { return has(option) ? options.at(option).front() : std::string(); }

  [[noreturn]] void fail(const std::string& what) const;

  /// reports that the value of an option is invalid; `valid` describes the accepted values.
  [[noreturn]] void refuse(const std::string& option, const std::string& valid) const;

  /// reads one of the given words, a number in [min, max], described by `range`, or an integer up to 10^9; returns the default `usual` if
  /// the option is not given.
  std::string word(const std::string& option, const Words& words, const std::string& usual) const;
  double number(const std::string& option, double min, double max, const std::string& range, double usual) const;
  unsigned int count(const std::string& option, unsigned int min, unsigned int usual,
                     const std::string& other_words = "") const;
};

/// parses the words of the command line after the name of the program.
Command_line parse_command_line(Words words);

/// returns the name of the program, its version, and that of CGAL.
std::string program_version();

} // namespace Program

#endif // PROGRAM_COMMAND_LINE_H
