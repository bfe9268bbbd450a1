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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_TEXT_SCANNER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_TEXT_SCANNER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>
#include <CGAL/Spherical_parameterization/internal/files/Polygon_soup.h>
#include <CGAL/Spherical_parameterization/internal/files/parse_number.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Reads the content of a file, as lines of words or as bytes, and reports damage, for all readers. Their memory is
// bounded by the size of the file, whatever numbers it contains.
//
// In a text, `#` starts a comment. All lines end like the first one, with a line feed or with a carriage return alone.
// Items are identified by the parts of their names, which are joined only for a message.
class Text_scanner
{
public:
  // \param joins_lines whether a backslash at the end of a line joins it with the next one
  explicit Text_scanner(std::string content, bool joins_lines = false)
    : m_content(std::move(content))
    , m_joins_lines(joins_lines)
  {
    const std::size_t end = m_content.find_first_of("\r\n");
    if(end != m_content.npos && m_content[end] == '\r' && m_content.compare(end, 2, "\r\n") != 0)
      m_has_line_feeds = false;
    if(m_content.compare(0, 3, "\xEF\xBB\xBF") == 0) // the byte order mark of UTF-8
      m_next = 3;
  }

  // Moves to the beginning of the next line that has a word, and returns whether there is one.
  bool next_line()
  {
    while(m_next < m_content.size())
    {
      std::string_view line = rest().substr(0, size_of_line(m_next));
      m_cursor = &m_content[m_next];
      m_line_number += m_number_of_joined_lines + 1;
      m_number_of_joined_lines = 0;
      while(m_joins_lines && is_joined(line.size()))
      {
        line = rest().substr(0, line.size() + 1 + size_of_line(m_next + line.size() + 1));
        ++m_number_of_joined_lines;
      }
      m_next = (std::min)(m_next + line.size() + 1, m_content.size());
      m_byte = 0;
      if(line.find('\0') != line.npos)
        fail("there is a byte that is no text");
      m_end = m_cursor + (std::min)(line.find('#'), line.size());
      *m_end = '\0';
      if(!is_at_end_of_line())
        return true;
    }
    return false;
  }

  std::size_t line_number() const { return m_line_number; }

  bool is_at_end_of_line()
  {
    while(is_blank(*m_cursor))
      ++m_cursor;
    return *m_cursor == '\0';
  }

  // Returns the next word of the line, which is empty at its end, without moving.
  std::string_view word()
  {
    is_at_end_of_line();
    const char* end = m_cursor;
    while(!is_end_of_word(*end))
      ++end;
    return std::string_view(m_cursor, static_cast<std::size_t>(end - m_cursor));
  }

  // Returns the next word of the line, which is empty at its end.
  std::string_view read_word()
  {
    const std::string_view result = word();
    skip(result.size());
    return result;
  }

  // Moves `count` characters forward, within the line.
  void skip(std::size_t count) { m_cursor += count; }

  template <class... Name>
  double read_number(const Name&... name)
  {
    if(is_at_end_of_line())
      fail(name..., " is missing");
    const Parsed_number<double> number = parse_number(rest_of_line());
    if(number.size == 0 || !is_end_of_word(m_cursor[number.size]))
      fail(name..., " is not a number: ", quoted(m_cursor));
    if(number.is_too_large)
      fail(name..., " is too large, beyond 1.8e308: ", quoted(m_cursor));
    skip(number.size);
    return number.value;
  }

  template <class... Name>
  Simple_cartesian<double>::Point_3 read_point(const Name&... name)
  {
    const double x = read_number("coordinate x of ", name...);
    const double y = read_number("coordinate y of ", name...);
    return Simple_cartesian<double>::Point_3(x, y, read_number("coordinate z of ", name...));
  }

  template <class... Name>
  long long read_integer(const Name&... name)
  {
    return read_integer_before('\0', name...);
  }

