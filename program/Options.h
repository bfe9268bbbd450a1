#ifndef PROGRAM_OPTIONS_H
#define PROGRAM_OPTIONS_H

#include "command_line.h"
#include "Repair_step.h"

#include <CGAL/Spherical_parameterization/Sharpness.h>

#include <optional>

namespace Program {

/// The command line and its interpretation.
struct Options : Command_line
{
  /// returns whether the method preserves only angles.
  bool is_conformal() const
  {
    return energy == "conformal" || is_among(method, {"conformal", "harmonic", "stereographic"});
  }

  /// returns whether there may be many meshes, whose output names are derived from the inputs.
  bool is_batch() const { return has("output-folder"); }

  /// returns the names of the input files other than the meshes.
  Words other_inputs() const
  {
    Words lists = spheres, result;
    for(const std::string& name : {start_file, sphere_file, domain_size == 0 ? domain : "", onto, density_file})
      if(!name.empty())
        lists.push_back(name);
    for(const char* option : {"values-sphere", "template", "mask", "labels", "beside", "landmarks", "areas", "masks",
                              "transfer", "features"})
      for(const std::string& list : words(option))
        lists.push_back(list);
    for(const std::string& list : lists)
      for(const std::string& name : split_list(list))
        if(!is_among(name, own_feature_names))
          result.push_back(name);
    return result;
  }

  /// returns the format of a mesh that is written to this file.
  std::string format_of(const std::string& name) const { return format.empty() ? output_format(name) : format; }

  /// returns whether the sphere is rotated to the pose of the surface and has the radius of the convention, unless a radius is given.
  ///
  /// \param sphere the file name of the sphere; empty if it is not written
  bool follows_convention(const std::string& sphere) const
  {
    return has("convention") ? text("convention") == "cortex"
                             : !has("template") && !sphere.empty() && is_cortical(format_of(sphere));
  }

  /// adds a setting to the description of the method.
  void describe(const std::string& setting) { description += ", " + setting; }

  /// returns the initial map or the template, which determine a map besides the mesh; empty if there is none.
  std::string start_or_template() const { return has("template") ? text("template") : start_file; }

  std::string sphere_file;                       ///< the map that is checked or shown, empty if there is none
  Words inputs;                                  ///< meshes; in a batch, also folders
  File_names file_names;                         ///< of the mesh, unless this is a batch
  std::string domain;                            ///< of remeshing: a solid or a file name; empty without remeshing
  unsigned int domain_size = 0;                  ///< number of segments per edge of the solid
  unsigned int image_size = 0;                   ///< pixels per row of the geometry image; 0 if none is requested
  std::string onto;                              ///< the target surface or atlas; empty if there is none
  bool is_onto_atlas = false;                    ///< whether the target is an atlas, which is its own sphere
  std::map<std::string, double> feature_weights; ///< by feature name; 1 for others
  double landmark_weight = 0.;                   ///< 0 if landmarks are met exactly
  double morph_time = 0.;
  Words spheres;                         ///< source and target sphere of resampling, or empty
  std::optional<Repair_settings> repair; ///< before mapping; none if surfaces are not repaired
  std::string format;                    ///< of all written meshes; empty if it follows from their names
  std::string method = "bld";
  std::string start = "hierarchical"; ///< empty if the initial map is read from a file
  std::string start_file;
  std::string energy = "symmetric-dirichlet";
  std::string density_file; ///< the file of the density; empty for the density 1
  SP::Sharpness sharpness;
  std::string radius;          ///< the word of --radius; empty if the radius is a variable of the objective
  double fixed_radius = 0.;    ///< if `radius` is `fixed`
  bool is_unit_sphere = false; ///< whether the radius is 1 because nothing else determines it
  std::string description;     ///< the method and its settings in words
  double energy_tolerance = 1e-3, radius_tolerance = 2e-3;
  std::optional<std::size_t> max_iterations; ///< default of the method if not given
  double max_seconds = 0.;                   ///< 0: no limit
  unsigned int max_threads = 0;              ///< 0 if there is no limit
};

/// interprets the command line.
Options read_options(const Command_line& given);

/// interprets the options of the method, for `read_options()`.
void read_method_options(Options& o);

/// reports names of files whose format cannot store values.
void check_values(const Options& o, const std::string& option, const std::string& names);

/// The exit status of the program if a written map is not bijective.
constexpr int exit_status_folded = 2;

/// Each runs a command and returns the exit status. `run_map()` also runs `match`, `register`, `remesh`, `repair` and `show`.
int run_map(const Options& options);
int run_check(const Options& options);
int run_batch(const Options& options);
int run_resample(const Options& options);

} // namespace Program

#endif // PROGRAM_OPTIONS_H
