// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEXT_SCANNER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEXT_SCANNER_H

#include "Program_error.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace Program {

/// Reads a text line by line and word by word, and tells where it is broken. A `#` begins a comment.
///
/// What is read is named by the parts of its name, which are put together only for a message: a mesh has a number of each
/// kind for every corner.
class Text_scanner
{
public:
  /// reads `text`.
  explicit Text_scanner(std::string text)
    : m_text(std::move(text))
  {
    if(m_text.compare(0, 3, "\xEF\xBB\xBF") == 0) // the mark that some editors put before UTF-8
      m_next = 3;
  }

  Text_scanner(const Text_scanner&) = delete;
  Text_scanner& operator=(const Text_scanner&) = delete;

  /// moves to the beginning of the next line that has a word, and returns whether there is one.
  ///
  /// \throws Program_error if a byte on the way is 0
  bool next_line()
  {
    while(m_next < m_text.size())
    {
      const std::size_t begin = m_next, end = (std::min)(m_text.find('\n', begin), m_text.size());
      m_cursor = &m_text[begin];
      m_next = (std::min)(end + 1, m_text.size());
      ++m_line_number;
      const std::string_view line(m_cursor, end - begin);
      if(line.find('\0') != line.npos)
        fail("there is a byte that is no text");
      m_cursor[(std::min)(line.find('#'), line.size())] = '\0';
      if(!is_at_end_of_line())
        return true;
    }
    return false;
  }

  /// returns whether the line has no more words.
  bool is_at_end_of_line()
  {
    while(is_blank(*m_cursor))
      ++m_cursor;
    return *m_cursor == '\0';
  }

  /// returns the next word of the line, which is empty at its end, and stays before it.
  std::string_view word()
  {
    is_at_end_of_line();
    const char* end = m_cursor;
    while(!is_end_of_word(*end))
      ++end;
    return std::string_view(m_cursor, static_cast<std::size_t>(end - m_cursor));
  }

  /// returns the next word of the line, which is empty at its end.
  std::string_view read_word()
  {
    const std::string_view result = word();
    skip(result.size());
    return result;
  }

  /// moves `count` characters forward, within the line.
  void skip(std::size_t count) { m_cursor += count; }

  /// returns the next word of the line, a number.
  ///
  /// \throws Program_error if it is not
  template <class... Name>
  double read_number(const Name&... name)
  {
    if(is_at_end_of_line())
      fail(text_of(name...) + " is missing");
    char* end = m_cursor;
    const double x = std::strtod(m_cursor, &end);
    if(end == m_cursor || !is_end_of_word(*end))
      fail(text_of(name...) + " is not a number: " + quoted(m_cursor));
    m_cursor = end;
    return x;
  }

  /// returns the next word of the line, a whole number.
  ///
  /// \throws Program_error if it is not
  template <class... Name>
  long long read_integer(const Name&... name)
  {
    return read_integer_before('\0', name...);
  }

  /// returns the whole number at the beginning of the next word of the line, and skips the rest from `separator` on.
  ///
  /// \throws Program_error if there is none
  template <class... Name>
  long long read_integer_before(char separator, const Name&... name)
  {
    if(is_at_end_of_line())
      fail(text_of(name...) + " is missing");
    char* end = m_cursor;
    errno = 0;
    const long long i = std::strtoll(m_cursor, &end, 10);
    if(end == m_cursor || !(is_end_of_word(*end) || *end == separator) || errno == ERANGE)
      fail(text_of(name...) + " should be a whole number, not " + quoted(m_cursor));
    read_word();
    return i;
  }

  /// returns the next word of the line, a whole number that is not negative.
  ///
  /// \throws Program_error if it is not
  std::size_t read_count(const std::string& things)
  {
    const long long count = read_integer("the number of ", things);
    if(count < 0)
      fail("the number of " + things + " is negative");
    return static_cast<std::size_t>(count);
  }

  /// returns what follows the line.
  std::string_view rest() const { return std::string_view(m_text).substr(m_next); }

  /// throws a `Program_error` with the number of the line.
  [[noreturn]] void fail(const std::string& what) const
  {
    throw Program_error("line " + std::to_string(m_line_number) + ": " + what);
  }

  /// returns the first word of `text` for a message, as far as it can be printed.
  static std::string quoted(std::string_view text)
  {
    constexpr std::size_t longest = 20;
    std::size_t size = 0;
    while(size < (std::min)(text.size(), longest) && text[size] > ' ' && text[size] < 127)
      ++size;
    return size == 0 ? "a byte that is no text" : "'" + std::string(text.substr(0, size)) + "'";
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  static bool is_end_of_word(char c) { return c == '\0' || is_blank(c); }

  template <class... Name>
  static std::string text_of(const Name&... name)
  {
    std::ostringstream text;
    (text << ... << name);
    return text.str();
  }

  std::string m_text;
  std::size_t m_next = 0; // where the next line begins
  std::size_t m_line_number = 0;
  char* m_cursor = nullptr; // in the line, which ends with 0
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_TEXT_SCANNER_H
