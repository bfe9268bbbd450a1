#include "command_line.h"

#include <CGAL/Spherical_parameterization/reproducibility.h>

#include <CLI/CLI.hpp>

#include <CGAL/version_macros.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Program {

namespace {

constexpr const char* program = "spherical_parameterization";

// Options of earlier versions and their present form. Options that another command has need no line.
const std::map<std::string, std::string> new_forms = {
    {"--onto", "replaced by the command match: match SURFACE TARGET"},
    {"--onto-atlas", "replaced by the command register: register SURFACE ATLAS --features A B"},
    {"--remesh", "replaced by the command remesh: remesh SURFACE DOMAIN=N"},
    {"--resample", "replaced by the command resample: resample VALUES SPHERE_A SPHERE_B -o RESULT"},
    {"--through", "an option of the command resample: resample SPHERE SPHERE_A SPHERE_B --through -o RESULT"},
    {"--fill-holes", "replaced by --repair: map SURFACE --repair"},
    {"--components",
     "replaced by --repair, which keeps the largest component, or --each-component: map SURFACE --repair"},
    {"--filled", "replaced by the command repair: repair SURFACE -o RESULT"},
    {"--s-first", "replaced by the first number of --schedule: map SURFACE --schedule FIRST,LAST"},
    {"--s-last", "replaced by the second number of --schedule: map SURFACE --schedule FIRST,LAST"},
    {"--average-sweeps", "replaced by the third number of --schedule: map SURFACE --schedule FIRST,LAST,SWEEPS"}};

using Terms = std::vector<std::pair<std::string, std::string>>;

constexpr const char* introduction =
    "Maps closed triangle meshes of genus 0 to the sphere, bijectively and with low distortion. Exact arithmetic "
    "certifies each map.";

constexpr const char* default_command =
    "The default command is map, and batch with --output-folder. For the options of a command, see "
    "'spherical_parameterization COMMAND --help'.";

constexpr const char* files_and_signals =
    "Files are .off, .obj, .ply, .stl and .ts meshes, or cortical surfaces in GIFTI (.gii, .gii.gz) and FreeSurfer "
    "formats (such as lh.white). Ctrl-C stops the sweeps; the current map is written.";

const Terms general_options = {{"-h, --help", "print this help"},
                               {"--version", "print the version"},
                               {"--completion bash", "print a completion script for bash"},
                               {"--manual", "print the manual page, in the format of man"}};

const Terms exit_statuses = {
    {"0", "All requested files were written, and every map in them is certified bijective."},
    {"1", "An error occurred and is reported. For batch: some meshes were not mapped."},
    {"2",
     "All files were written, but a map is not bijective. This is possible with --method conformal, --method arap, "
     "resample --through, and a given SPHERE."}};

[[noreturn]] void fail_of(const std::string& command, const std::string& what)
{
  throw Program_error(what, "\nSee '", program, ' ', command, " --help'.");
}

bool has_option(const Command& command, const std::string& option)
{
  const std::vector<Command_option> options = options_of(command.name);
  return option == "--help" || std::any_of(options.begin(), options.end(),
                                           [&](const Command_option& other) { return "--" + other.name() == option; });
}

// Reports a long option that the command does not have: where it is now, which command has it, or the most similar one.
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
    fail_of(command.name, option + " is not an option of " + command.name + ", but of " + list_of(others, " and "));
  Words names = {"--help"};
  for(const Command_option& other : options_of(command.name))
    names.push_back("--" + other.name());
  const std::string nearest = nearest_of(option, names);
  fail_of(command.name,
          "unknown option " + printable(option) + (nearest.empty() ? "" : "; did you mean " + nearest + '?'));
}

// Reports a first word that is no file but similar to a command.
void check_first_word(const std::string& word)
{
  std::error_code ignored;
  if(word.compare(0, 1, "-") == 0 || std::filesystem::exists(path_of(word), ignored))
    return;
  Words names;
  for(const Command& command : commands)
    names.push_back(command.name);
  if(const std::string nearest = nearest_of(word, names); !nearest.empty())
    fail_of(nearest, "'" + printable(word) + "' is not a command; did you mean '" + nearest + "'?");
}

// Appends words to a text whose last line has `column` characters; further lines are indented.
void append_wrapped(std::string& text, const std::string& words, std::size_t column)
{
  constexpr std::size_t width = 100;
  const std::string indent(column, ' ');
  std::istringstream in(words);
  std::size_t length = column;
  for(std::string word; in >> word;)
  {
    if(length > column && length + 1 + word.size() > width)
    {
      text += '\n' + indent;
      length = column;
    }
    text += (length > column ? " " : "") + word;
    length += word.size() + (length > column ? 1 : 0);
  }
  text += '\n';
}

std::string help_of(const Command& command)
{
  constexpr std::size_t column = 30;
  const std::string name = std::string(program) + ' ' + command.name + ' ';
  std::string text = "Usage: " + name + command.usage + "\n\n", heading;
  append_wrapped(text, command.text, 0);
  for(const Command_option& option : options_of(command.name))
  {
    if(const std::string group = option.group.empty() ? "Options" : option.group; group != heading)
      text += '\n' + (heading = group) + ":\n";
    const std::string names = option.names.substr(0, option.names.find(',')); // `-o` of `-o,--output`
    std::string line = "  " + names + (option.values.empty() ? "" : " " + option.values);
    line.resize((std::max)(line.size() + 1, column), ' ');
    text += line;
    append_wrapped(text, option.help, column);
  }
  return text + "\nExample: " + name + command.example + '\n';
}

