#include "Earlier_report.h"

#include "Run_report.h"
#include "command_line.h"
#include "output_files.h"
#include "read_file.h"

#ifndef BOOST_BIND_GLOBAL_PLACEHOLDERS
#define BOOST_BIND_GLOBAL_PLACEHOLDERS // the parser uses them, and older versions of Boost say so in every compilation
#endif
#include <boost/property_tree/json_parser.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <ios>
#include <sstream>
#include <system_error>

namespace Program {

namespace {

// Reads a report but for its history, which is the one part without a limit to its length. The parser calls itself for
// what is nested, and takes a hundred times the memory of the file; a report is neither deep nor, but for its history, long.
boost::property_tree::ptree read_report(const std::string& path)
{
  constexpr std::uintmax_t max_size = std::uintmax_t(64) << 20;
  constexpr std::size_t max_size_of_rest = std::size_t(1) << 17;
  constexpr std::ptrdiff_t max_depth = 100;
  if(std::filesystem::file_size(path) > max_size)
    throw error_in(path, "is longer than any report");
  std::string text = read_file(path);
  if(text != Run_report::sealed(text.substr(0, text.rfind(Run_report::seal))))
    throw error_in(path, "is damaged");
  const std::string history = "\"history\": ";
  const std::size_t begin = text.find(history);
  if(begin != text.npos)
  {
    const std::size_t end = text.find_first_not_of("0123456789+-.enul[], \n", begin + history.size());
    text.erase(begin, (std::min)(end, text.size()) - begin);
  }
  if(text.size() > max_size_of_rest)
    throw error_in(path, "is longer than any report");
  std::ptrdiff_t depth = 0;
  for(const char c : text)
  {
    depth += (c == '[' || c == '{') - (c == ']' || c == '}'); // those of texts as well, which are few
    if(depth > max_depth)
      throw error_in(path, "is nested deeper than any report");
  }
  boost::property_tree::ptree tree;
  std::istringstream in(text);
  boost::property_tree::read_json(in, tree);
  return tree;
}

} // namespace

Earlier_report::Earlier_report(const File_names& names)
  : m_names(names)
{
  try
  {
    m_tree = read_report(names.json);
  }
  catch(const std::exception&) // what cannot be read or understood is the report of no run
  {}
}

bool Earlier_report::tells_the_same_run(const Options& options) const
{
  namespace fs = std::filesystem;
  return text("program") == program_version() && text("method") == options.description &&
         fs::path(text("input")).filename() == fs::path(valid_utf8(m_names.input)).filename() &&
         text("stop_reason") != Run_report::stop_reason_interrupted && is_as_it_was("input_stamp", m_names.input) &&
         (options.start_or_template().empty() || is_as_it_was("start_stamp", options.start_or_template())) &&
         has_its_sphere();
}

std::string Earlier_report::foreign_file() const
{
  const auto exists = [](const std::string& name) {
    std::error_code error;
    return std::filesystem::exists(std::filesystem::symlink_status(name, error));
  };
  return exists(m_names.sphere) && !has_its_sphere() ? m_names.sphere
         : exists(m_names.json) && m_tree.empty()    ? m_names.json
                                                     : "";
}

bool Earlier_report::is_as_it_was(const std::string& name, const std::string& path) const
{
  const File_stamp stamp(path);
  return !stamp.is_empty() && text(name + ".bytes") == std::to_string(stamp.bytes) &&
         text(name + ".changed") == stamp.changed;
}

bool Earlier_report::has_its_sphere() const
{
  std::error_code error;
  if(!std::filesystem::is_regular_file(m_names.sphere, error) ||
     text("sphere_bytes") != std::to_string(std::filesystem::file_size(m_names.sphere, error)))
    return false;
  Checksum checksum;
  std::ifstream in(m_names.sphere, std::ios::binary);
  std::array<char, 1 << 16> block;
  while(in.read(block.data(), block.size()) || in.gcount() > 0)
    checksum.add(block.data(), static_cast<std::size_t>(in.gcount()));
  return text("sphere_bytes") == std::to_string(checksum.bytes) &&
         text("sphere_crc32") == std::to_string(checksum.crc.checksum());
}

} // namespace Program
