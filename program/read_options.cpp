#include "Options.h"

#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Program {

namespace {

// Options that exclude each other.
struct Contradiction
{
  const char *option, *other, *text;
};

constexpr const char *contradict = " contradict each other; give only one of them", *exclude = " cannot be combined";

const std::vector<Contradiction> contradictions = {
    {"areas", "through", exclude},      {"mask", "through", exclude},          {"valid", "through", exclude},
    {"method", "through", exclude},     {"paper", "density", contradict},      {"prefer", "sharpness", contradict},
    {"schedule", "prefer", contradict}, {"schedule", "sharpness", contradict}, {"initial", "density", exclude},
    {"radius", "density", exclude},     {"tolerance", "density", exclude},     {"template", "density", exclude}};

// Values of options that need no other check.
const std::map<std::string, Words> choices = {
    {"convention", {"cortex", "none"}}, {"regularize", {"surfaces", "spheres"}}, {"compare", {"ranks", "values"}}};

void check_words(const Options& o)
{
  for(const auto& [option, other, text] : contradictions)
    if(o.has(option) && o.has(other))
      o.fail("--" + std::string(option) + " and --" + other + text);
  for(const auto& [option, words] : choices)
    o.word(option, words, "");
  for(const auto& [option, values] : o.options)
    if(values.front().empty() &&
       is_among(option, {"output", "output-folder", "sphere", "transfer", "values-sphere", "json", "colored", "page",
                         "template", "overlay", "expected-errors", "labels", "beside", "mask", "valid", "repaired",
                         "handles", "texture"}))
      o.fail("--" + option + " needs a file name");
}

// Checks that the format of an output file can be written.
void check_output(const Options& o, const std::string& option, const std::string& name)
{
  if(o.format_of(name).empty())
    o.fail("--" + option + " must be a file name that ends with " + output_names + ", not '" + printable(name) + "'");
#ifndef PROGRAM_READS_GIFTI
  if(is_gifti(o.format_of(name)))
    o.fail("--" + option + ": this program was built without expat and zlib, which GIFTI files need");
#endif
}

// Assigns the file names to the arguments of the command.
void read_names(Options& o)
{
  o.inputs = o.names;
  if(o.is("resample"))
  {
    o.spheres.assign(o.inputs.end() - 2, o.inputs.end());
    o.inputs.resize(o.inputs.size() - 2);
  }
  if(o.is("batch") || o.is("resample"))
    return;
  const std::string second = o.names.size() > 1 ? o.names[1] : "";
  o.inputs.resize(1);
  o.file_names.input = o.names.front();
  std::error_code ignored;
  if(std::filesystem::is_directory(path_of(o.file_names.input), ignored))
    o.fail(printable(o.file_names.input) + " is a folder; to map the meshes in it, give --output-folder");
  o.is_onto_atlas = o.is("register");
  (o.is("check") || o.is("show") ? o.sphere_file : o.is("remesh") ? o.domain : o.onto) = second;
  if(o.is("check") && second.empty() && o.has("json"))
    o.fail("--json needs a sphere, whose distortion it reports: check SURFACE SPHERE --json FILE");
}

void read_resampling(Options& o)
{
  if(o.has("output") == o.has("output-folder"))
    o.fail(std::string("resample needs ") +
           (o.has("output") ? "one of -o and --output-folder" : "-o or --output-folder"));
  if(o.inputs.size() > 1 && o.has("output"))
    o.fail("several files of values need --output-folder instead of -o; quote file names that contain blanks");
  o.method =
      o.word("method", {"barycentric", "adaptive", "nearest", "largest"}, o.has("areas") ? "adaptive" : "barycentric");
  const bool needs_areas = is_among(o.method, {"adaptive", "largest"});
  if(needs_areas && !o.has("areas"))
    o.fail("--method " + o.method + " needs --areas, the vertex areas of both spheres");
  if(!needs_areas && o.has("areas"))
    o.fail("--areas requires --method adaptive or largest");
  o.file_names.sphere = o.text("output");
}

void read_format(Options& o)
{
  if(!o.has("format"))
    return;
  const std::string word = o.text("format");
  o.format = word == "freesurfer" ? freesurfer_format
             : word == "gifti"    ? ".gii"
                                  : file_format("sphere." + word.substr(word.find_first_not_of('.') == 1 ? 1 : 0));
  if(!is_among(o.format, output_formats) && o.format != freesurfer_format)
    o.refuse("format", "off, obj, ply, ts, gifti or freesurfer");
}

void read_features(Options& o)
{
  const Words lists = o.words("features");
  if(o.is_onto_atlas && !o.has("features"))
    o.fail("register needs --features: a feature of SURFACE, such as depth or lh.sulc, and a file with the same "
           "feature of ATLAS, because a sphere has no features of its own");
  for(const std::string& list : lists)
  {
    check_values(o, "features", list);
    for(const std::string& name : split_list(list))
      if(std::error_code ignored; !is_among(name, own_feature_names))
      {
        if(name.find_first_of("./") == name.npos && !std::filesystem::exists(path_of(name), ignored))
          o.fail("--features has '" + printable(name) + "', which is neither a file nor one of " +
                 list_of(own_feature_names));
      }
      else if(o.is_onto_atlas && &list == &lists[1])
        o.fail("--features has '" + name +
               "' for the atlas, but this cannot be computed from a sphere; give a file of values");
  }
  if(!o.has("feature-weights"))
    return;
  for(const std::string& pair : split_list(o.text("feature-weights")))
  {
    const std::size_t sign = pair.rfind('=');
    double weight = -1.;
    if(sign == 0 || sign == pair.npos || !is_number(pair.substr(sign + 1), weight) ||
       !(weight >= 0. && weight <= 1e6) || !o.feature_weights.emplace(pair.substr(0, sign), weight).second)
      o.refuse("feature-weights", "a list such as sulc=2,curv=0.5, each name once, with a number from 0 to 1e6");
  }
}

void read_match(Options& o)
{
  if(o.has("template") && !o.start_file.empty())
    o.fail("--template and the map of --initial cannot be combined");
  if(o.has("template"))
    o.describe("template " + printable(o.text("template")));
  o.landmark_weight = o.number("soft-landmarks", 1e-6, 1e6, "a number from 1e-6 to 1e6", 0.);
  read_features(o);
  for(const std::string& name : o.words("masks"))
    check_values(o, "masks", name);
  if(o.has("split") && o.text("regularize") == "spheres")
    o.fail("--split and --regularize spheres contradict each other: --split lowers the energy between surfaces");
  o.file_names.overlay = o.text("overlay");
  if(o.has("overlay") && file_format(o.file_names.overlay) != ".ply")
    o.refuse("overlay", "the name of a .ply file, which can store properties");
  o.file_names.expected_errors = o.text("expected-errors");
  const std::string& errors = o.file_names.expected_errors;
  if(!errors.empty() && file_format(errors) != ".ply" && is_among(format_of_values(errors), {"", ".annot"}))
    o.fail("--expected-errors must be a file name that ends with .ply, .gii, .mgh or .mgz, or begins with lh. or rh. "
           "for the format of FreeSurfer, not '" +
           printable(errors) + "'");
  if(o.has("expected-errors") && o.has("features"))
    o.fail("--expected-errors and --features cannot be combined: errors are estimated only for the built-in features");
  if(!o.has("morph"))
    return;
  const Words morph = o.words("morph");
  if(!is_number(morph[0], o.morph_time) || !(o.morph_time >= 0. && o.morph_time <= 1.))
    o.fail("--morph must be a number from 0 to 1 and a file name, not '" + printable(morph[0]) + "'");
  o.file_names.morph = morph[1];
  check_output(o, "morph", morph[1]);
}

void read_batch(Options& o)
{
  if(!o.has("output-folder"))
    o.fail("batch needs --output-folder, the folder for spheres and reports");
}

void read_files(Options& o)
{
  File_names& names = o.file_names;
  names.sphere = o.text("sphere");
  (o.is("remesh")    ? names.remesh
   : !o.onto.empty() ? names.onto
   : o.is("repair")  ? names.repaired
   : o.is("show")    ? names.page
                     : names.sphere) = o.text("output");
  for(const char* option : {"output", "sphere"})
    if(o.has(option) && !o.is("show"))
      check_output(o, option, o.text(option));
  if(o.is("match") && o.has("sphere"))
    names.target_sphere = with_suffix(names.sphere, "_target");
  names.json = o.text("json") == "-" ? "" : o.text("json");
  names.colored = o.text("colored");
  names.texture = o.text("texture");
  if(o.has("texture") && file_format(names.texture) != ".obj")
    o.refuse("texture", "a file name that ends with .obj");
  if(o.has("page"))
    names.page = o.text("page");
  if(o.is("show") && !o.has("output"))
    o.fail("show needs -o, the file name of the page");
  if(!names.page.empty() && file_format(names.page) != ".html")
    o.refuse(o.is("show") ? "output" : "page", "a file name that ends with .html");
  if(o.has("labels") && names.page.empty())
    o.fail("--labels requires --page");
  if(o.has("beside") && !o.sphere_file.empty())
    o.fail("SPHERE and --beside cannot be combined");
}

void read_domain(Options& o)
{
  constexpr unsigned int max_subdivision = SP::Sphere_domain_3::max_subdivision;
  if(o.domain.empty() && (!o.has("geometry-image") || o.has("output") || o.has("transfer")))
    o.fail("remesh needs a DOMAIN, such as octahedron=64");
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
  else if(!o.domain.empty() && (is_solid || !std::filesystem::is_regular_file(path_of(o.domain), ignored)))
    o.fail("DOMAIN must be octahedron=N, cube=N or icosahedron=N with an integer N from 1 to " +
           std::to_string(max_subdivision) + ", or a file with a mesh of the sphere, not '" + printable(o.domain) +
           "'");
}

void read_sampling(Options& o)
{
  constexpr unsigned int max_size = 2 * SP::Sphere_domain_3::max_subdivision + 1;
  read_domain(o);
  const std::string sizes = "an odd number from 3 to " + std::to_string(max_size);
  const double size = o.number("image-size", 3, max_size, sizes, 257);
  if(std::fmod(size, 2.) != 1.)
    o.refuse("image-size", sizes);
  o.image_size = o.has("geometry-image") ? static_cast<unsigned int>(size) : 0;
  o.file_names.image = o.text("geometry-image");
  if(o.has("geometry-image") && !is_among(file_format(o.file_names.image), {".png", ".exr"}))
    o.refuse("geometry-image", "a file name that ends with .png or .exr");
  if(!o.has("transfer"))
    return;
  check_values(o, "transfer", o.text("transfer"));
  const std::string &name = o.file_names.remesh, format = o.format_of(name);
  if(o.has("output") && format != ".ply" && !is_gifti(format))
    o.refuse("output", "the name of a .ply or .gii file; other formats cannot store the properties of --transfer");
  if(is_gifti(format))
    o.file_names.values = name.substr(0, name.size() - ending_of(name).size()) + ".func" + format;
}

// Checks that no option refers to vertices or faces of the file where the mapped surface has different ones.
void check_numbers(const Options& o, const std::string& option, const std::string& why)
{
  Words others;
  if(!o.start_file.empty())
    others.push_back("initial");
  if(!o.density_file.empty())
    others.push_back("density");
  for(const char* other : {"landmarks", "masks", "labels", "transfer"})
    if(o.has(other) && (other != std::string("transfer") || !o.has("values-sphere")))
      others.push_back(other);
  for(const std::string& list : o.words("features"))
    for(const std::string& name : split_list(list))
      if(!is_among(name, own_feature_names))
        others.push_back("features");
  if(!others.empty())
    o.fail("--" + option + " and a file of --" + others.front() + " cannot be combined: " + why);
}

// The repair of a surface before it is mapped.
void read_repair(Options& o)
{
  const Words triggers = {"repair", "repaired", "max-added-area", "max-hole", "max-handle", "coarse-patches", "wrap"};
  if(o.is("repair") ||
     std::any_of(triggers.begin(), triggers.end(), [&](const std::string& option) { return o.has(option); }))
  {
    constexpr double any = (std::numeric_limits<double>::infinity)();
    Repair_settings& repair = o.repair.emplace();
    repair.limits.maximum_added_area =
        o.number("max-added-area", 0., 1., "a number from 0 to 1", repair.limits.maximum_added_area);
    repair.limits.maximum_hole = o.number("max-hole", 0., any, "a number that is not negative", any);
    repair.limits.maximum_handle = o.number("max-handle", 0., any, "a number that is not negative", any);
    repair.limits.refines_patches = !o.has("coarse-patches");
    repair.alpha = o.number("wrap", 1e-4, 1., "a number from 1e-4 to 1", 0.);
    o.describe("repaired");
    if(o.has("wrap"))
    {
      o.describe("wrapped: " + o.text("wrap"));
      check_numbers(o, "wrap", "the wrapped surface has new vertices and faces");
    }
  }
  o.file_names.handles = o.text("handles");
  if(o.has("handles") && file_format(o.file_names.handles) != ".ply")
    o.refuse("handles", "the name of a .ply file");
  if(o.has("repaired"))
    check_output(o, "repaired", o.file_names.repaired = o.text("repaired"));
  if(o.has("each-component"))
  {
    check_numbers(o, "each-component",
                  "the vertices of each component are numbered separately; write the components with the command "
                  "repair, and map these files");
    o.describe("each component");
  }
}

} // namespace

void check_values(const Options& o, const std::string& option, const std::string& names)
{
  for(const std::string& name : split_list(names))
    if(is_among(file_format(name), {".off", ".obj", ".stl", ".ts"}))
      o.fail("--" + option + " needs .ply files, which can store properties, or files of vertex values, not '" +
             printable(name) + "'");
}

Options read_options(const Command_line& given)
{
  Options o;
  static_cast<Command_line&>(o) = given;
  check_words(o);
  o.max_threads = o.count("threads", 1, 0);
  read_names(o);
  if(o.is("resample"))
  {
    read_resampling(o);
    return o;
  }
  read_method_options(o);
  if(!o.sphere_file.empty())
  {
    o.method = "none";
    o.description = "map of " + printable(o.sphere_file);
    o.is_unit_sphere = true;
  }
  read_format(o);
  read_match(o);
  if(o.has("convention"))
    o.describe("convention " + o.text("convention"));
  if(o.is("batch"))
    read_batch(o);
  read_files(o);
  if(o.is("remesh"))
    read_sampling(o);
  read_repair(o);
  return o;
}

} // namespace Program
