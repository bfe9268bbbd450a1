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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_GIFTI_DATA_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_GIFTI_DATA_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/Zlib.h>
#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// The base 64 digit of each character, or 64.
inline std::array<std::uint8_t, 256> digits_of_characters()
{
  std::array<std::uint8_t, 256> result;
  result.fill(64);
  for(std::size_t k = 0; k < base64_digits.size(); ++k)
    result[static_cast<unsigned char>(base64_digits[k])] = static_cast<std::uint8_t>(k);
  return result;
}

// Decodes a text in base 64; blanks and line ends are skipped.
inline std::string from_base64(std::string_view text)
{
  constexpr std::uint32_t bits_of_digit = 6, bits_of_byte = 8;
  static const std::array<std::uint8_t, 256> digits = digits_of_characters();
  std::string result;
  result.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0, n_bits = 0;
  std::size_t n_digits = 0, n_padding = 0;
  for(const char c : text)
  {
    if(c == ' ' || c == '\t' || c == '\r' || c == '\n')
      continue;
    const std::uint32_t digit = digits[static_cast<unsigned char>(c)];
    if(c == '=')
      ++n_padding;
    else if(digit == 64 || n_padding > 0)
      throw File_error("the data have ", in_quotes(std::string(1, c)),
                       " where a digit of base 64 is expected: the file is damaged.");
    else
    {
      ++n_digits;
      bits = bits << bits_of_digit | digit;
      n_bits += bits_of_digit;
      if(n_bits >= bits_of_byte)
      {
        n_bits -= bits_of_byte;
        result += static_cast<char>(bits >> n_bits & 0xFF);
      }
    }
  }
  if(n_digits % 4 == 1 || n_padding > 2 || (n_digits + n_padding) % 4 != 0)
    throw File_error("the data in base 64 end too early: ", truncated);
  return result;
}

inline std::string to_base64(std::string_view bytes)
{
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for(std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t bits = 0;
    for(std::size_t k = i; k < i + 3; ++k)
      bits = bits << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0);
    for(std::size_t k = 0; k < 4; ++k)
      result += i + k > bytes.size() ? '=' : base64_digits[bits >> (18 - 6 * k) & 63];
  }
  return result;
}

// An array of a GIFTI file, as described by its attributes.
struct Gifti_array
{
  std::string intent, type, order, encoding, endian;
  std::vector<std::uint64_t> dimensions;
  IO::Metadata metadata;
  std::vector<IO::Coordinate_system> systems;
  std::size_t line; // in the file
  bool has_data = false;

  static constexpr std::uint64_t max_size = std::uint64_t(1) << 40;

  std::size_t rows() const { return static_cast<std::size_t>(dimensions[0]); }
  std::size_t columns() const { return static_cast<std::size_t>(dimensions.size() > 1 ? dimensions[1] : 1); }
};

// Decodes the text of an array to its numbers, by rows. The size of the file bounds the total size of all arrays.
class Gifti_data
{
public:
  Gifti_data(const Gifti_array& array, std::size_t file_size, std::size_t& unpacked_size)
    : m_array(array)
    , m_file_size(file_size)
    , m_unpacked_size(unpacked_size)
  {}

