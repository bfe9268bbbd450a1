#include "command_line.h"

#include "Command_options.h"

#include <CLI/CLI.hpp>

#include <CGAL/version_macros.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Program {

namespace {

constexpr const char* program = "spherical_parameterization";

// What has another form now. Options that another command has need no line.
const std::map<std::string, std::string> new_forms = {
    {"--onto", "the command match now: match SURFACE TARGET"},
    {"--onto-atlas", "the command register now: register SURFACE ATLAS --features A B"},
    {"--remesh", "the command remesh now: remesh SURFACE DOMAIN=N"},
    {"--resample", "the command resample now: resample VALUES SPHERE_A SPHERE_B -o RESULT"},
    {"--through", "an option of resample now: resample SPHERE SPHERE_A SPHERE_B --through -o RESULT"},
    {"--filled", "the command repair now: repair SURFACE --fill-holes N -o RESULT"},
    {"--s-first", "the first number of --schedule now: map SURFACE --schedule FIRST,LAST"},
    {"--s-last", "the second number of --schedule now: map SURFACE --schedule FIRST,LAST"},
    {"--average-sweeps", "the third number of --schedule now: map SURFACE --schedule FIRST,LAST,SWEEPS"}};

// A command with its options as CLI11 has them.
class Parser
{
public:
  explicit Parser(const Command& command)
  {
    m_app.set_help_flag("-h,--help", "explain this command");
    m_app.add_option("names", m_line.names)->expected(0, -1);
    for(const Command_option& option : options_of(command.name))
    {
      const std::string name = option.name();
      Words& words = m_line.options[name];
      if(option.values.empty())
        m_flags.emplace_back(name, m_app.add_flag(option.names, option.help));
      else
        m_app.add_option(option.names, words, option.help)
            ->expected(option.number_of_values(), option.takes_more() ? -1 : option.number_of_values());
    }
    m_line.command = command.name;
    for(const auto& [option, others] : needed_options)
      for(const char* other : others)
        if(CLI::Option* first = m_app.get_option_no_throw(option), *second = m_app.get_option_no_throw(other);
           first && second)
          first->needs(second);
  }

  bool has(const std::string& option) const { return m_app.get_option_no_throw(option) != nullptr; }

  // Returns what is given.
  Command_line parse(Words words)
  {
    std::reverse(words.begin(), words.end());
    m_app.parse(words);
    for(const auto& [name, flag] : m_flags)
      if(flag->count() > 0)
        m_line.options[name] = {""};
    for(auto entry = m_line.options.begin(); entry != m_line.options.end();)
      entry = entry->second.empty() ? m_line.options.erase(entry) : std::next(entry);
    return m_line;
  }

private:
  CLI::App m_app;
  Command_line m_line;
  std::vector<std::pair<std::string, CLI::Option*>> m_flags;
};

[[noreturn]] void fail(const std::string& what, const std::string& command)
{
  throw Program_error(what, "\nAll options are explained by: ", program, ' ', command, command.empty() ? "" : " ",
                      "--help");
}

// Refuses an option that the command does not have, if it is known otherwise.
void check_option(const std::string& word, const Parser& parser, const Command& command)
{
  const std::string option = word.substr(0, word.find('='));
  if(option.compare(0, 2, "--") != 0 || option == "--" || parser.has(option))
    return;
  const auto form = new_forms.find(option);
  if(form != new_forms.end())
  {
    std::string text = form->second;
    text.insert(text.find(": ") + 2, std::string(program) + ' ');
    fail(option + " is " + text + " ...", command.name);
  }
  Words others;
  for(const Command& other : commands)
    if(Parser(other).has(option))
      others.push_back(other.name);
  if(!others.empty())
    fail(option + " is no option of " + command.name + ", but of " + list_of(others, " and "), command.name);
}

std::string help_of(const Command& command)
{
  constexpr std::size_t column = 25;
  std::string text = "Example: " + std::string(program) + ' ' + command.name + ' ' + command.example +
                     "\nUsage: " + program + ' ' + command.name + ' ' + command.usage + "\n\n" + command.text + "\n\n";
  for(const Command_option& option : options_of(command.name))
  {
    std::string line = "  " + option.shown() + (option.values.empty() ? "" : " " + option.values);
    line.resize((std::max)(line.size() + 1, column), ' ');
    text += line + option.help + '\n';
  }
  return text;
}

std::string help()
{
  constexpr std::size_t column = 12;
  std::string text =
      "Example: " + std::string(program) + " cow.off -o sphere.off\n\n" +
      "Maps a closed triangle mesh of genus 0 to a sphere, one-to-one and with low distortion, certified\n"
      "by exact arithmetic; and what can be done with such maps. The first word is a command:\n\n";
  for(const Command& command : commands)
  {
    std::string line = "  " + command.name + ' ';
    line.resize((std::max)(line.size(), column), ' ');
    text += line + command.summary + '\n';
  }
  return text + "\nWithout one, map is meant; with --output-folder, batch. " + program + " COMMAND --help\n" +
         R"(explains its options. Files are .off, .obj, .ply, .stl, .ts, or surfaces in the formats GIFTI
(.gii, .gii.gz) and of FreeSurfer, such as lh.white. Ctrl-C ends the sweeps; the map reached is
written.

  -h, --help          print this
  --version           print the version
  --completion bash   print what completes commands and options in this shell

Exit status: 0, all that was asked for was written, and every map in it is certified as one-to-one;
1, an error, of which a message tells; 2, a map folds, which --method conformal and arap do not
exclude, but all files were written nevertheless. With batch: 1, some meshes have no map; 2, all
have one, but some fold.
)";
}

