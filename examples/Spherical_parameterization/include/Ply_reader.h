// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PLY_READER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PLY_READER_H

#include "Binary_scanner.h"
#include "Polygon_soup.h"
#include "Program_error.h"
#include "Text_scanner.h"
#include "check_count.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Program {

/// Reads the vertices and faces of the format PLY, text or binary; everything else is skipped.
///
/// CGAL's reader crashes if a coordinate is declared as an integer or a list, believes the counts of the header and of the
/// lists however large they are, and does not say where and why a file is broken. The memory of this class is bounded by
/// the size of the file.
class Ply_reader
{
public:
  /// reads the content of a file.
  explicit Ply_reader(std::string content)
    : m_in(std::move(content))
  {}

  /// returns the mesh.
  ///
  /// \throws Program_error if the file is damaged
  Polygon_soup operator()()
  {
    read_header();
    for(const Element& element : m_elements)
      read_element(element);
    return std::move(m_soup);
  }

private:
  enum class Encoding
  {
    UNKNOWN,
    TEXT,
    LITTLE_ENDIAN_BINARY,
    BIG_ENDIAN_BINARY
  };

  enum class Type
  {
    INT8,
    UINT8,
    INT16,
    UINT16,
    INT32,
    UINT32,
    FLOAT32,
    FLOAT64
  };

  struct Type_name
  {
    const char* name;
    const char* name_with_size;
    std::size_t size;
  };

  // in the order of the enumeration
  static constexpr std::array<Type_name, 8> type_names = {{{"char", "int8", 1},
                                                           {"uchar", "uint8", 1},
                                                           {"short", "int16", 2},
                                                           {"ushort", "uint16", 2},
                                                           {"int", "int32", 4},
                                                           {"uint", "uint32", 4},
                                                           {"float", "float32", 4},
                                                           {"double", "float64", 8}}};

  // What a property is to the mesh: nothing, a coordinate of a vertex, or the corners of a face.
  enum class Role
  {
    NONE,
    X,
    Y,
    Z,
    CORNERS
  };

  struct Property
  {
    Role role;
    bool is_list;
    Type type_of_size; // of a list
    Type type;
  };

  struct Element
  {
    std::string name;
    std::string label; // the name as it is printed
    std::size_t count;
    std::vector<Property> properties;

    bool is_vertex() const { return name == "vertex" || name == "vertices"; }
    bool is_face() const { return name == "face" || name == "faces"; }
    bool has(Role role) const
    {
      return std::any_of(properties.begin(), properties.end(), [role](const Property& p) { return p.role == role; });
    }
  };

  static bool is_integer(Type type) { return type != Type::FLOAT32 && type != Type::FLOAT64; }
  static std::size_t size_of(Type type) { return type_names[static_cast<std::size_t>(type)].size; }

  void read_header()
  {
    if(!m_in.next_line())
      throw Program_error("the file is empty");
    std::string_view statement = m_in.read_word();
    if(statement != "ply")
      m_in.fail("a PLY file begins with ply, not with " + Text_scanner::quoted(statement));
    while(statement != "end_header")
    {
      if(!m_in.next_line())
        throw Program_error("the file ends within its header: it is truncated");
      statement = m_in.read_word();
      if(statement == "format")
        read_format();
      else if(statement == "element")
        read_element_declaration();
      else if(statement == "property")
        read_property_declaration();
      else if(statement != "end_header" && statement != "comment" && statement != "obj_info")
        m_in.fail("no line in the header of a PLY file begins with " + Text_scanner::quoted(statement));
    }
    if(m_encoding == Encoding::UNKNOWN)
      m_in.fail("the header has no line that begins with format");
    for(const Element& element : m_elements)
      if(element.is_vertex())
        m_number_of_vertices += element.count;
    m_bytes = Binary_scanner(m_in.rest(), m_encoding == Encoding::BIG_ENDIAN_BINARY);
  }

  void read_format()
  {
    const std::string_view format = m_in.read_word();
    if(format == "ascii")
      m_encoding = Encoding::TEXT;
    else if(format == "binary_little_endian")
      m_encoding = Encoding::LITTLE_ENDIAN_BINARY;
    else if(format == "binary_big_endian")
      m_encoding = Encoding::BIG_ENDIAN_BINARY;
    else
      m_in.fail("the format is ascii, binary_little_endian or binary_big_endian, not " + Text_scanner::quoted(format));
  }

  void read_element_declaration()
  {
    const std::string name(m_in.read_word());
    m_elements.push_back(
        {name, Text_scanner::quoted(name), m_in.read_count(Text_scanner::quoted(name) + " elements"), {}});
  }

  void read_property_declaration()
  {
    if(m_elements.empty())
      m_in.fail("a property without element");
    Element& element = m_elements.back();
    Property property{Role::NONE, false, Type::UINT8, Type::UINT8};
    std::string_view word = m_in.read_word();
    if(word == "list")
    {
      property.is_list = true;
      property.type_of_size = type_of(m_in.read_word());
      if(!is_integer(property.type_of_size))
        m_in.fail("the size of a list has to be a whole number");
      word = m_in.read_word();
    }
    property.type = type_of(word);
    property.role = role_of(m_in.read_word(), element, property.is_list);
    if(property.role == Role::CORNERS && !is_integer(property.type))
      m_in.fail("the corners of a face have to be whole numbers");
    if(property.role != Role::NONE && element.has(property.role))
      m_in.fail("the same property once more");
    element.properties.push_back(property);
  }

