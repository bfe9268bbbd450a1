#include "Command_options.h"
#include "Option_reader.h"

#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <limits>
#include <system_error>

namespace Program {

namespace {

constexpr const char* advice_on_filler = "write the closed surface by the command repair, and map that";

} // namespace

bool is_number(const std::string& text, double& x)
{
  char* end = nullptr;
  x = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0';
}

Option_reader::Option_reader(const Command_line& line)
  : m_line(line)
{
  o.command = line.command;
  o.is_quiet = has("quiet");
  o.max_threads = read_count("threads", 1, 0);
  for(const auto& [option, values] : line.options)
    if(is_among(option, {"output", "output-folder", "sphere", "transfer", "values-sphere", "json", "colored", "page",
                         "template", "overlay", "labels", "beside", "mask", "valid"}) &&
       values.front().empty())
      fail("--" + option + " needs a name");
  read_names();
  if(is("resample"))
  {
    read_resampling();
    return;
  }
  read_method();
  if(!o.sphere_file.empty())
  {
    o.method = "none";
    o.description = "map of " + printable(o.sphere_file);
    o.is_unit_sphere = true;
  }
  read_format();
  read_match();
  o.convention = read_word("convention", {"cortex", "none"}, "");
  o.keeps_radius = has("radius");
  if(has("convention"))
    describe("convention " + o.convention);
  read_files();
  read_sampling();
  read_repair();
}

void Option_reader::fail(const std::string& what) const
{
  throw Program_error(what, "\nAll options are explained by: spherical_parameterization ", o.command, " --help");
}

void Option_reader::refuse(const std::string& option, const std::string& valid) const
{
  fail("--" + option + " has to be " + valid + ", not '" + printable(text(option)) + "'");
}

void Option_reader::refuse_both(const std::string& option, const std::string& other) const
{
  if(has(option) && has(other))
    fail("--" + option + " and --" + other + " contradict each other: give one of them");
}

std::string Option_reader::read_word(const std::string& option, const Words& words, const std::string& usual) const
{
  if(has(option) && !is_among(text(option), words))
    refuse(option, list_of(words, " or "));
  return has(option) ? text(option) : usual;
}

double Option_reader::read_number(const std::string& option, double min, double max, const std::string& range,
                                  double usual) const
{
  double x = usual;
  if(has(option) && (!is_number(text(option), x) || !(x >= min && x <= max)))
    refuse(option, range);
  return x;
}

unsigned int Option_reader::read_count(const std::string& option, unsigned int min, unsigned int usual) const
{
  const std::string range = "a whole number from " + std::to_string(min) + " to 1e9";
  const double x = read_number(option, min, 1e9, range, usual);
  if(x != std::floor(x))
    refuse(option, range);
  return static_cast<unsigned int>(x);
}

void Option_reader::check_output(const std::string& option, const std::string& name) const
{
  if(o.format_of(name).empty())
    fail("--" + option + " has to be a name that ends with one of " + output_names + ", not '" + printable(name) + "'");
#ifndef PROGRAM_READS_GIFTI
  if(is_gifti(o.format_of(name)))
    fail("--" + option + ": this program was built without expat and zlib, which GIFTI files take");
#endif
}

void Option_reader::check_values(const std::string& option, const std::string& names) const
{
  for(const std::string& name : split_list(names))
    if(is_among(file_format(name), {".off", ".obj", ".stl", ".ts"}))
      fail("--" + option + " needs .ply files, which can hold properties, or files of values of vertices, not '" +
           printable(name) + "'");
}

// Gives the names of files to what the command takes.
void Option_reader::read_names()
{
  const auto command =
      std::find_if(commands.begin(), commands.end(), [&](const Command& other) { return other.name == o.command; });
  Words names = m_line.names;
  const bool is_atlas = is("register"), is_pair = is("match") || is_atlas;
  if(names.size() < command->min_names)
    fail(names.empty() ? std::string(has("surfaces") ? "there is no INPUT; it comes before --surfaces and its names"
                                                     : "there is no INPUT")
                       : o.command + " needs " + command->usage);
  if(names.size() > command->max_names)
    fail(is("map")
             ? "there is more than one INPUT; a name with blanks has to be quoted, and many meshes need --output-folder"
             : o.command + " takes " + command->usage + "; a name with blanks has to be quoted");
  if(is("resample"))
  {
    o.spheres.assign(names.end() - 2, names.end());
    names.resize(names.size() - 2);
  }
  o.inputs = names;
  if(is("batch") || is("resample"))
    return;
  o.inputs.resize(1);
  o.file_names.input = names.front();
  std::error_code ignored;
  if(std::filesystem::is_directory(names.front(), ignored))
    fail(printable(names.front()) + " is a folder; to map the meshes in it, say with --output-folder where to");
  if(is_pair)
    o.onto = names[1];
  o.is_onto_atlas = is_atlas;
  if(names.size() > 1 && (is("check") || is("show")))
    o.sphere_file = names[1];
  else if(is("check") && has("json"))
    fail("--json has the distortions of a sphere: check SURFACE SPHERE --json FILE");
  if(names.size() > 1 && is("remesh"))
    o.domain = names[1];
}

void Option_reader::read_resampling()
{
  o.carries_sphere = has("through");
  for(const char* option : {"areas", "mask", "valid", "method"})
    if(has(option) && o.carries_sphere)
      fail("--" + std::string(option) + " and --through cannot be combined");
  if(has("output") == has("output-folder"))
    fail(o.command + " needs " + (has("output") ? "one of -o and --output-folder" : "-o or --output-folder"));
  if(o.inputs.size() > 1 && has("output"))
    fail("there is more than one file of values; a name with blanks has to be quoted, and many need --output-folder");
  o.area_files = words("areas");
  o.method =
      read_word("method", {"barycentric", "adaptive", "nearest", "largest"}, has("areas") ? "adaptive" : "barycentric");
  if(is_among(o.method, {"adaptive", "largest"}) && !has("areas"))
    fail("--method " + o.method + " needs --areas, of the vertices of both spheres");
  if(is_among(o.method, {"barycentric", "nearest"}) && has("areas"))
    fail("--areas goes with --method adaptive or largest");
  o.file_names.sphere = text("output");
  o.output_folder = text("output-folder");
  o.mask_file = text("mask");
  o.valid_file = text("valid");
}

void Option_reader::read_format()
{
  if(!has("format"))
    return;
  const std::string word = text("format");
  o.format = word == "freesurfer" ? freesurfer_format
             : word == "gifti"    ? ".gii"
                                  : file_format("sphere." + word.substr(word.find_first_not_of('.') == 1 ? 1 : 0));
  if(!is_among(o.format, output_formats) && o.format != freesurfer_format)
    refuse("format", "one of off, obj, ply, ts, gifti or freesurfer");
}

void Option_reader::read_match()
{
  o.template_file = text("template");
  if(!o.template_file.empty() && !o.start_file.empty())
    fail("--template and the map of --initial cannot be combined");
  o.landmark_files = words("landmarks");
  o.mask_files = words("masks");
  read_features();
  o.regularizes_spheres = read_word("regularize", {"surfaces", "spheres"}, "surfaces") == "spheres";
  o.splits = has("split");
  if(o.splits && o.regularizes_spheres)
    fail("--split and --regularize spheres contradict each other: edges are split where faces bend over the surface");
  if(o.splits && has("fill-holes"))
    fail("--split and --fill-holes cannot be combined; " + std::string(advice_on_filler));
  o.landmark_weight = read_number("soft-landmarks", 1e-6, 1e6, "a number from 1e-6 to 1e6", 0.);
  for(const std::string& name : o.mask_files)
    check_values("masks", name);
  o.file_names.overlay = text("overlay");
  if(has("overlay") && file_format(o.file_names.overlay) != ".ply")
    refuse("overlay", "the name of a .ply file, which can hold properties");
  if(has("morph"))
  {
    const Words morph = words("morph");
    if(!is_number(morph[0], o.morph_time) || !(o.morph_time >= 0. && o.morph_time <= 1.))
      fail("--morph has to be a number from 0 to 1 and the name of a file, not '" + printable(morph[0]) + "'");
    o.file_names.morph = morph[1];
    check_output("morph", morph[1]);
  }
  if(!o.template_file.empty())
    describe("template " + printable(o.template_file));
}

void Option_reader::read_features()
{
  o.feature_files = words("features");
  for(const std::string& list : o.feature_files)
    for(const std::string& name : split_list(list))
      if(std::error_code ignored; !is_among(name, own_feature_names) && name.find_first_of("./") == name.npos &&
                                  !std::filesystem::exists(name, ignored))
        fail("--features has '" + printable(name) + "', which is neither a file nor one of " +
             list_of(own_feature_names));
  if(o.is_onto_atlas && !has("features"))
    fail("register needs --features, as a sphere has none of its own: what SURFACE is compared by, such as depth or "
         "lh.sulc, and a file of what ATLAS has for it");
  if(o.is_onto_atlas)
    for(const std::string& name : split_list(o.feature_files[1]))
      if(is_among(name, own_feature_names))
        fail("--features has '" + name + "' for the atlas, which is a sphere without folds: give a file of values");
  for(const std::string& name : o.feature_files)
    check_values("features", name);
  o.compares_values = read_word("compare", {"ranks", "values"}, "ranks") == "values";
  if(!has("feature-weights"))
    return;
  for(const std::string& pair : split_list(text("feature-weights")))
  {
    const std::size_t sign = pair.rfind('=');
    double weight = -1.;
    if(sign == 0 || sign == pair.npos || !is_number(pair.substr(sign + 1), weight) ||
       !(weight >= 0. && weight <= 1e6) || !o.feature_weights.emplace(pair.substr(0, sign), weight).second)
      refuse("feature-weights", "a list such as sulc=2,curv=0.5: each name once, with a number from 0 to 1e6");
  }
}

void Option_reader::read_files()
{
  if(is("batch") && !has("output-folder"))
    fail("batch needs --output-folder, where the spheres and their reports are written");
  o.output_folder = text("output-folder");
  o.is_resumed = has("resume");
  o.overwrites = has("overwrite");
  o.surfaces = words("surfaces");
  for(std::string& name : o.surfaces)
  {
    name = std::filesystem::path(name).lexically_normal().string();
    if(name.empty() || name == "." || name.front() == '/' || name.back() == '/' || name.compare(0, 2, "..") == 0)
      fail("--surfaces takes names of files, or their paths from INPUT on, not '" + printable(name) + "'");
  }
  const std::string output = text("output");
  (is("remesh")      ? o.file_names.remesh
   : !o.onto.empty() ? o.file_names.onto
   : is("repair")    ? o.file_names.filled
   : is("show")      ? o.file_names.page
                     : o.file_names.sphere) = output;
  if(has("sphere"))
    o.file_names.sphere = text("sphere");
  if(is("match") && has("sphere"))
    o.file_names.target_sphere = with_suffix(o.file_names.sphere, "_target");
  for(const char* option : {"output", "sphere"})
    if(has(option) && !is("show"))
      check_output(option, text(option));
  o.prints_json = text("json") == "-";
  o.file_names.json = o.prints_json ? "" : text("json");
  o.file_names.colored = text("colored");
  if(has("page"))
    o.file_names.page = text("page");
  if(is("show") && !has("output"))
    fail("show needs -o, the name of the page");
  if(!o.file_names.page.empty() && file_format(o.file_names.page) != ".html")
    refuse(is("show") ? "output" : "page", "a name that ends with .html");
  o.labels_file = text("labels");
  o.beside = text("beside");
  if(has("labels") && o.file_names.page.empty())
    fail("--labels goes with --page");
  if(!o.beside.empty() && !o.sphere_file.empty())
    fail("show takes one of SPHERE and --beside");
}

void Option_reader::read_sampling()
{
  constexpr unsigned int max_subdivision = SP::Sphere_domain_3::max_subdivision;
  o.image_size = has("geometry-image") ? read_count("image-size", 3, 257) : 0;
  if(has("geometry-image") && (o.image_size % 2 == 0 || o.image_size > 2 * max_subdivision + 1))
    refuse("image-size", "an odd number from 3 to " + std::to_string(2 * max_subdivision + 1));
  o.file_names.image = text("geometry-image");
  if(has("geometry-image") && !is_among(file_format(o.file_names.image), {".png", ".exr"}))
    refuse("geometry-image", "a name that ends with .png or .exr");
  o.values_file = text("transfer");
  o.values_sphere = text("values-sphere");
  if(has("transfer"))
    check_values("transfer", o.values_file);
  if(!is("remesh"))
    return;
  if(o.domain.empty() && (!has("geometry-image") || has("output") || has("transfer")))
    fail("there is no DOMAIN to sample by, such as octahedron=64");
  const std::size_t equals = o.domain.find('=');
  double n = 0.;
  std::error_code ignored;
  const bool is_solid =
      is_among(o.domain.substr(0, equals), {"octahedron", "cube", "icosahedron"}) && equals != std::string::npos;
  if(is_solid && is_number(o.domain.substr(equals + 1), n) && n >= 1 && n <= max_subdivision && n == std::floor(n))
  {
    o.domain.resize(equals);
    o.domain_size = static_cast<unsigned int>(n);
  }
  else if(!o.domain.empty() && (is_solid || !std::filesystem::is_regular_file(o.domain, ignored)))
    fail("DOMAIN has to be octahedron=N, cube=N or icosahedron=N with a whole number N from 1 to " +
         std::to_string(max_subdivision) + ", or the name of a file with a mesh of the sphere, not '" +
         printable(o.domain) + "'");
  const std::string format = o.format_of(o.file_names.remesh);
  if(!has("transfer") || !has("output"))
    return;
  if(format != ".ply" && !is_gifti(format))
    refuse("output", "the name of a .ply or .gii file, as other formats do not hold the properties of --transfer");
  if(is_gifti(format))
  {
    const std::string& name = o.file_names.remesh;
    o.file_names.values = name.substr(0, name.size() - ending_of(name).size()) + ".func" + format;
  }
}

// What is done to a surface before it is mapped.
void Option_reader::read_repair()
{
  if(has("fill-holes") || is("repair"))
  {
    const std::string wanted = has("fill-holes") ? text("fill-holes") : "all";
    o.max_hole_edges =
        wanted == "all"
            ? (std::numeric_limits<std::size_t>::max)()
            : static_cast<std::size_t>(read_number("fill-holes", 3, 1e9, "a number of edges from 3 on, or all", 0.));
    describe("holes filled: " + wanted);
    if(has("transfer"))
      fail("--transfer and --fill-holes cannot be combined, as the filler has no values; " +
           std::string(advice_on_filler));
    if(!o.start_file.empty())
      fail("--initial with a file and --fill-holes cannot be combined, as the file has no images of the filler; " +
           std::string(advice_on_filler));
  }
  o.file_names.handles = text("handles");
  if(has("handles") && file_format(o.file_names.handles) != ".ply")
    refuse("handles", "the name of a .ply file");
  const std::string component = read_word("components", {"largest", "each"}, "");
  o.picks_component = has("components");
  o.takes_each_component = component == "each";
  if(o.takes_each_component && is("batch"))
    fail("--components each is for one mesh: leave out --output-folder");
  if(o.picks_component)
    describe(component + " component");
}

} // namespace Program
