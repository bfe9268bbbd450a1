// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OBJ_READER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OBJ_READER_H

#include "Polygon_soup.h"
#include "Text_scanner.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Program {

/// Reads the vertices and faces of the format OBJ; everything else is skipped, as long as it belongs to the format.
///
/// CGAL's reader does not say where and why a file is broken, and drops corners that are separated by tabs.
class Obj_reader
{
public:
  /// reads the content of a file.
  explicit Obj_reader(std::string text)
    : m_in(std::move(text))
  {}

  /// returns the mesh.
  ///
  /// \throws Program_error if the file is damaged
  Polygon_soup operator()()
  {
    while(m_in.next_line())
    {
      const std::string_view statement = m_in.read_word();
      if(statement == "v")
        read_vertex();
      else if(statement == "f" || statement == "fo")
        read_face();
      else if(std::find(others.begin(), others.end(), statement) == others.end())
        m_in.fail("no line of an OBJ file begins with " + Text_scanner::quoted(statement));
    }
    return std::move(m_soup);
  }

private:
  static constexpr std::array<std::string_view, 42> others = {
      "vt",        "vn",     "vp",     "g",      "s",     "mg",       "o",        "p",    "l",
      "usemtl",    "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp", "lod",  "shadow_obj",
      "trace_obj", "ctech",  "stech",  "cstype", "deg",   "bmat",     "step",     "curv", "curv2",
      "surf",      "parm",   "trim",   "hole",   "scrv",  "sp",       "end",      "con",  "call",
      "csh",       "bsp",    "bzp",    "cdc",    "cdp",   "res"};

  void read_vertex()
  {
    const std::size_t i = m_soup.points.size();
    const double x = m_in.read_number("coordinate x of vertex ", i);
    const double y = m_in.read_number("coordinate y of vertex ", i);
    const double z = m_in.read_number("coordinate z of vertex ", i);
    m_soup.points.emplace_back(x, y, z);
  }

  // A corner is a vertex, counted from 1, or backwards from the last one so far, -1. Texture and normal may follow.
  void read_face()
  {
    const std::size_t f = m_soup.polygons.size();
    std::vector<std::size_t> corners;
    while(!m_in.is_at_end_of_line())
    {
      const long long v = m_in.read_integer_before('/', "corner ", corners.size(), " of face ", f);
      const long long n = static_cast<long long>(m_soup.points.size());
      if(v == 0 || v < -n)
        m_in.fail("face " + std::to_string(f) + " has the corner " + std::to_string(v) +
                  ", but an OBJ file counts its vertices from 1, or from -1 backwards");
      corners.push_back(static_cast<std::size_t>(v > 0 ? v - 1 : n + v));
    }
    m_soup.polygons.push_back(std::move(corners));
  }

  Text_scanner m_in;
  Polygon_soup m_soup;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OBJ_READER_H
