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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_PLY_READER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_PLY_READER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>
#include <CGAL/Spherical_parameterization/internal/files/Polygon_soup.h>
#include <CGAL/Spherical_parameterization/internal/files/Text_scanner.h>
#include <CGAL/Spherical_parameterization/internal/files/printable_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Reads the format PLY, text or binary.
class Ply_reader
{
public:
  // \param keeps_values whether to keep the properties of vertices and faces other than coordinates and corners
  Ply_reader(Text_scanner& in, bool keeps_values)
    : m_in(in)
    , m_keeps_values(keeps_values)
  {}

  Polygon_soup operator()()
  {
    read_header();
    for(const Element& element : m_elements)
      if(element.is_vertex())
        m_number_of_vertices = element.count;
    for(Element& element : m_elements)
      read_element(element);
    for(const Element& element : m_elements)
      if(element.is_strip() && element.count > 0 && !m_soup.values_of_faces.empty())
      {
        leave_out("the properties of the faces, as those of triangle strips have none");
        m_soup.values_of_faces.clear();
      }
    return std::move(m_soup);
  }

private:
  // Transferring properties takes time that is quadratic in their number.
  static constexpr std::size_t max_properties = 4096;

  struct Type
  {
    const char* name;
    const char* name_with_size;
    File_number number; // any value of the type

    std::size_t size() const
    {
      return std::visit([](auto x) { return sizeof(x); }, number);
    }

    bool is_integer() const
    {
      return std::visit([](auto x) { return std::is_integral_v<decltype(x)>; }, number);
    }

    // Returns whether `x` is in the range of this type, after rounding.
    bool has(double x) const
    {
      return std::visit(
          [x](auto any) {
            using Limits = std::numeric_limits<decltype(any)>;
            if constexpr(Limits::is_integer)
              return x >= double((Limits::min)()) && x <= double((Limits::max)());
            else
              return !std::isfinite(x) || std::abs(x) <= double((Limits::max)());
          },
          number);
    }
  };

  static const Type& type_of(std::string_view name, const Text_scanner& in)
  {
    static constexpr std::array<Type, 8> types = {{{"char", "int8", std::int8_t()},
                                                   {"uchar", "uint8", std::uint8_t()},
                                                   {"short", "int16", std::int16_t()},
                                                   {"ushort", "uint16", std::uint16_t()},
                                                   {"int", "int32", std::int32_t()},
                                                   {"uint", "uint32", std::uint32_t()},
                                                   {"float", "float32", float()},
                                                   {"double", "float64", double()}}};
    for(const Type& type : types)
      if(name == type.name || name == type.name_with_size)
        return type;
    in.fail("the type of a property is unknown: ", Text_scanner::quoted(name));
  }

  struct Property
  {
    std::string name;
    char role; // in the mesh: a coordinate x, y, z, the corners c, those of strips s, or a blank
    const Type* type;
    const Type* size_type; // of a list, null otherwise
    bool is_kept;          // in `numbers`
    std::vector<double> numbers = {};
  };

  struct Element
  {
    std::string name, label; // the name, and its printable form
    std::size_t count;
    std::vector<Property> properties = {};
    std::set<std::string> names = {}; // of the properties

    bool is_vertex() const { return name == "vertex" || name == "vertices"; }
    bool is_face() const { return name == "face" || name == "faces"; }
    bool is_strip() const { return name == "tristrips" || name == "tristrip"; }
    bool is_of_mesh() const { return is_vertex() || is_face(); }

    char role_of(const std::string& property, bool is_list) const
    {
      if(is_list)
        return property != "vertex_indices" && property != "vertex_index" ? ' '
               : is_face()                                                ? 'c'
               : is_strip()                                               ? 's'
                                                                          : ' ';
      return is_vertex() && (property == "x" || property == "y" || property == "z") ? property[0] : ' ';
    }

    // Returns the index of the property with this role, or the number of properties.
    std::size_t find(char role) const
    {
      std::size_t k = 0;
      while(k < properties.size() && properties[k].role != role)
        ++k;
      return k;
    }
    bool has(char role) const { return find(role) < properties.size(); }
  };

