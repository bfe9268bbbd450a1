#include "Options.h"

#include <cmath>
#include <limits>

namespace Program {

namespace {

const Words starts = {"hierarchical", "stereographic", "harmonic", "conformal", "schnyder"};

// The methods that an option applies to; options that are not listed apply to all.
struct Scope
{
  std::string option;
  Words methods;
  bool applies_to_paper;
};

const std::vector<Scope> scopes = {
    {"initial", {"bld", "arap"}, true},
    {"energy", {"bld", "hierarchical"}, false},
    {"prefer", {"bld"}, false},
    {"sharpness", {"bld"}, false},
    {"schedule", {"bld"}, true},
    {"density", {"bld"}, false},
    {"radius", {"bld"}, true},
    {"tolerance", {"bld"}, false},
    {"iterations", {"bld", "harmonic", "conformal", "arap"}, true},
    {"time-limit", {"bld", "hierarchical", "harmonic", "conformal", "arap"}, true},
};

constexpr double max_sharpness = 1e6;
constexpr double min_double = (std::numeric_limits<double>::min)(), max_double = (std::numeric_limits<double>::max)();

// The shortest text, of at least 6 digits, from which the same number is read again.
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

// Reports options that would be ignored.
void check_scopes(const Options& o)
{
  Words known, known_to_paper;
  for(const Scope& scope : scopes)
  {
    if(is_among(o.method, scope.methods))
      known.push_back("--" + scope.option);
    if(scope.applies_to_paper)
      known_to_paper.push_back("--" + scope.option);
  }
  for(const Scope& scope : scopes)
    if(o.has(scope.option) && o.has("paper") && !scope.applies_to_paper)
      o.fail("--" + scope.option + " cannot be combined with --paper, which sets it; only " +
             list_of(known_to_paper, " and ") + " can");
    else if(o.has(scope.option) && !is_among(o.method, scope.methods))
      o.fail("--" + scope.option + " requires --method " + list_of(scope.methods, " or ") + "; " + o.method +
             (known.empty() ? " has no settings" : " supports only " + list_of(known, " and ")));
}

void read_initial(Options& o)
{
  const std::string value = o.has("initial") ? o.text("initial") : o.has("paper") ? "harmonic" : "hierarchical";
  o.start = is_among(value, starts) ? value : "";
  if(o.start.empty() && !std::filesystem::exists(path_of(value)))
    o.refuse("initial", list_of(starts, ", ") + ", or a file with a map");
  if(o.start.empty())
    o.start_file = value;
  o.describe(o.start.empty() ? "start from " + printable(o.start_file) : o.start + " start");
}

void read_areas(Options& o)
{
  const std::string value = o.text("density");
  if(value == "equal")
    o.describe("equal areas");
  if(!o.has("density") || value == "equal")
    return;
  o.density_file = value;
  if(value.empty())
    o.fail("--density needs a file name, or equal");
  check_values(o, "density", value);
  if(o.has("output-folder"))
    o.fail("a --density file and --output-folder cannot be combined: the file belongs to one mesh");
  o.describe("areas by " + printable(value));
}

// The schedule of the paper is exp(s E) with s from 0.1 to 10, after 100 sweeps of the sum of E. A constant s is that of AMIPS.
void read_schedule(Options& o)
{
  const Words numbers = o.has("schedule") ? split_list(o.text("schedule")) : Words{"0.1", "10"};
  double first = 0., last = 0., n = 100.;
  if(numbers.size() < 2 || numbers.size() > 3 || !is_number(numbers[0], first) || !is_number(numbers[1], last) ||
     !(first >= min_double && first <= last && last <= max_sharpness) ||
     (numbers.size() == 3 && (!is_number(numbers[2], n) || !(n >= 0. && n <= 1e9 && n == std::floor(n)))))
    o.refuse("schedule",
             "FIRST,LAST or FIRST,LAST,SWEEPS with 2.3e-308 <= FIRST <= LAST <= 1e6 and an integer number of sweeps, "
             "such as 0.1,10,100");
  o.describe("s " + (first < last ? "from " + short_text(first) + " to " : "= ") + short_text(last));
  const bool has_number = o.has("paper") || numbers.size() == 3;
  const auto n_sweeps = static_cast<unsigned int>(n);
  o.sharpness = has_number ? SP::Sharpness::schedule(first, last, n_sweeps) : SP::Sharpness::schedule(first, last);
  if(has_number)
    o.description += " after " + std::to_string(n_sweeps) + " sweeps of the plain sum";
  else if(first < last)
    o.description += " after sweeps of the plain sum while they help";
}

// --prefer determines energy and sharpness; its default depends on whether the surface is sampled.
void read_energy(Options& o)
{
  bool samples = o.is("remesh") && o.method == "bld" && !o.has("paper");
  for(const char* option : {"energy", "sharpness", "schedule", "radius"})
    samples = samples && !o.has(option);
  const std::string preference =
      o.word("prefer", {"average", "balance", "worst", "sampling"}, samples ? "sampling" : "balance");
  if(preference == "sampling" && o.has("energy"))
    o.fail("--prefer sampling sets the energy; omit --energy");
  o.energy = preference == "sampling"
                 ? "stretch"
                 : o.word("energy", {"symmetric-dirichlet", "isometric", "conformal"},
                          o.has("paper") || o.method == "hierarchical" ? "isometric" : "symmetric-dirichlet");
  o.describe(o.energy + " energy");
  if(o.method == "hierarchical")
    return;
  if(o.has("paper") || o.has("schedule"))
  {
    read_schedule(o);
    return;
  }
  const double beta = o.number("sharpness", 0., max_sharpness, "a number from 0 to 1e6",
                               preference == "average"    ? 0.
                               : preference == "balance"  ? 20.
                               : preference == "sampling" ? 3.
                                                          : 40.);
  o.sharpness = SP::Sharpness::relative(beta);
  o.describe("sharpness " + short_text(beta));
}

void read_radius(Options& o)
{
  const std::string usual = o.has("density")          ? "area"
                            : o.has("paper")          ? "two-phase"
                            : o.energy == "conformal" ? "fixed=1"
                            : o.energy == "stretch"   ? "area"
                                                      : "objective";
  const std::string value = o.has("radius") ? o.text("radius") : usual, fixed = "fixed=";
  o.is_unit_sphere = !o.has("radius") && !o.has("density") && o.energy == "conformal";
  if(value.compare(0, fixed.size(), fixed) == 0 && is_number(value.substr(fixed.size()), o.fixed_radius) &&
     o.fixed_radius >= min_double && o.fixed_radius <= max_double)
    o.radius = "fixed";
  else if(is_among(value, {"two-phase", "optimal", "area", "balanced"}))
    o.radius = value;
  else if(value != "objective" || o.has("paper"))
    o.refuse("radius", std::string(o.has("paper") ? "" : "objective, ") +
                           "two-phase, optimal, area, balanced or fixed=R with a number R from 2.3e-308 to 1.7e308");
  o.describe("radius " + value);
}

void read_limits(Options& o)
{
  const bool is_bld = o.method == "bld";
  // Samples do not show the effect of the last sweeps.
  o.energy_tolerance = o.number("tolerance", 0., 1., "a number from 0 to 1", o.energy == "stretch" ? 3e-3 : 1e-3);
  o.radius_tolerance = o.energy_tolerance > 0. ? 2e-3 : 0.;
  if(o.has("tolerance"))
    o.describe("tolerance " + short_text(o.energy_tolerance));
  if(o.has("iterations") || !is_bld || o.has("paper"))
  {
    o.max_iterations = o.count("iterations", 0, o.has("paper") ? 2000 : o.method == "arap" ? 500 : 100);
    if(is_bld || !is_among(o.method, {"hierarchical", "stereographic", "schnyder"}))
      o.describe("at most " + std::to_string(*o.max_iterations) + (is_bld ? " sweeps" : " global steps"));
  }
  o.max_seconds = o.number("time-limit", min_double, max_double, "a number from 2.3e-308 to 1.7e308", 0.);
  if(o.max_seconds > 0.)
    o.describe("at most " + short_text(o.max_seconds) + " seconds");
}

} // namespace

void read_method_options(Options& o)
{
  o.method =
      o.word("method", {"bld", "hierarchical", "harmonic", "conformal", "arap", "stereographic", "schnyder"}, o.method);
  if(o.has("paper") && o.has("method"))
    o.fail("--paper sets the method; omit --method");
  check_scopes(o);
  const bool is_bld = o.method == "bld", is_arap = o.method == "arap";
  o.is_unit_sphere = !is_bld && !is_arap;
  o.description = o.method + (o.has("paper") ? " as published" : "");
  if(is_bld || is_arap)
    read_initial(o);
  read_areas(o);
  if(is_bld || o.method == "hierarchical")
    read_energy(o);
  if(is_bld)
    read_radius(o);
  read_limits(o);
}

} // namespace Program
