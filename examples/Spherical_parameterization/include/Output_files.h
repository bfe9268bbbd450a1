// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILES_H

#include "File_names.h"
#include "Output_file.h"
#include "Program_error.h"

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace Program {

/// All files that a run is to write.
class Output_files
{
public:
  /// checks that all of them can be written, and that none of them would replace an input or another output.
  ///
  /// \throws Program_error otherwise
  ///
  /// \param start_file another input; empty if there is none
  Output_files(const File_names& names, const std::string& start_file)
  {
    if(!names.sphere.empty())
      sphere.emplace(names.sphere);
    if(!names.json.empty())
      json.emplace(names.json);
    if(!names.colored.empty())
    {
      colored_surface.emplace(names.colored + "_surface.ply");
      colored_sphere.emplace(names.colored + "_sphere.ply");
    }

    std::error_code ignored;
    const std::vector<Output_file*> files = wanted();
    for(auto file = files.begin(); file != files.end(); ++file)
    {
      for(const std::string& input : {names.input, start_file})
        if(std::filesystem::equivalent((*file)->path(), input, ignored))
          throw Program_error((*file)->name() + ": would replace the input; choose another name");
      for(auto other = files.begin(); other != file; ++other)
        if((*file)->path() == (*other)->path())
          throw Program_error((*file)->name() + ": would be written twice; choose another name");
    }
  }

  /// removes the files that have these names now, the report first: it is never beside the map of another run.
  ///
  /// \throws Program_error if that fails
  void remove_earlier()
  {
    const std::vector<Output_file*> files = wanted();
    for(auto file = files.rbegin(); file != files.rend(); ++file)
      (*file)->remove_earlier();
  }

  /// gives all files their names, once all of them are complete.
  void commit()
  {
    for(Output_file* file : wanted())
      file->commit();
  }

  /// returns the names of all files.
  std::vector<std::string> names()
  {
    std::vector<std::string> result;
    for(const Output_file* file : wanted())
      result.push_back(file->name());
    return result;
  }

  std::optional<Output_file> sphere, colored_surface, colored_sphere, json;

private:
  std::vector<Output_file*> wanted()
  {
    std::vector<Output_file*> result;
    for(std::optional<Output_file>* file : {&sphere, &colored_surface, &colored_sphere, &json})
      if(*file)
        result.push_back(&**file);
    return result;
  }
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILES_H
