#include "find_batch.h"

#include "output_files.h"
#include "read_file.h"

#include <algorithm>
#include <map>
#include <set>

namespace Program {

namespace fs = std::filesystem;

namespace {

// Returns the path with links and dots resolved, as far as possible.
fs::path resolved_path(const fs::path& path)
{
  std::error_code error;
  const fs::path result = resolved(path, error);
  return error ? path : result;
}

// Resolves only the folder, not a link at the end of the path.
fs::path path_in_resolved_folder(const fs::path& path)
{
  std::error_code error;
  const fs::path result = resolved(fs::absolute(path).parent_path(), error) / path.filename();
  return error ? path : result;
}

// Returns the sorted entries of a folder without hidden files, in which some systems store metadata of each file.
std::vector<fs::path> entries_of(const fs::path& folder)
{
  std::vector<fs::path> paths;
  std::error_code error;
  for(fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
    if(name_of(entry->path().filename()).front() != '.')
      paths.push_back(entry->path());
  if(error)
    throw error_in(name_of(folder), "cannot be read: ", error.message());
  std::sort(paths.begin(), paths.end());
  return paths;
}

// Returns the mesh files of a folder. FreeSurfer surfaces are not included: a folder has several surfaces of the same brain, and
// their names do not distinguish them from other files.
std::vector<fs::path> meshes_of_folder(const fs::path& folder)
{
  std::vector<fs::path> paths = entries_of(folder);
  const auto is_no_mesh = [](const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored) || !(is_among(file_format(name_of(path)), input_formats) ||
                                                is_among(ending_of(name_of(path)), {".surf.gii", ".surf.gii.gz"}));
  };
  paths.erase(std::remove_if(paths.begin(), paths.end(), is_no_mesh), paths.end());
  if(paths.empty())
    throw error_in(name_of(folder), "this folder contains no file whose name ends with one of ", list_of(input_formats),
                   ", .surf.gii");
  return paths;
}

// Returns the file names of the mesh `path` in a batch; its results are named like `result_path` in the output folder.
File_names names_in_batch(const fs::path& path, const fs::path& result_path, const Options& options)
{
  const std::string input = name_of(path), ending = ending_of(input);
  File_names names;
  names.input = input;
  const std::string result = name_of(path_of(options.text("output-folder")) / result_path),
                    beginning = result.substr(0, result.size() - ending.size());
  const std::string& format = options.format;
  if(format.empty())
    names.sphere = options.format_of(input).empty() ? beginning + output_formats.front() : result;
  else
    names.sphere = beginning + (is_gifti(format) ? ".surf" + format : format == freesurfer_format ? "" : format);
  names.json = beginning + ".json";
  return names;
}

} // namespace

std::vector<File_names> find_batch(const Options& options)
{
  std::error_code error;
  std::vector<File_names> meshes;
  for(const std::string& input : options.inputs)
  {
    if(!fs::exists(path_of(input), error)) // a dangling link in a folder is a mesh that fails
      throw error_in(input, error ? error.message() : "no such file");
    if(!fs::is_directory(path_of(input), error))
    {
      if(!is_among(file_format(input), input_formats) && kind_of_file(input) == Surface_file_kind::none)
        throw error_in(input, "the name of a mesh file must end with one of ", input_names);
      meshes.push_back(names_in_batch(path_of(input), path_of(input).filename(), options));
      continue;
    }
    if(resolved_path(path_of(input)) == resolved_path(path_of(options.text("output-folder"))))
      throw error_in(options.text("output-folder"),
                     "the results would be written among the meshes; choose another --output-folder");
    for(const fs::path& path : meshes_of_folder(path_of(input)))
      meshes.push_back(names_in_batch(path, path.filename(), options));
  }

  std::set<fs::path> inputs;
  for(const File_names& names : meshes)
    inputs.insert({resolved_path(path_of(names.input)), path_in_resolved_folder(path_of(names.input))});
  if(const std::string& name = options.start_or_template(); !name.empty())
    inputs.insert({resolved_path(path_of(name)), path_in_resolved_folder(path_of(name))});
  std::map<fs::path, std::string> input_of;
  for(const File_names& names : meshes)
    for(const std::string& name : {names.json, names.sphere})
    {
      const fs::path path = path_in_resolved_folder(path_of(name)); // a link itself is replaced
      if(inputs.count(path) > 0)
        throw error_in(name, "would replace an input; choose another --output-folder");
      const auto [entry, is_new] = input_of.emplace(path, names.input);
      if(!is_new)
      {
        if(resolved_path(path_of(entry->second)) == resolved_path(path_of(names.input)))
          throw error_in(names.input, "is given twice");
        throw error_in(name, "would be written for both ", printable(entry->second), " and ", printable(names.input),
                       "; rename one of them, or map them to different folders");
      }
    }

  fs::create_directories(path_of(options.text("output-folder")), error);
  if(error)
    throw error_in(options.text("output-folder"), "cannot be created: ", error.message());
  const fs::path trial = path_of(options.text("output-folder")) / ".spherical_parameterization";
  const Output_files check({name_of(trial)}, {}, Output_policy::replace);
  std::set<fs::path> folders = {path_of(options.text("output-folder"))};
  for(const File_names& names : meshes)
    folders.insert(path_of(names.json).parent_path());
  for(const fs::path& folder : folders)
    sweep_temporary_files(folder);
  return meshes;
}

} // namespace Program
