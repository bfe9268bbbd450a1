#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_EARLIER_REPORT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_EARLIER_REPORT_H

#include "Program_options.h"
#include "Run_report.h"
#include "mesh_files.h"
#include "read_soup.h"

#ifndef BOOST_BIND_GLOBAL_PLACEHOLDERS
#define BOOST_BIND_GLOBAL_PLACEHOLDERS // the parser uses them, and older versions of Boost say so in every compilation
#endif
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <sstream>
#include <string>
#include <system_error>

namespace Program {

/// reads a JSON file of a size and a depth that the parser, which calls itself for what is nested, can hold.
///
/// \throws std::exception if it is none
inline boost::property_tree::ptree read_json(const std::string& path)
{
  constexpr std::uintmax_t max_size = std::uintmax_t(64) << 20;
  constexpr std::ptrdiff_t max_depth = 100;
  if(std::filesystem::file_size(path) > max_size)
    throw Program_error(path + ": is longer than any report");
  const std::string text = read_file(path);
  std::ptrdiff_t depth = 0;
  for(const char c : text)
  {
    depth += (c == '[' || c == '{') - (c == ']' || c == '}'); // those of texts as well, which are few
    if(depth > max_depth)
      throw Program_error(path + ": is nested deeper than any report");
  }
  boost::property_tree::ptree tree;
  std::istringstream in(text);
  boost::property_tree::read_json(in, tree);
  return tree;
}

/// The report that an earlier run has left for a mesh, as `Run_report` writes it.
class Earlier_report
{
public:
  /// reads the report, if there is one.
  explicit Earlier_report(const File_names& names)
    : m_names(names)
  {
    try
    {
      m_tree = read_json(names.json);
    }
    catch(const std::exception&) // what cannot be read or understood is the report of no run
    {}
  }

  /// returns whether the mesh is done: its map is there as it was written, and made by this program with these options
  /// from the input as it is now. A map that was interrupted is not done.
  bool tells_the_same_run(const Program_options& options) const
  {
    namespace fs = std::filesystem;
    std::error_code error;
    const std::uintmax_t sphere_bytes = fs::file_size(m_names.sphere, error);
    return !error && text("sphere_bytes") == std::to_string(sphere_bytes) && text("program") == program_version() &&
           text("method") == options.description &&
           fs::path(text("input")).filename() == fs::path(m_names.input).filename() &&
           text("stop_reason") != Run_report::stop_reason_interrupted && is_as_it_was("input_stamp", m_names.input) &&
           (options.start_file.empty() || is_as_it_was("start_stamp", options.start_file));
  }

  /// returns whether the map was certified.
  bool is_one_to_one() const { return text("one_to_one") == "true"; }

private:
  std::string text(const std::string& name) const { return m_tree.get<std::string>(name, ""); }

  bool is_as_it_was(const std::string& name, const std::string& path) const
  {
    const File_stamp stamp(path);
    return !stamp.is_empty() && text(name + ".bytes") == std::to_string(stamp.bytes) &&
           text(name + ".changed") == stamp.changed;
  }

  File_names m_names;
  boost::property_tree::ptree m_tree;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_EARLIER_REPORT_H
