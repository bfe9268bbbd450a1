// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OFF_READER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OFF_READER_H

#include "Polygon_soup.h"
#include "Text_scanner.h"
#include "check_count.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Program {

/// Reads the text variants of the format OFF in three dimensions. Colours, normals and texture coordinates are skipped.
///
/// CGAL reads them as well, but does not say where and why a file is broken, and believes the counts in its header
/// however large they are. This class names the line, and its memory is bounded by the size of the file.
class Off_reader
{
public:
  /// reads the content of a file.
  explicit Off_reader(std::string text)
    : m_in(std::move(text))
  {}

  /// returns the mesh.
  ///
  /// \throws Program_error if the file is damaged, or of another variant
  Polygon_soup operator()()
  {
    read_header();
    Polygon_soup soup;
    read_vertices(soup.points);
    read_faces(soup.polygons);
    return soup;
  }

private:
  // of a line: "0 0 0" or "0", and its end
  static constexpr std::size_t shortest_vertex = 6, shortest_face = 2;

  void read_header()
  {
    if(!m_in.next_line())
      throw Program_error("the file is empty");
    const std::string_view variant = m_in.word();
    const std::size_t prefix = (std::min)(variant.find_first_not_of("STCN4n"), variant.size());
    if(variant.compare(prefix, 3, "OFF") != 0)
      m_in.fail("an OFF file begins with OFF, not with " + Text_scanner::quoted(variant));
    m_is_homogeneous = variant.find('4') < prefix;
    const bool has_dimension = variant.find('n') < prefix;
    m_in.skip(prefix + 3); // some files have no blank between OFF and the first number
    find_word();
    if(m_in.word() == "BINARY")
      m_in.fail("the binary variant is not read: write the mesh as text, or as PLY");
    if(has_dimension)
    {
      const long long dimension = m_in.read_integer("the dimension");
      if(dimension != 3)
        m_in.fail("the dimension is " + std::to_string(dimension) + ", not 3");
      find_word();
    }
    m_number_of_vertices = m_in.read_count("vertices");
    m_number_of_faces = m_in.read_count("faces");
  }

  // moves to the next line if this one is at its end
  void find_word()
  {
    if(m_in.is_at_end_of_line() && !m_in.next_line())
      throw Program_error("the file ends within its header");
  }

  void next_item(const char* what, std::size_t i, std::size_t count)
  {
    if(!m_in.next_line())
      throw Program_error("the file ends after " + std::to_string(i) + " of " + std::to_string(count) + " " + what +
                          ": it is truncated, or the numbers in its first lines are wrong");
  }

  void read_vertices(std::vector<Point_3>& points)
  {
    check_count(m_number_of_vertices, "vertices", m_in.rest().size() + 1, shortest_vertex); // the last may lack its end
    points.reserve(m_number_of_vertices);
    for(std::size_t i = 0; i < m_number_of_vertices; ++i)
    {
      next_item("vertices", i, m_number_of_vertices);
      const double x = m_in.read_number("coordinate x of vertex ", i);
      const double y = m_in.read_number("coordinate y of vertex ", i);
      const double z = m_in.read_number("coordinate z of vertex ", i);
      const double w = m_is_homogeneous ? m_in.read_number("coordinate w of vertex ", i) : 1.;
      points.emplace_back(x / w, y / w, z / w);
    }
  }

  void read_faces(std::vector<std::vector<std::size_t>>& polygons)
  {
    check_count(m_number_of_faces, "faces", m_in.rest().size() + 1, shortest_face);
    polygons.reserve(m_number_of_faces);
    std::vector<std::size_t> corners;
    for(std::size_t i = 0; i < m_number_of_faces; ++i)
    {
      next_item("faces", i, m_number_of_faces);
      const long long size = m_in.read_integer("the number of corners of face ", i);
      if(size < 0)
        m_in.fail("the number of corners of face " + std::to_string(i) + " is negative");
      corners.clear();
      for(long long k = 0; k < size; ++k)
      {
        const long long v = m_in.read_integer("corner ", k, " of face ", i);
        if(v < 0 || static_cast<std::size_t>(v) >= m_number_of_vertices)
          m_in.fail("face " + std::to_string(i) + " has the corner " + std::to_string(v) + ", but there are " +
                    std::to_string(m_number_of_vertices) + " vertices, counted from 0");
        corners.push_back(static_cast<std::size_t>(v));
      }
      polygons.push_back(corners);
    }
  }

  Text_scanner m_in;
  bool m_is_homogeneous = false;
  std::size_t m_number_of_vertices = 0, m_number_of_faces = 0;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OFF_READER_H
