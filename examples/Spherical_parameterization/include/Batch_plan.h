// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BATCH_PLAN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BATCH_PLAN_H

#include "File_names.h"
#include "Output_file.h"
#include "Program_error.h"
#include "Program_options.h"
#include "file_format.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace Program {

/// The meshes of a batch: what the inputs stand for, and where everything is to be written.
class Batch_plan
{
public:
  /// finds all meshes, checks that none of their files would replace an input or another output, and makes the output
  /// folder.
  ///
  /// \throws Program_error if anything stands against a start
  explicit Batch_plan(const Program_options& options)
    : m_options(options)
  {
    for(const std::string& input : options.inputs)
      if(is_folder(input))
        add_folder(input);
      else
        add_mesh(input);
    check_outputs();
    make_output_folder();
  }

  /// returns the files of all meshes, in the order of the inputs.
  const std::vector<File_names>& meshes() const { return m_meshes; }

private:
  static bool is_folder(const std::filesystem::path& path)
  {
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored);
  }

  static std::filesystem::path canonical(const std::filesystem::path& path)
  {
    std::error_code error;
    const std::filesystem::path result = std::filesystem::weakly_canonical(path, error);
    return error ? path : result;
  }

  // Hidden files are no meshes, whatever their names end with: some systems keep notes on each file in one.
  void add_folder(const std::filesystem::path& folder)
  {
    if(canonical(folder) == canonical(m_options.output_folder))
      throw Program_error(m_options.output_folder +
                          ": the results would be among the meshes; choose another --output-folder");
    std::vector<std::filesystem::path> paths;
    std::error_code error;
    std::filesystem::directory_iterator entry(folder, error);
    for(; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
    {
      const std::filesystem::path& path = entry->path();
      if(path.filename().string().front() != '.' && is_among(file_format(path.string()), input_formats) &&
         !is_folder(path))
        paths.push_back(path);
    }
    if(error)
      throw Program_error(folder.string() + ": cannot be read: " + error.message());
    if(paths.empty())
      throw Program_error(folder.string() + ": there is no mesh file in this folder, whose name ends with one of " +
                          list_of(input_formats));
    std::sort(paths.begin(), paths.end());
    for(const std::filesystem::path& path : paths)
      add_mesh(path);
  }

  void add_mesh(const std::filesystem::path& path)
  {
    std::error_code error;
    const bool exists = std::filesystem::exists(path, error);
    if(!exists)
      throw Program_error(path.string() + ": " + (error ? error.message() : "there is no such file"));
    const std::string extension = path.extension().string(), format = file_format(path.string());
    if(!is_among(format, input_formats))
      throw Program_error(path.string() + ": the name of a mesh file has to end with one of " + list_of(input_formats));

    File_names names;
    names.input = path.string();
    std::filesystem::path result = m_options.output_folder / path.filename();
    if(!m_options.format.empty())
      result.replace_extension(m_options.format);
    else if(!is_among(format, output_formats))
      result.replace_extension(output_formats.front());
    names.sphere = result.string();
    names.json = result.replace_extension(".json").string();
    m_meshes.push_back(names);
  }

  void check_outputs() const
  {
    std::set<std::filesystem::path> inputs;
    for(const File_names& names : m_meshes)
      inputs.insert(canonical(names.input));
    if(!m_options.start_file.empty())
      inputs.insert(canonical(m_options.start_file));

    std::map<std::filesystem::path, std::string> input_of;
    for(const File_names& names : m_meshes)
      for(const std::string& name : {names.json, names.sphere})
      {
        const std::filesystem::path path = canonical(name);
        if(inputs.count(path) > 0)
          throw Program_error(name + ": would replace an input; choose another --output-folder");
        const auto [entry, is_new] = input_of.emplace(path, names.input);
        if(!is_new)
          throw Program_error(canonical(entry->second) == canonical(names.input)
                                  ? names.input + ": is given twice"
                                  : name + ": would be written for both " + entry->second + " and " + names.input +
                                        "; rename one of them, or map them to different folders");
      }
  }

  void make_output_folder() const
  {
    std::error_code error;
    std::filesystem::create_directories(m_options.output_folder, error);
    if(error)
      throw Program_error(m_options.output_folder + ": cannot be made: " + error.message());
    if(!m_meshes.empty())
      const Output_file check(
          (std::filesystem::path(m_options.output_folder) / ".spherical_parameterization").string());
  }

  const Program_options& m_options;
  std::vector<File_names> m_meshes;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BATCH_PLAN_H
