#include "Option_reader.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <vector>

namespace Program {

namespace {

const Words methods = {"bld", "hierarchical", "harmonic", "conformal", "arap", "stereographic", "schnyder"};
const Words starts = {"hierarchical", "stereographic", "harmonic", "conformal", "schnyder"};

// Which methods an option goes with; options that are not listed go with all.
struct Scope
{
  std::string option;
  Words methods;
  bool goes_with_paper;
};

const std::vector<Scope> scopes = {
    {"initial", {"bld", "arap"}, true},
    {"energy", {"bld", "hierarchical"}, false},
    {"prefer", {"bld", "hierarchical"}, false},
    {"sharpness", {"bld", "hierarchical"}, false},
    {"schedule", {"bld"}, true},
    {"density", {"bld"}, false},
    {"radius", {"bld"}, true},
    {"tolerance", {"bld"}, false},
    {"iterations", {"bld", "harmonic", "conformal", "arap"}, true},
    {"time-limit", {"bld", "hierarchical", "harmonic", "conformal", "arap"}, true},
};

constexpr double max_sharpness = 1e6;
constexpr double min_double = (std::numeric_limits<double>::min)(), max_double = (std::numeric_limits<double>::max)();

// As many digits as it takes to read the same number again.
std::string short_text(double x)
{
  std::string text;
  double again = 0.;
  for(int digits = 6; digits <= std::numeric_limits<double>::max_digits10 && (text.empty() || again != x); ++digits)
  {
    text = fixed_text(x, digits, false);
    is_number(text, again);
  }
  return text;
}

} // namespace

bool Option_reader::knows(const std::string& option) const
{
  for(const Scope& scope : scopes)
    if(scope.option == option)
      return is_among(o.method, scope.methods);
  return true;
}

void Option_reader::read_method()
{
  o.method = read_word("method", methods, o.method);
  o.is_published = has("paper");
  if(o.is_published && has("method"))
    fail("--paper is a method of its own: leave out --method");
  refuse_both("paper", "density");
  Words known, known_to_paper;
  for(const Scope& scope : scopes)
  {
    if(is_among(o.method, scope.methods))
      known.push_back("--" + scope.option);
    if(scope.goes_with_paper)
      known_to_paper.push_back("--" + scope.option);
  }
  for(const Scope& scope : scopes) // what would be ignored
    if(has(scope.option) && o.is_published && !scope.goes_with_paper)
      fail("--" + scope.option + " is among the settings of --paper, which can be combined with " +
           list_of(known_to_paper, " and ") + " only");
    else if(has(scope.option) && !is_among(o.method, scope.methods))
      fail("--" + scope.option + " goes with --method " + list_of(scope.methods, " or ") + "; " + o.method +
           (known.empty() ? " has no settings" : " knows " + list_of(known, " and ") + " only"));
  o.is_unit_sphere = o.method != "bld" && o.method != "arap";
  o.description = o.method + (o.is_published ? " as published" : "");

  if(knows("initial"))
    read_initial();
  if(has("density"))
    read_density();
  read_preference();
  if(knows("energy"))
    read_energy();
  if(knows("sharpness"))
    read_sharpness();
  if(knows("radius"))
    read_radius();
  read_limits();
}

void Option_reader::read_initial()
{
  const std::string value = has("initial") ? text("initial") : (o.is_published ? "harmonic" : "hierarchical");
  o.start = is_among(value, starts) ? value : "";
  if(o.start.empty())
  {
    if(!std::filesystem::exists(value))
      refuse("initial", list_of(starts, " or ") + ", or the name of a file with a map");
    o.start_file = value;
  }
  describe(o.start.empty() ? "start from " + printable(o.start_file) : o.start + " start");
}

void Option_reader::read_density()
{
  for(const char* option : {"initial", "radius", "tolerance", "template"})
    if(has(option))
      fail("--" + std::string(option) + " and --density cannot be combined");
  o.gives_areas = true;
  if(text("density") == "equal")
  {
    describe("equal areas");
    return;
  }
  o.density_file = text("density");
  if(o.density_file.empty())
    fail("--density needs the name of a file, or the word equal");
  check_values("density", o.density_file);
  for(const char* option : {"output-folder", "fill-holes"})
    if(has(option))
      fail("--density with a file and --" + std::string(option) + " cannot be combined" +
           (has("fill-holes")
                ? ", as the filler has no values; write the closed surface by the command repair, and map that"
                : ", as it is for one mesh"));
  describe("areas by " + printable(o.density_file));
}

// What is preferred decides on other settings, and what is sampled on that.
void Option_reader::read_preference()
{
  bool is_plain = o.method == "bld" && !o.is_published;
  for(const char* option : {"energy", "sharpness", "schedule", "radius"})
    is_plain = is_plain && !has(option);
  m_preference = read_word("prefer", {"average", "balance", "worst", "sampling"},
                           o.method == "hierarchical" ? "average"
                           : is("remesh") && is_plain ? "sampling"
                                                      : "balance");
}

void Option_reader::read_energy()
{
  if(m_preference == "sampling" && has("energy"))
    fail("--prefer sampling has an energy of its own: leave out --energy");
  o.energy = m_preference == "sampling"
                 ? "stretch"
                 : read_word("energy", {"symmetric-dirichlet", "isometric", "conformal"},
                             o.is_published || o.method == "hierarchical" ? "isometric" : "symmetric-dirichlet");
  describe(o.energy + " energy");
}

void Option_reader::read_sharpness()
{
  refuse_both("prefer", "sharpness");
  for(const char* dial : {"prefer", "sharpness"})
    refuse_both("schedule", dial);
  if(o.is_published || has("schedule"))
  {
    read_schedule();
    return;
  }
  const double beta = read_number("sharpness", 0., max_sharpness, "a number from 0 to 1e6",
                                  m_preference == "average"    ? 0.
                                  : m_preference == "balance"  ? 20.
                                  : m_preference == "sampling" ? 3.
                                                               : 40.);
  o.sharpness = SP::Sharpness::relative(beta);
  describe("sharpness " + short_text(beta));
}

// The paper's schedule is exp(s E) with s from 0.1 to 10, after 100 sweeps of the plain sum of E. A fixed s is that of AMIPS.
void Option_reader::read_schedule()
{
  const Words numbers = has("schedule") ? split_list(text("schedule")) : Words{"0.1", "10"};
  double first = 0., last = 0., n = 100.;
  if(numbers.size() < 2 || numbers.size() > 3 || !is_number(numbers[0], first) || !is_number(numbers[1], last) ||
     !(first >= min_double && first <= last && last <= max_sharpness) ||
     (numbers.size() == 3 && (!is_number(numbers[2], n) || !(n >= 0. && n <= 1e9 && n == std::floor(n)))))
    refuse("schedule",
           "FIRST,LAST or FIRST,LAST,SWEEPS with 2.3e-308 <= FIRST <= LAST <= 1e6 and a whole number of sweeps, "
           "such as 0.1,10,100");
  describe("s " + (first < last ? "from " + short_text(first) + " to " : "= ") + short_text(last));
  if(o.is_published || numbers.size() == 3)
  {
    o.sharpness = SP::Sharpness::schedule(first, last, static_cast<unsigned int>(n));
    o.description += " after " + std::to_string(static_cast<unsigned int>(n)) + " sweeps of the plain sum";
    return;
  }
  o.sharpness = SP::Sharpness::schedule(first, last);
  if(first < last)
    o.description += " after sweeps of the plain sum while they help";
}

void Option_reader::read_radius()
{
  const std::string usual = o.is_published            ? "two-phase"
                            : o.energy == "conformal" ? "fixed=1"
                            : o.energy == "stretch"   ? "area"
                                                      : "objective";
  const std::string value = o.gives_areas ? "area" : has("radius") ? text("radius") : usual, fixed = "fixed=";
  o.is_unit_sphere = !has("radius") && !o.gives_areas && o.energy == "conformal";
  if(value.compare(0, fixed.size(), fixed) == 0 && is_number(value.substr(fixed.size()), o.fixed_radius) &&
     o.fixed_radius >= min_double && o.fixed_radius <= max_double)
    o.radius = "fixed";
  else if(is_among(value, {"two-phase", "optimal", "area", "balanced"}))
    o.radius = value;
  else if(value != "objective" || o.is_published)
    refuse("radius", std::string(o.is_published ? "" : "objective, ") +
                         "two-phase, optimal, area, balanced or fixed=R with a number R from 2.3e-308 to 1.7e308");
  describe("radius " + value);
}

void Option_reader::read_limits()
{
  const bool is_bld = o.method == "bld";
  // Samples do not tell whether the last of the sweeps have been made.
  o.energy_tolerance = read_number("tolerance", 0., 1., "a number from 0 to 1", o.energy == "stretch" ? 3e-3 : 1e-3);
  o.radius_tolerance = o.energy_tolerance > 0. ? 2e-3 : 0.;
  if(has("tolerance"))
    describe("tolerance " + short_text(o.energy_tolerance));
  if(has("iterations") || !is_bld || o.is_published)
  {
    o.max_iterations = read_count("iterations", 0, o.is_published ? 2000 : (o.method == "arap" ? 500 : 100));
    if(knows("iterations"))
      describe("at most " + std::to_string(*o.max_iterations) + (is_bld ? " sweeps" : " global steps"));
  }
  o.max_seconds = read_number("time-limit", min_double, max_double, "a number from 2.3e-308 to 1.7e308", 0.);
  if(o.max_seconds > 0.)
    describe("at most " + short_text(o.max_seconds) + " seconds");
}

} // namespace Program
