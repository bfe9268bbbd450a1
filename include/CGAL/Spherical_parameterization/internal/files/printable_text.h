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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_PRINTABLE_TEXT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_PRINTABLE_TEXT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <boost/locale/utf.hpp>

#include <cstdio>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

// Returns a text with `\xHH` for each byte that is not UTF-8: the name of a file may contain any bytes, JSON may not.
// Newlines and other control characters, which may move the cursor of a terminal or hide text, are escaped as well
// unless `keeps_controls`.
inline std::string valid_utf8(const std::string& text, bool keeps_controls = true)
{
  using Utf8 = boost::locale::utf::utf_traits<char>;
  constexpr boost::locale::utf::code_point first_printable = 0x20, first_above_ascii = 0x7f, last_control = 0x9f;
  std::string result;
  const char* const end = text.data() + text.size();
  for(const char *c = text.data(), *next = c; c != end; c = next)
  {
    const boost::locale::utf::code_point code = Utf8::decode(next, end);
    const bool is_valid = boost::locale::utf::is_valid_codepoint(code);
    const bool is_control = code < first_printable || (code >= first_above_ascii && code <= last_control);
    if(!is_valid)
      next = c + 1;
    if(is_valid && (keeps_controls || !is_control))
      result.append(c, next);
    else
      for(; c != next; ++c)
      {
        char escape[8];
        std::snprintf(escape, sizeof escape, "\\x%02x", static_cast<unsigned int>(static_cast<unsigned char>(*c)));
        result += escape;
      }
  }
  return result;
}

// Returns the name of a file for a terminal or a log: in one line, without control characters.
inline std::string printable(const std::string& name)
{
  return valid_utf8(name, false);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_PRINTABLE_TEXT_H
