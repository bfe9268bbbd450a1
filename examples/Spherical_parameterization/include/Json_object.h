// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_JSON_OBJECT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_JSON_OBJECT_H

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace Program {

/// A JSON object that is put together member by member.
class Json_object
{
public:
  Json_object& add(const char* name, const std::string& value) { return add_text(name, quote(value)); }
  Json_object& add(const char* name, const char* value) { return add_text(name, quote(value)); }
  Json_object& add(const char* name, bool value) { return add_text(name, value ? "true" : "false"); }
  Json_object& add(const char* name, std::size_t value) { return add_text(name, std::to_string(value)); }
  Json_object& add(const char* name, const Json_object& value) { return add_text(name, value.text()); }

  /// adds a number with 17 digits, or null if it is infinite or not a number, which JSON has no words for.
  Json_object& add(const char* name, double value) { return add_text(name, number(value)); }

  Json_object& add(const char* name, const std::vector<std::string>& values)
  {
    std::string list;
    for(const std::string& value : values)
      list += (list.empty() ? "" : ", ") + quote(value);
    return add_text(name, "[" + list + "]");
  }

  /// adds an array of rows, each an array of numbers.
  template <std::size_t n>
  Json_object& add(const char* name, const std::vector<std::array<double, n>>& rows)
  {
    std::string list;
    for(const std::array<double, n>& row : rows)
    {
      std::string numbers;
      for(const double value : row)
        numbers += (numbers.empty() ? "" : ", ") + number(value);
      list += (list.empty() ? "\n  [" : ",\n  [") + numbers + "]";
    }
    return add_text(name, "[" + list + (list.empty() ? "]" : "\n]"));
  }

  std::string text() const
  {
    // indented here, so that an object need not know how deep it is
    std::string result = "{";
    for(const char c : m_members)
      result += c == '\n' ? std::string("\n  ") : std::string(1, c);
    return result + "\n}";
  }

private:
  Json_object& add_text(const char* name, const std::string& value)
  {
    m_members += (m_members.empty() ? "\n" : ",\n") + quote(name) + ": " + value;
    return *this;
  }

  static std::string number(double value)
  {
    constexpr int most_characters = 32;
    char digits[most_characters];
    std::snprintf(digits, sizeof digits, "%.17g", value);
    return std::isfinite(value) ? digits : "null";
  }

  static std::string quote(const std::string& text)
  {
    std::string result = "\"";
    for(const char c : text)
    {
      char escape[8] = {c, '\0'};
      if(c == '"' || c == '\\')
        std::snprintf(escape, sizeof escape, "\\%c", c);
      else if(static_cast<unsigned char>(c) < 0x20)
        std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned int>(static_cast<unsigned char>(c)));
      result += escape;
    }
    return result + "\"";
  }

  std::string m_members;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_JSON_OBJECT_H