  Type type_of(std::string_view name) const
  {
    for(std::size_t i = 0; i < type_names.size(); ++i)
      if(name == type_names[i].name || name == type_names[i].name_with_size)
        return static_cast<Type>(i);
    m_in.fail("the type of a property is unknown: " + Text_scanner::quoted(name));
  }

  static Role role_of(std::string_view name, const Element& element, bool is_list)
  {
    if(element.is_face() && is_list && (name == "vertex_indices" || name == "vertex_index"))
      return Role::CORNERS;
    if(!element.is_vertex() || is_list)
      return Role::NONE;
    return name == "x" ? Role::X : name == "y" ? Role::Y : name == "z" ? Role::Z : Role::NONE;
  }

  bool is_text() const { return m_encoding == Encoding::TEXT; }

  // the bytes that an element takes at least; in a text, a digit and a blank for each number
  std::size_t smallest_size(const Element& element) const
  {
    std::size_t size = 0;
    for(const Property& p : element.properties)
      size += is_text() ? 2 : size_of(p.is_list ? p.type_of_size : p.type);
    return size;
  }

  std::size_t size_of_rest() const { return is_text() ? m_in.rest().size() + 1 : m_bytes.size(); }

  void read_element(const Element& element)
  {
    if(element.is_vertex() && !(element.has(Role::X) && element.has(Role::Y) && element.has(Role::Z)))
      throw Program_error("the vertices have no properties x, y and z that are numbers");
    if(element.is_face() && !element.has(Role::CORNERS))
      throw Program_error("the faces have no property vertex_indices that is a list");
    if(element.properties.empty())
      return; // which takes no bytes, however many there are
    check_count(element.count, element.label + " elements", size_of_rest(), smallest_size(element));
    if(element.is_vertex())
      m_soup.points.reserve(m_soup.points.size() + element.count);
    if(element.is_face())
      m_soup.polygons.reserve(m_soup.polygons.size() + element.count);

    std::array<double, 3> point{};
    std::vector<std::size_t> corners;
    for(m_item = 0; m_item < element.count; ++m_item)
    {
      if(is_text() && !m_in.next_line())
        fail_at_end(element);
      for(const Property& p : element.properties)
      {
        if(p.is_list)
          read_list(element, p, corners);
        else
        {
          const double x = read_number(element, p.type);
          if(p.role != Role::NONE)
            point[static_cast<std::size_t>(p.role) - static_cast<std::size_t>(Role::X)] = x;
        }
      }
      if(element.is_vertex())
        m_soup.points.emplace_back(point[0], point[1], point[2]);
      if(element.is_face())
        m_soup.polygons.push_back(corners);
    }
  }

  void read_list(const Element& element, const Property& property, std::vector<std::size_t>& corners)
  {
    const double size = read_number(element, property.type_of_size);
    if(!(size >= 0.))
      fail(element, "has a list of negative length");
    if(property.role == Role::CORNERS)
      corners.clear();
    for(double i = 0.; i < size; ++i) // ends with the file at the latest
    {
      const double x = read_number(element, property.type);
      if(property.role == Role::CORNERS)
      {
        if(!(x >= 0. && x < static_cast<double>(m_number_of_vertices)))
          fail(element, "has a corner that does not exist: there are " + std::to_string(m_number_of_vertices) +
                            " vertices, counted from 0");
        corners.push_back(static_cast<std::size_t>(x));
      }
    }
  }

  // Every type of the format fits into a double.
  double read_number(const Element& element, Type type)
  {
    if(is_text() && is_integer(type))
      return static_cast<double>(m_in.read_integer("a number of ", element.label, " ", m_item));
    if(is_text())
      return m_in.read_number("a number of ", element.label, " ", m_item);
    switch(type)
    {
    case Type::INT8:
      return read_binary<std::int8_t>(element);
    case Type::UINT8:
      return read_binary<std::uint8_t>(element);
    case Type::INT16:
      return read_binary<std::int16_t>(element);
    case Type::UINT16:
      return read_binary<std::uint16_t>(element);
    case Type::INT32:
      return read_binary<std::int32_t>(element);
    case Type::UINT32:
      return read_binary<std::uint32_t>(element);
    case Type::FLOAT32:
      return static_cast<double>(read_binary<float>(element));
    case Type::FLOAT64:
      break;
    }
    return read_binary<double>(element);
  }

  template <class Number>
  Number read_binary(const Element& element)
  {
    Number x{};
    if(!m_bytes.read(x))
      fail_at_end(element);
    return x;
  }

  [[noreturn]] void fail_at_end(const Element& element) const
  {
    throw Program_error("the file ends in " + name_of_item(element) + " of " + std::to_string(element.count) +
                        ": it is truncated, or the number is wrong");
  }

  [[noreturn]] void fail(const Element& element, const std::string& what) const
  {
    throw Program_error(name_of_item(element) + " " + what);
  }

  std::string name_of_item(const Element& element) const { return element.label + " " + std::to_string(m_item); }

  Text_scanner m_in;
  Binary_scanner m_bytes{{}, false};
  Encoding m_encoding = Encoding::UNKNOWN;
  std::vector<Element> m_elements;
  std::size_t m_number_of_vertices = 0;
  std::size_t m_item = 0; // the number of the element that is read
  Polygon_soup m_soup;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PLY_READER_H