  // Returns the integer at the beginning of the next word, and skips the rest of the word, which must be empty or start
  // with `separator`.
  template <class... Name>
  long long read_integer_before(char separator, const Name&... name)
  {
    if(is_at_end_of_line())
      fail(name..., " is missing");
    const Parsed_number<long long> number = parse_integer(rest_of_line());
    const char behind = m_cursor[number.size];
    if(number.size == 0 || !(is_end_of_word(behind) || behind == separator) || number.is_too_large)
      fail(name..., " should be an integer, not ", quoted(m_cursor));
    read_word();
    return number.value;
  }

  std::size_t read_count(const std::string& things)
  {
    const long long count = read_integer("the number of ", things);
    if(count < 0)
      fail("the number of ", things, " is negative");
    return static_cast<std::size_t>(count);
  }

  // Checks that the rest of the file is large enough for `count` items of `min_size` bytes each.
  void check_count(std::size_t count, const std::string& things, std::size_t min_size) const
  {
    if(count > (rest().size() + 1) / min_size) // the last line may lack its end
      throw File_error("the file is too short for ", count, " ", things, ": it is truncated, or the number is wrong");
  }

  // Reads a number from the bytes after the line, and returns whether there are enough of them.
  template <class Number>
  bool read_bytes(Number& number, bool is_big_endian = false)
  {
    if(rest().size() < sizeof(Number))
      return false;
    std::memcpy(&number, rest().data(), sizeof(Number));
    convert_bytes(number, is_big_endian);
    m_byte = m_next;
    m_next += sizeof(Number);
    return true;
  }

  void skip_bytes(std::size_t count) { m_next += count; }

  // Returns the data after the line.
  std::string_view rest() const { return std::string_view(m_content).substr(m_next); }

  // Throws a `File_error` with the number of the line, or of the first byte of the last number, counted from 0.
  template <class... What>
  [[noreturn]] void fail(const What&... what) const
  {
    throw File_error(m_byte == 0 ? "line " : "byte ", m_byte == 0 ? m_line_number : m_byte, ": ", what...);
  }

  // Returns the first word of `text` for a message, as far as it is printable.
  static std::string quoted(std::string_view text)
  {
    constexpr std::size_t max_size = 20;
    std::size_t size = 0;
    while(size < (std::min)(text.size(), max_size) && text[size] > ' ' && text[size] < 127)
      ++size;
    return size == 0 ? "a byte that is no text" : "'" + std::string(text.substr(0, size)) + "'";
  }

private:
  std::size_t size_of_line(std::size_t begin) const
  {
    const std::size_t end = m_has_line_feeds ? m_content.find('\n', begin) : m_content.find_first_of("\r\n", begin);
    return (std::min)(end, m_content.size()) - begin;
  }

  // Returns whether a backslash joins the line that begins at `m_next` with another one; replaces the backslash and the
  // end of the line by blanks.
  bool is_joined(std::size_t size)
  {
    const std::size_t end = m_next + size, carriage_return = size > 0 && m_content[end - 1] == '\r' ? 1 : 0;
    if(end + 1 >= m_content.size() || size < 1 + carriage_return || m_content[end - 1 - carriage_return] != '\\')
      return false;
    m_content[end - 1 - carriage_return] = m_content[end] = ' ';
    return true;
  }

  std::string_view rest_of_line() const
  {
    return std::string_view(m_cursor, static_cast<std::size_t>(m_end - m_cursor));
  }

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  static bool is_end_of_word(char c) { return c == '\0' || is_blank(c); }

  std::string m_content;
  bool m_joins_lines, m_has_line_feeds = true;
  std::size_t m_next = 0; // the beginning of the next line
  std::size_t m_line_number = 0;
  std::size_t m_number_of_joined_lines = 0; // after the line of this number
  std::size_t m_byte = 0;                   // the start of the last number read as bytes, 0 if the last item was a line
  char* m_cursor = nullptr;                 // in the line, which ends with 0
  char* m_end = nullptr;                    // the end of the line
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_TEXT_SCANNER_H
