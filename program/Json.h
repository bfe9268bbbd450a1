#ifndef PROGRAM_JSON_H
#define PROGRAM_JSON_H

#include "text.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <type_traits>
#include <utility>

namespace Program {

/// A JSON value; objects are composed member by member. (Boost.PropertyTree would write all numbers as texts.)
class Json
{
public:
  /// constructs an object.
  Json() = default;
  Json(std::initializer_list<std::pair<std::string, Json>> members)
  {
    for(const auto& [name, value] : members)
      add(name, value);
  }

  Json(const std::string& value)
    : m_value(quoted(value))
  {}
  Json(const char* value)
    : m_value(quoted(value))
  {}
  Json(bool value)
    : m_value(value ? "true" : "false")
  {}

  /// constructs a number with 17 digits, or null for infinite values and NaN.
  Json(double value)
  {
    constexpr int digits = 17;
    m_value = std::isfinite(value) ? fixed_text(value, digits, false) : "null";
  }

  template <class Count, class = std::enable_if_t<std::is_unsigned<Count>::value>>
  Json(Count value)
    : m_value(std::to_string(value))
  {}

  template <std::size_t n>
  Json(const std::array<double, n>& values)
    : m_value(list_of(values, ", ", ""))
  {}

  template <class Value>
  Json(const std::vector<Value>& values)
    : m_value(list_of(values, ", ", ""))
  {}

  /// constructs an array of rows, one per line.
  Json(const std::vector<std::array<double, 3>>& rows)
    : m_value(rows.empty() ? "[]" : list_of(rows, ",\n  ", "\n"))
  {}

  /// adds a member to an object.
  Json& add(const std::string& name, const Json& value)
  {
    m_members += (m_members.empty() ? "\n" : ",\n") + quoted(name) + ": " + value.text();
    return *this;
  }

  std::string text() const
  {
    if(!m_value.empty())
      return m_value;
    std::string result = "{";
    for(const char c : m_members) // indented here, so that an object need not know its depth
      result += c == '\n' ? std::string("\n  ") : std::string(1, c);
    return result + "\n}";
  }

private:
  template <class Range>
  static std::string list_of(const Range& values, const std::string& separator, const std::string& end)
  {
    std::string list;
    for(const auto& value : values)
      list += (list.empty() ? end + (end.empty() ? "" : "  ") : separator) + Json(value).text();
    return "[" + list + end + "]";
  }

  static std::string quoted(const std::string& text)
  {
    std::string result = "\"";
    for(const char c : valid_utf8(text))
    {
      std::array<char, 8> escape = {c, '\0'};
      if(c == '"' || c == '\\')
        std::snprintf(escape.data(), escape.size(), "\\%c", c);
      else if(static_cast<unsigned char>(c) < 0x20)
        std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned int>(c));
      result += escape.data();
    }
    return result + "\"";
  }

  std::string m_members; // of an object
  std::string m_value;   // of other values
};

} // namespace Program

#endif // PROGRAM_JSON_H
