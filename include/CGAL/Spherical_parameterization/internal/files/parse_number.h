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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_PARSE_NUMBER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_PARSE_NUMBER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>

// The function of g++ 11 reports the smallest numbers as errors.
#if defined(__cpp_lib_to_chars) && !(defined(_GLIBCXX_RELEASE) && _GLIBCXX_RELEASE < 12)
#define CGAL_SPHERICAL_PARAMETERIZATION_HAS_FROM_CHARS
#else
#include <cerrno>
#include <cstdlib>
#include <locale.h>
#ifdef __APPLE__
#include <xlocale.h>
#endif
#endif

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A number at the beginning of a text.
template <class Number>
struct Parsed_number
{
  Number value{};
  std::size_t size = 0;      // of its text, with the blanks before it; 0 if there is none
  bool is_too_large = false; // for the type
};

// Returns where a number begins, after blanks and a plus sign, which std::from_chars() does not skip.
inline const char* begin_of_number(const char* begin, const char* end)
{
  while(begin != end && (*begin == ' ' || (*begin >= '\t' && *begin <= '\r')))
    ++begin;
  return end - begin > 1 && begin[0] == '+' && begin[1] != '-' ? begin + 1 : begin;
}

// Replaces std::strtoll(), independently of the locale of the program.
inline Parsed_number<long long> parse_integer(std::string_view text)
{
  const char* const end = text.data() + text.size();
  Parsed_number<long long> number;
  const auto [rest, error] = std::from_chars(begin_of_number(text.data(), end), end, number.value);
  if(error != std::errc::invalid_argument)
    number.size = static_cast<std::size_t>(rest - text.data());
  number.is_too_large = error == std::errc::result_out_of_range;
  return number;
}

// Replaces std::strtod(), independently of the locale of the program: nan, inf and hexadecimal numbers are valid;
// underflow gives 0.
inline Parsed_number<double> parse_number(std::string_view text)
{
  Parsed_number<double> number;
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_FROM_CHARS
  const char *const end = text.data() + text.size(), *const begin = begin_of_number(text.data(), end);
  const bool is_negative = begin != end && *begin == '-';
  const char* digits = begin + (is_negative ? 1 : 0);
  constexpr std::string_view hexadecimal = ".0123456789abcdefABCDEF";
  const bool has_prefix = end - digits > 2 && digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X') &&
                          hexadecimal.find(digits[2]) != hexadecimal.npos;
  std::from_chars_result result{begin, std::errc::invalid_argument};
  if(has_prefix)
  {
    result = std::from_chars(digits + 2, end, number.value, std::chars_format::hex);
    number.value = is_negative ? -number.value : number.value;
  }
  const bool is_hexadecimal = has_prefix && result.ec != std::errc::invalid_argument;
  if(!is_hexadecimal)
    result = std::from_chars(begin, end, number.value);
  if(result.ec == std::errc::result_out_of_range)
  {
    // The number is about b^k, where k is the exponent plus the position of the point after the first digit.
    if(is_hexadecimal)
      digits += 2;
    const std::string_view word(digits, static_cast<std::size_t>(result.ptr - digits));
    const std::size_t mark = (std::min)(word.find_first_of(is_hexadecimal ? "pP" : "eE"), word.size());
    const std::string_view mantissa = word.substr(0, mark);
    const auto first = static_cast<long long>((std::min)(mantissa.find_first_not_of("0."), mantissa.size()));
    const auto point = static_cast<long long>((std::min)(mantissa.find('.'), mantissa.size()));
    const Parsed_number<long long> exponent = parse_integer(word.substr((std::min)(mark + 1, word.size())));
    const bool has_huge_negative_exponent = exponent.is_too_large && word[mark + 1] == '-';
    number.is_too_large = exponent.is_too_large ? !has_huge_negative_exponent
                                                : (point - first) * (is_hexadecimal ? 4 : 1) + exponent.value > 0;
    number.value = std::copysign(number.is_too_large ? HUGE_VAL : 0., is_negative ? -1. : 1.);
  }
  if(result.ec != std::errc::invalid_argument)
    number.size = static_cast<std::size_t>(result.ptr - text.data());
#else
  static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", locale_t());
  constexpr const char* blanks = " \t\n\v\f\r";
  const std::size_t begin = (std::min)(text.find_first_not_of(blanks), text.size());
  const std::string word(text.substr(begin, (std::min)(text.find_first_of(blanks, begin), text.size()) - begin));
  char* end = nullptr;
  errno = 0;
  number.value = strtod_l(word.c_str(), &end, c_locale);
  number.is_too_large = errno == ERANGE && std::abs(number.value) > 1.;
  if(end != word.c_str())
    number.size = begin + static_cast<std::size_t>(end - word.c_str());
#endif
  return number;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_PARSE_NUMBER_H
