// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_TEMPORARY_FOLDER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_TEMPORARY_FOLDER_H

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include <stdlib.h>

namespace benchmarks {

// A folder that is there as long as this object.
class Temporary_folder
{
public:
  Temporary_folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "benchmark_XXXXXX").string();
    if(mkdtemp(name.data()) == nullptr)
    {
      throw std::runtime_error(name + ": cannot be created");
    }
    m_path = name;
  }
  ~Temporary_folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  const std::filesystem::path& path() const { return m_path; }

private:
  std::filesystem::path m_path;
};

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_TEMPORARY_FOLDER_H
