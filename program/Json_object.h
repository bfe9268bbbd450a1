#ifndef PROGRAM_JSON_OBJECT_H
#define PROGRAM_JSON_OBJECT_H

#include "text.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

namespace Program {

/// A JSON object that is put together member by member. (Boost.PropertyTree, which reads it, would write all numbers as
/// texts.)
class Json_object
{
public:
  template <class Value>
  Json_object& add(const std::string& name, const Value& value)
  {
    m_members += (m_members.empty() ? "\n" : ",\n") + quote(name) + ": " + text_of(value);
    return *this;
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
  static std::string text_of(const std::string& value) { return quote(value); }
  static std::string text_of(const char* value) { return quote(value); }
  static std::string text_of(bool value) { return value ? "true" : "false"; }
  static std::string text_of(const Json_object& value) { return value.text(); }

  // 17 digits, or null for what JSON has no words for
  static std::string text_of(double value)
  {
    constexpr int max_size = 32;
    char digits[max_size];
    std::snprintf(digits, sizeof digits, "%.17g", value);
    return std::isfinite(value) ? digits : "null";
  }

  template <class Count>
  static std::enable_if_t<std::is_unsigned<Count>::value, std::string> text_of(Count value)
  {
    return std::to_string(value);
  }

  template <std::size_t n>
  static std::string text_of(const std::array<double, n>& values)
  {
    return list_of(values, ", ", "");
  }

  template <class Value>
  static std::string text_of(const std::vector<Value>& values)
  {
    return list_of(values, ", ", "");
  }

  // a row on each line
  static std::string text_of(const std::vector<std::array<double, 3>>& rows)
  {
    return rows.empty() ? "[]" : list_of(rows, ",\n  ", "\n");
  }

  template <class Range>
  static std::string list_of(const Range& values, const std::string& separator, const std::string& end)
  {
    std::string list;
    for(const auto& value : values)
      list += (list.empty() ? end + (end.empty() ? "" : "  ") : separator) + text_of(value);
    return "[" + list + end + "]";
  }

  static std::string quote(const std::string& text)
  {
    std::string result = "\"";
    for(const char c : valid_utf8(text))
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

#endif // PROGRAM_JSON_OBJECT_H
