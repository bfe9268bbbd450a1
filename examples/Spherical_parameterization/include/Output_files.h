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

#include "Output_file.h"
#include "Program_error.h"
#include "Program_options.h"

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
  explicit Output_files(const Program_options& options)
  {
    if(!options.output.empty())
      sphere.emplace(options.output);
    if(!options.json.empty())
      json.emplace(options.json);
    if(!options.colored.empty())
    {
      colored_surface.emplace(options.colored + "_surface.ply");
      colored_sphere.emplace(options.colored + "_sphere.ply");
    }

    std::error_code ignored;
    const std::vector<Output_file*> files = wanted();
    for(auto file = files.begin(); file != files.end(); ++file)
    {
      for(const std::string& input : {options.input, options.start_file})
        if(std::filesystem::equivalent((*file)->path(), input, ignored))
          throw Program_error((*file)->name() + ": would replace the input; choose another name");
      for(auto other = files.begin(); other != file; ++other)
        if((*file)->path() == (*other)->path())
          throw Program_error((*file)->name() + ": would be written twice; choose another name");
    }
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
