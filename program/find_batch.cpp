#include "find_batch.h"

#include "find_surfaces.h"
#include "output_files.h"
#include "read_file.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <system_error>
#include <utility>

namespace Program {

namespace {

// Returns the path behind links and dots, as far as it can be told, but for a link that the name itself may be.
std::filesystem::path canonical_place(const std::filesystem::path& path)
{
  std::error_code error;
  const std::filesystem::path result = place_of(std::filesystem::absolute(path).parent_path(), error) / path.filename();
  return error ? path : result;
}

// Returns whether a file of a folder is a mesh. Those of FreeSurfer have to be named, as there are several surfaces of the same
// brain in a folder, and their names do not tell them from other files.
bool is_mesh_of_folder(const std::filesystem::path& path)
{
  return is_among(file_format(path.string()), input_formats) ||
         is_among(ending_of(path.string()), {".surf.gii", ".surf.gii.gz"});
}

// Returns the mesh files of a folder, sorted. Hidden files are no meshes, whatever their names end with: some systems keep
// notes on each file in one.
std::vector<std::filesystem::path> meshes_of_folder(const std::filesystem::path& folder)
{
  namespace fs = std::filesystem;
  std::vector<fs::path> paths;
  std::error_code error, ignored;
  for(fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
  {
    const fs::path& path = entry->path();
    if(path.filename().string().front() != '.' && is_mesh_of_folder(path) && !fs::is_directory(path, ignored))
      paths.push_back(path);
  }
  if(error)
    throw error_in(folder.string(), "cannot be read: " + error.message());
  if(paths.empty())
    throw error_in(folder.string(), "there is no mesh file in this folder, whose name ends with one of " +
                                        list_of(input_formats) +
                                        ", .surf.gii; --surfaces names those of folders below it");
  std::sort(paths.begin(), paths.end());
  return paths;
}

// Returns the names of the files of the mesh `path` in a batch, whose results are called as `result` in the output folder.
File_names names_in_batch(const std::filesystem::path& path, const std::filesystem::path& result_path,
                          const Options& options)
{
  const std::string input = path.string(), ending = ending_of(input);
  File_names names;
  names.input = input;
  const std::string result = (options.output_folder / result_path).string(),
                    beginning = result.substr(0, result.size() - ending.size());
  const std::string& format = options.format;
  if(format.empty())
    names.sphere = options.format_of(input).empty() ? beginning + output_formats.front() : result;
  else
    names.sphere = beginning + (is_gifti(format) ? ".surf" + format : format == freesurfer_format ? "" : format);
  names.json = beginning + ".json";
  return names;
}

// Returns the names of the files of the surfaces that `--surfaces` names in the folders below one.
std::vector<File_names> names_in_study(const std::filesystem::path& folder, const Options& options)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  if(!fs::is_directory(folder, ignored))
    throw error_in(folder.string(), "is a file; with --surfaces, each INPUT is a folder that has them below it");
  fs::path results = options.output_folder, name_of_folder; // results of several folders go to folders of their names
  if(options.inputs.size() > 1)
    results /= name_of_folder = fs::absolute(folder / "x").lexically_normal().parent_path().filename();
  const fs::path place = true_place(folder);
  const Found_surfaces found = find_surfaces(folder, options.surfaces, results);
  for(const fs::path& link : found.links_left_out)
    std::cerr << "spherical_parameterization: " << printable((folder / link).string())
              << ": left out, as it is a link, and results beside the surfaces are not written through links\n";
  std::vector<File_names> meshes;
  for(const fs::path& path : found.paths)
  {
    // The faces of a template are no sphere.
    const std::string name = path.filename().string();
    const fs::path result = options.template_file.empty() ? path.parent_path() / name_of_sphere(name) : path;
    File_names& names = meshes.emplace_back(names_in_batch(folder / path, name_of_folder / result, options));
    names.subject = subject_of(place, path);
    const fs::path result_in_place = true_place(options.output_folder) / name_of_folder / path;
    if(canonical_place(result_in_place) != result_in_place)
      throw error_in(fs::path(names.sphere).parent_path().string(),
                     "there is a link on the way to this folder, and results are not written through links; "
                     "choose another --output-folder");
    if(place == true_place(results))
      for(const std::string& pattern : options.surfaces)
        if(matches(pattern, path.parent_path() / fs::path(names.sphere).filename(), false))
          throw error_in(names.sphere,
                         "the next run would take this result for a surface, as --surfaces has " + printable(pattern));
  }
  return meshes;
}

} // namespace

std::vector<File_names> find_batch(const Options& options)
{
  std::error_code error;
  std::vector<File_names> meshes;
  for(const std::string& input : options.inputs)
  {
    if(!std::filesystem::exists(input, error)) // in a folder, such a link is a mesh that fails
      throw error_in(input, error ? error.message() : "there is no such file");
    if(!options.surfaces.empty())
    {
      for(File_names& names : names_in_study(input, options))
        meshes.push_back(std::move(names));
      continue;
    }
    if(!std::filesystem::is_directory(input, error))
    {
      if(!is_among(file_format(input), input_formats) && kind_of_file(input) == Surface_file_kind::none)
        throw error_in(input, "the name of a mesh file has to end with one of " + input_names);
      meshes.push_back(names_in_batch(input, std::filesystem::path(input).filename(), options));
      continue;
    }
    if(true_place(input) == true_place(options.output_folder))
      throw error_in(options.output_folder, "the results would be among the meshes; choose another --output-folder");
    for(const std::filesystem::path& path : meshes_of_folder(input))
      meshes.push_back(names_in_batch(path, path.filename(), options));
  }

  std::set<std::filesystem::path> inputs;
  for(const File_names& names : meshes)
    inputs.insert({true_place(names.input), canonical_place(names.input)});
  if(const std::string& name = options.start_or_template(); !name.empty())
    inputs.insert({true_place(name), canonical_place(name)});
  std::map<std::filesystem::path, std::string> input_of;
  for(const File_names& names : meshes)
    for(const std::string& name : {names.json, names.sphere})
    {
      const std::filesystem::path path = canonical_place(name); // a link is replaced itself
      if(inputs.count(path) > 0)
        throw error_in(name, "would replace an input; choose another --output-folder");
      const auto [entry, is_new] = input_of.emplace(path, names.input);
      if(!is_new)
      {
        if(true_place(entry->second) == true_place(names.input))
          throw error_in(names.input, "is given twice");
        throw error_in(name, "would be written for both " + printable(entry->second) + " and " +
                                 printable(names.input) + "; rename one of them, or map them to different folders");
      }
    }

  std::filesystem::create_directories(options.output_folder, error);
  if(error)
    throw error_in(options.output_folder, "cannot be made: " + error.message());
  const std::filesystem::path trial = std::filesystem::path(options.output_folder) / ".spherical_parameterization";
  const Output_files check({trial.string()}, {}, Output_policy::replace);
  std::set<std::filesystem::path> folders = {options.output_folder};
  for(const File_names& names : meshes)
    folders.insert(std::filesystem::path(names.json).parent_path());
  for(const std::filesystem::path& folder : folders)
    sweep_temporary_files(folder);
  return meshes;
}

} // namespace Program
