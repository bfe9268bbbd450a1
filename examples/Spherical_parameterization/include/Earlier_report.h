// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_EARLIER_REPORT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_EARLIER_REPORT_H

#include "File_names.h"
#include "Program_options.h"
#include "Run_report.h"
#include "program_version.h"

#ifndef BOOST_BIND_GLOBAL_PLACEHOLDERS
#define BOOST_BIND_GLOBAL_PLACEHOLDERS // the parser uses them, and older versions of Boost say so in every compilation
#endif
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

namespace Program {

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
      boost::property_tree::read_json(names.json, m_tree);
    }
    catch(const boost::property_tree::json_parser_error&)
    {
      m_tree.clear(); // which is the report of no run
    }
  }

  /// returns whether the mesh is done: its map is there as it was written, and made by this program with these options
  /// from the input as it is now. A map that was interrupted is not done.
  bool tells_the_same_run(const Program_options& options) const
  {
    namespace fs = std::filesystem;
    return text("program") == program_version() && text("method") == options.description &&
           fs::path(text("input")).filename() == fs::path(m_names.input).filename() &&
           text("stop_reason") != Run_report::stop_reason_interrupted && has_size("input_bytes", m_names.input) &&
           has_size("sphere_bytes", m_names.sphere) && is_newer_than(m_names.input) &&
           (options.start_file.empty() || is_newer_than(options.start_file));
  }

  /// returns whether the map was certified.
  bool is_one_to_one() const { return text("one_to_one") == "true"; }

private:
  std::string text(const char* name) const { return m_tree.get<std::string>(name, ""); }

  bool has_size(const char* name, const std::string& path) const
  {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    return !error && text(name) == std::to_string(size);
  }

  // Not older, to be precise: the clock of a file system may be slow.
  bool is_newer_than(const std::string& path) const
  {
    std::error_code error, other_error;
    const auto time = std::filesystem::last_write_time(m_names.json, error);
    const auto other_time = std::filesystem::last_write_time(path, other_error);
    return !error && !other_error && time >= other_time;
  }

  File_names m_names;
  boost::property_tree::ptree m_tree;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_EARLIER_REPORT_H
