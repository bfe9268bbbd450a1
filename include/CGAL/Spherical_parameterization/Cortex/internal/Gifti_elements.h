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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_GIFTI_ELEMENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_GIFTI_ELEMENTS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>
#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <expat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Returns a text without leading and trailing blanks.
inline std::string stripped(std::string_view text)
{
  constexpr const char* blanks = " \t\r\n";
  const std::size_t begin = (std::min)(text.find_first_not_of(blanks), text.size());
  return std::string(text.substr(begin, text.find_last_not_of(blanks) + 1 - begin));
}

// Returns the name of the first entity in the attributes of the current element that is not one of the five entities of
// XML, or an empty name. Expat skips such entities without a call if the file has a document type.
inline std::string undeclared_entity(XML_Parser parser)
{
  int begin = 0, size = 0;
  const char* const text = XML_GetInputContext(parser, &begin, &size);
  std::string tag = text == nullptr ? "" : std::string(text + begin, std::size_t(XML_GetCurrentByteCount(parser)));
  tag.erase(std::remove(tag.begin(), tag.end(), '\0'), tag.end()); // from 16-bit characters
  constexpr std::array<std::string_view, 5> known = {"lt", "gt", "amp", "quot", "apos"};
  for(std::size_t k = tag.find('&'); k < tag.size(); k = tag.find('&', k + 1))
  {
    const std::string name = tag.substr(k + 1, (std::min)(tag.find(';', k), tag.size()) - k - 1);
    if(name.substr(0, 1) != "#" && std::find(known.begin(), known.end(), name) == known.end())
      return name;
  }
  return "";
}

// Returns the value of an attribute of an element, or an empty text.
inline std::string attribute(const XML_Char* const* attributes, std::string_view name)
{
  for(; *attributes != nullptr; attributes += 2)
    if(attributes[0] == name)
      return attributes[1];
  return "";
}

// Returns the label with these attributes, without its name.
inline IO::Label label_of(const XML_Char* const* attributes)
{
  IO::Label label;
  std::string key = attribute(attributes, "Key");
  if(key.empty())
    key = attribute(attributes, "Index"); // the name used by some programs
  constexpr double max = (std::numeric_limits<std::int32_t>::max)();
  double x = 0.;
  if(!Number_text::is_number(key, x) || !(x == std::floor(x) && x >= -max && x <= max))
    throw File_error("the key of a label is ", in_quotes(key), ", which is not an integer: the file is damaged.");
  label.key = static_cast<std::int32_t>(x);
  label.color = {{0., 0., 0., 1.}};
  constexpr std::array<const char*, 4> names = {"Red", "Green", "Blue", "Alpha"};
  for(std::size_t k = 0; k < names.size(); ++k)
    if(const std::string text = attribute(attributes, names[k]);
       !text.empty() && !(Number_text::is_number(text, label.color[k]) && std::isfinite(label.color[k])))
      throw File_error("the color of a label is ", in_quotes(text), ", which is no number: the file is damaged.");
  return label;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_GIFTI_ELEMENTS_H
