#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FIND_BATCH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FIND_BATCH_H

#include "Output_file.h"
#include "Program_error.h"
#include "Program_options.h"
#include "Temporary_name.h"
#include "mesh_files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace Program {

/// returns the path behind links and dots, as far as it can be told, but for a link that the name itself may be.
inline std::filesystem::path canonical_place(const std::filesystem::path& path)
{
  std::error_code error;
  const std::filesystem::path result = place_of(std::filesystem::absolute(path).parent_path(), error) / path.filename();
  return error ? path : result;
}

/// returns the path behind links and dots, as far as it can be told.
inline std::filesystem::path canonical(const std::filesystem::path& path)
{
  std::error_code error;
  const std::filesystem::path result = place_of(path, error);
  return error ? path : result;
}

/// returns the mesh files of a folder, sorted. Hidden files are no meshes, whatever their names end with: some systems keep
/// notes on each file in one.
inline std::vector<std::filesystem::path> meshes_of_folder(const std::filesystem::path& folder)
{
  namespace fs = std::filesystem;
  std::vector<fs::path> paths;
  std::error_code error, ignored;
  for(fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
  {
    const fs::path& path = entry->path();
    if(path.filename().string().front() != '.' && is_among(file_format(path.string()), input_formats) &&
       !fs::is_directory(path, ignored))
      paths.push_back(path);
  }
  if(error)
    throw Program_error(folder.string(), "cannot be read: " + error.message());
  if(paths.empty())
    throw Program_error(folder.string(),
                        "there is no mesh file in this folder, whose name ends with one of " + list_of(input_formats));
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// returns the names of the files of the mesh `path` in a batch.
inline File_names names_in_batch(const std::filesystem::path& path, const Program_options& options)
{
  const std::string format = file_format(path.string());
  if(!is_among(format, input_formats))
    throw Program_error(path.string(), "the name of a mesh file has to end with one of " + list_of(input_formats));

  File_names names;
  names.input = path.string();
  std::filesystem::path result = options.output_folder / path.filename();
  if(!options.format.empty())
    result.replace_extension(options.format);
  else if(!is_among(format, output_formats))
    result.replace_extension(output_formats.front());
  names.sphere = result.string();
  names.json = result.replace_extension(".json").string();
  return names;
}

/// finds the files of all meshes of a batch, in the order of the inputs, checks that none of them would replace an input or
/// another output, and makes the output folder.
///
/// \throws Program_error if anything stands against a start
inline std::vector<File_names> find_batch(const Program_options& options)
{
  std::error_code error;
  std::vector<File_names> meshes;
  for(const std::string& input : options.inputs)
  {
    if(!std::filesystem::exists(input, error)) // in a folder, such a link is a mesh that fails
      throw Program_error(input, error ? error.message() : "there is no such file");
    if(!std::filesystem::is_directory(input, error))
    {
      meshes.push_back(names_in_batch(input, options));
      continue;
    }
    if(canonical(input) == canonical(options.output_folder))
      throw Program_error(options.output_folder,
                          "the results would be among the meshes; choose another --output-folder");
    for(const std::filesystem::path& path : meshes_of_folder(input))
      meshes.push_back(names_in_batch(path, options));
  }

  std::set<std::filesystem::path> inputs;
  for(const File_names& names : meshes)
    inputs.insert({canonical(names.input), canonical_place(names.input)});
  if(const std::string& name = options.start_or_template(); !name.empty())
    inputs.insert({canonical(name), canonical_place(name)});
  std::map<std::filesystem::path, std::string> input_of;
  for(const File_names& names : meshes)
    for(const std::string& name : {names.json, names.sphere})
    {
      const std::filesystem::path path = canonical_place(name); // a link is replaced itself
      if(inputs.count(path) > 0)
        throw Program_error(name, "would replace an input; choose another --output-folder");
      const auto [entry, is_new] = input_of.emplace(path, names.input);
      if(!is_new)
      {
        if(canonical(entry->second) == canonical(names.input))
          throw Program_error(names.input, "is given twice");
        throw Program_error(name, "would be written for both " + printable(entry->second) + " and " +
                                      printable(names.input) +
                                      "; rename one of them, or map them to different folders");
      }
    }

  std::filesystem::create_directories(options.output_folder, error);
  if(error)
    throw Program_error(options.output_folder, "cannot be made: " + error.message());
  const Output_file check((std::filesystem::path(options.output_folder) / ".spherical_parameterization").string(),
                          Output_file::Policy::replace);
  Temporary_name::sweep(options.output_folder);
  return meshes;
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FIND_BATCH_H
