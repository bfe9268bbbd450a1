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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_BASE64_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_BASE64_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL::Spherical_parameterization::internal {

constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// The digit that each character is, or 64.
inline std::array<std::uint8_t, 256> digits_of_characters()
{
  std::array<std::uint8_t, 256> result;
  result.fill(64);
  for(std::size_t k = 0; k < base64_digits.size(); ++k)
    result[static_cast<unsigned char>(base64_digits[k])] = static_cast<std::uint8_t>(k);
  return result;
}

// Returns the bytes behind a text in base 64, whose blanks and ends of lines are skipped.
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

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_BASE64_H
