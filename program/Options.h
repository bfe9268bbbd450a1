#ifndef PROGRAM_OPTIONS_H
#define PROGRAM_OPTIONS_H

#include "file_names.h"

#include <CGAL/Spherical_parameterization/Sharpness.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace Program {

/// What the command line asks for. Words that the options take are kept as they are.
struct Options
{
  /// returns whether the method only cares for angles.
  bool is_conformal() const
  {
    return energy == "conformal" || is_among(method, {"conformal", "harmonic", "stereographic"});
  }

  /// returns whether there may be many meshes: the names of their files are made from those of the inputs.
  bool is_batch() const { return !output_folder.empty(); }

  /// returns the names of the files that are read beside the meshes.
  Words other_inputs() const
  {
    Words result;
    for(const std::string& name : {start_file, sphere_file, domain_size == 0 ? domain : "", values_sphere, onto,
                                   template_file, mask_file, labels_file, density_file, beside})
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

  std::string command;     ///< `map`, for example
  std::string sphere_file; ///< the map that is checked or shown, empty if there is none
  bool is_quiet = false;
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
  std::string radius;          ///< what decides on it: a word of --radius; empty if it is a variable of the objective
  double fixed_radius = 0.;    ///< if that is `fixed`
  bool is_unit_sphere = false; ///< whether the radius is 1 because nothing else has chosen one
  std::string description;     ///< the method with all of its settings in words
  double energy_tolerance = 1e-3, radius_tolerance = 2e-3;
  std::optional<std::size_t> max_iterations; ///< if not given, the method's default
  double max_seconds = 0.;                   ///< 0 if there is no limit
  unsigned int max_threads = 0;              ///< 0 if there is no limit
};

} // namespace Program

#endif // PROGRAM_OPTIONS_H
