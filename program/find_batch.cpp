#include "find_batch.h"

#include "output_files.h"
#include "read_file.h"
#include "system.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace Program {

namespace fs = std::filesystem;

namespace {

// Returns the path behind links and dots, as far as it can be found.
fs::path true_place(const fs::path& path)
{
  std::error_code error;
  const fs::path result = place_of(path, error);
  return error ? path : result;
}

// Does so but for a link that the name itself may be.
fs::path canonical_place(const fs::path& path)
{
  std::error_code error;
  const fs::path result = place_of(fs::absolute(path).parent_path(), error) / path.filename();
  return error ? path : result;
}

// Returns what is in a folder, sorted. Hidden files are no meshes, whatever their names end with: some systems keep notes on
// each file in one.
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

// Returns the mesh files of a folder. Those of FreeSurfer have to be named, as there are several surfaces of the same brain in a
// folder, and their names do not distinguish them from other files.
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
    throw error_in(name_of(folder), "there is no mesh file in this folder, whose name ends with one of ",
                   list_of(input_formats), ", .surf.gii; --surfaces names those of folders below it");
  return paths;
}

// Returns whether a file, or a folder that leads to one, is called as a pattern of the shell says: by its name, or, if the
// pattern has a slash, by its path.
bool matches(const std::string& pattern, const fs::path& path, bool is_folder)
{
  if(pattern.find('/') == pattern.npos)
    return is_folder || matches_pattern(pattern, path.filename());
  std::size_t end = pattern.size();
  if(is_folder) // as many names as the folder has
  {
    end = 0;
    for(auto n = std::distance(path.begin(), path.end()); n > 0 && end != pattern.npos; --n)
      end = pattern.find('/', end + 1);
    if(end == pattern.npos)
      return false;
  }
  return matches_pattern(pattern.substr(0, end), path);
}

// Returns whether a file is one of values of vertices, or a report. What cannot be read or is damaged is a mesh that fails.
bool is_no_surface(const fs::path& path)
{
  using Kind = Surface_file_kind;
  try
  {
    const std::string format = file_format(name_of(path));
    const Kind kind = is_among(format, input_formats) ? Kind::none : kind_of_file(name_of(path));
    return format == ".json" || kind == Kind::freesurfer_curv || kind == Kind::freesurfer_annotation ||
           kind == Kind::freesurfer_label || kind == Kind::mgh;
  }
  catch(const std::exception&)
  {
    return false;
  }
}

// The surfaces of a study: files in the folders below one, such as those of the subjects of FreeSurfer, which have the same
// names. Those that match a pattern are found, but for files of values. A folder below that cannot be read is among them: it fails
// alone, as a surface does.
class Surface_finder
{
public:
  // What is where the results go is none of the surfaces, unless that is the folder itself. Then links to other folders are left
  // out, as results would be written through them.
  Surface_finder(const fs::path& folder, const Words& patterns, const fs::path& results)
    : m_folder(folder)
    , m_patterns(patterns)
  {
    const fs::path place = true_place(folder);
    const bool is_among_inputs = place == true_place(results);
    if(!is_among_inputs)
      m_visited.insert(true_place(results));
    for(fs::path above = place.parent_path(); m_visited.insert(above).second;) // for links that lead there
      above = above.parent_path();
    search("");
    // Folders come before links to them, so that each has the name that it has by itself.
    for(std::size_t k = 0; !is_among_inputs && k < m_links.size(); ++k)
      search(fs::path(m_links[k])); // a copy, as there may be more
    if(is_among_inputs)
      links_left_out = std::move(m_links);
    for(const std::string& pattern : patterns)
      if(m_matched.count(pattern) == 0)
        add_missing(pattern);
    std::sort(paths.begin(), paths.end());
  }

  std::vector<fs::path> paths;            // of the surfaces within the folder, sorted
  std::map<fs::path, std::string> faults; // of those that cannot be read
  std::vector<fs::path> links_left_out;   // to other folders

private:
  void search(const fs::path& folder)
  {
    if(!m_visited.insert(true_place(m_folder / folder)).second)
      return;
    std::vector<fs::path> entries;
    try
    {
      entries = entries_of(m_folder / folder);
    }
    catch(const Program_error& error)
    {
      if(folder.empty())
        throw;
      paths.push_back(folder);
      faults[folder] = error.what();
    }
    std::error_code ignored;
    for(const fs::path& path : entries)
    {
      const bool is_folder = fs::is_directory(path, ignored);
      const fs::path name = folder / path.filename();
      Words matching;
      std::copy_if(m_patterns.begin(), m_patterns.end(), std::back_inserter(matching),
                   [&](const std::string& pattern) { return matches(pattern, name, is_folder); });
      if(matching.empty() || (!is_folder && is_no_surface(path)))
        continue;
      if(!is_folder)
      {
        paths.push_back(name);
        m_matched.insert(matching.begin(), matching.end());
      }
      else if(fs::is_symlink(path, ignored))
        m_links.push_back(name);
      else
        search(name);
    }
  }

  // A file that was named by its path, in a list of what is to be mapped, fails alone.
  void add_missing(const std::string& pattern)
  {
    if(pattern.find('/') == pattern.npos || pattern.find_first_of("*?[\\") != pattern.npos)
      throw error_in(name_of(m_folder), "no surface below this folder is called ", printable(pattern),
                     (links_left_out.empty() ? ""
                                             : "; links to other folders are left out, as results beside the "
                                               "surfaces are not written through links"));
    paths.push_back(path_of(pattern));
  }

  fs::path m_folder;
  const Words& m_patterns;
  std::set<fs::path> m_visited;
  std::set<std::string> m_matched;
  std::vector<fs::path> m_links;
};

