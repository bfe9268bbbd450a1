// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEXT_OFF_READER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEXT_OFF_READER_H

#include "Polygon_soup.h"
#include "Program_error.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <istream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace Program {

/// Reads the text variants of the format OFF whose vertices begin with three coordinates.
///
/// CGAL reads them as well, but does not say where and why a file is broken, and believes the counts in its header
/// however large they are. This class names the line, and its memory is bounded by the size of the file.
class Text_off_reader
{
public:
  /// reads all text of a file.
  explicit Text_off_reader(std::istream& in)
    : m_text(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>())
  {}

  /// returns `false` if the file is of another variant: binary, homogeneous, of another dimension, or a skeleton.
  ///
  /// \throws Program_error if the file is damaged
  bool operator()(Polygon_soup& soup)
  {
    if(!read_variant())
      return false;
    read_counts();
    read_vertices(soup.points);
    read_faces(soup.polygons);
    return true;
  }

private:
  // of a line: "0 0 0" or "0", and its end
  static constexpr long long shortest_vertex = 6, shortest_face = 2;

  [[noreturn]] void fail(const std::string& what) const
  {
    throw Program_error("line " + std::to_string(m_line_number) + ": " + what);
  }

  // moves to the next line that is not empty, and cuts off its comment
  bool next_line()
  {
    while(m_next < m_text.size())
    {
      m_cursor = &m_text[m_next];
      const std::size_t end = (std::min)(m_text.find('\n', m_next), m_text.size());
      if(end < m_text.size())
        m_text[end] = '\0';
      char* const comment = std::find(m_cursor, m_cursor + (end - m_next), '#');
      *comment = '\0';
      m_next = end + 1;
      ++m_line_number;
      if(!is_at_end_of_line())
        return true;
    }
    return false;
  }

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\0'; }

  bool is_at_end_of_line()
  {
    while(*m_cursor != '\0' && is_blank(*m_cursor))
      ++m_cursor;
    return *m_cursor == '\0';
  }

  // returns the word at the cursor, for a message
  std::string word() const
  {
    constexpr std::size_t longest = 20;
    std::string result;
    for(const char* c = m_cursor; *c > ' ' && *c < 127 && result.size() < longest; ++c)
      result += *c;
    return result.empty() ? "a byte that is no text" : "'" + result + "'";
  }

  // The messages are put together only when they are needed: there is one number of each kind per corner of the mesh.
  double read_coordinate(std::size_t vertex)
  {
    if(is_at_end_of_line())
      fail("vertex " + std::to_string(vertex) + " has fewer than three coordinates");
    char* end = nullptr;
    const double x = std::strtod(m_cursor, &end);
    if(end == m_cursor || !is_blank(*end))
      fail("vertex " + std::to_string(vertex) + " has a coordinate that is not a number: " + word());
    m_cursor = end;
    return x;
  }

  template <class... Name>
  long long read_integer(const Name&... name)
  {
    char* end = m_cursor;
    errno = 0;
    const long long i = is_at_end_of_line() ? 0 : std::strtoll(m_cursor, &end, 10);
    if(end == m_cursor || !is_blank(*end) || errno == ERANGE)
    {
      std::ostringstream what;
      (what << ... << name);
      fail(what.str() + (*m_cursor == '\0' ? " is missing" : " should be a whole number, not " + word()));
    }
    m_cursor = end;
    return i;
  }

  std::size_t read_count(const char* what, long long shortest_line)
  {
    const long long count = read_integer("the number of ", what);
    if(count < 0)
      fail(std::string("the number of ") + what + " is negative");
    if(count > static_cast<long long>(m_text.size()) / shortest_line)
      fail("the file is too short for " + std::to_string(count) + " " + what +
           ": it is truncated, or the number is wrong");
    return static_cast<std::size_t>(count);
  }

  bool read_variant()
  {
    if(!next_line())
      throw Program_error("the file is empty");
    const std::string line(m_cursor);
    if(line.compare(0, 4, "SKEL") == 0 || line.find("BINARY") != std::string::npos)
      return false;
    const std::size_t prefix = (std::min)(line.find_first_not_of("STCN4n"), line.size());
    if(line.compare(prefix, 3, "OFF") != 0)
      fail("an OFF file begins with OFF, not with " + word());
    if(line.find_first_of("4n") < prefix)
      return false;
    m_cursor += prefix + 3;
    return true;
  }

  void read_counts()
  {
    if(is_at_end_of_line() && !next_line())
      throw Program_error("the file ends after its first line");
    m_number_of_vertices = read_count("vertices", shortest_vertex);
    m_number_of_faces = read_count("faces", shortest_face);
  }

  void next_item(const char* what, std::size_t i, std::size_t count)
  {
    if(!next_line())
      throw Program_error("the file ends after " + std::to_string(i) + " of " + std::to_string(count) + " " + what +
                          ": it is truncated, or the numbers in its first lines are wrong");
  }

  void read_vertices(std::vector<Point_3>& points)
  {
    points.reserve(m_number_of_vertices);
    for(std::size_t i = 0; i < m_number_of_vertices; ++i)
    {
      next_item("vertices", i, m_number_of_vertices);
      double p[3];
      for(double& x : p)
        x = read_coordinate(i);
      points.emplace_back(p[0], p[1], p[2]);
    }
  }

  void read_faces(std::vector<std::vector<std::size_t>>& polygons)
  {
    polygons.reserve(m_number_of_faces);
    std::vector<std::size_t> corners;
    for(std::size_t i = 0; i < m_number_of_faces; ++i)
    {
      next_item("faces", i, m_number_of_faces);
      const long long size = read_integer("the number of corners of face ", i);
      corners.clear();
      for(long long k = 0; k < size; ++k)
      {
        const long long v = read_integer("corner ", k, " of face ", i);
        if(v < 0 || v >= static_cast<long long>(m_number_of_vertices))
          fail("face " + std::to_string(i) + " has the corner " + std::to_string(v) + ", but the vertices are 0 to " +
               std::to_string(m_number_of_vertices - 1));
        corners.push_back(static_cast<std::size_t>(v));
      }
      polygons.push_back(corners);
    }
  }

  std::string m_text;
  std::size_t m_next = 0;
  std::size_t m_line_number = 0;
  char* m_cursor = nullptr;
  std::size_t m_number_of_vertices = 0, m_number_of_faces = 0;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEXT_OFF_READER_H
