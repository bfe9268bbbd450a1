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
#include <CGAL/Spherical_parameterization/Cortex/internal/surface_file_checks.h>
#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {
namespace internal {

constexpr std::int32_t max_key_of_annotation = 1 << 24; // the number of RGB colors
constexpr std::uint32_t magic_of_triangles = 0xFFFFFE, magic_of_quadrangles = 0xFFFFFD, magic_of_curv = 0xFFFFFF;

inline void read_freesurfer_surface(std::string_view content, IO::Surface_file& file, std::string&)
{
  Byte_reader in(content);
  const std::uint32_t magic = in.read_3_bytes("the magic number");
  if(magic == magic_of_quadrangles || magic == magic_of_curv)
    throw File_error("This is ", magic == magic_of_curv ? "no surface but values of vertices, or " : "",
                     "an old quadrangle file of FreeSurfer, which is not read: convert it with mris_convert.");
  if(magic != magic_of_triangles)
    throw File_error("This is no surface of FreeSurfer: it does not begin with the bytes FF FF FE.");
  const std::size_t end_of_line = in.rest().find('\n');
  if(end_of_line == std::string_view::npos)
    throw File_error("The file ends within its first line: ", truncated);
  file.origin.created_by = in.read_bytes(end_of_line, "the first line");
  in.read_bytes(1, "the first line");
  if(!in.rest().empty() && in.rest().front() == '\n') // some programs omit the empty line
    in.read_bytes(1, "the first line");
  const std::size_t begin = in.position();
  const auto n_points = in.read<std::int32_t>("the number of vertices"),
             n_triangles = in.read<std::int32_t>("the number of triangles");
  constexpr std::size_t size_of_item = 12; // three 32-bit numbers
  in.check_count(n_points, "vertices", size_of_item, begin);
  in.check_count(n_triangles, "triangles", size_of_item, begin + sizeof(std::int32_t));
  file.points.resize(static_cast<std::size_t>(n_points));
  for(std::array<double, 3>& p : file.points)
    for(double& x : p)
      x = static_cast<double>(in.read<float>("the coordinates of the vertices"));
  in.check_count(n_triangles, "triangles", size_of_item, begin + sizeof(std::int32_t));
  file.triangles.resize(static_cast<std::size_t>(n_triangles));
  for(std::array<std::uint32_t, 3>& t : file.triangles)
    for(std::uint32_t& v : t)
      v = in.read<std::uint32_t>("the corners of the triangles");
  check_corners(file);
  check_footer(in);
  file.origin.footer = in.rest();
}

inline void read_freesurfer_curv(std::string_view content, IO::Surface_file& file, std::string&)
{
  Byte_reader in(content);
  const std::uint32_t magic = in.read_3_bytes("the magic number");
  std::vector<double>& values = file.columns.emplace_back().values;
  if(magic == magic_of_curv)
  {
    const std::size_t n = in.read_count("vertices", sizeof(float));
    in.read<std::int32_t>("the number of triangles");
    const auto n_values = in.read<std::int32_t>("the number of values of a vertex");
    if(n_values != 1)
      throw File_error("Byte 11: the file has ", n_values, " values for each vertex, not 1: it is no file of curv ",
                       "values, but may be an old quadrangle file, which mris_convert converts.");
    in.check_count(static_cast<std::int64_t>(n), "values", sizeof(float), 3);
    for(values.reserve(n); values.size() < n;)
      values.push_back(static_cast<double>(in.read<float>("the values")));
  }
  else if(magic == magic_of_triangles || magic == magic_of_quadrangles)
    throw File_error("This is a surface of FreeSurfer, not a file of values: give one such as lh.sulc.");
  else // the old format, 16-bit integers in units of 0.01
  {
    in.read_3_bytes("the number of triangles");
    in.check_count(magic, "values", sizeof(std::int16_t), 0);
    constexpr double hundred = 100.;
    for(values.reserve(magic); values.size() < magic;)
      values.push_back(in.read<std::int16_t>("the values") / hundred);
  }
  if(in.remaining() > 0)
    throw File_error("The file goes on for ", in.remaining(), " bytes after its ", values.size(),
                     " values: it is damaged, or no curv file of FreeSurfer.");
}

// Color of a label in an annotation; only unnamed labels have the fourth byte. 0 (transparent black) means no label.
inline std::uint32_t color_of_annotation(const IO::Label& label)
{
  if(label.name.empty() && label.color == std::array<double, 4>{})
    return 0;
  std::array<std::uint32_t, 4> bytes;
  for(std::size_t k = 0; k < 4; ++k)
    bytes[k] = static_cast<std::uint32_t>(std::lround(255. * (std::min)((std::max)(label.color[k], 0.), 1.)));
  return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | (label.name.empty() ? 255 - bytes[3] : 0) << 24;
}

inline void read_color_table(Byte_reader& in, IO::Surface_file& file)
{
  constexpr std::size_t min_size = 20; // of an entry: the length of its name, and four numbers
  const std::size_t begin = in.position();
  std::int32_t n = in.read<std::int32_t>("the color table");
  const bool has_numbers = n < 0; // version 2; version 1 numbers the entries by position
  if(has_numbers && n != -2)
    throw File_error("Byte ", begin, ": the color table has the version ", -static_cast<std::int64_t>(n),
                     ", but 1 and 2 are known: convert it with FreeSurfer.");
  if(has_numbers)
    in.read<std::int32_t>("the color table"); // a bound on the numbers
  in.read_text("the name of the color table");
  if(has_numbers)
    n = static_cast<std::int32_t>(in.read_count("entries of the color table", min_size));
  in.check_count(n, "entries of the color table", min_size, begin);
  std::set<std::int32_t> keys;
  for(std::int32_t k = 0; k < n; ++k)
  {
    const std::size_t begin_of_entry = in.position();
    IO::Label label{
        has_numbers ? in.read<std::int32_t>("the color table") : k, in.read_text("the name of a structure"), {}};
    for(double& x : label.color)
    {
      const auto byte = in.read<std::int32_t>("the color table");
      if(byte < 0 || byte > 255)
        throw File_error("Byte ", begin_of_entry, ": entry ", k, " of the color table has a component ", byte,
                         ", but 0 to 255 are possible: the file is damaged.");
      x = byte / 255.;
    }
    label.color[3] = 1. - label.color[3]; // the file stores transparency
    if(label.name.empty())
      label.name = File_error::join("structure ", label.key); // an empty name denotes a color without an entry
    const bool is_possible = label.key >= 0 && label.key <= max_key_of_annotation;
    if(!is_possible || !keys.insert(label.key).second)
      throw File_error("Byte ", begin_of_entry, ": entry ", k, " of the color table has the number ", label.key,
                       is_possible ? ", as another one has" : ", which is out of range", ": the file is damaged.");
    file.labels.push_back(std::move(label));
  }
}

inline void read_freesurfer_annotation(std::string_view content, IO::Surface_file& file, std::string& message)
{
  Byte_reader in(content);
  constexpr std::size_t size_of_pair = 8; // a vertex and its color
  const std::size_t n = in.read_count("vertices", size_of_pair);
  std::vector<std::uint32_t> colors(n);
  std::vector<bool> is_known(n, false);
  for(std::size_t k = 0; k < n; ++k)
  {
    const auto v = in.read<std::uint32_t>("the vertices");
    if(v >= n || is_known[v])
      throw File_error("Byte ", in.position() - sizeof v, ": vertex ", static_cast<std::int32_t>(v), " of ", n,
                       v >= n ? " does not exist" : " is there twice",
                       ": the file is damaged, or no annotation of FreeSurfer.");
    is_known[v] = true;
    colors[v] = in.read<std::uint32_t>("the colors of the vertices");
  }
  const std::size_t begin = in.position();
  const std::int32_t n_tables = in.remaining() > 0 ? in.read<std::int32_t>("the number of color tables") : 0;
  if(n_tables != 0 && n_tables != 1)
    throw File_error("Byte ", begin, ": the number of color tables is ", n_tables,
                     ", not 0 or 1: the file is damaged, or no annotation of FreeSurfer.");
  if(n_tables == 1)
    read_color_table(in, file);
  check_footer(in);
  std::map<std::uint32_t, std::int32_t> keys; // the first label of a color
  std::int32_t next = 0;
  for(const IO::Label& label : file.labels)
  {
    keys.emplace(color_of_annotation(label), label.key);
    next = (std::max)(next, label.key + 1);
  }
  const std::size_t n_named = keys.size();
  std::size_t n_unnamed_vertices = 0;
  IO::Vertex_values& column = file.columns.emplace_back();
  column.intent = "NIFTI_INTENT_LABEL";
  column.type = IO::Vertex_values::Type::int32;
  column.values.reserve(n);
  std::map<std::uint32_t, std::int32_t> unnamed;
  for(const std::uint32_t color : colors)
  {
    auto found = keys.find(color);
    if(found == keys.end())
    {
      ++n_unnamed_vertices;
      found = unnamed.find(color);
      if(found == unnamed.end())
      {
        found = unnamed.emplace(color, next++).first;
        file.labels.push_back({found->second,
                               "",
                               {{(color & 255) / 255., (color >> 8 & 255) / 255., (color >> 16 & 255) / 255.,
                                 (255 - (color >> 24)) / 255.}}});
      }
    }
    column.values.push_back(found->second);
  }
  if(n_unnamed_vertices > 0)
  {
    const std::uint32_t color = unnamed.begin()->first;
    message = File_error::join(n_unnamed_vertices, " vertices have ", unnamed.size(), " colors that the table of ",
                               n_named, " does not name, such as ", color & 255, ' ', color >> 8 & 255, ' ',
                               color >> 16 & 255, ": they are labels without name.\n");
  }
}

inline void read_freesurfer_label(std::string_view content, IO::Surface_file& file, std::string&)
{
  std::size_t line_number = 1;
  if(!content.empty() && content.front() == '#')
  {
    content.remove_prefix((std::min)(content.find('\n'), content.size() - 1) + 1);
    ++line_number;
  }
  Number_text text(content);
  const auto read = [&](const char* what, bool is_whole) {
    const std::string_view word = text.next_word();
    double x = 0.;
    if(word.empty())
      throw File_error("The file ends before ", what, " of line ", line_number, ": ", truncated);
    constexpr double max = (std::numeric_limits<std::int32_t>::max)();
    if(!text.is_number(word, x) || (is_whole && !(x == std::floor(x) && x >= 0. && x <= max)))
      throw File_error("Line ", line_number, ": ", what, " is ", in_quotes(word), ", which is no ",
                       is_whole ? "integer from 0 on" : "number", ": the file is damaged, or no label file.");
    return x;
  };
  const double n = read("the number of vertices", true);
  constexpr std::size_t min_size = 10; // of a line
  if(n > static_cast<double>(content.size() / min_size))
    throw File_error("Line ", line_number, ": the file is too short for ", n, " vertices: ", truncated);
  IO::Vertex_values& column = file.columns.emplace_back();
  for(double k = 0.; k < n; ++k)
  {
    ++line_number;
    file.vertices.push_back(static_cast<std::uint32_t>(read("the vertex", true)));
    for(const char* what : {"coordinate x", "coordinate y", "coordinate z"})
      read(what, false);
    column.values.push_back(read("the value", false));
  }
  if(const std::string_view word = text.next_word(); !word.empty())
    throw File_error("Line ", line_number + 1, ": the file goes on after ", n, " vertices with ", in_quotes(word),
                     ": the number of vertices in its second line is wrong, or it is damaged.");
}

} // namespace internal

