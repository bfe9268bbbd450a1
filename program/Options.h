#ifndef PROGRAM_OPTIONS_H
#define PROGRAM_OPTIONS_H

#include "command_line.h"
#include "Surface_repair.h"

#include <CGAL/Spherical_parameterization/Sharpness.h>

#include <optional>

namespace Program {

/// What the command line asks for: its words, and what they mean where that takes more than a look at them.
struct Options : Command_line
{
  /// returns whether the method only cares for angles.
  bool is_conformal() const
  {
    return energy == "conformal" || is_among(method, {"conformal", "harmonic", "stereographic"});
  }

  /// returns whether there may be many meshes: the names of their files are made from those of the inputs.
  bool is_batch() const { return has("output-folder"); }

  /// returns the names of the files that are read beside the meshes.
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

  /// returns the format of a mesh that is written under this name.
  std::string format_of(const std::string& name) const { return format.empty() ? output_format(name) : format; }

  /// returns whether the sphere is to lie as its surface does, and to have the radius of the convention, if no other was given.
  ///
  /// \param sphere the name that it is written under, empty if it is not
  bool follows_convention(const std::string& sphere) const
  {
    return has("convention") ? text("convention") == "cortex"
                             : !has("template") && !sphere.empty() && is_cortical(format_of(sphere));
  }

  /// adds a setting to the description of the method.
  void describe(const std::string& setting) { description += ", " + setting; }

  /// returns the file that decides on a map beside the mesh itself; empty if there is none.
  std::string start_or_template() const { return has("template") ? text("template") : start_file; }

  std::string sphere_file;      ///< the map that is checked or shown, empty if there is none
  Words inputs;                 ///< meshes, and folders if there may be many
  File_names file_names;        ///< of the one mesh, if there is only one
  std::string domain;           ///< to sample by: a solid, or the name of a file; empty if no remesh is wanted
  unsigned int domain_size = 0; ///< what the edges of the solid are divided into
  unsigned int image_size = 0;  ///< pixels in a row of the geometry image; 0 if none is wanted
  std::string onto;             ///< the surface, or the atlas, to map onto, empty if there is none
  bool is_onto_atlas = false;   ///< whether that is its own sphere
  std::map<std::string, double> feature_weights; ///< by the names of the features; 1 for others
  double landmark_weight = 0.;                   ///< 0 if landmarks are met exactly
  double morph_time = 0.;
  Words spheres;                         ///< to resample from one to the other, none if nothing is resampled
  std::optional<Repair_settings> repair; ///< of surfaces before they are mapped, none if they are not repaired
  std::string format;                    ///< of all meshes that are written, empty if their names say it
  std::string method = "bld";
  std::string start = "hierarchical"; ///< empty if the map to start from is in a file
  std::string start_file;
  std::string energy = "symmetric-dirichlet";
  std::string density_file; ///< that says which share of the sphere is wanted; empty if it is that of the area
  SP::Sharpness sharpness;
  std::string radius;          ///< what decides on it: a word of --radius; empty if it is a variable of the objective
  double fixed_radius = 0.;    ///< if that is `fixed`
  bool is_unit_sphere = false; ///< whether the radius is 1 because nothing else has chosen one
  std::string description;     ///< the method with all of its settings in words
  double energy_tolerance = 1e-3, radius_tolerance = 2e-3;
  std::optional<std::size_t> max_iterations; ///< if not given, the method's default
  double max_seconds = 0.;                   ///< 0 if there is no limit
  unsigned int max_threads = 0;              ///< 0 if there is no limit
};

/// reads what the words of the command line mean.
Options read_options(const Command_line& given);

/// reads what they say of the method, for `read_options()`.
void read_method_options(Options& o);

/// refuses names of files that hold no values by their format.
void check_values(const Options& o, const std::string& option, const std::string& names);

/// The exit status of the program if a map was written that is not one-to-one.
constexpr int exit_status_folded = 2;

/// Each runs a command and returns the exit status. `run_map()` runs `match`, `register`, `remesh`, `repair` and `show` as well.
int run_map(const Options& options);
int run_check(const Options& options);
int run_batch(const Options& options);
int run_resample(const Options& options);

} // namespace Program

#endif // PROGRAM_OPTIONS_H
