#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_OPTIONS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_OPTIONS_H

#include "Program_error.h"
#include "mesh_files.h"

#include <CGAL/Spherical_parameterization/Area_balancing_radius_3.h>
#include <CGAL/Spherical_parameterization/Area_preserving_radius_3.h>
#include <CGAL/Spherical_parameterization/Fixed_radius_3.h>
#include <CGAL/Spherical_parameterization/Optimal_radius_3.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Two_phase_radius_3.h>

#include <boost/program_options.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

namespace Program {

namespace SP = CGAL::Spherical_parameterization;

using Radius_choice = std::variant<SP::Two_phase_radius_3<>, SP::Optimal_radius_3, SP::Area_balancing_radius_3,
                                   SP::Area_preserving_radius_3, SP::Fixed_radius_3>;

/// What the command line asks for. Words that the options take are kept as they are.
class Program_options
{
public:
  /// reads the command line.
  ///
  /// \throws Program_error if an option is unknown, out of its range, of no use, or contradicts another one
  Program_options(int argc, const char* const* argv)
  {
    parse(argc, argv);
    wants_help = has("help");
    wants_version = has("version");
    if(wants_help || wants_version)
      return;
    read_inputs();
    read_resampling();
    if(resamples())
      return;
    read_method();
    if(knows("initial"))
      read_initial();
    read_density();
    read_sampling();
    if(knows("energy"))
      read_energy();
    if(knows("sharpness"))
      read_sharpness();
    if(knows("radius"))
      read_radius();
    read_limits();
    read_format();
    read_match();
    read_convention();
    read_outputs();
    read_repair();
  }

  /// returns the explanation of all options.
  std::string help() const
  {
    std::ostringstream text;
    text << R"(Usage: spherical_parameterization INPUT [-o SPHERE] [options]
       spherical_parameterization INPUT --onto TARGET [-o RESULT] [options]
       spherical_parameterization INPUT --onto-atlas SPHERE --features A B [-o SPHERE] [options]
       spherical_parameterization INPUT ... --output-folder FOLDER [options]
       spherical_parameterization SUBJECTS --surfaces lh.white rh.white --output-folder FOLDER [options]
       spherical_parameterization VALUES --resample SPHERE SPHERE2 -o RESULT [options]

Maps a closed triangle mesh of genus 0 to a sphere, one-to-one and with low distortion. INPUT is a file of
one of the formats )"
         << list_of(input_formats) << R"(, a surface in the format GIFTI (.gii, .gii.gz), or one of
FreeSurfer, such as lh.white. The result is certified by exact arithmetic.
Without -o nothing but the report is printed. Ctrl-C or SIGTERM ends the sweeps; the map reached is written.

With --onto, the surface is mapped one-to-one onto another one, through both spheres.

With --resample, values of vertices, labels or surfaces are carried from one sphere to another one.

With --output-folder, a mesh that fails does not stop the others. Small meshes are mapped one on each core,
large ones one after the other on all. After Ctrl-C nothing that is incomplete is left; --resume goes on.

)" << describe_options()
         << R"(
Exit status: 0, a certified one-to-one map was found and all files were written; 1, an error, of which a
message tells; 2, the map folds, which --method conformal and arap do not exclude;
all files were written nevertheless. With --output-folder: 0, all meshes have a certified map; 1, some have
none; 2, all have one, but some fold.
)";
    return text.str();
  }

  /// returns whether the method only cares for angles.
  bool is_conformal() const
  {
    return energy == "conformal" || is_among(method, {"conformal", "harmonic", "stereographic"});
  }

  /// returns whether there may be many meshes: the names of their files are made from those of the inputs.
  bool is_batch() const { return !output_folder.empty(); }

  /// returns whether no mesh is mapped, but what vertices have is carried from sphere to sphere.
  bool resamples() const { return !spheres.empty(); }

  /// returns the names of the files that are read beside the meshes.
  Words other_inputs() const
  {
    Words result;
    for(const std::string& name : {start_file, domain_size == 0 ? domain : "", values_sphere, onto, template_file,
                                   mask_file, labels_file, density_file, beside})
      if(!name.empty())
        result.push_back(name);
    for(const Words* names : {&landmark_files, &spheres, &area_files})
      result.insert(result.end(), names->begin(), names->end());
    Words lists = mask_files;
    if(!values_file.empty())
      lists.push_back(values_file);
    for(const std::string& list : lists)
      for(const std::string& name : split_list(list))
        result.push_back(name);
    for(const std::string& list : feature_files)
      for(const std::string& name : split_list(list))
        if(!is_among(name, own_feature_names))
          result.push_back(name);
    return result;
  }

  /// returns the format of a mesh that is written under this name.
  std::string format_of(const std::string& name) const { return format.empty() ? output_format(name) : format; }

  /// returns whether the sphere is to lie as its surface does, and to have the radius of the convention, if no other was given.
  ///
  /// \param sphere the name that it is written under, empty if it is not
  bool follows_convention(const std::string& sphere) const
  {
    return convention.empty() ? template_file.empty() && !sphere.empty() && is_cortical(format_of(sphere))
                              : convention == "cortex";
  }

  /// returns the file that decides on a map beside the mesh itself; empty if there is none.
  const std::string& start_or_template() const { return template_file.empty() ? start_file : template_file; }

  bool wants_help = false, wants_version = false, is_quiet = false;
  Words inputs;                 ///< meshes, and folders if there may be many
  File_names file_names;        ///< of the one mesh, if there is only one
  bool prints_json = false;     ///< whether its report is printed as JSON
  std::string domain;           ///< to sample by: a solid, or the name of a file; empty if no remesh is wanted
  unsigned int domain_size = 0; ///< what the edges of the solid are divided into
  unsigned int image_size = 0;  ///< pixels in a row of the geometry image; 0 if none is wanted
  std::string values_file;      ///< with the properties that the remesh gets; empty if there is none
  std::string beside;           ///< the surface that the page shows in place of the sphere; empty if it shows that
  std::string labels_file;      ///< of the vertices, for the page, empty if there is none
  std::string values_sphere;    ///< the map of that mesh, if it is not the input
  std::string onto;             ///< the surface, or the atlas, to map onto, empty if there is none
  bool is_onto_atlas = false;   ///< whether that is its own sphere
  std::string template_file;    ///< the surface to map onto each of many, empty if there is none
  Words landmark_files, feature_files, mask_files; ///< of both surfaces, or none
  std::map<std::string, double> feature_weights;   ///< by the names of the features; 1 for others
  bool compares_values = false;                    ///< of the features, and not ranks
  bool regularizes_spheres = false; ///< whether the distortion is kept low between the spheres, and not the surfaces
  double landmark_weight = 0.;      ///< 0 if landmarks are met exactly
  double morph_time = 0.;
  Words spheres;                  ///< to resample from one to the other, none if nothing is resampled
  bool carries_sphere = false;    ///< whether the second one is a registration that spheres are carried through
  Words area_files;               ///< with the areas around the vertices of both, or none
  std::string mask_file;          ///< with the vertices that count, empty if all do
  std::string valid_file;         ///< that tells which vertices get something, empty if it is not wanted
  bool splits = false;            ///< whether the surface is refined where that makes for a better map
  std::size_t max_hole_edges = 0; ///< of holes that are filled; 0 if none is
  bool picks_component = false;   ///< whether one part of the surface is mapped
  bool takes_each_component = false;
  std::string output_folder; ///< of the many, empty otherwise
  Words surfaces;            ///< what the many are called in the folders below; empty if they are in the folder itself
  bool overwrites = false;   ///< whether files of those folders are replaced that the program has not written
  std::string format;        ///< of all meshes that are written, empty if their names tell it
  std::string convention;    ///< of spheres; empty if their formats tell it
  bool keeps_radius = false; ///< whether that of a map is the one to be written, as it was chosen
  bool is_resumed = false;   ///< whether meshes that are done are left out
  std::string method = "bld";
  bool is_published = false;          ///< "bld" with the settings of the paper
  std::string start = "hierarchical"; ///< empty if the map to start from is in a file
  std::string start_file;
  std::string energy = "symmetric-dirichlet";
  bool gives_areas = false; ///< whether each part of the surface gets the share of the sphere that is wanted
  std::string density_file; ///< that says which; empty if it is its share of the area
  SP::Sharpness sharpness;
  std::optional<Radius_choice> radius; ///< if not, it is a variable of the objective
  bool is_unit_sphere = false;         ///< whether the radius is 1 because nothing else has chosen one
  std::string description;             ///< the method with all of its settings in words
  double energy_tolerance = 1e-3, radius_tolerance = 2e-3;
  std::optional<std::size_t> max_iterations; ///< if not given, the method's default
  double max_seconds = 0.;                   ///< 0 if there is no limit
  unsigned int max_threads = 0;              ///< 0 if there is no limit

