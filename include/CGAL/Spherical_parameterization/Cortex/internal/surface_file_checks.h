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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_SURFACE_FILE_CHECKS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_SURFACE_FILE_CHECKS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>
#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

inline bool are_in_float_range(const std::vector<IO::Vertex_values>& columns)
{
  return std::all_of(columns.begin(), columns.end(), [](const auto& column) {
    return std::all_of(column.values.begin(), column.values.end(), is_in_float_range);
  });
}

// Returns whether all numbers are in the range of their type, and integers if it is a type of integers.
inline bool are_of_their_type(const IO::Vertex_values& column)
{
  using Type = IO::Vertex_values::Type;
  const double min = column.type == Type::uint8 ? 0. : (std::numeric_limits<std::int32_t>::min)(),
               max = column.type == Type::uint8 ? 255. : (std::numeric_limits<std::int32_t>::max)();
  return column.type == Type::float32 || std::all_of(column.values.begin(), column.values.end(), [&](double x) {
           return x >= min && x <= max && x == std::floor(x);
         });
}

// Throws if the values of each vertex are so many that what is kept for each column would fill the memory.
inline void check_number_of_columns(std::size_t n)
{
  constexpr std::size_t max_columns = 1 << 16;
  if(n > max_columns)
    throw File_error("The file has ", n, " values for each vertex, more than ", max_columns,
                     ": it is damaged, or no file of values of vertices.");
}

// Checks what follows the data of a file: numbered records, most of which begin with their length.
inline void check_footer(Byte_reader in)
{
  enum Tag : std::int32_t
  {
    old_color_table = 1,
    old_real_coordinates = 2,
    old_geometry_of_volume = 20,
    old_transformation = 30,
    max_tag = 1000
  };
  while(in.remaining() > 0)
  {
    const std::size_t begin = in.position();
    const std::int32_t tag = in.remaining() < sizeof(std::int32_t) ? 0 : in.read<std::int32_t>("the footer");
    if(tag <= 0 || tag > max_tag)
      throw File_error("The file goes on after its data, at byte ", begin, " of ", begin + in.remaining(),
                       ", with what is no footer: it is damaged, or the numbers in its header are wrong.");
    if(tag == old_color_table) // whose length is not given
      return;
    if(tag == old_real_coordinates)
      in.read_bytes(sizeof(std::int32_t), "the footer");
    else if(tag == old_geometry_of_volume)
    {
      constexpr int lines = 8;
      for(int k = 0; k < lines; ++k)
        in.read_bytes((std::min)(in.rest().find('\n'), in.remaining()) + 1, "the geometry of the volume");
    }
    else
    {
      const std::int64_t size =
          tag == old_transformation ? in.read<std::int32_t>("the footer") : in.read<std::int64_t>("the footer");
      in.check_count(size, "bytes of the footer", 1, begin);
      in.read_bytes(static_cast<std::size_t>(size), "the footer");
    }
  }
}

// Throws unless all corners are points.
inline void check_corners(const IO::Surface_file& file)
{
  for(std::size_t f = 0; f < file.triangles.size(); ++f)
    for(const std::uint32_t v : file.triangles[f])
      if(v >= file.points.size())
        throw File_error("Triangle ", f, " has the corner ", static_cast<std::int32_t>(v), ", but there are ",
                         file.points.size(), " vertices, counted from 0: the file is damaged.");
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_SURFACE_FILE_CHECKS_H
