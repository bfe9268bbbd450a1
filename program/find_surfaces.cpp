#include "find_surfaces.h"

#include "read_file.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>
#include <regex>
#include <set>
#include <system_error>
#include <utility>

#include <fnmatch.h>

namespace Program {

namespace {

class Surface_finder
{
public:
  Surface_finder(const std::filesystem::path& folder, const Words& patterns, const std::filesystem::path& results)
    : m_folder(folder)
    , m_patterns(patterns)
  {
    const std::filesystem::path place = true_place(folder);
    const bool is_among_inputs = place == true_place(results);
    if(!is_among_inputs)
      m_visited.insert(true_place(results));
    for(std::filesystem::path above = place.parent_path(); m_visited.insert(above).second;) // for links that lead there
      above = above.parent_path();
    search("");
    // Folders come before links to them, so that each has the name that it has by itself.
    for(std::size_t k = 0; !is_among_inputs && k < m_links.size(); ++k)
      search(std::filesystem::path(m_links[k])); // a copy, as there may be more
    if(is_among_inputs)
      found.links_left_out = std::move(m_links);
    for(const std::string& pattern : patterns)
      if(m_matched.count(pattern) == 0)
        add_missing(pattern);
    std::sort(found.paths.begin(), found.paths.end());
  }

  Found_surfaces found;

private:
  void search(const std::filesystem::path& folder)
  {
    namespace fs = std::filesystem;
    if(!m_visited.insert(true_place(m_folder / folder)).second)
      return;
    std::error_code error, ignored;
    std::vector<fs::path> names;
    for(fs::directory_iterator entry(m_folder / folder, error); !error && entry != fs::directory_iterator();
        entry.increment(error))
      if(entry->path().filename().string().front() != '.')
        names.push_back(folder / entry->path().filename());
    if(error)
      throw error_in((m_folder / folder).string(), "cannot be read: " + error.message());
    std::sort(names.begin(), names.end());
    for(const fs::path& name : names)
    {
      const bool is_folder = fs::is_directory(m_folder / name, ignored);
      Words matching;
      std::copy_if(m_patterns.begin(), m_patterns.end(), std::back_inserter(matching),
                   [&](const std::string& pattern) { return matches(pattern, name, is_folder); });
      if(matching.empty() || (!is_folder && is_no_surface(m_folder / name)))
        continue;
      if(!is_folder)
      {
        found.paths.push_back(name);
        m_matched.insert(matching.begin(), matching.end());
      }
      else if(fs::is_symlink(m_folder / name, ignored))
        m_links.push_back(name);
      else
        search(name);
    }
  }

  // returns whether a file is one of values of vertices, or a report. What cannot be read or is damaged is a mesh that fails.
  static bool is_no_surface(const std::filesystem::path& path)
  {
    using Kind = Surface_file_kind;
    try
    {
      const std::string format = file_format(path.string());
      const Kind kind = is_among(format, input_formats) ? Kind::none : kind_of_file(path.string());
      return format == ".json" || kind == Kind::freesurfer_curv || kind == Kind::freesurfer_annotation ||
             kind == Kind::freesurfer_label || kind == Kind::mgh;
    }
    catch(const std::exception&)
    {
      return false;
    }
  }

  // A file that was named by its path, in a list of what is to be mapped, fails alone.
  void add_missing(const std::string& pattern)
  {
    const bool is_path = pattern.find('/') != pattern.npos && pattern.find_first_of("*?[\\") == pattern.npos;
    if(!is_path)
      throw error_in(m_folder.string(),
                     "no surface below this folder is called " + printable(pattern) +
                         (found.links_left_out.empty() ? ""
                                                       : "; links to other folders are left out, as results beside "
                                                         "the surfaces are not written through links"));
    found.paths.emplace_back(pattern);
  }

  std::filesystem::path m_folder;
  const Words& m_patterns;
  std::set<std::filesystem::path> m_visited;
  std::set<std::string> m_matched;
  std::vector<std::filesystem::path> m_links;
};

} // namespace

std::filesystem::path true_place(const std::filesystem::path& path)
{
  std::error_code error;
  const std::filesystem::path result = place_of(path, error);
  return error ? path : result;
}

bool matches(const std::string& pattern, const std::filesystem::path& path, bool is_folder)
{
  if(pattern.find('/') == pattern.npos)
    return is_folder || fnmatch(pattern.c_str(), path.filename().c_str(), FNM_PERIOD) == 0;
  std::size_t end = pattern.size();
  if(is_folder) // as many names as the folder has
  {
    end = 0;
    for(auto n = std::distance(path.begin(), path.end()); n > 0 && end != pattern.npos; --n)
      end = pattern.find('/', end + 1);
    if(end == pattern.npos)
      return false;
  }
  return fnmatch(pattern.substr(0, end).c_str(), path.c_str(), FNM_PATHNAME | FNM_PERIOD) == 0;
}

Found_surfaces find_surfaces(const std::filesystem::path& folder, const Words& patterns,
                             const std::filesystem::path& results)
{
  return Surface_finder(folder, patterns, results).found;
}

std::string subject_of(const std::filesystem::path& study, const std::filesystem::path& path)
{
  Words folders;
  for(const std::filesystem::path& name : (study / path).parent_path())
    folders.push_back(name.string());
  std::string last; // of the folders
  for(; !folders.empty(); folders.pop_back())
  {
    const std::string name = folders.back();
    if(name.compare(0, 4, "sub-") == 0)
      return name + (last.compare(0, 4, "ses-") == 0 ? '/' + last : "");
    if(last == "surf")
      return name;
    last = name;
  }
  return (path.has_parent_path() ? *path.begin() : study.filename()).string();
}

std::string name_of_sphere(const std::string& name)
{
  // the last such word, as the name of a subject comes first
  const std::regex pattern("(.*[._]|)(white|pial|midthickness|graymid|smoothwm|orig|(very_)?inflated)([._].*|)");
  std::smatch parts;
  return std::regex_match(name, parts, pattern) ? parts.str(1) + "sphere" + parts.str(4) : with_suffix(name, "_sphere");
}

} // namespace Program