  std::vector<double> operator()(const std::string& text)
  {
    const auto is = [this](const char* type) { return m_array.type == "NIFTI_TYPE_" + std::string(type); };
    if(is("UINT8"))
      return decode<std::uint8_t>(text);
    if(is("INT8"))
      return decode<std::int8_t>(text);
    if(is("INT16"))
      return decode<std::int16_t>(text);
    if(is("UINT16"))
      return decode<std::uint16_t>(text);
    if(is("INT32"))
      return decode<std::int32_t>(text);
    if(is("FLOAT32"))
      return decode<float>(text);
    if(is("FLOAT64"))
      return decode<double>(text);
    throw File_error("the type ", in_quotes(m_array.type),
                     " is not read: write the numbers as NIFTI_TYPE_UINT8, NIFTI_TYPE_INT32 or NIFTI_TYPE_FLOAT32.");
  }

private:
  template <class Number>
  std::vector<double> decode(const std::string& text)
  {
    const std::size_t n = m_array.rows() * m_array.columns(), size = n * sizeof(Number);
    const auto check_size = [&](std::size_t found) {
      if(found != size)
        throw File_error("the data are ", found > size ? "more than " : "", (std::min)(found, size),
                         " bytes, but the dimensions say ", size, ": the file is damaged.");
    };
    std::vector<double> numbers;
    if(m_array.encoding == "ASCII")
      numbers = read_text<Number>(text, n);
    else if(m_array.encoding == "Base64Binary" || m_array.encoding == "GIFTI_ENCODING_B64BIN")
    {
      const std::string bytes = from_base64(text);
      check_size(bytes.size());
      add_numbers(n);
      numbers = read_binary<Number>(bytes, n);
    }
    else if(m_array.encoding == "GZipBase64Binary" || m_array.encoding == "GIFTI_ENCODING_B64GZ")
    {
      const std::string packed = from_base64(text);
      add_numbers(n);
      const std::string bytes = unpack(packed, size, false);
      check_size(bytes.size());
      numbers = read_binary<Number>(bytes, n);
    }
    else if(m_array.encoding == "ExternalFileBinary")
      throw File_error("the data are in another file (ExternalFileBinary), which is not read: convert the file, for "
                       "example with wb_command -gifti-convert GZIP_BASE64_BINARY.");
    else
      throw File_error("the encoding ", in_quotes(m_array.encoding),
                       " is unknown: it is ASCII, Base64Binary or GZipBase64Binary.");
    const bool is_by_column = is_second(m_array.order, "RowMajorOrder", "ColumnMajorOrder");
    return is_by_column && m_array.columns() > 1 ? transposed(numbers) : numbers;
  }

  void add_numbers(std::size_t n)
  {
    m_unpacked_size += n * sizeof(double);
    check_unpacked_size(m_unpacked_size, m_file_size);
  }

  // whether an attribute with two possible values has the second one
  static bool is_second(const std::string& value, const std::string& first, const std::string& second)
  {
    if(value != first && value != second)
      throw File_error("an order is ", in_quotes(value), ", not ", first, " or ", second, ": the file is damaged.");
    return value == second;
  }

  template <class Number>
  std::vector<double> read_binary(const std::string& bytes, std::size_t n)
  {
    const bool is_old_word = m_array.endian.substr(0, 13) == "GIFTI_ENDIAN_"; // as written by some programs
    Byte_reader in(bytes, is_old_word ? is_second(m_array.endian, "GIFTI_ENDIAN_LITTLE", "GIFTI_ENDIAN_BIG")
                                      : is_second(m_array.endian, "LittleEndian", "BigEndian"));
    std::vector<double> numbers;
    for(numbers.reserve(n); numbers.size() < n;)
      numbers.push_back(static_cast<double>(in.read<Number>("an array")));
    return numbers;
  }

  template <class Number>
  std::vector<double> read_text(const std::string& text, std::size_t n)
  {
    using Limits = std::numeric_limits<Number>;
    if(n > text.size()) // before memory is allocated
      throw File_error("the text is too short for ", n, " numbers: ", truncated);
    add_numbers(n);
    Number_text words(text);
    std::vector<double> numbers;
    for(numbers.reserve(n); numbers.size() < n;)
    {
      const std::string_view word = words.next_word();
      double x = 0.;
      if(word.empty())
        throw File_error("there are ", numbers.size(), " numbers, but the dimensions say ", n, ": ", truncated);
      const bool is_number = words.is_number(word, x);
      const bool is_possible = std::is_floating_point_v<Number>
                                   ? !std::isfinite(x) || std::abs(x) <= static_cast<double>((Limits::max)())
                                   : x == std::floor(x) && x >= static_cast<double>((Limits::min)()) &&
                                         x <= static_cast<double>((Limits::max)());
      if(!is_number || !is_possible)
        throw File_error("number ", numbers.size(), " is ", in_quotes(word), ", which is none of the type ",
                         in_quotes(m_array.type), ": the file is damaged.");
      numbers.push_back(static_cast<double>(static_cast<Number>(x)));
    }
    if(const std::string_view word = words.next_word(); !word.empty())
      throw File_error("the text goes on after ", n, " numbers with ", in_quotes(word), ": the file is damaged.");
    return numbers;
  }

  std::vector<double> transposed(const std::vector<double>& numbers) const
  {
    const std::size_t n = m_array.rows(), n_columns = m_array.columns();
    std::vector<double> result;
    result.reserve(numbers.size());
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t k = 0; k < n_columns; ++k)
        result.push_back(numbers[k * n + i]);
    return result;
  }

  const Gifti_array& m_array;
  std::size_t m_file_size;
  std::size_t& m_unpacked_size; // bytes of the numbers of all arrays so far
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_GIFTI_DATA_H