// Returns whose surface this is, by its path within the folder of a study: the name of the last folder that begins with `sub-`, with
// the session if there is one, or that has a folder `surf`; or else the first one in the folder of the study, or that itself.
std::string subject_of(const fs::path& study, const fs::path& path)
{
  std::string last; // of the folders
  for(fs::path folder = (study / path).parent_path(); folder.has_relative_path(); folder = folder.parent_path())
  {
    const std::string name = name_of(folder.filename());
    if(name.compare(0, 4, "sub-") == 0)
      return name + (last.compare(0, 4, "ses-") == 0 ? '/' + last : "");
    if(last == "surf")
      return name;
    last = name;
  }
  return name_of(path.has_parent_path() ? *path.begin() : study.filename());
}

// Returns what the sphere of a surface is called: `lh.sphere` for `lh.white`, `sub-1_hemi-L_sphere.surf.gii` for
// `sub-1_hemi-L_white.surf.gii`, and `NAME_sphere` for names that do not say which surface it is.
std::string name_of_sphere(const std::string& name)
{
  // the last such word, as the name of a subject comes first
  const std::regex pattern("(.*[._]|)(white|pial|midthickness|graymid|smoothwm|orig|(very_)?inflated)([._].*|)");
  std::smatch parts;
  return std::regex_match(name, parts, pattern) ? parts.str(1) + "sphere" + parts.str(4) : with_suffix(name, "_sphere");
}

// Returns the names of the files of the mesh `path` in a batch, whose results are called as `result` in the output folder.
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

// Returns the names of the files of the surfaces that `--surfaces` names in the folders below one.
std::vector<File_names> names_in_study(const fs::path& folder, const Options& options)
{
  std::error_code ignored;
  if(!fs::is_directory(folder, ignored))
    throw error_in(name_of(folder), "is a file; with --surfaces, each INPUT is a folder that has them below it");
  fs::path results = path_of(options.text("output-folder")),
           name_of_folder; // results of several folders go to folders of their names
  if(options.inputs.size() > 1)
    results /= name_of_folder = fs::absolute(folder / "x").lexically_normal().parent_path().filename();
  const fs::path place = true_place(folder);
  const Surface_finder found(folder, options.surfaces, results);
  for(const fs::path& link : found.links_left_out)
    std::cerr << "spherical_parameterization: " << printable(name_of(folder / link))
              << ": left out, as it is a link, and results beside the surfaces are not written through links\n";
  std::vector<File_names> meshes;
  for(const fs::path& path : found.paths)
  {
    // The faces of a template are no sphere.
    const std::string name = name_of(path.filename());
    const fs::path result = !options.has("template") ? path.parent_path() / name_of_sphere(name) : path;
    File_names& names = meshes.emplace_back(names_in_batch(folder / path, name_of_folder / result, options));
    names.subject = subject_of(place, path);
    if(const auto fault = found.faults.find(path); fault != found.faults.end())
      names.fault = fault->second;
    const fs::path result_in_place = true_place(path_of(options.text("output-folder"))) / name_of_folder / path;
    if(canonical_place(result_in_place) != result_in_place)
      throw error_in(name_of(path_of(names.sphere).parent_path()),
                     "there is a link on the way to this folder, and results are not written through links; "
                     "choose another --output-folder");
    if(place == true_place(results))
      for(const std::string& pattern : options.surfaces)
        if(matches(pattern, path.parent_path() / path_of(names.sphere).filename(), false))
          throw error_in(names.sphere, "the next run would take this result for a surface, as --surfaces has ",
                         printable(pattern));
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
    if(!fs::exists(path_of(input), error)) // in a folder, such a link is a mesh that fails
      throw error_in(input, error ? error.message() : "there is no such file");
    if(!options.surfaces.empty())
    {
      for(File_names& names : names_in_study(path_of(input), options))
        meshes.push_back(std::move(names));
      continue;
    }
    if(!fs::is_directory(path_of(input), error))
    {
      if(!is_among(file_format(input), input_formats) && kind_of_file(input) == Surface_file_kind::none)
        throw error_in(input, "the name of a mesh file has to end with one of ", input_names);
      meshes.push_back(names_in_batch(path_of(input), path_of(input).filename(), options));
      continue;
    }
    if(true_place(path_of(input)) == true_place(path_of(options.text("output-folder"))))
      throw error_in(options.text("output-folder"),
                     "the results would be among the meshes; choose another --output-folder");
    for(const fs::path& path : meshes_of_folder(path_of(input)))
      meshes.push_back(names_in_batch(path, path.filename(), options));
  }

  std::set<fs::path> inputs;
  for(const File_names& names : meshes)
    inputs.insert({true_place(path_of(names.input)), canonical_place(path_of(names.input))});
  if(const std::string& name = options.start_or_template(); !name.empty())
    inputs.insert({true_place(path_of(name)), canonical_place(path_of(name))});
  std::map<fs::path, std::string> input_of;
  for(const File_names& names : meshes)
    for(const std::string& name : {names.json, names.sphere})
    {
      const fs::path path = canonical_place(path_of(name)); // a link is replaced itself
      if(inputs.count(path) > 0)
        throw error_in(name, "would replace an input; choose another --output-folder");
      const auto [entry, is_new] = input_of.emplace(path, names.input);
      if(!is_new)
      {
        if(true_place(path_of(entry->second)) == true_place(path_of(names.input)))
          throw error_in(names.input, "is given twice");
        throw error_in(name, "would be written for both ", printable(entry->second), " and ", printable(names.input),
                       "; rename one of them, or map them to different folders");
      }
    }

  fs::create_directories(path_of(options.text("output-folder")), error);
  if(error)
    throw error_in(options.text("output-folder"), "cannot be made: ", error.message());
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
