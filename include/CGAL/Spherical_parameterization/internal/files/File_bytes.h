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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_FILE_BYTES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_FILE_BYTES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/files/parse_number.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ios>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// An error of a file: what is wrong, where, and a remedy.
class File_error : public std::runtime_error
{
public:
  template <class... Part>
  explicit File_error(const Part&... parts)
    : std::runtime_error(join(parts...))
  {}

  template <class... Part>
  static std::string join(const Part&... parts)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(std::numeric_limits<std::int32_t>::digits10 + 1); // so that 32-bit integers have all digits
    (text << ... << parts);
    return text.str();
  }
};

// Returns the content of a stream.
inline std::string read_all(std::istream& in)
{
  std::string content;
  std::array<char, 1 << 16> block;
  try
  {
    while(in.read(block.data(), block.size()) || in.gcount() > 0)
      content.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  catch(const std::ios_base::failure&) // at the end, if the stream has exceptions enabled
  {
    content.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  if(in.bad())
    throw File_error("The file cannot be read to its end: check the disk or the network that it is on.");
  return content;
}

// Calls read(content, result, message) with the content of a file, which fills `result` or throws a `File_error`. The
// text of the error becomes `message`.
template <class Result, class Read>
Error_code read_or_report(std::istream& in, Result& result, std::string& message, const Read& read,
                          Error_code error_code = ERROR_INVALID_SURFACE_FILE)
{
  message.clear();
  try
  {
    Result all;
    read(read_all(in), all, message);
    result = std::move(all);
    return OK;
  }
  catch(const File_error& error)
  {
    message = error.what();
    return error_code;
  }
}

// Returns a word of a file for a message, as far as it is printable.
inline std::string in_quotes(std::string_view text)
{
  constexpr std::size_t max_size = 40;
  std::string result = "'";
  for(const char c : text.substr(0, max_size))
    result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > max_size ? "...'" : "'");
}

// Returns a text with its ASCII letters in lower case.
inline std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

constexpr const char* truncated = "it is truncated: copy it again from where it is from.";

// Converts the bytes of a number between a given byte order and that of this machine.
template <class Number>
void convert_bytes(Number& number, bool is_big_endian)
{
  char* const bytes = reinterpret_cast<char*>(&number);
  if(is_big_endian != (boost::endian::order::native == boost::endian::order::big))
    std::reverse(bytes, bytes + sizeof(Number));
}

// Reads binary numbers, in big-endian order unless `is_big_endian` is false, and reports where the data end.
class Byte_reader
{
public:
  explicit Byte_reader(std::string_view bytes, bool is_big_endian = true)
    : m_bytes(bytes)
    , m_is_big_endian(is_big_endian)
  {}

  std::size_t position() const { return m_position; }
  std::size_t remaining() const { return m_bytes.size() - m_position; }
  std::string_view rest() const { return m_bytes.substr(m_position); }

  template <class Number>
  Number read(const char* what)
  {
    Number number;
    std::memcpy(&number, read_bytes(sizeof(Number), what).data(), sizeof(Number));
    convert_bytes(number, m_is_big_endian);
    return number;
  }

  // An unsigned number of three bytes.
  std::uint32_t read_3_bytes(const char* what)
  {
    std::uint32_t number = 0;
    for(const char c : read_bytes(3, what))
      number = number << 8 | static_cast<unsigned char>(c);
    return number;
  }

  std::string_view read_bytes(std::size_t size, const char* what)
  {
    if(size > remaining())
      throw File_error("The file ends within ", what, ", at byte ", m_bytes.size(), ": ", truncated);
    m_position += size;
    return m_bytes.substr(m_position - size, size);
  }

  // A text preceded by its length in bytes, without trailing zeros.
  std::string read_text(const char* what)
  {
    const std::size_t begin = m_position;
    const auto size = read<std::int32_t>(what);
    if(size < 0 || static_cast<std::size_t>(size) > remaining())
      throw File_error("Byte ", begin, ": ", what, " has ", size, " bytes, but ", remaining(),
                       " follow: the file is truncated, or damaged. Copy it again from where it is from.");
    const std::string_view text = read_bytes(static_cast<std::size_t>(size), what);
    return std::string(text.substr(0, (std::min)(text.find('\0'), text.size())));
  }

  // The number of items of at least the given number of bytes each.
  std::size_t read_count(const char* things, std::size_t min_size)
  {
    const std::size_t begin = m_position;
    const auto count = read<std::int32_t>(things);
    check_count(count, things, min_size, begin);
    return static_cast<std::size_t>(count);
  }

  void check_count(std::int64_t count, const char* things, std::size_t min_size, std::size_t begin) const
  {
    if(count < 0)
      throw File_error("Byte ", begin, ": the number of ", things, " is negative, ", count,
                       ": the file is damaged, or of another kind.");
    if(static_cast<std::uint64_t>(count) > remaining() / min_size)
      throw File_error("Byte ", begin, ": the file is too short for ", count, " ", things,
                       ": it is truncated, or damaged. Copy it again from where it is from.");
  }

private:
  std::string_view m_bytes;
  std::size_t m_position = 0;
  bool m_is_big_endian;
};

// Returns whether a number is in the range of float. Numbers that are not finite are.
inline bool is_in_float_range(double x)
{
  return !std::isfinite(x) || std::abs(x) <= static_cast<double>((std::numeric_limits<float>::max)());
}

// Writes binary numbers.
class Byte_writer
{
public:
  explicit Byte_writer(bool is_big_endian = true)
    : m_is_big_endian(is_big_endian)
  {}

  template <class Number>
  void write(Number number)
  {
    convert_bytes(number, m_is_big_endian);
    content.append(reinterpret_cast<const char*>(&number), sizeof(Number));
  }

  // A text preceded by its length in bytes, with a trailing zero.
  void write_text(const std::string& text)
  {
    write(static_cast<std::int32_t>(text.size() + 1));
    content.append(text.c_str(), text.size() + 1);
  }

  std::string content;

private:
  bool m_is_big_endian;
};

// Returns whether the bytes were written to the stream.
inline bool is_written(std::ostream& out, const std::string& bytes)
{
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return out.good();
}

// Reads numbers from words separated by blanks, independently of the locale of the program.
class Number_text
{
public:
  explicit Number_text(std::string_view text)
    : m_text(text)
  {}

  std::string_view next_word()
  {
    constexpr const char* blanks = " \t\r\n";
    const std::size_t begin = (std::min)(m_text.find_first_not_of(blanks, m_position), m_text.size());
    m_position = (std::min)(m_text.find_first_of(blanks, begin), m_text.size());
    return m_text.substr(begin, m_position - begin);
  }

  // Returns whether the word is a decimal number, including nan and inf.
  static bool is_number(std::string_view word, double& x)
  {
    const Parsed_number<double> number = parse_number(word);
    x = number.value;
    return !word.empty() && number.size == word.size() && !number.is_too_large &&
           word.find_first_of("xX( \t\n\v\f\r") == word.npos;
  }

private:
  std::string_view m_text;
  std::size_t m_position = 0;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_FILE_BYTES_H
