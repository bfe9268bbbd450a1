// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_STL_READER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_STL_READER_H

#include "Binary_scanner.h"
#include "Polygon_soup.h"
#include "Program_error.h"
#include "Text_scanner.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Program {

/// Reads the format STL, text or binary. Corners at the same point become one vertex, in the order of the file.
///
/// CGAL's reader does not say where and why a file is broken, and takes a coordinate that is not a number for another one.
class Stl_reader
{
public:
  /// reads the content of a file.
  explicit Stl_reader(std::string content)
    : m_content(std::move(content))
  {}

  /// returns the mesh.
  ///
  /// \throws Program_error if the file is damaged
  Polygon_soup operator()()
  {
    if(is_binary())
      read_binary();
    else
      read_text();
    return std::move(m_soup);
  }

private:
  static constexpr std::size_t size_of_title = 80, size_of_header = 84, size_of_facet = 50;

  // The title of a binary file may begin with the same word as a text, but then the file is as long as its header says.
  bool is_binary() const
  {
    const std::size_t word = m_content.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if(word == std::string::npos ||
       (m_content.compare(word, 5, "solid") != 0 && m_content.compare(word, 5, "SOLID") != 0))
      return true;
    return m_content.size() >= size_of_header &&
           m_content.size() == size_of_header + size_of_facet * std::size_t(number_of_binary_facets());
  }

  std::uint32_t number_of_binary_facets() const
  {
    std::uint32_t number = 0;
    Binary_scanner(std::string_view(m_content).substr(size_of_title), false).read(number);
    return number;
  }

  void read_binary()
  {
    if(m_content.size() < size_of_header)
      throw Program_error("this is no STL file: it neither begins with solid, nor is it long enough for a binary one");
    const std::size_t count = number_of_binary_facets();
    if(count > (m_content.size() - size_of_header) / size_of_facet)
      throw Program_error(
          "this is no STL file, or a truncated one: it neither begins with solid, nor is it long enough "
          "for the " +
          std::to_string(count) + " facets of a binary one");
    m_soup.polygons.reserve(count);
    for(std::size_t i = 0; i < count; ++i)
    {
      constexpr std::size_t size_of_normal = 12;
      Binary_scanner in(std::string_view(m_content).substr(size_of_header + i * size_of_facet + size_of_normal), false);
      for(int k = 0; k < 3; ++k)
      {
        std::array<float, 3> p{};
        for(float& x : p)
          in.read(x);
        add_corner({double(p[0]), double(p[1]), double(p[2])});
      }
      end_facet();
    }
  }

  void read_text()
  {
    Text_scanner in(std::move(m_content));
    bool is_within_facet = false, is_within_solid = false;
    while(in.next_line())
    {
      const std::string_view statement = in.read_word();
      const std::size_t i = m_soup.polygons.size();
      if(statement == "vertex")
      {
        if(!is_within_facet || m_corners.size() == 3)
          in.fail(is_within_facet ? "facet " + std::to_string(i) + " has a fourth vertex" : "a vertex without facet");
        const double x = in.read_number("coordinate x of facet ", i);
        const double y = in.read_number("coordinate y of facet ", i);
        const double z = in.read_number("coordinate z of facet ", i);
        add_corner({x, y, z});
      }
      else if(statement == "facet")
      {
        if(is_within_facet)
          in.fail("facet " + std::to_string(i) + " does not end");
        is_within_facet = true;
      }
      else if(statement == "endfacet")
      {
        if(m_corners.size() != 3)
          in.fail("facet " + std::to_string(i) + " has " + std::to_string(m_corners.size()) + " vertices");
        is_within_facet = false;
        end_facet();
      }
      else if(statement == "solid")
        is_within_solid = true;
      else if(statement == "endsolid")
        is_within_solid = false;
      else if(statement != "outer" && statement != "endloop")
        in.fail("no line of an STL file begins with " + Text_scanner::quoted(statement));
    }
    if(is_within_solid || is_within_facet)
      throw Program_error("the file ends without endsolid: it is truncated");
  }

  // The order of the map would be none with coordinates that are not numbers.
  void add_corner(const std::array<double, 3>& p)
  {
    for(const double x : p)
      if(!std::isfinite(x))
        throw Program_error("facet " + std::to_string(m_soup.polygons.size()) +
                            " has a coordinate that is infinite or not a number");
    const auto inserted = m_vertices.emplace(p, m_soup.points.size());
    if(inserted.second)
      m_soup.points.emplace_back(p[0], p[1], p[2]);
    m_corners.push_back(inserted.first->second);
  }

  void end_facet()
  {
    m_soup.polygons.push_back(m_corners);
    m_corners.clear();
  }

  std::string m_content;
  Polygon_soup m_soup;
  std::vector<std::size_t> m_corners; // of the facet
  std::map<std::array<double, 3>, std::size_t> m_vertices;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_STL_READER_H
