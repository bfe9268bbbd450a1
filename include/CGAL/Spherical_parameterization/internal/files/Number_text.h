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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_NUMBER_TEXT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_NUMBER_TEXT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ios>
#include <limits>
#include <locale>
#include <sstream>
#include <string_view>

namespace CGAL::Spherical_parameterization::internal {

// Reads numbers from words between blanks, whatever the locale of the program is.
class Number_text
{
public:
  explicit Number_text(std::string_view text)
    : m_text(text)
  {
    m_format.imbue(std::locale::classic());
  }

  std::string_view next_word()
  {
    constexpr const char* blanks = " \t\r\n";
    const std::size_t begin = (std::min)(m_text.find_first_not_of(blanks, m_position), m_text.size());
    m_position = (std::min)(m_text.find_first_of(blanks, begin), m_text.size());
    return m_text.substr(begin, m_position - begin);
  }

  // returns whether the word is a number; nan and inf are some
  bool is_number(std::string_view word, double& x)
  {
    std::ios_base::iostate state = std::ios_base::goodbit;
    const char* const end = word.data() + word.size();
    if(m_parser.get(word.data(), end, m_format, state, x) == end && !word.empty())
      return (state & std::ios_base::failbit) == 0;
    const bool is_negative = !word.empty() && word.front() == '-';
    const std::string_view name = word.substr(!word.empty() && (is_negative || word.front() == '+') ? 1 : 0);
    if(is_word(name, "nan"))
      x = std::numeric_limits<double>::quiet_NaN();
    else if(is_word(name, "inf") || is_word(name, "infinity"))
      x = is_negative ? -HUGE_VAL : HUGE_VAL;
    else
      return false;
    return true;
  }

private:
  struct Parser : std::num_get<char, const char*>
  {
    ~Parser() override = default; // that of the base is protected
  };

  // regardless of case
  static bool is_word(std::string_view text, std::string_view word)
  {
    const auto is_same = [](char c, char d) { return (c | 0x20) == d; };
    return text.size() == word.size() && std::equal(text.begin(), text.end(), word.begin(), is_same);
  }

  std::string_view m_text;
  std::size_t m_position = 0;
  std::istringstream m_format; // but for its locale, none of it is used
  Parser m_parser;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_NUMBER_TEXT_H
