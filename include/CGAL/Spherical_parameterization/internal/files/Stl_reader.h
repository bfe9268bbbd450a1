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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_STL_READER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_STL_READER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>
#include <CGAL/Spherical_parameterization/internal/files/Polygon_soup.h>
#include <CGAL/Spherical_parameterization/internal/files/Text_scanner.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Reads the format STL, text or binary. Corners at the same point become one vertex, in the order of the file.
class Stl_reader
{
public:
  explicit Stl_reader(Text_scanner& in)
    : m_in(in)
  {}

  Polygon_soup operator()()
  {
    const std::string_view content = m_in.rest();
    std::uint32_t n_facets = 0;
    const bool is_long_enough =
        Text_scanner(std::string(content.substr((std::min)(size_of_title, content.size()), 4))).read_bytes(n_facets);
    // The title of a binary file may start with the same word as a text file, but a binary file has the size stated in
    // its header.
    const std::size_t word = (std::min)(content.find_first_not_of(" \t\r\n"), content.size());
    const bool is_text = content.compare(word, 5, "solid") == 0 || content.compare(word, 5, "SOLID") == 0;
    const std::size_t size = size_of_header + size_of_facet * std::size_t(n_facets);
    if(is_text && !(is_long_enough && content.size() == size))
      read_text();
    else if(!is_long_enough)
      throw File_error("this is no STL file: it neither begins with solid, nor is it long enough for a binary one");
    else if(content.size() < size)
      throw File_error("this is no STL file, or a truncated one: it neither begins with solid, nor is it long enough "
                       "for the ",
                       n_facets, " facets of a binary one");
    else
      read_facets(n_facets);
    return std::move(m_soup);
  }

private:
  static constexpr std::size_t size_of_title = 80, size_of_header = 84, size_of_facet = 50;

  void read_facets(std::uint32_t count)
  {
    m_in.skip_bytes(size_of_header);
    for(std::uint32_t i = 0; i < count; ++i)
    {
      std::array<float, 12> x{}; // the normal, and three points
      for(float& coordinate : x)
        m_in.read_bytes(coordinate);
      for(std::size_t k = 3; k < x.size(); k += 3)
        add_corner(Simple_cartesian<double>::Point_3(double(x[k]), double(x[k + 1]), double(x[k + 2])));
      end_facet();
      m_in.skip_bytes(2);
    }
  }

  void read_text()
  {
    bool is_within_facet = false, is_within_solid = false;
    while(m_in.next_line())
    {
      const std::string statement = lower_case(std::string(m_in.read_word())); // some programs write capitals
      const std::size_t i = m_soup.polygons.size();
      if(statement == "vertex")
      {
        if(!is_within_facet)
          m_in.fail("a vertex without facet");
        if(m_corners.size() == 3)
          m_in.fail("facet ", i, " has a fourth vertex");
        add_corner(m_in.read_point("facet ", i));
      }
      else if(statement == "facet")
      {
        if(is_within_facet)
          m_in.fail("facet ", i, " does not end");
        is_within_facet = true;
      }
      else if(statement == "endfacet")
      {
        if(m_corners.size() != 3)
          m_in.fail("facet ", i, " has ", m_corners.size(), " vertices");
        is_within_facet = false;
        end_facet();
      }
      else if(statement == "solid")
        is_within_solid = true;
      else if(statement == "endsolid")
        is_within_solid = false;
      else if(statement != "outer" && statement != "endloop")
        m_in.fail("no line of an STL file begins with ", Text_scanner::quoted(statement));
    }
    if(is_within_solid || is_within_facet)
      throw File_error("the file ends without endsolid: it is truncated");
  }

  // The map requires an order, which NaN does not have.
  void add_corner(const Simple_cartesian<double>::Point_3& p)
  {
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw File_error("facet ", m_soup.polygons.size(), " has a coordinate that is infinite or not a number");
    const auto [vertex, is_new] = m_vertices.emplace(p, m_soup.points.size());
    if(is_new)
      m_soup.points.push_back(p);
    m_corners.push_back(vertex->second);
  }

  void end_facet()
  {
    m_soup.polygons.push_back(m_corners);
    m_corners.clear();
  }

  Text_scanner& m_in;
  Polygon_soup m_soup;
  Polygon m_corners; // of the facet
  std::map<Simple_cartesian<double>::Point_3, std::size_t> m_vertices;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_STL_READER_H
