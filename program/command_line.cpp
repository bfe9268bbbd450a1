#include "command_line.h"

#include <CGAL/Spherical_parameterization/reproducibility.h>

#include <CLI/CLI.hpp>

#include <CGAL/version_macros.h>

#include <algorithm>
#include <cmath>

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
    {"--fill-holes", "part of --repair now: map SURFACE --repair"},
    {"--components", "--repair now, which keeps the largest, or --each-component: map SURFACE --repair"},
    {"--filled", "the command repair now: repair SURFACE -o RESULT"},
    {"--s-first", "the first number of --schedule now: map SURFACE --schedule FIRST,LAST"},
    {"--s-last", "the second number of --schedule now: map SURFACE --schedule FIRST,LAST"},
    {"--average-sweeps", "the third number of --schedule now: map SURFACE --schedule FIRST,LAST,SWEEPS"}};

[[noreturn]] void fail_of(const std::string& command, const std::string& what)
{
  throw Program_error(what, "\nAll options are explained by: ", program, ' ', command, " --help");
}

bool has_option(const Command& command, const std::string& option)
{
  const std::vector<Command_option> options = options_of(command.name);
  return option == "--help" || std::any_of(options.begin(), options.end(),
                                           [&](const Command_option& other) { return "--" + other.name() == option; });
}

// Refuses an option that the command does not have, if it is known otherwise.
void check_option(const std::string& word, const Command& command)
{
  const std::string option = word.substr(0, word.find('='));
  if(option.compare(0, 2, "--") != 0 || has_option(command, option))
    return;
  const auto form = new_forms.find(option);
  if(form != new_forms.end())
  {
    std::string text = form->second;
    text.insert(text.find(": ") + 2, std::string(program) + ' ');
    fail_of(command.name, option + " is " + text + " ...");
  }
  Words others;
  for(const Command& other : commands)
    if(has_option(other, option))
      others.push_back(other.name);
  if(!others.empty())
    fail_of(command.name, option + " is no option of " + command.name + ", but of " + list_of(others, " and "));
}

std::string help_of(const Command& command)
{
  constexpr std::size_t column = 27;
  const std::string name = std::string(program) + ' ' + command.name + ' ';
  std::string text =
      "Example: " + name + command.example + "\nUsage: " + name + command.usage + "\n\n" + command.text + "\n\n";
  for(const Command_option& option : options_of(command.name))
  {
    const std::string names = option.names.substr(0, option.names.find(',')); // `-o` of `-o,--output`
    std::string line = "  " + names + (option.values.empty() ? "" : " " + option.values);
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
      "Maps a closed triangle mesh of genus 0 to a sphere, one-to-one and with low distortion, certified by\n"
      "exact arithmetic; and what can be done with such maps. The first word is a command:\n\n";
  for(const Command& command : commands)
  {
    std::string line = "  " + command.name + ' ';
    line.resize((std::max)(line.size(), column), ' ');
    text += line + command.summary + '\n';
  }
  return text + "\nWithout one, map is meant, and with --output-folder, batch. " + program + "\n" +
         R"(COMMAND --help explains its options. Files are .off, .obj, .ply, .stl, .ts, or surfaces in the
formats GIFTI (.gii, .gii.gz) and of FreeSurfer, such as lh.white. Ctrl-C ends the sweeps; the map
reached is written.

  -h, --help          print this
  --version           print the version
  --completion bash   print what completes commands and options in this shell
  --manual            print the manual page, for man

Exit status: 0, all that was asked for was written, and every map in it is certified as one-to-one;
1, an error, with a message; 2, a map has inverted faces, which --method conformal and arap, and
resample --through, do not exclude, but all files were written. With batch: 1, some meshes have no map;
2, all have one, but some have inverted faces.
)";
}

std::string completion()
{
  std::string names, cases;
  for(const Command& command : commands)
  {
    names += command.name + ' ';
    cases += "    " + command.name + ") words=\"--help";
    for(const Command_option& option : options_of(command.name))
      cases += " --" + option.name();
    cases += "\" ;;\n";
  }
  return std::string("# Completes commands and options of ") + program + " in bash, and names of files elsewhere.\n_" +
         program + "()\n{\n  local word=${COMP_WORDS[COMP_CWORD]} words=\n  case ${COMP_WORDS[1]} in\n" + cases +
         "    *) words=\"--help --version --completion --manual\" ;;\n  esac\n  [ \"$COMP_CWORD\" -gt 1 ] || "
         "words+=\" " +
         names +
         "\"\n  [[ $word == -* || $COMP_CWORD == 1 ]] && mapfile -t COMPREPLY < <(compgen -W \"$words\" -- "
         "\"$word\")\n}\n"
         "complete -o default -F _" +
         program + ' ' + program + '\n';
}

// What is to be read literally by man.
std::string escaped(const std::string& text)
{
  std::string result;
  for(std::size_t i = 0; i < text.size(); ++i)
  {
    if((i == 0 || text[i - 1] == '\n') && (text[i] == '.' || text[i] == '\''))
      result += "\\&";
    result += text[i] == '-' ? "\\-" : text[i] == '\\' ? "\\e" : std::string(1, text[i]);
  }
  return result;
}