// Adds lines with a term and its explanation.
void append_terms(std::string& text, const Terms& terms, std::size_t column)
{
  for(const auto& [term, explanation] : terms)
  {
    std::string line = "  " + term;
    line.resize((std::max)(line.size() + 1, column), ' ');
    append_wrapped(text += line, explanation, column);
  }
}

std::string help()
{
  std::string text = "Usage: " + std::string(program) + " COMMAND [ARGUMENT...] [OPTION...]\n\n";
  append_wrapped(text, introduction, 0);
  text += "\nCommands:\n";
  Terms summaries;
  for(const Command& command : commands)
    summaries.emplace_back(command.name, command.summary);
  append_terms(text, summaries, 12);
  append_wrapped(text += '\n', default_command, 0);
  text += "\nOptions:\n";
  append_terms(text, general_options, 22);
  append_wrapped(text += '\n', files_and_signals, 0);
  text += "\nExit status:\n";
  append_terms(text, exit_statuses, 6);
  return text + "\nExample: " + program + " cow.off -o sphere.off\n";
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
  return std::string("# Completion of commands, options and file names of ") + program + " for bash.\n_" + program +
         "()\n{\n  local word=${COMP_WORDS[COMP_CWORD]} words=\n  case ${COMP_WORDS[1]} in\n" + cases +
         "    *) words=\"--help --version --completion --manual\" ;;\n  esac\n  [ \"$COMP_CWORD\" -gt 1 ] || "
         "words+=\" " +
         names +
         "\"\n  [[ $word == -* || $COMP_CWORD == 1 ]] && mapfile -t COMPREPLY < <(compgen -W \"$words\" -- "
         "\"$word\")\n}\n"
         "complete -o default -F _" +
         program + ' ' + program + '\n';
}

// Escapes text for the format of man.
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
  const auto terms = [](const Terms& all) {
    std::string text;
    for(const auto& [term, explanation] : all)
      text += ".TP\n.B " + escaped(term) + '\n' + escaped(explanation) + '\n';
    return text;
  };
  for(const Command& command : commands)
  {
    synopsis += ".B " + escaped(name + ' ' + command.name) + '\n' + escaped(command.usage) + "\n.br\n";
    details += ".SS " + command.name + '\n' + escaped(command.text) + "\n.PP\nExample:\n.B " +
               escaped(name + ' ' + command.name + ' ' + command.example) + '\n';
    std::string group;
    for(const Command_option& option : options_of(command.name))
    {
      if(option.group != group)
        details += ".PP\n.I " + escaped(option.group) + '\n';
      group = option.group;
      std::string names = option.names;
      if(const std::size_t comma = names.find(','); comma != std::string::npos)
        names.insert(comma + 1, " ");
      details += ".TP\n.B " + escaped(names + (option.values.empty() ? "" : " " + option.values)) + '\n' +
                 escaped(option.help) + '\n';
    }
  }
  return ".TH " + name + " 1 \"\" \"" + escaped(program_version().substr(0, program_version().find(','))) +
         "\" \"User Commands\"\n.SH NAME\n" + escaped(name) +
         " \\- bijective maps of surfaces to the sphere and onto each other\n.SH SYNOPSIS\n" + synopsis +
         ".SH DESCRIPTION\n" + escaped(introduction) + "\n.PP\n" + escaped(default_command) + "\n.PP\n" +
         escaped(files_and_signals) + "\n.SH OPTIONS\n" + terms(general_options) + ".SH COMMANDS\n" + details +
         ".SH EXIT STATUS\n" + terms(exit_statuses);
}

// Parses the words after a command.
Command_line parse(const Command& command, Words words)
{
  for(auto word = words.begin(); word != words.end() && *word != "--"; ++word) // file names follow
    check_option(*word, command);
  CLI::App app;
  Command_line line;
  line.command = command.name;
  app.allow_windows_style_options(false); // /home/mesh.off is a file name
  app.set_help_flag("-h,--help", "print this help");
  app.add_option("names", line.names)->expected(0, -1);
  for(const Command_option& option : options_of(command.name))
    if(option.values.empty())
      app.add_flag(option.names, option.help);
    else
    {
      const int n = 1 + static_cast<int>(std::count(option.values.begin(), option.values.end(), ' '));
      app.add_option(option.names, line.options[option.name()], option.help)
          ->expected(n)
          ->allow_extra_args(false); // the words after these are file names
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
  constexpr const char* version = "of CGAL"; // as a part of CGAL, the package has no version of its own
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
  fail("--" + option + " must be " + valid + ", not '" + printable(text(option)) + "'");
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
  const std::string range = "an integer from " + std::to_string(min) + " to 1e9" + other_words;
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
    check_first_word(first);
    const auto is_folder = [](const std::string& word) { return word.compare(0, 15, "--output-folder") == 0; };
    command = find(std::any_of(words.begin(), words.end(), is_folder) ? "batch" : "map");
  }
  const Command_line line = parse(*command, words);
  if(line.printed.empty() && line.names.empty())
    line.fail("no file name is given; usage: " + command->name + ' ' + command->usage);
  if(line.printed.empty() && line.names.size() < command->min_names)
    line.fail("too few file names; usage: " + command->name + ' ' + command->usage);
  if(line.names.size() > command->max_names)
    line.fail(line.is("map")
                  ? "'" + printable(line.names.front()) +
                        "' is not a command, and map takes one SURFACE; quote file names that contain blanks, and use "
                        "--output-folder for many meshes"
                  : "too many file names; quote those that contain blanks; usage: " + command->name + ' ' +
                        command->usage);
  return line;
}

} // namespace Program
