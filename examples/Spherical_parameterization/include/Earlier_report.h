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
#include "File_stamp.h"
#include "Program_options.h"
#include "Run_report.h"
#include "program_version.h"

#ifndef BOOST_BIND_GLOBAL_PLACEHOLDERS
#define BOOST_BIND_GLOBAL_PLACEHOLDERS // the parser uses them, and older versions of Boost say so in every compilation
#endif
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cstdint>
#include <exception>
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
    catch(const std::exception&) // what cannot be read or understood is the report of no run
    {
      m_tree.clear();
    }
  }

  /// returns whether the mesh is done: its map is there as it was written, and made by this program with these options
  /// from the input as it is now. A map that was interrupted is not done.
  bool tells_the_same_run(const Program_options& options) const
  {
    namespace fs = std::filesystem;
    return text("program") == program_version() && text("method") == options.description &&
           fs::path(text("input")).filename() == fs::path(m_names.input).filename() &&
           text("stop_reason") != Run_report::stop_reason_interrupted && is_as_it_was("input_stamp", m_names.input) &&
           (options.start_file.empty() || is_as_it_was("start_stamp", options.start_file)) && has_sphere();
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

  bool has_sphere() const
  {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(m_names.sphere, error);
    return !error && text("sphere_bytes") == std::to_string(size);
  }

  File_names m_names;
  boost::property_tree::ptree m_tree;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_EARLIER_REPORT_H