std::string completion()
{
  Words names;
  std::string cases;
  for(const Command& command : commands)
  {
    names.push_back(command.name);
    std::string options = "--help";
    for(const Command_option& option : options_of(command.name))
      options += " --" + option.name();
    cases += "    " + command.name + ") words=\"" + options + "\" ;;\n";
  }
  std::string all;
  for(const std::string& name : names)
    all += name + ' ';
  return std::string("# Completes commands and options of ") + program + " in bash, and names of files elsewhere.\n_" +
         program + "()\n{\n  local word=${COMP_WORDS[COMP_CWORD]} words=\n  case ${COMP_WORDS[1]} in\n" + cases +
         "    *) words=\"--help --version --completion\" ;;\n  esac\n  [ \"$COMP_CWORD\" -gt 1 ] || words+=\" " + all +
         "\"\n  [[ $word == -* || $COMP_CWORD == 1 ]] && mapfile -t COMPREPLY < <(compgen -W \"$words\" -- "
         "\"$word\")\n}\n"
         "complete -o default -F _" +
         program + ' ' + program + '\n';
}

} // namespace

std::string program_version()
{
#ifdef SPHERICAL_PARAMETERIZATION_VERSION
  constexpr const char* version = SPHERICAL_PARAMETERIZATION_VERSION;
#else
  constexpr const char* version = "of CGAL"; // within which the package has no version of its own
#endif
  return std::string(program) + ' ' + version + ", built with CGAL " + CGAL_VERSION_STR;
}

Command_line parse_command_line(int argc, const char* const* argv)
{
  Words words(argv + 1, argv + argc);
  Command_line line;
  const std::string first = words.empty() ? "" : words.front();
  if(is_among(first, {"-h", "--help"}))
    line.printed = help();
  else if(first == "--version")
    line.printed = program_version() + '\n';
  else if(first == "--completion")
    line.printed = completion();
  if(!line.printed.empty())
    return line;

  const auto is_named = [](const std::string& name) {
    return [name](const Command& command) { return command.name == name; };
  };
  auto command = std::find_if(commands.begin(), commands.end(), is_named(first));
  if(command != commands.end())
    words.erase(words.begin());
  else
  {
    const auto is_folder = [](const std::string& word) { return word.compare(0, 15, "--output-folder") == 0; };
    const bool is_batch = std::any_of(words.begin(), words.end(), is_folder);
    command = std::find_if(commands.begin(), commands.end(), is_named(is_batch ? "batch" : "map"));
  }
  Parser parser(*command);
  for(const std::string& word : words)
    check_option(word, parser, *command);
  try
  {
    line = parser.parse(words);
  }
  catch(const CLI::CallForHelp&)
  {
    return {"", {}, {}, help_of(*command)};
  }
  catch(const CLI::ParseError& error)
  {
    fail(printable(error.what()), command->name);
  }
  return line;
}

} // namespace Program