namespace IO {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_FreeSurfer_surface(std::istream& in, Surface_file& file,
                                                                          std::string& message)
{
  return internal::read_or_report(in, file, message, internal::read_freesurfer_surface);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code write_FreeSurfer_surface(std::ostream& out, const Surface_file& file,
                                                                           std::string& message)
{
  message.clear();
  if(const Error_code error = internal::check_points(file.points, message); error != OK)
    return error;
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
  return internal::write_bytes(out, bytes.content + file.origin.footer, message);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_FreeSurfer_curv(std::istream& in, Surface_file& file,
                                                                       std::string& message)
{
  return internal::read_or_report(in, file, message, internal::read_freesurfer_curv);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code write_FreeSurfer_curv(std::ostream& out, const Vertex_values& values,
                                                                        std::size_t number_of_triangles,
                                                                        std::string& message)
{
  message.clear();
  if(const Error_code error = internal::check_columns({values}, true, message); error != OK)
    return error;
  internal::Byte_writer bytes;
  bytes.content = "\xFF\xFF\xFF";
  bytes.write(static_cast<std::int32_t>(values.values.size()));
  bytes.write(static_cast<std::int32_t>(number_of_triangles));
  bytes.write(std::int32_t(1)); // values per vertex
  for(const double x : values.values)
    bytes.write(static_cast<float>(x));
  return internal::write_bytes(out, bytes.content, message);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_FreeSurfer_annotation(std::istream& in, Surface_file& file,
                                                                             std::string& message)
{
  return internal::read_or_report(in, file, message, internal::read_freesurfer_annotation);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code write_FreeSurfer_annotation(std::ostream& out,
                                                                              const Surface_file& file,
                                                                              std::string& message)
{
  message.clear();
  const auto refuse = [&](const auto&... parts) { return internal::refuse(message, ERROR_WRONG_PARAMETER, parts...); };
  if(file.columns.empty())
    return refuse("There is no column of labels, which an annotation holds.");
  if(const Error_code error = internal::check_consecutive(file.vertices, message); error != OK)
    return error;
  std::map<double, std::uint32_t> colors;
  std::map<std::uint32_t, std::int32_t> keys; // the first label of a color
  std::set<double> all_keys;
  std::int32_t max_key = -1, n_named = 0;
  for(const Label& label : file.labels)
  {
    for(const double x : label.color)
      if(!(x >= 0. && x <= 1.))
        return refuse("Label ", label.key, " has the color component ", x, ", which is not from 0 to 1.");
    if(!all_keys.insert(label.key).second)
      return refuse("Two labels have the key ", label.key, ".");
    const std::uint32_t color = internal::color_of_annotation(label);
    if(keys.emplace(color, label.key).second)
      colors.emplace(label.key, color);
    if(label.name.empty())
      continue;
    if(label.key < 0 || label.key > internal::max_key_of_annotation)
      return refuse("The key ", label.key, " of a label is not from 0 to ", internal::max_key_of_annotation,
                    ", as those of annotations are: number the labels anew, or write a GIFTI file.");
    max_key = (std::max)(max_key, label.key);
    ++n_named;
  }
  for(const double key : file.columns.front().values)
    if(colors.count(key) == 0)
      return refuse("A vertex has the label ", key,
                    all_keys.count(key) == 0 ? ", which is not in the table of labels."
                                             : ", whose color is that of a label before it, by which annotations "
                                               "distinguish them: give it another one.");
  internal::Byte_writer bytes;
  bytes.write(static_cast<std::int32_t>(file.columns.front().values.size()));
  std::int32_t v = 0;
  for(const double key : file.columns.front().values)
  {
    bytes.write(v++);
    bytes.write(colors.at(key));
  }
  for(const std::int32_t number : {1, -2, max_key + 1}) // one table, version 2, and the bound on its numbers
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
  return internal::write_bytes(out, bytes.content, message);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_FreeSurfer_label(std::istream& in, Surface_file& file,
                                                                        std::string& message)
{
  return internal::read_or_report(in, file, message, internal::read_freesurfer_label);
}

} // namespace IO
} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_FREESURFER_IMPL_H
