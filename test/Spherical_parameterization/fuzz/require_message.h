// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_REQUIRE_MESSAGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_REQUIRE_MESSAGE_H

#include "require.h"

#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <algorithm>
#include <cstddef>
#include <string>

// what a terminal shows as it is, and not too much of it
inline bool is_message(const std::string& text)
{
  constexpr std::size_t max_size = 700;
  return !text.empty() && text.size() <= max_size &&
         std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
}

// calls f(), which may refuse the file
template <class F>
void require_message_or_nothing(const F& f)
{
  try
  {
    f();
  }
  catch(const CGAL::Spherical_parameterization::internal::File_error& error)
  {
    require(is_message(error.what()), error.what());
  }
}

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_REQUIRE_MESSAGE_H
