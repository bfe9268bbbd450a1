#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_HEMISPHERES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_HEMISPHERES_H

#include "Program_error.h"
#include "mesh_files.h"

#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace Program {

/// The names of files, each with the half of the brain that it is of: `left`, `right`, or nothing if that is not known.
using Hemispheres = std::vector<std::pair<std::string, std::string>>;

/// returns which half of the brain a file is of, as its metadata say, or else its name as FreeSurfer, BIDS or the Human Connectome
/// Project has it; or as both say, if they disagree.
inline Hemispheres hemispheres_of(const std::string& path,
                                  const CGAL::Spherical_parameterization::IO::Surface_origin& origin)
{
  std::string by_metadata, by_name;
  for(const auto* metadata : {&origin.metadata, &origin.metadata_of_points})
    for(const auto& [name, value] : *metadata)
      if(name == "AnatomicalStructurePrimary")
        for(const char* side : {"Left", "Right"})
          if(value.find(side) != value.npos)
            by_metadata = side[0] == 'L' ? "left" : "right";
  const std::string name = '.' + std::filesystem::path(path).filename().string();
  for(const auto& [left, right] :
      {std::pair(".lh.", ".rh."), std::pair("_hemi-L_", "_hemi-R_"), std::pair(".L.", ".R.")})
    if(by_name.empty())
      by_name = name.find(left) != name.npos ? "left" : name.find(right) != name.npos ? "right" : "";
  if(!by_metadata.empty() && !by_name.empty() && by_metadata != by_name)
    return {{path + " by its metadata", by_metadata}, {path + " by its name", by_name}};
  return {{path, by_metadata.empty() ? by_name : by_metadata}};
}

/// returns what is to be said of files that are used together, if they are of different halves of the brain: a line; empty otherwise.
inline std::string mixed_hemispheres(const Hemispheres& files)
{
  const std::pair<std::string, std::string>* first = nullptr;
  for(const auto& file : files)
    if(!file.second.empty())
    {
      if(first == nullptr)
        first = &file;
      else if(first->second != file.second)
        return printable(first->first) + " is of the " + first->second + " hemisphere, but " + printable(file.first) +
               " of the " + file.second + " one\n";
    }
  return "";
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_HEMISPHERES_H