private:
  inline static const Words methods = {"bld",  "hierarchical",  "harmonic", "conformal",
                                       "arap", "stereographic", "schnyder"};
  inline static const Words starts = {"hierarchical", "stereographic", "harmonic", "conformal", "schnyder"};
  inline static const Words energies = {"symmetric-dirichlet", "isometric", "conformal"};

  inline static const Words resampling_methods = {"barycentric", "adaptive", "nearest", "largest"};

  // Which methods an option goes with; options that are not listed go with all.
  struct Scope
  {
    std::string option;
    Words methods;
    bool goes_with_paper;
  };

  inline static const std::vector<Scope> scopes = {
      {"initial", {"bld", "arap"}, true},
      {"energy", {"bld", "hierarchical"}, false},
      {"prefer", {"bld", "hierarchical"}, false},
      {"sharpness", {"bld", "hierarchical"}, false},
      {"s-first", {"bld"}, true},
      {"s-last", {"bld"}, true},
      {"average-sweeps", {"bld"}, true},
      {"density", {"bld"}, false},
      {"radius", {"bld"}, true},
      {"tolerance", {"bld"}, false},
      {"iterations", {"bld", "harmonic", "conformal", "arap"}, true},
      {"time-limit", {"bld", "hierarchical", "harmonic", "conformal", "arap"}, true},
  };

  void parse(int argc, const char* const* argv)
  {
    namespace po = boost::program_options;
    po::options_description all = describe_options();
    all.add_options()("input", po::value<Words>());
    po::positional_options_description positions;
    positions.add("input", -1);
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    try
    {
      po::store(po::command_line_parser(argc, argv).options(all).positional(positions).style(style).run(), m_values);
    }
    catch(const po::error& error)
    {
      fail(printable(error.what()));
    }
  }

  static boost::program_options::options_description describe_options()
  {
    namespace po = boost::program_options;
    constexpr unsigned int line_length = 100;
    po::options_description options("Options", line_length);
    const auto word = [](const char* name) { return po::value<std::string>()->value_name(name); };
    const auto words = [](const char* names) { return po::value<Words>()->multitoken()->value_name(names); };
    // clang-format off
    options.add_options()
      ("output,o", word("SPHERE"), "write the sphere: the faces of INPUT, with the images of its vertices in the same "
                                   "order (0 0 0 for a vertex without a face) and 17 digits; .off, .obj, .ply or .ts; or with numbers of "
                                   "32 bits, .gii, or a name that begins with lh. or rh. for the format of FreeSurfer")
      ("fill-holes", word("N"), "fill the holes of the surface that have at most N edges, or all of them by the word all; each is told. "
                                "What is measured and written is that of the faces of INPUT")
      ("filled", word("FILE"), "with --fill-holes, write the closed surface, whose first vertices and faces are those of INPUT; "
                               "a .ply file, where the property filler of the other faces is 1")
      ("handles", word("FILE"), "write a short closed path around each handle, which keeps a surface from being mapped, as lines; a .ply "
                                "file, with the numbers of the vertices")
      ("components", word("WHICH"), "of a surface of several parts, map the largest one; or each, with files numbered by size, "
                                    "NAME_1.off, say, for the largest")
      ("remesh", word("DOMAIN=N"), "write the surface to -o instead, with other faces: those of an octahedron, a cube or an "
                                   "icosahedron whose edges are divided into N, say octahedron=64, 4 N^2 + 2, "
                                   "6 N^2 + 2 or 10 N^2 + 2 vertices; or FILE: those of a mesh of the sphere, such as "
                                   "--sphere has written. --prefer is sampling if nothing else is given; a .ply "
                                   "file has normals, too")
      ("sphere", word("SPHERE"), "with --remesh, write the sphere here; with --onto, the directions of the vertices of INPUT "
                                 "on the sphere of TARGET, and that sphere to SPHERE_target")
      ("transfer", word("VALUES"), "with --remesh, carry over the properties of the vertices and faces of a .ply file that "
                                   "has the faces of INPUT, with a warning for each that cannot be; whole numbers are "
                                   "labels, which are not averaged. Or values of the vertices in a file of FreeSurfer, "
                                   "such as lh.sulc, a .mgh, .mgz or .gii file, or several with commas between them. "
                                   "With -o NAME.surf.gii, they are written to NAME.func.gii")
      ("values-sphere", word("SPHERE"), "VALUES is another surface, and this its sphere")
      ("geometry-image", word("FILE"), "write the surface as an image, .png with 16 bits or .exr with 32: an octahedron that "
                                       "is unfolded to a square, with points as colours; and its normals to FILE_normals. "
                                       "--prefer is sampling if nothing else is given")
      ("image-size", word("N"), "pixels in each of its rows and columns, odd; 257")
      ("onto", word("TARGET"), "map the surface onto this one: -o is INPUT with its vertices on TARGET. The spheres are aligned "
                               "by features of the surfaces, and by landmarks")
      ("onto-atlas", word("ATLAS"), "register the surface to an atlas, a sphere whose features are given by --features: -o is the sphere of "
                                    "INPUT in register, its vertices on that of ATLAS; --sphere is as it was before")
      ("landmarks", words("A B"), "with --onto, files with the vertices of INPUT and TARGET that correspond, one a line, counted "
                                  "from 0; further columns are not looked at. They are met exactly, with a warning for each "
                                  "that cannot be")
      ("soft-landmarks", word("W"), "with --landmarks, the weight of their mean squared distance on the unit sphere instead")
      ("features", words("A B"), "with --onto, .ply files with the vertices of INPUT and TARGET, whose properties of the same "
                                 "names are what the spheres are aligned by; or files of values as for --transfer, "
                                 "of which the first of A and of B correspond, and so on. In place of a file, four words stand for what is "
                                 "measured: depth, that of the folds, positive in furrows, as lh.sulc of FreeSurfer; height, the "
                                 "opposite, as sulc of the Human Connectome Project; curvature, positive in furrows too; and inflated, "
                                 "that of the surface without its small folds. Cortical surfaces are aligned by the values of "
                                 "depth,inflated if nothing is given")
      ("feature-weights", word("NAME=W,..."), "with --features, how much those of these names count beside the others, which have the weight "
                                              "1; 0 leaves one out")
      ("compare", word("WHAT"), "with --features, compare their ranks, or their values, in units of their deviation over both "
                                "surfaces; ranks")
      ("regularize", word("WHAT"), "with --onto or --onto-atlas, keep the distortion low of the map between the surfaces, the default, or of that "
                                   "between their spheres: surfaces or spheres")
      ("masks", words("A B"), "with --onto, files with one value for each vertex of INPUT and TARGET, 0 where features are not to be "
                              "compared; or labels of FreeSurfer, which are the vertices where they are")
      ("split", "with --onto, split edges of INPUT where its faces are too large for what they cover of TARGET, or keep landmarks from "
                "their places, as long as that lowers the energy by much; at most half as many vertices again. -o and --sphere "
                "have them behind those of INPUT, --json tells which faces they make")
      ("overlay", word("FILE"), "with --onto, write the common refinement of both surfaces, a .ply file with positions on INPUT, "
                                "those on TARGET and the faces of both as properties")
      ("morph", words("T FILE"), "with --onto, write the common refinement on its way from INPUT, T = 0, to TARGET, T = 1")
      ("resample", words("A B"), "INPUT is a file of values of vertices, of labels or of a surface, or with --output-folder several: "
                                 "carry it from the vertices of the sphere A to those of B. "
                                 "Whole numbers are labels, which are not averaged")
      ("areas", words("A B"), "with --resample, surfaces with the vertices of the spheres, or files with the areas around these: "
                              "average, weighted with areas, where B is coarser")
      ("mask", word("FILE"), "with --resample, the vertices of A that count: those whose value is positive, or which a label of "
                             "FreeSurfer has. What gets nothing is 0")
      ("valid", word("FILE"), "with --resample, write 1 for the vertices of B that get something, 0 for the others")
      ("through", words("A B"), "INPUT is a sphere: carry it through a registration, from the sphere A to B, which has the same faces")
      ("output-folder", word("FOLDER"), "map many meshes: each INPUT is a mesh, or a folder, which stands for the mesh "
                                        "files in it; write each sphere and its report to FOLDER, as NAME.off, say, "
                                        "and NAME.json")
      ("surfaces", words("NAME ..."), "with --output-folder, map the files of these names in all folders below each INPUT, such as the "
                                      "surfaces lh.white and rh.white of the subjects of FreeSurfer; each may be a pattern, such as "
                                      "'*_white.surf.gii', or, with a slash, the path from INPUT on. Results go to the "
                                      "folders of the same names below FOLDER, as SUBJECT/surf/lh.sphere, say, and lh.sphere.json; "
                                      "beside the surfaces if FOLDER is INPUT; with several, to folders of their names")
      ("overwrite", "with --surfaces, replace files of these names that the program has not written; they are an error otherwise")
      ("template", word("T"), "with --output-folder, map the surface T onto each INPUT, and write T with its vertices there "
                              "instead of the sphere: all get the same faces")
      ("format", word("FORMAT"), "the format of all meshes that are written, if names are not to tell it, or with --output-folder that "
                                 "of the INPUT, and off for .stl: off, obj, ply, ts, gifti or freesurfer")
      ("convention", word("WHICH"), "cortex: spheres as programs for cortical surfaces expect them, the default for .gii and the format "
                                    "of FreeSurfer: they lie as the surface does, seen from its centroid, and have the radius 100, or "
                                    "that of --radius; and cortical surfaces are mapped onto each other by their folds, see --features. "
                                    "none: spheres as the method leaves them, the default for other formats")
      ("resume", "leave out the meshes whose sphere and report are there, made by the same version of the program from "
                 "the same file with the same options")
      ("method", word("METHOD"), "bld: lowest distortion, the default; or one of the methods that it can start from or "
                                 "is compared with, alone: hierarchical, harmonic, stereographic or schnyder, "
                                 "which are one-to-one; conformal or arap, which may fold. With --resample: barycentric, what is "
                                 "interpolated, the default; adaptive, the default with --areas; nearest, what has the largest "
                                 "weight; or largest, the same by the weights of adaptive")
      ("paper", "the published method with all of its settings: harmonic start, isometric energy with the flat areas "
                "of images, gradient steps, 100 sweeps of the energy's sum, then s from 0.1 to 10, two-phase radius, "
                "at most 2000 sweeps. --initial, --s-first, --s-last, --average-sweeps, --radius and --iterations may "
                "change it")
      ("initial", word("START"), "what bld and arap start from: hierarchical, the default; stereographic; harmonic; "
                                 "schnyder; conformal, which must not fold; or FILE: a map written before for the same mesh")
      ("energy", word("ENERGY"), "symmetric-dirichlet: lengths and areas, the default; isometric: the paper's, default "
                                 "of --method hierarchical; conformal: angles only")
      ("prefer", word("WHAT"), "the lowest average distortion, the lowest worst, or a balance of both, the default: "
                               "average, balance or worst, which is sharpness 0, 20 or 40; --method hierarchical "
                               "prefers average, if nothing is given. Or sampling: samples that are even on the sphere "
                               "describe the surface best, with an energy of its own, sharpness 3, --radius area and --tolerance 3e-3")
      ("density", word("FILE"), "give each part of the surface a share of the sphere: of equal areas, by the word equal; or of its area times "
                                "a density: the one value that each vertex has, or each face, in a file as for --transfer, or the property density. The "
                                "report tells how near the areas of the cells of vertices have come, and --json where they have not")
      ("sharpness", word("B"), "anything between: 0 or more")
      ("s-first", word("S"), "the paper's schedule instead of a sharpness: exp(s E) with s from here, 0.1 ...")
      ("s-last", word("S"), "... to here, 10; the same as --s-first for a fixed s, as in AMIPS")
      ("average-sweeps", word("N"), "exactly so many sweeps of the plain sum of E before them, as in the paper; 0 for "
                                    "none. If not given, as many as help, or none for a fixed s")
      ("radius", word("RADIUS"), "objective: it is a variable of what the vertices lower, the default; two-phase: equal "
                                 "area at first, then balanced areas, the default of --paper; optimal: of the lowest "
                                 "energy; area: equal area; balanced: balanced areas; fixed=R: R, the default of "
                                 "--energy conformal, with R = 1")
      ("tolerance", word("T"), "end when two sweeps change the objective by no more than this share, 1e-3; 0: when nothing "
                            "changes any more")
      ("iterations", word("N"), "most sweeps over the mesh, if not given 250, as many times more as it has fewer than "
                                "2000 vertices, 2000 with --paper; or most global steps, if not given 100, 500 with "
                                "--method arap; 0 leaves the initial map")
      ("time-limit", word("SECONDS"), "sweep no longer than this on each mesh; the map reached is written")
      ("threads", word("N"), "use no more threads; the result is always the same")
      ("json", word("FILE"), "write the report and the distortions as JSON; - prints them instead of the report")
      ("colored", word("PREFIX"), "write PREFIX_surface.ply and PREFIX_sphere.ply, with the distortion as colour")
      ("page", word("FILE"), "write a page for web browsers, which needs no network: the surface and its sphere, or "
                             "with --onto both surfaces, side by side, coloured, with the distortion of the place that is pointed at; "
                             "of a surface with handles, where these are; .html. Cortical surfaces can be seen with furrows "
                             "and ridges in grey")
      ("beside", word("SURFACE"), "with --page, show this surface in place of the sphere: it has the faces of INPUT, as two ends of a mode "
                                  "of shapes have")
      ("labels", word("FILE"), "with --page, the labels of the vertices of INPUT, an annotation of FreeSurfer or a .label.gii file, whose "
                               "colours the page shows")
      ("quiet", "print nothing but errors")
      ("help,h", "print this")
      ("version", "print the version");
    // clang-format on
    return options;
  }

  bool has(const std::string& option) const { return m_values.count(option) > 0; }

  // returns the value of an option, which is empty if it was not given
  std::string text(const std::string& option) const
  {
    return has(option) ? m_values[option].as<std::string>() : std::string();
  }

  [[noreturn]] static void fail(const std::string& what)
  {
    throw Program_error(what + "\nAll options are explained by: spherical_parameterization --help");
  }

  // refuses the value of an option; `valid` says which would be accepted
  [[noreturn]] void refuse(const std::string& option, const std::string& valid) const
  {
    fail("--" + option + " has to be " + valid + ", not '" + printable(text(option)) + "'");
  }

  std::string read_word(const std::string& option, const Words& words, const std::string& usual) const
  {
    if(has(option) && !is_among(text(option), words))
      refuse(option, list_of(words, " or "));
    return has(option) ? text(option) : usual;
  }

  static bool is_number(const std::string& text, double& x)
  {
    char* end = nullptr;
    x = std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0';
  }

  // reads a number in [min, max], which is `range` in words
  double read_number(const std::string& option, double min, double max, const std::string& range, double usual) const
  {
    double x = usual;
    if(has(option) && (!is_number(text(option), x) || !(x >= min && x <= max)))
      refuse(option, range);
    return x;
  }

  unsigned int read_count(const std::string& option, unsigned int min, unsigned int usual) const
  {
    const std::string range = "a whole number from " + std::to_string(min) + " to 1e9";
    const double x = read_number(option, min, 1e9, range, usual);
    if(x != std::floor(x))
      refuse(option, range);
    return static_cast<unsigned int>(x);
  }

  // as many digits as it takes to read the same number again
  static std::string short_text(double x)
  {
    std::string text;
    double again = 0.;
    for(int digits = 6; digits <= std::numeric_limits<double>::max_digits10 && (text.empty() || again != x); ++digits)
    {
      std::ostringstream out;
      out.precision(digits);
      out << x;
      text = out.str();
      is_number(text, again);
    }
    return text;
  }

  void describe(const std::string& setting) { description += ", " + setting; }

  // returns whether the method has a setting of the name of `option`
  bool knows(const std::string& option) const
  {
    for(const Scope& scope : scopes)
      if(scope.option == option)
        return is_among(method, scope.methods);
    return true;
  }

  // Reads the two words of an option. What follows them is an INPUT.
  Words read_pair(const std::string& option, const std::string& valid)
  {
    if(!has(option))
      return {};
    Words result = m_values[option].as<Words>();
    if(result.size() < 2)
      fail("--" + option + " needs " + valid);
    inputs.insert(inputs.end(), result.begin() + 2, result.end());
    result.resize(2);
    return result;
  }

  void read_inputs()
  {
    if(has("input"))
      inputs = m_values["input"].as<Words>();
    landmark_files = read_pair("landmarks", "two files, of INPUT and of TARGET");
    feature_files = read_pair("features", "two files, of INPUT and of TARGET");
    mask_files = read_pair("masks", "two files, of INPUT and of TARGET");
    morph = read_pair("morph", "a number and the name of a file");
    spheres = read_pair("resample", "two files, the spheres to resample from and to");
    area_files = read_pair("areas", "two files, of the spheres that are resampled from and to");
    const Words registration = read_pair("through", "two files, a sphere before and after its registration");
    carries_sphere = !registration.empty();
    if(carries_sphere)
    {
      refuse_both("resample", "through");
      spheres = registration;
    }
    if(has("surfaces"))
      surfaces = m_values["surfaces"].as<Words>();
    for(std::string& name : surfaces)
    {
      name = std::filesystem::path(name).lexically_normal().string();
      if(name.empty() || name == "." || name.front() == '/' || name.back() == '/' || name.compare(0, 2, "..") == 0)
        fail("--surfaces takes names of files, or their paths from INPUT on, not '" + printable(name) + "'");
    }
    if(inputs.empty())
      fail(surfaces.empty() ? "there is no INPUT" : "there is no INPUT; it comes before --surfaces and its names");
    if(has("output-folder"))
      return;
    if(inputs.size() > 1)
      fail("there is more than one INPUT; a name with blanks has to be quoted, and many meshes need --output-folder");
    file_names.input = inputs.front();
    std::error_code ignored;
    if(std::filesystem::is_directory(file_names.input, ignored))
      fail(printable(file_names.input) + " is a folder; to map the meshes in it, say with --output-folder where to");
  }

  void read_resampling()
  {
    for(const char* option : {"areas", "mask", "valid"})
      if(has(option) && (carries_sphere || !resamples()))
        fail("--" + std::string(option) + " goes with --resample");
    if(!resamples())
      return;
    const std::string mode = carries_sphere ? "through" : "resample";
    for(const auto& value : m_values)
      if(!is_among(value.first, {"input", "resample", "through", "areas", "mask", "valid", "output", "output-folder",
                                 "threads", "quiet"}) &&
         (value.first != "method" || carries_sphere))
        fail("--" + value.first + " and --" + mode + " cannot be combined");
    if(has("output") == has("output-folder"))
      fail("--" + mode + " needs " + (has("output") ? "one of -o and --output-folder" : "-o or --output-folder"));
    for(const char* option : {"output", "output-folder", "mask", "valid"})
      if(has(option) && text(option).empty())
        fail("--" + std::string(option) + " needs a name");
    method = read_word("method", resampling_methods, has("areas") ? "adaptive" : "barycentric");
    if(is_among(method, {"adaptive", "largest"}) && !has("areas"))
      fail("--method " + method + " needs --areas, of the vertices of both spheres");
    if(is_among(method, {"barycentric", "nearest"}) && has("areas"))
      fail("--areas goes with --method adaptive or largest");
    file_names.sphere = text("output");
    output_folder = text("output-folder");
    mask_file = text("mask");
    valid_file = text("valid");
    is_quiet = has("quiet");
    max_threads = read_count("threads", 1, 0);
  }

  void read_method()
  {
    method = read_word("method", methods, method);
    is_published = has("paper");
    if(is_published && has("method"))
      fail("--paper is a method of its own: leave out --method");
    refuse_both("paper", "density");
    for(const Scope& scope : scopes)
      if(has(scope.option))
        check_scope(scope);
    is_unit_sphere = method != "bld" && method != "arap";
    description = method + (is_published ? " as published" : "");
  }

  // refuses an option that would be ignored
  void check_scope(const Scope& scope) const
  {
    Words known, known_to_paper;
    for(const Scope& other : scopes)
    {
      if(is_among(method, other.methods))
        known.push_back("--" + other.option);
      if(other.goes_with_paper)
        known_to_paper.push_back("--" + other.option);
    }
    if(is_published && !scope.goes_with_paper)
      fail("--" + scope.option + " is among the settings of --paper, which can be combined with " +
           list_of(known_to_paper, " and ") + " only");
    if(!is_among(method, scope.methods))
      fail("--" + scope.option + " goes with --method " + list_of(scope.methods, " or ") + "; " + method +
           (known.empty() ? " has no settings" : " knows " + list_of(known, " and ") + " only"));
  }

  void refuse_both(const std::string& option, const std::string& other) const
  {
    if(has(option) && has(other))
      fail("--" + option + " and --" + other + " contradict each other: give one of them");
  }

  void read_initial()
  {
    const std::string value = has("initial") ? text("initial") : (is_published ? "harmonic" : "hierarchical");
    start = is_among(value, starts) ? value : "";
    if(start.empty())
    {
      if(!std::filesystem::exists(value))
        refuse("initial", list_of(starts, " or ") + ", or the name of a file with a map");
      start_file = value;
    }
    describe(start.empty() ? "start from " + printable(start_file) : start + " start");
  }

  void read_density()
  {
    if(!has("density"))
      return;
    for(const char* option : {"initial", "radius", "tolerance", "onto", "template"})
      if(has(option))
        fail("--" + std::string(option) + " and --density cannot be combined");
    gives_areas = true;
    if(text("density") == "equal")
    {
      describe("equal areas");
      return;
    }
    density_file = text("density");
    if(density_file.empty())
      fail("--density needs the name of a file, or the word equal");
    check_values("density", density_file);
    for(const char* option : {"output-folder", "fill-holes"})
      if(has(option))
        fail("--density with a file and --" + std::string(option) + " cannot be combined" +
             (has("fill-holes") ? ", as the filler has no values; write the closed surface by --filled, and map that"
                                : ", as it is for one mesh"));
    describe("areas by " + printable(density_file));
  }

  // What is preferred decides on other settings, and what is sampled on that.
  void read_sampling()
  {
    if(has("sphere") && !has("remesh") && !has("onto") && !has("onto-atlas"))
      fail("--sphere goes with --remesh, --onto or --onto-atlas; without them, -o is the sphere");
    if(has("transfer") && !has("remesh"))
      fail("--transfer goes with --remesh");
    if(has("image-size") && !has("geometry-image"))
      fail("--image-size goes with --geometry-image");
    if(has("geometry-image"))
      read_image();
    if(has("values-sphere") && !has("transfer"))
      fail("--values-sphere goes with --transfer");
    if(has("remesh"))
      read_domain();
    values_file = text("transfer");
    values_sphere = text("values-sphere");
    if(has("transfer"))
      check_values("transfer", values_file);

    const bool samples = has("remesh") || has("geometry-image");
    bool is_plain = method == "bld" && !is_published;
    for(const char* option : {"energy", "sharpness", "s-first", "s-last", "average-sweeps", "radius"})
      is_plain = is_plain && !has(option);
    preference = read_word("prefer", {"average", "balance", "worst", "sampling"},
                           method == "hierarchical" ? "average"
                           : samples && is_plain    ? "sampling"
                                                    : "balance");
  }

  void read_image()
  {
    image_size = read_count("image-size", 3, 257);
    if(image_size % 2 == 0 || image_size > 2 * SP::Sphere_domain_3::max_subdivision + 1)
      refuse("image-size", "an odd number from 3 to " + std::to_string(2 * SP::Sphere_domain_3::max_subdivision + 1));
    file_names.image = text("geometry-image");
    if(!is_among(file_format(file_names.image), {".png", ".exr"}))
      refuse("geometry-image", "a name that ends with .png or .exr");
  }

  void read_domain()
  {
    const std::string value = text("remesh");
    const std::size_t equals = value.find('=');
    double n = 0.;
    std::error_code ignored;
    const bool is_solid =
        is_among(value.substr(0, equals), {"octahedron", "cube", "icosahedron"}) && equals != std::string::npos;
    if(is_solid && is_number(value.substr(equals + 1), n) && n >= 1 && n <= SP::Sphere_domain_3::max_subdivision &&
       n == std::floor(n))
    {
      domain = value.substr(0, equals);
      domain_size = static_cast<unsigned int>(n);
    }
    else if(!is_solid && std::filesystem::is_regular_file(value, ignored))
      domain = value;
    else
      refuse("remesh", "octahedron=N, cube=N or icosahedron=N with a whole number N from 1 to " +
                           std::to_string(SP::Sphere_domain_3::max_subdivision) +
                           ", or the name of a file with a mesh of the sphere");
  }

  void read_energy()
  {
    const bool is_usually_isometric = is_published || method == "hierarchical";
    if(preference == "sampling")
    {
      if(has("energy"))
        fail("--prefer sampling has an energy of its own: leave out --energy");
      energy = "stretch";
      describe(energy + " energy");
      return;
    }
    energy = read_word("energy", energies, is_usually_isometric ? "isometric" : "symmetric-dirichlet");
    describe(energy + " energy");
  }

  void read_sharpness()
  {
    refuse_both("prefer", "sharpness");
    for(const char* schedule : {"s-first", "s-last", "average-sweeps"})
      for(const char* dial : {"prefer", "sharpness"})
        refuse_both(schedule, dial);
    if(is_published || has("s-first") || has("s-last"))
    {
      read_schedule();
      return;
    }
    if(has("average-sweeps"))
      fail("--average-sweeps goes with --s-first, --s-last or --paper");
    const double beta = read_number("sharpness", 0., max_sharpness, "a number from 0 to 1e6",
                                    preference == "average"    ? 0.
                                    : preference == "balance"  ? 20.
                                    : preference == "sampling" ? 3.
                                                               : 40.);
    sharpness = SP::Sharpness::relative(beta);
    describe("sharpness " + short_text(beta));
  }

  void read_schedule()
  {
    constexpr double usual_first = 0.1, usual_last = 10.;
    constexpr unsigned int usual_sweeps = 100;
    const double min = (std::numeric_limits<double>::min)();
    const char* range = "a number from 2.3e-308 to 1e6";
    const double first = read_number("s-first", min, max_sharpness, range, usual_first);
    const double last = read_number("s-last", min, max_sharpness, range, usual_last);
    if(first > last)
      fail("--s-first must not be greater than --s-last, but they are " + short_text(first) + " and " +
           short_text(last) + "; valid are 0 < s-first <= s-last <= 1e6, by default " + short_text(usual_first) +
           " and " + short_text(usual_last));
    describe("s " + (first < last ? "from " + short_text(first) + " to " : "= ") + short_text(last));
    if(is_published || has("average-sweeps"))
    {
      const unsigned int n = read_count("average-sweeps", 0, usual_sweeps);
      sharpness = SP::Sharpness::schedule(first, last, n);
      description += " after " + std::to_string(n) + " sweeps of the plain sum";
      return;
    }
    sharpness = SP::Sharpness::schedule(first, last);
    if(first < last)
      description += " after sweeps of the plain sum while they help";
  }

  void read_radius()
  {
    if(gives_areas)
    {
      describe("radius area");
      return;
    }
    const std::string fixed = "fixed=";
    const std::string usual = is_published            ? "two-phase"
                              : energy == "conformal" ? "fixed=1"
                              : energy == "stretch"   ? "area"
                                                      : "objective",
                      value = has("radius") ? text("radius") : usual;
    is_unit_sphere = !has("radius") && energy == "conformal";
    double r = 0.;
    if(value == "two-phase") // in the paper the second phase waits for the energy as well
      radius = is_published ? SP::Two_phase_radius_3<>({}, {}, 0.) : SP::Two_phase_radius_3<>();
    else if(value == "optimal")
      radius = SP::Optimal_radius_3();
    else if(value == "area")
      radius = SP::Area_preserving_radius_3();
    else if(value == "balanced")
      radius = SP::Area_balancing_radius_3();
    else if(value.compare(0, fixed.size(), fixed) == 0 && is_number(value.substr(fixed.size()), r) &&
            r >= (std::numeric_limits<double>::min)() && r <= (std::numeric_limits<double>::max)())
      radius = SP::Fixed_radius_3(r);
    else if(value != "objective" || is_published)
      refuse("radius", std::string(is_published ? "" : "objective, ") +
                           "two-phase, optimal, area, balanced or fixed=R with a number R from 2.3e-308 to 1.7e308");
    describe("radius " + value);
  }

  void read_limits()
  {
    const bool is_bld = method == "bld";
    // Samples do not tell whether the last of the sweeps have been made.
    energy_tolerance = read_number("tolerance", 0., 1., "a number from 0 to 1", energy == "stretch" ? 3e-3 : 1e-3);
    radius_tolerance = energy_tolerance > 0. ? 2e-3 : 0.;
    if(has("tolerance"))
      describe("tolerance " + short_text(energy_tolerance));
    if(has("iterations") || !is_bld || is_published)
    {
      max_iterations = read_count("iterations", 0, is_published ? 2000 : (method == "arap" ? 500 : 100));
      if(knows("iterations"))
        describe("at most " + std::to_string(*max_iterations) + (is_bld ? " sweeps" : " global steps"));
    }
    max_seconds = read_number("time-limit", (std::numeric_limits<double>::min)(), (std::numeric_limits<double>::max)(),
                              "a number from 2.3e-308 to 1.7e308", 0.);
    if(max_seconds > 0.)
      describe("at most " + short_text(max_seconds) + " seconds");
    max_threads = read_count("threads", 1, 0);
  }

  void read_format()
  {
    if(!has("format"))
      return;
    const std::string word = text("format");
    format = word == "freesurfer" ? freesurfer_format
             : word == "gifti"    ? ".gii"
                                  : file_format("sphere." + word.substr(word.find_first_not_of('.') == 1 ? 1 : 0));
    if(!is_among(format, output_formats) && format != freesurfer_format)
      refuse("format", "one of off, obj, ply, ts, gifti or freesurfer");
  }

  // refuses the name of a mesh that is to be written, unless it tells a format that the program has
  void check_output(const std::string& option, const std::string& name) const
  {
    if(format_of(name).empty())
      fail("--" + option + " has to be a name that ends with one of " + output_names + ", not '" + printable(name) +
           "'");
#ifndef PROGRAM_READS_GIFTI
    if(is_gifti(format_of(name)))
      fail("--" + option + ": this program was built without expat and zlib, which GIFTI files take");
#endif
  }

  // refuses a file of values that can be told by its name to be none
  void check_values(const std::string& option, const std::string& names) const
  {
    for(const std::string& name : split_list(names))
      if(is_among(file_format(name), {".off", ".obj", ".stl", ".ts"}))
        fail("--" + option + " needs .ply files, which can hold properties, or files of values of vertices, not '" +
             printable(name) + "'");
  }

  void read_feature_weights()
  {
    for(const std::string& pair : split_list(text("feature-weights")))
    {
      const std::size_t sign = pair.rfind('=');
      double weight = -1.;
      if(sign == 0 || sign == pair.npos || !is_number(pair.substr(sign + 1), weight) ||
         !(weight >= 0. && weight <= 1e6) || !feature_weights.emplace(pair.substr(0, sign), weight).second)
        refuse("feature-weights", "a list such as sulc=2,curv=0.5: each name once, with a number from 0 to 1e6");
    }
  }

  void read_match()
  {
    refuse_both("onto", "onto-atlas");
    is_onto_atlas = has("onto-atlas");
    onto = text(is_onto_atlas ? "onto-atlas" : "onto");
    template_file = text("template");
    for(const char* option : {"landmarks", "features", "masks", "split", "overlay", "morph", "regularize"})
      if(has(option) && onto.empty())
        fail("--" + std::string(option) + " goes with --onto");
    for(const char* option : {"remesh", "geometry-image", "output-folder", "initial"})
      if(has(option) && !onto.empty())
        fail("--" + std::string(option) + (is_onto_atlas ? " and --onto-atlas" : " and --onto") +
             " cannot be combined");
    for(const std::string& list : feature_files)
      for(const std::string& name : split_list(list))
        if(std::error_code ignored; !is_among(name, own_feature_names) && name.find_first_of("./") == name.npos &&
                                    !std::filesystem::exists(name, ignored))
          fail("--features has '" + printable(name) + "', which is neither a file nor one of " +
               list_of(own_feature_names));
    if(is_onto_atlas && !has("features"))
      fail("--onto-atlas needs --features, as a sphere has none of its own: what INPUT is compared by, such as depth "
           "or lh.sulc, and "
           "a file of what ATLAS has for it");
    if(is_onto_atlas)
      for(const std::string& name : split_list(feature_files[1]))
        if(is_among(name, own_feature_names))
          fail("--features has '" + name + "' for the atlas, which is a sphere without folds: give a file of values");
    for(const char* option : {"split", "morph"})
      if(has(option) && is_onto_atlas)
        fail("--" + std::string(option) + " and --onto-atlas cannot be combined, as the atlas is no surface");
    regularizes_spheres = read_word("regularize", {"surfaces", "spheres"}, "surfaces") == "spheres";
    if(has("split") && regularizes_spheres)
      fail("--split and --regularize spheres contradict each other: edges are split where faces bend over the surface");
    if(!template_file.empty() && (!has("output-folder") || !start_file.empty()))
      fail("--template goes with --output-folder, and without the map of --initial");
    splits = has("split");
    if(splits && has("fill-holes"))
      fail("--split and --fill-holes cannot be combined; write the closed surface by --filled, and map that");
    if(has("soft-landmarks") && !has("landmarks"))
      fail("--soft-landmarks goes with --landmarks");
    landmark_weight = read_number("soft-landmarks", 1e-6, 1e6, "a number from 1e-6 to 1e6", 0.);
    for(const std::string& name : feature_files)
      check_values("features", name);
    for(const std::string& name : mask_files)
      check_values("masks", name);
    for(const char* option : {"feature-weights", "compare"})
      if(has(option) && !has("features"))
        fail("--" + std::string(option) + " goes with --features");
    compares_values = read_word("compare", {"ranks", "values"}, "ranks") == "values";
    if(has("feature-weights"))
      read_feature_weights();
    file_names.overlay = text("overlay");
    if(has("overlay") && file_format(file_names.overlay) != ".ply")
      refuse("overlay", "the name of a .ply file, which can hold properties");
    if(!morph.empty())
    {
      if(!is_number(morph[0], morph_time) || !(morph_time >= 0. && morph_time <= 1.))
        fail("--morph has to be a number from 0 to 1 and the name of a file, not '" + printable(morph[0]) + "'");
      file_names.morph = morph[1];
      check_output("morph", morph[1]);
    }
    if(!template_file.empty())
      describe("template " + printable(template_file));
  }

  void read_convention()
  {
    convention = read_word("convention", {"cortex", "none"}, "");
    keeps_radius = has("radius");
    if(has("convention"))
      describe("convention " + convention);
  }

  void read_outputs()
  {
    is_quiet = has("quiet");
    const bool is_for_many = has("output-folder");
    for(const char* option : {"output", "sphere", "transfer", "values-sphere", "json", "colored", "page",
                              "output-folder", "onto", "onto-atlas", "template", "overlay", "labels", "beside"})
      if(has(option) && text(option).empty())
        fail("--" + std::string(option) + " needs a name");
    for(const char* option : {"resume", "surfaces"})
      if(has(option) && !is_for_many)
        fail("--" + std::string(option) + " goes with --output-folder");
    if(has("overwrite") && !has("surfaces"))
      fail("--overwrite goes with --surfaces; other results are replaced as they are");
    for(const char* option : {"remesh", "geometry-image", "page"})
      if(has(option) && is_for_many)
        fail("--" + std::string(option) + " is for one mesh: leave out --output-folder");
    for(const char* option : {"output", "json", "colored"})
      if(has(option) && is_for_many)
        fail("--" + std::string(option) + " is for one mesh; with --output-folder, the sphere of each and its report " +
             "are written there");
    const bool has_result = has("remesh") || !onto.empty();
    file_names.sphere = text(has_result ? "sphere" : "output");
    if(has_result)
      (has("remesh") ? file_names.remesh : file_names.onto) = text("output");
    if(has("onto") && has("sphere"))
      file_names.target_sphere = with_suffix(file_names.sphere, "_target");
    prints_json = text("json") == "-";
    file_names.json = prints_json ? "" : text("json");
    file_names.colored = text("colored");
    file_names.page = text("page");
    if(has("page") && file_format(file_names.page) != ".html")
      refuse("page", "a name that ends with .html");
    labels_file = text("labels");
    beside = text("beside");
    for(const char* option : {"labels", "beside"})
      if(has(option) && !has("page"))
        fail("--" + std::string(option) + " goes with --page");
    refuse_both("beside", "onto");
    refuse_both("beside", "onto-atlas");
    output_folder = text("output-folder");
    is_resumed = has("resume");
    overwrites = has("overwrite");
    for(const char* option : {"output", "sphere"})
      if(has(option))
        check_output(option, text(option));
    if(has("transfer") && has("output"))
    {
      const std::string format_of_remesh = format_of(file_names.remesh);
      if(format_of_remesh != ".ply" && !is_gifti(format_of_remesh))
        refuse("output", "the name of a .ply or .gii file, as other formats do not hold the properties of --transfer");
      if(is_gifti(format_of_remesh))
      {
        const std::string& name = file_names.remesh;
        file_names.values = name.substr(0, name.size() - ending_of(name).size()) + ".func" + format_of_remesh;
      }
    }
  }

  // what is done to a surface before it is mapped
  void read_repair()
  {
    if(has("fill-holes"))
    {
      max_hole_edges =
          text("fill-holes") == "all"
              ? (std::numeric_limits<std::size_t>::max)()
              : static_cast<std::size_t>(read_number("fill-holes", 3, 1e9, "a number of edges from 3 on, or all", 0.));
      describe("holes filled: " + text("fill-holes"));
      const std::string advice = "write the closed surface by --filled, and map that";
      if(has("transfer"))
        fail("--transfer and --fill-holes cannot be combined, as the filler has no values; " + advice);
      if(!start_file.empty())
        fail("--initial with a file and --fill-holes cannot be combined, as the file has no images of the filler; " +
             advice);
    }
    file_names.filled = text("filled");
    if(has("filled") && !has("fill-holes"))
      fail("--filled goes with --fill-holes");
    if(has("filled") && has("output-folder"))
      fail("--filled is for one mesh: leave out --output-folder");
    if(has("filled") && file_format(file_names.filled) != ".ply")
      refuse("filled", "the name of a .ply file, which can hold properties");
    file_names.handles = text("handles");
    if(has("handles") && has("output-folder"))
      fail("--handles is for one mesh: leave out --output-folder");
    if(has("handles") && file_format(file_names.handles) != ".ply")
      refuse("handles", "the name of a .ply file");
    const std::string component = read_word("components", {"largest", "each"}, "");
    picks_component = has("components");
    takes_each_component = component == "each";
    if(takes_each_component && has("output-folder"))
      fail("--components each is for one mesh: leave out --output-folder");
    if(picks_component)
      describe(component + " component");
  }

  static constexpr double max_sharpness = 1e6;

  std::string preference; // of --prefer
  Words morph;            // the two words of --morph

  boost::program_options::variables_map m_values;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_OPTIONS_H
