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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_VERTEX_VALUES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_VERTEX_VALUES_H

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

// Returns whether all numbers are whole and in the range of their type, if that is one of whole numbers.
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

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_VERTEX_VALUES_H