  void read_header()
  {
    if(!m_in.next_line())
      throw File_error("the file is empty");
    std::string_view statement = m_in.read_word();
    if(statement != "ply")
      m_in.fail("a PLY file begins with ply, not with ", Text_scanner::quoted(statement));
    std::string format;
    while(statement != "end_header")
    {
      if(!m_in.next_line())
        throw File_error("the file ends within its header: it is truncated");
      statement = m_in.read_word();
      if(statement == "format")
      {
        format = m_in.read_word();
        if(format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
          m_in.fail("the format is ascii, binary_little_endian or binary_big_endian, not ",
                    Text_scanner::quoted(format));
      }
      else if(statement == "element")
        read_statement_of_element();
      else if(statement == "property")
        read_property();
      else if(statement != "end_header" && statement != "comment" && statement != "obj_info")
        m_in.fail("no line in the header of a PLY file begins with ", Text_scanner::quoted(statement));
    }
    if(format.empty())
      m_in.fail("the header has no line that begins with format");
    m_is_text = format == "ascii";
    m_is_big_endian = format == "binary_big_endian";
  }

  void read_statement_of_element()
  {
    const std::string name(m_in.read_word()), label = Text_scanner::quoted(name);
    const Element element = {name, label, m_in.read_count(label + " elements")};
    const auto is_of_same_kind = [&](const Element& other) {
      return other.is_vertex() == element.is_vertex() && other.is_face() == element.is_face();
    };
    if(!element.is_of_mesh() && !element.is_strip())
      leave_out("the elements '" + printable(name) + "'");
    else if(std::any_of(m_elements.begin(), m_elements.end(), is_of_same_kind))
      m_in.fail("the ", element.is_vertex() ? "vertices" : "faces", " once more");
    m_elements.push_back(element);
  }

  void read_property()
  {
    if(m_elements.empty())
      m_in.fail("a property without element");
    Element& element = m_elements.back();
    const bool is_list = m_in.word() == "list";
    const Type* size_type = nullptr;
    if(is_list)
    {
      m_in.read_word();
      size_type = &type_of(m_in.read_word(), m_in);
      if(!size_type->is_integer())
        m_in.fail("the size of a list has to be an integer");
    }
    const Type& type = type_of(m_in.read_word(), m_in);
    const std::string name(m_in.read_word());
    if(name.empty())
      m_in.fail("a property without name");
    const char role = element.role_of(name, is_list);
    const bool has_values = m_keeps_values && element.is_of_mesh() && role == ' ';
    if((role == 'c' || role == 's') && !type.is_integer())
      m_in.fail("the corners of a face have to be integers");
    const bool is_new = element.names.insert(name).second;
    if(has_values && element.names.size() > max_properties)
      m_in.fail("there are more than ", max_properties, " properties of ", element.label);
    if((role != ' ' && element.has(role)) || (has_values && !is_new))
      m_in.fail("the same property once more");
    if(has_values && is_list)
      leave_out("the list '" + printable(name) + "' of '" + printable(element.name) + "'");
    element.properties.push_back({name, role, &type, size_type, has_values && !is_list});
  }

  void leave_out(const std::string& what)
  {
    if(m_keeps_values)
      m_soup.left_out.push_back(what);
  }

  void read_element(Element& element)
  {
    const std::size_t n = element.properties.size();
    if(element.is_vertex() && !(element.has('x') && element.has('y') && element.has('z')))
      throw File_error("the vertices have no properties x, y and z that are numbers");
    if(element.is_face() && !element.has('c'))
      throw File_error("the faces have no property vertex_indices that is a list");
    if(element.is_strip() && !element.has('s'))
      throw File_error("the triangle strips have no property vertex_indices that is a list");
    if(n == 0)
      return; // which has no bytes, for any count
    std::size_t min_size = 0;
    for(const Property& p : element.properties) // in a text, a digit and a blank for each number
      min_size += m_is_text ? 2 : (p.size_type ? p.size_type : p.type)->size();
    m_in.check_count(element.count, element.label + " elements", min_size);
    if(element.is_vertex())
      m_soup.points.reserve(element.count);
    if(element.is_face())
      m_soup.polygons.reserve(element.count);
    for(Property& p : element.properties)
      if(p.is_kept)
        p.numbers.reserve(element.count);

    const std::size_t x = element.find('x'), y = element.find('y'), z = element.find('z');
    std::vector<double> row(n); // the numbers of a vertex, a face or another element
    bool has_more = false;      // numbers than declared in the header
    for(m_item = 0; m_item < element.count; ++m_item)
    {
      if(m_is_text && !m_in.next_line())
        fail_at_end(element);
      if(element.is_face())
        m_soup.polygons.emplace_back();
      for(std::size_t k = 0; k < n; ++k)
      {
        Property& p = element.properties[k];
        row[k] = read_number(element, p.size_type ? *p.size_type : *p.type);
        if(p.size_type)
          read_list(element, *p.type, row[k], p.role);
        if(!p.is_kept)
          continue;
        if(!p.type->has(row[k]))
          m_in.fail("a number of ", name_of_item(element), " is not in the range of its type: ", row[k]);
        p.numbers.push_back(row[k]);
      }
      if(m_is_text && element.is_of_mesh() && !has_more && !m_in.is_at_end_of_line())
      {
        has_more = true;
        leave_out("what the header does not declare of '" + printable(element.name) + "', as in line " +
                  std::to_string(m_in.line_number()));
      }
      if(element.is_vertex())
        m_soup.points.emplace_back(row[x], row[y], row[z]);
    }
    for(Property& p : element.properties)
      if(p.is_kept)
        (element.is_vertex() ? m_soup.values_of_vertices : m_soup.values_of_faces)
            .push_back({p.name, p.type->number, std::move(p.numbers)});
  }

  void read_list(const Element& element, const Type& type, double size, char role)
  {
    if(!(size >= 0.))
      m_in.fail(name_of_item(element), " has a list of negative length");
    Polygon strip;
    for(double i = 0.; i < size; ++i) // ends with the file at the latest
    {
      const double x = read_number(element, type);
      if(role == ' ')
        continue;
      if(role == 's' && x < 0.) // the start of another strip
      {
        strip.clear();
        continue;
      }
      if(!(x >= 0. && x < static_cast<double>(m_number_of_vertices)))
        m_in.fail(name_of_item(element), " has a corner that does not exist: there are ", m_number_of_vertices,
                  " vertices, counted from 0");
      Polygon& corners = role == 's' ? strip : m_soup.polygons.back();
      corners.push_back(static_cast<std::size_t>(x));
      if(role == 's' && strip.size() >= 3)
        add_triangle_of_strip(strip);
    }
  }

  // Every second triangle of a strip has the opposite order. If two corners coincide, the strip continues elsewhere.
  void add_triangle_of_strip(const Polygon& strip)
  {
    const std::size_t n = strip.size(), odd = n % 2 == 0 ? 1 : 0;
    const std::size_t a = strip[n - 3 + odd], b = strip[n - 2 - odd], c = strip[n - 1];
    if(a == b || b == c || c == a)
      return;
    m_soup.polygons.emplace_back();
    for(const std::size_t v : {a, b, c})
      m_soup.polygons.back().push_back(v);
  }

  double read_number(const Element& element, const Type& type)
  {
    if(m_is_text && type.is_integer())
      return static_cast<double>(m_in.read_integer("a number of ", element.label, " ", m_item));
    if(m_is_text)
      return m_in.read_number("a number of ", element.label, " ", m_item);
    return std::visit(
        [&](auto number) {
          if(!m_in.read_bytes(number, m_is_big_endian))
            fail_at_end(element);
          return static_cast<double>(number);
        },
        type.number);
  }

  [[noreturn]] void fail_at_end(const Element& element) const
  {
    throw File_error("the file ends in ", name_of_item(element), " of ", element.count,
                     ": it is truncated, or the number is wrong");
  }

  std::string name_of_item(const Element& element) const { return element.label + " " + std::to_string(m_item); }

  Text_scanner& m_in;
  bool m_keeps_values;
  bool m_is_text = true, m_is_big_endian = false;
  std::vector<Element> m_elements;
  std::size_t m_number_of_vertices = 0;
  std::size_t m_item = 0; // the index of the current element
  Polygon_soup m_soup;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_PLY_READER_H
