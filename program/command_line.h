#ifndef PROGRAM_COMMAND_LINE_H
#define PROGRAM_COMMAND_LINE_H

#include "text.h"

#include <cstddef>
#include <map>

namespace Program {

/// An option of a command.
struct Command_option
{
  std::string names; ///< `-o,--output`, for example
  std::string
      values; ///< what follows it: words with blanks between them, the last one with `...` for more; empty for a flag
  std::string help; ///< one line

  /// returns the long name without hyphens.
  std::string name() const { return names.substr(names.rfind("--") + 2); }
};

struct Command
{
  std::string name, summary, example, usage, text;
  std::size_t min_names, max_names; ///< how many names of files it takes
};

extern const std::vector<Command> commands;

/// The option that an option is of no use without.
extern const std::map<std::string, std::string> needed_options;

/// returns the options of a command, in the order in which they are explained.
std::vector<Command_option> options_of(const std::string& command);

/// What the command line says, as words.
struct Command_line
{
  std::string command;                  ///< `map`, for example; empty if nothing but `printed` is wanted
  std::string printed;                  ///< the explanation, the version or the completion that was asked for
  Words names;                          ///< of files, in the order in which they were given
  std::map<std::string, Words> options; ///< by their long names

  bool is(const char* name) const { return command == name; }
  bool has(const std::string& option) const { return options.count(option) > 0; }

  /// returns the words of an option, or the first one of them; empty if it was not given.
  Words words(const std::string& option) const { return has(option) ? options.at(option) : Words(); }
  std::string text(const std::string& option) const { return has(option) ? options.at(option).front() : std::string(); }

  [[noreturn]] void fail(const std::string& what) const;

  /// refuses the value of an option; `valid` says which would be accepted.
  [[noreturn]] void refuse(const std::string& option, const std::string& valid) const;

  /// reads one of some words, a number in [min, max], which is `range` in words, or a whole number up to 10^9; or returns what is usual.
  std::string word(const std::string& option, const Words& words, const std::string& usual) const;
  double number(const std::string& option, double min, double max, const std::string& range, double usual) const;
  unsigned int count(const std::string& option, unsigned int min, unsigned int usual,
                     const std::string& other_words = "") const;
};

/// parses the words of the command line behind the name of the program.
Command_line parse_command_line(Words words);

/// returns the name of the program, its version, and that of CGAL.
std::string program_version();

} // namespace Program

#endif // PROGRAM_COMMAND_LINE_H
