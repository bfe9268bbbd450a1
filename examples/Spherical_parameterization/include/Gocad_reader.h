// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_GOCAD_READER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_GOCAD_READER_H

#include "Polygon_soup.h"
#include "Program_error.h"
#include "Text_scanner.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace Program {

/// Reads the triangulated surfaces of the format GOCAD TSurf as one mesh.
///
/// CGAL's reader does not say where and why a file is broken, and expects the numbers of the vertices to be consecutive.
class Gocad_reader
{
public:
  /// reads the content of a file.
  explicit Gocad_reader(std::string text)
    : m_in(std::move(text))
  {}

  /// returns the mesh.
  ///
  /// \throws Program_error if the file is damaged
  Polygon_soup operator()()
  {
    bool is_within_surface = false;
    while(m_in.next_line())
    {
      const std::string_view statement = m_in.read_word();
      if(statement == "GOCAD")
      {
        is_within_surface = true;
        m_vertices.clear(); // each surface counts its own
      }
      else if(!is_within_surface)
        m_in.fail("a surface of a GOCAD file begins with GOCAD, not with " + Text_scanner::quoted(statement));
      else if(statement == "VRTX" || statement == "PVRTX")
        read_vertex();
      else if(statement == "ATOM" || statement == "PATOM")
        read_atom();
      else if(statement == "TRGL")
        read_triangle();
      else if(statement == "END")
        is_within_surface = false;
    }
    if(is_within_surface)
      throw Program_error("the file ends without END: it is truncated");
    return std::move(m_soup);
  }

private:
  void add_vertex(long long number, std::size_t v)
  {
    if(!m_vertices.emplace(number, v).second)
      m_in.fail("the vertex " + std::to_string(number) + " exists already");
  }

  std::size_t read_reference(const char* what)
  {
    const long long number = m_in.read_integer(what);
    const auto vertex = m_vertices.find(number);
    if(vertex == m_vertices.end())
      m_in.fail(std::string(what) + " is the vertex " + std::to_string(number) + ", which no line before has defined");
    return vertex->second;
  }

  void read_vertex()
  {
    const long long number = m_in.read_integer("the number of the vertex");
    const double x = m_in.read_number("coordinate x of vertex ", number);
    const double y = m_in.read_number("coordinate y of vertex ", number);
    const double z = m_in.read_number("coordinate z of vertex ", number);
    add_vertex(number, m_soup.points.size());
    m_soup.points.emplace_back(x, y, z);
  }

  // another number for the same vertex
  void read_atom()
  {
    const long long number = m_in.read_integer("the number of the atom");
    add_vertex(number, read_reference("what the atom stands for"));
  }

  void read_triangle()
  {
    const std::size_t a = read_reference("corner 0");
    const std::size_t b = read_reference("corner 1");
    const std::size_t c = read_reference("corner 2");
    m_soup.polygons.push_back({a, b, c});
  }

  Text_scanner m_in;
  Polygon_soup m_soup;
  std::map<long long, std::size_t> m_vertices; // by their numbers
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_GOCAD_READER_H
