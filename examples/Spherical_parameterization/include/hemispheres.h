#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_HEMISPHERES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_HEMISPHERES_H

#include "Program_error.h"
#include "mesh_files.h"

#include <CGAL/Spherical_parameterization/IO/Surface_file.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace Program {

/// The names of files, each with the half of the brain that it is of: `left`, `right`, or nothing if that is not known.
using Hemispheres = std::vector<std::pair<std::string, std::string>>;

/// returns which half of the brain a file is of, as its metadata say, or else its name as FreeSurfer, BIDS or the Human Connectome
/// Project has it.
inline std::string hemisphere_of(const std::string& path,
                                 const CGAL::Spherical_parameterization::IO::Surface_origin& origin)
{
  for(const auto* metadata : {&origin.metadata_of_points, &origin.metadata})
    for(const auto& [name, value] : *metadata)
      if(name == "AnatomicalStructurePrimary")
        for(const char* side : {"Left", "Right"})
          if(value.find(side) != value.npos)
            return side[0] == 'L' ? "left" : "right";
  const std::string name = '.' + std::filesystem::path(path).filename().string();
  for(const auto& [left, right] :
      {std::pair(".lh.", ".rh."), std::pair("_hemi-L_", "_hemi-R_"), std::pair(".L.", ".R.")})
    if(const bool is_left = name.find(left) != name.npos; is_left || name.find(right) != name.npos)
      return is_left ? "left" : "right";
  return "";
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