// The manual page, in the format of man.
std::string manual()
{
  const std::string name = program;
  std::string synopsis, details;
  for(const Command& command : commands)
  {
    synopsis += ".B " + escaped(name + ' ' + command.name) + '\n' + escaped(command.usage) + "\n.br\n";
    details += ".SS " + command.name + '\n' + escaped(command.text) + "\n.PP\nExample:\n.B " +
               escaped(name + ' ' + command.name + ' ' + command.example) + '\n';
    for(const Command_option& option : options_of(command.name))
    {
      std::string names = option.names;
      if(const std::size_t comma = names.find(','); comma != std::string::npos)
        names.insert(comma + 1, " ");
      details += ".TP\n.B " + escaped(names + (option.values.empty() ? "" : " " + option.values)) + '\n' +
                 escaped(option.help) + '\n';
    }
  }
  return ".TH " + name + " 1 \"\" \"" + escaped(program_version().substr(0, program_version().find(','))) +
         "\" \"User Commands\"\n.SH NAME\n" + escaped(name) +
         " \\- map surfaces to the sphere and onto each other, one\\-to\\-one\n.SH SYNOPSIS\n" + synopsis +
         ".SH DESCRIPTION\n.nf\n" + escaped(help()) + ".fi\n.SH COMMANDS\n" + details;
}

// Parses the words behind a command.
Command_line parse(const Command& command, Words words)
{
  for(const std::string& word : words)
    check_option(word, command);
  CLI::App app;
  Command_line line;
  line.command = command.name;
  app.allow_windows_style_options(false); // nor is /home/mesh.off one
  app.set_help_flag("-h,--help", "explain this command");
  app.add_option("names", line.names)->expected(0, -1);
  for(const Command_option& option : options_of(command.name))
    if(option.values.empty())
      app.add_flag(option.names, option.help);
    else
    {
      const int n = 1 + static_cast<int>(std::count(option.values.begin(), option.values.end(), ' '));
      app.add_option(option.names, line.options[option.name()], option.help)
          ->expected(n)
          ->allow_extra_args(false); // what follows are names
    }
  for(const auto& [option, other] : needed_options)
    if(has_option(command, option))
      app.get_option(option)->needs(app.get_option(other));
  try
  {
    std::reverse(words.begin(), words.end());
    app.parse(words);
  }
  catch(const CLI::CallForHelp&)
  {
    return {"", help_of(command), {}, {}};
  }
  catch(const CLI::ParseError& error)
  {
    line.fail(printable(error.what()));
  }
  line.options.clear();
  for(const CLI::Option* option : app.get_options())
    if(option->count() > 0 && !option->get_lnames().empty())
      line.options[option->get_lnames().front()] = option->results();
  return line;
}

} // namespace

std::string program_version()
{
#ifdef SPHERICAL_PARAMETERIZATION_VERSION
  constexpr const char* version = SPHERICAL_PARAMETERIZATION_VERSION;
#else
  constexpr const char* version = "of CGAL"; // within which the package has no version of its own
#endif
  return std::string(program) + ' ' + version + ", results " +
         (SP::is_reproducible() ? SP::results_version : "of this build alone") + ", built with CGAL " +
         CGAL_VERSION_STR;
}

void Command_line::fail(const std::string& what) const
{
  fail_of(command, what);
}

void Command_line::refuse(const std::string& option, const std::string& valid) const
{
  fail("--" + option + " has to be " + valid + ", not '" + printable(text(option)) + "'");
}

std::string Command_line::word(const std::string& option, const Words& words, const std::string& usual) const
{
  if(has(option) && !is_among(text(option), words))
    refuse(option, list_of(words, " or "));
  return has(option) ? text(option) : usual;
}

double Command_line::number(const std::string& option, double min, double max, const std::string& range,
                            double usual) const
{
  double x = usual;
  if(has(option) && (!is_number(text(option), x) || !(x >= min && x <= max)))
    refuse(option, range);
  return x;
}

unsigned int Command_line::count(const std::string& option, unsigned int min, unsigned int usual,
                                 const std::string& other_words) const
{
  const std::string range = "a whole number from " + std::to_string(min) + " to 1e9" + other_words;
  const double x = number(option, min, 1e9, range, usual);
  if(x != std::floor(x))
    refuse(option, range);
  return static_cast<unsigned int>(x);
}

Command_line parse_command_line(Words words)
{
  const std::string first = words.empty() ? "" : words.front();
  if(is_among(first, {"-h", "--help", "--version", "--completion", "--manual"}))
    return {"",
            first == "--version"      ? program_version() + '\n'
            : first == "--completion" ? completion()
            : first == "--manual"     ? manual()
                                      : help(),
            {},
            {}};
  const auto find = [](const std::string& name) {
    return std::find_if(commands.begin(), commands.end(), [&](const Command& other) { return other.name == name; });
  };
  auto command = find(first);
  if(command != commands.end())
    words.erase(words.begin());
  else
  {
    const auto is_folder = [](const std::string& word) { return word.compare(0, 15, "--output-folder") == 0; };
    command = find(std::any_of(words.begin(), words.end(), is_folder) ? "batch" : "map");
  }
  const Command_line line = parse(*command, words);
  if(line.printed.empty() && line.names.empty())
    line.fail("there is no name of a file; " + command->name + " takes " + command->usage);
  if(line.printed.empty() && line.names.size() < command->min_names)
    line.fail(command->name + " needs " + command->usage);
  if(line.names.size() > command->max_names)
    line.fail(
        line.is("map")
            ? "'" + printable(line.names.front()) +
                  "' is no command, and map takes one SURFACE; a name with blanks has to be quoted, and many meshes "
                  "need --output-folder"
            : command->name + " takes " + command->usage + "; a name with blanks has to be quoted");
  return line;
}

} // namespace Program
