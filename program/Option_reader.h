#ifndef PROGRAM_OPTION_READER_H
#define PROGRAM_OPTION_READER_H

#include "Options.h"
#include "command_line.h"

#include <string>

namespace Program {

/// Reads what the words of the command line mean.
class Option_reader
{
public:
  /// \throws Program_error if an option is out of its range, of no use, or contradicts another one
  explicit Option_reader(const Command_line& line);

  Options o; ///< what has been read

private:
  void read_names();
  void read_resampling();
  void read_repair();
  void read_files();
  void read_match();
  void read_features();
  void read_sampling();
  void read_format();

  void read_method();
  void read_initial();
  void read_density();
  void read_preference();
  void read_energy();
  void read_sharpness();
  void read_schedule();
  void read_radius();
  void read_limits();

  bool has(const std::string& option) const { return m_line.options.count(option) > 0; }

  // Returns the first value of an option, which is empty if it was not given.
  std::string text(const std::string& option) const { return has(option) ? words(option).front() : std::string(); }
  Words words(const std::string& option) const { return has(option) ? m_line.options.at(option) : Words(); }

  bool is(const char* command) const { return o.command == command; }

  [[noreturn]] void fail(const std::string& what) const;

  // Refuses the value of an option; `valid` says which would be accepted.
  [[noreturn]] void refuse(const std::string& option, const std::string& valid) const;
  void refuse_both(const std::string& option, const std::string& other) const;

  // Refuses the name of a file that does not tell a format that can be written, or that can be told to hold no values.
  void check_output(const std::string& option, const std::string& name) const;
  void check_values(const std::string& option, const std::string& names) const;

  std::string read_word(const std::string& option, const Words& words, const std::string& usual) const;

  // Reads a number in [min, max], which is `range` in words.
  double read_number(const std::string& option, double min, double max, const std::string& range, double usual) const;
  unsigned int read_count(const std::string& option, unsigned int min, unsigned int usual) const;

  void describe(const std::string& setting) { o.description += ", " + setting; }

  // Returns whether the method has a setting of the name of `option`.
  bool knows(const std::string& option) const;

  const Command_line& m_line;
  std::string m_preference; // of --prefer
};

/// returns whether a text is a number, and which.
bool is_number(const std::string& text, double& x);

} // namespace Program

#endif // PROGRAM_OPTION_READER_H
