// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FILE_STAMP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FILE_STAMP_H

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

namespace Program {

/// The size of a file and when it was last changed: what tells, as for many build tools, whether it is as it was.
struct File_stamp
{
  File_stamp() = default;

  /// takes the stamp of a file; it is empty if there is no such file, or nothing is known of it.
  explicit File_stamp(const std::string& name)
  {
    std::error_code size_error, time_error;
    const std::uintmax_t size = std::filesystem::file_size(name, size_error);
    const std::filesystem::file_time_type time = std::filesystem::last_write_time(name, time_error);
    if(size_error || time_error)
      return;
    bytes = size;
    changed = std::to_string(time.time_since_epoch().count());
  }

  bool is_empty() const { return changed.empty(); }

  std::uintmax_t bytes = 0;
  std::string changed; ///< in ticks of the clock of the file system, of which nothing but equality is meant
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FILE_STAMP_H
