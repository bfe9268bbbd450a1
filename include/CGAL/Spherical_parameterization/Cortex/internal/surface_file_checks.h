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
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Writes why the file cannot be written, and returns the error code.
template <class... Part>
Error_code refuse(std::string& message, Error_code code, const Part&... parts)
{
  message = File_error::join(parts...);
  return code;
}

inline Error_code write_bytes(std::ostream& out, const std::string& bytes, std::string& message)
{
  const Error_code error = ERROR_CANNOT_WRITE_FILE;
  return is_written(out, bytes) ? OK : refuse(message, error, get_error_message(error));
}

inline Error_code check_points(const std::vector<std::array<double, 3>>& points, std::string& message)
{
  for(std::size_t v = 0; v < points.size(); ++v)
    for(const double x : points[v])
      if(!is_in_float_range(x))
        return refuse(message, ERROR_OUT_OF_FLOAT_RANGE, "Vertex ", v, " has the coordinate ", x,
                      ", which is too large for a 32-bit number: scale the surface first, or write an OFF file.");
  return OK;
}

// Returns whether the vertices are 0, 1, 2 and so on, or none are listed: formats without indices have the values of
// these.
inline bool are_consecutive(const std::vector<std::uint32_t>& vertices)
{
  std::size_t n = 0;
  return std::all_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) { return v == n++; });
}

// Checks that a format without indices can represent the values.
inline Error_code check_consecutive(const std::vector<std::uint32_t>& vertices, std::string& message)
{
  return are_consecutive(vertices) ? OK
                                   : refuse(message, ERROR_WRONG_PARAMETER, "The values are of ", vertices.size(),
                                            " vertices of a surface, not of all from 0 on: write a GIFTI file.");
}

// Checks that keys of labels are distinct, colors are finite, and no vertex is listed twice. The readers require this.
inline Error_code check_labels_and_vertices(const IO::Surface_file& file, std::string& message)
{
  std::set<std::int32_t> keys;
  for(const IO::Label& label : file.labels)
  {
    if(!keys.insert(label.key).second)
      return refuse(message, ERROR_WRONG_PARAMETER, "Two labels have the key ", label.key, ".");
    if(!std::all_of(label.color.begin(), label.color.end(), [](double x) { return std::isfinite(x); }))
      return refuse(message, ERROR_WRONG_PARAMETER, "Label ", label.key, " has a color that is not finite.");
  }
  std::set<std::uint32_t> vertices;
  for(const std::uint32_t v : file.vertices)
    if(!vertices.insert(v).second)
      return refuse(message, ERROR_WRONG_PARAMETER, "The values are of vertex ", v, " twice.");
  return OK;
}

// Checks that the numbers have the type of their columns and fit into a 32-bit type. With `are_floats`, integers are
// written in single precision, too.
inline Error_code check_columns(const std::vector<IO::Vertex_values>& columns, bool are_floats, std::string& message)
{
  using Type = IO::Vertex_values::Type;
  for(const IO::Vertex_values& column : columns)
    for(std::size_t v = 0; v < column.values.size(); ++v)
    {
      const double x = column.values[v], min = column.type == Type::uint8 ? 0. : -2147483648.,
                   max = column.type == Type::uint8 ? 255. : 2147483647.;
      if(column.type == Type::float32)
      {
        if(!is_in_float_range(x))
          return refuse(message, ERROR_OUT_OF_FLOAT_RANGE, "The value ", x, " of vertex ", v, " in column ",
                        in_quotes(column.name), " is too large for a 32-bit number: scale the values first.");
      }
      else if(!(x >= min && x <= max && x == std::floor(x)))
        return refuse(message, ERROR_WRONG_PARAMETER, "The value ", x, " of vertex ", v, " in column ",
                      in_quotes(column.name), " is no integer from ", static_cast<std::int64_t>(min), " to ",
                      static_cast<std::int64_t>(max), ", as its type says: change the type to float32.");
      else if(are_floats && x != static_cast<double>(static_cast<float>(x)))
        return refuse(message, ERROR_OUT_OF_FLOAT_RANGE, "The integer ", static_cast<std::int64_t>(x), " of vertex ", v,
                      " in column ", in_quotes(column.name),
                      " would lose digits as a 32-bit floating-point number: write a GIFTI file.");
    }
  return OK;
}

// Throws if there are so many values per vertex that the data kept for each column would fill the memory.
inline void check_number_of_columns(std::size_t n)
{
  constexpr std::size_t max_columns = 1 << 14;
  if(n > max_columns)
    throw File_error("The file has ", n, " values for each vertex, more than ", max_columns,
                     ": it is damaged, or no file of values of vertices.");
}

// Checks the records that follow the data of a file. A record has a number, and most records have a length.
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
    if(tag == old_color_table) // has no length
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

// Throws unless all corners are indices of points.
inline void check_corners(const IO::Surface_file& file)
{
  for(std::size_t f = 0; f < file.triangles.size(); ++f)
    for(const std::uint32_t v : file.triangles[f])
      if(v >= file.points.size())
        throw File_error("Triangle ", f, " has the corner ", static_cast<std::int32_t>(v), ", but there are ",
                         file.points.size(), " vertices, counted from 0: the file is damaged.");
}

// Throws unless the sizes of triangles, columns and vertices are consistent.
inline void check_arrays(const IO::Surface_file& file)
{
  check_corners(file);
  const std::size_t n = !file.vertices.empty() || file.points.empty() ? file.vertices.size() : file.points.size();
  for(const IO::Vertex_values& column : file.columns)
  {
    const std::size_t expected = n > 0 ? n : file.columns.front().values.size();
    if(column.values.size() != expected)
      throw File_error("The values ", in_quotes(column.name), " are those of ", column.values.size(),
                       " vertices, but other arrays of the file are of ", expected, ": it is damaged.");
  }
}

// Sorts the values by vertex if the file lists the vertices. Throws if a vertex is listed twice or does not exist.
inline void sort_by_vertices(IO::Surface_file& file)
{
  if(file.vertices.empty())
    return;
  const std::vector<std::uint32_t> vertices = file.vertices;
  std::vector<std::size_t> order(vertices.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return vertices[i] < vertices[j]; });
  const auto sort = [&](auto& items) {
    const auto unsorted = items;
    std::transform(order.begin(), order.end(), items.begin(), [&](std::size_t i) { return unsorted[i]; });
  };
  sort(file.vertices);
  for(IO::Vertex_values& column : file.columns)
    sort(column.values);
  if(const auto twice = std::adjacent_find(file.vertices.begin(), file.vertices.end()); twice != file.vertices.end())
    throw File_error("The indices of vertices have ", *twice, " twice: the file is damaged.");
  if(!file.points.empty() && file.vertices.back() >= file.points.size())
    throw File_error("The indices of vertices have ", file.vertices.back(), ", but there are ", file.points.size(),
                     " vertices, counted from 0: the file is damaged.");
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_SURFACE_FILE_CHECKS_H
