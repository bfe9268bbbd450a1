// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FILE_FORMAT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FILE_FORMAT_H

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <string>

namespace Program {

/// The formats that are read, by the end of the name.
constexpr std::array<const char*, 5> input_formats = {".off", ".obj", ".ply", ".stl", ".ts"};

/// The formats that are written. An STL file is not among them: it repeats the vertices and forgets their order.
constexpr std::array<const char*, 4> output_formats = {".off", ".obj", ".ply", ".ts"};

/// returns the end of a file's name in lower case, with the dot.
inline std::string file_format(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for(char& c : extension)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// returns whether `format` is one of `formats`.
template <std::size_t n>
bool is_among(const std::string& format, const std::array<const char*, n>& formats)
{
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

/// returns `formats` as a text.
template <std::size_t n>
std::string list_of(const std::array<const char*, n>& formats)
{
  std::string list;
  for(const char* format : formats)
    list += (list.empty() ? "" : ", ") + std::string(format);
  return list;
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FILE_FORMAT_H
