// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_FREESURFER_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_FREESURFER_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/Freesurfer_parts.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <map>
#include <ostream>
#include <string>

namespace CGAL::Spherical_parameterization::IO {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_FreeSurfer_surface(std::istream& in, Surface_file& file,
                                                                          std::string& message)
{
  return internal::read_or_tell(file, message, [&](Surface_file& result, std::string&) {
    internal::read_freesurfer_surface(internal::read_all(in), result);
  });
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code write_FreeSurfer_surface(std::ostream& out, const Surface_file& file)
{
  if(!internal::are_in_float_range(file.points))
    return ERROR_OUT_OF_FLOAT_RANGE;
  internal::Byte_writer bytes;
  const std::string& line = file.origin.created_by;
  bytes.content = "\xFF\xFF\xFE" +
                  (line.empty() ? "created by Spherical_parameterization" : line.substr(0, line.find('\n'))) + "\n\n";
  bytes.write(static_cast<std::int32_t>(file.points.size()));
  bytes.write(static_cast<std::int32_t>(file.triangles.size()));
  for(const std::array<double, 3>& p : file.points)
    for(const double x : p)
      bytes.write(static_cast<float>(x));
  for(const std::array<std::uint32_t, 3>& t : file.triangles)
    for(const std::uint32_t v : t)
      bytes.write(v);
  return internal::is_written(out, bytes.content + file.origin.footer) ? OK : ERROR_CANNOT_WRITE_FILE;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_FreeSurfer_curv(std::istream& in, Surface_file& file,
                                                                       std::string& message)
{
  return internal::read_or_tell(file, message, [&](Surface_file& result, std::string&) {
    internal::read_freesurfer_curv(internal::read_all(in), result);
  });
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code write_FreeSurfer_curv(std::ostream& out, const Vertex_values& values,
                                                                        std::size_t number_of_triangles)
{
  internal::Byte_writer bytes;
  bytes.content = "\xFF\xFF\xFF";
  bytes.write(static_cast<std::int32_t>(values.values.size()));
  bytes.write(static_cast<std::int32_t>(number_of_triangles));
  bytes.write(std::int32_t(1)); // number for each vertex
  for(const double x : values.values)
  {
    if(!internal::is_in_float_range(x))
      return ERROR_OUT_OF_FLOAT_RANGE;
    bytes.write(static_cast<float>(x));
  }
  return internal::is_written(out, bytes.content) ? OK : ERROR_CANNOT_WRITE_FILE;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_FreeSurfer_annotation(std::istream& in, Surface_file& file,
                                                                             std::string& message)
{
  return internal::read_or_tell(file, message, [&](Surface_file& result, std::string& text) {
    internal::read_freesurfer_annotation(internal::read_all(in), result, text);
  });
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code write_FreeSurfer_annotation(std::ostream& out,
                                                                              const Surface_file& file)
{
  if(file.columns.empty())
    return ERROR_WRONG_PARAMETER;
  std::map<double, std::uint32_t> colors;
  std::map<std::uint32_t, std::int32_t> keys; // of the first label with a colour
  std::int32_t max_key = -1, n_named = 0;
  for(const Label& label : file.labels)
  {
    const std::uint32_t color = internal::color_of_annotation(label);
    if(keys.emplace(color, label.key).second)
      colors.emplace(label.key, color);
    if(label.name.empty())
      continue;
    if(label.key < 0)
      return ERROR_WRONG_PARAMETER;
    max_key = (std::max)(max_key, label.key);
    ++n_named;
  }
  internal::Byte_writer bytes;
  bytes.write(static_cast<std::int32_t>(file.columns.front().values.size()));
  std::int32_t v = 0;
  for(const double key : file.columns.front().values)
  {
    const auto color = colors.find(key);
    if(color == colors.end())
      return ERROR_WRONG_PARAMETER;
    bytes.write(v++);
    bytes.write(color->second);
  }
  for(const std::int32_t number : {1, -2, max_key + 1}) // one table, of version 2, and the bound on its numbers
    bytes.write(number);
  bytes.write_text("Spherical_parameterization");
  bytes.write(n_named);
  for(const Label& label : file.labels)
    if(!label.name.empty())
    {
      bytes.write(label.key);
      bytes.write_text(label.name);
      const std::uint32_t color = internal::color_of_annotation(label);
      for(const int shift : {0, 8, 16})
        bytes.write(static_cast<std::int32_t>(color >> shift & 255));
      bytes.write(255 - static_cast<std::int32_t>(std::lround(255. * label.color[3])));
    }
  return internal::is_written(out, bytes.content) ? OK : ERROR_CANNOT_WRITE_FILE;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_FreeSurfer_label(std::istream& in, Surface_file& file,
                                                                        std::string& message)
{
  return internal::read_or_tell(file, message, [&](Surface_file& result, std::string&) {
    internal::read_freesurfer_label(internal::read_all(in), result);
  });
}

} // namespace CGAL::Spherical_parameterization::IO

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_FREESURFER_IMPL_H
