// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WORD_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WORD_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace Program {

/// A word of the command line, and what it stands for. Each option that takes one has an array of them.
template <class Value>
struct Word
{
  const char* name;
  Value value;
};

/// returns the first of `words` that stands for `value`, one of theirs.
template <class Value, std::size_t n>
const char* name_of(const std::array<Word<Value>, n>& words, Value value)
{
  std::size_t i = 0;
  while(words[i].value != value)
    ++i;
  return words[i].name;
}

/// returns whether `name` is one of `words`.
template <class Value, std::size_t n>
bool is_among(const std::string& name, const std::array<Word<Value>, n>& words)
{
  return std::any_of(words.begin(), words.end(), [&](const Word<Value>& word) { return name == word.name; });
}

/// returns "a, b or c", with another word for "or" if wanted.
inline std::string list_of(const std::vector<std::string>& names, const std::string& last_separator = " or ")
{
  std::string list;
  for(std::size_t i = 0; i < names.size(); ++i)
    list += (i == 0 ? "" : (i + 1 < names.size() ? ", " : last_separator)) + names[i];
  return list;
}

template <class Value, std::size_t n>
std::string list_of(const std::array<Word<Value>, n>& words)
{
  std::vector<std::string> names;
  for(const Word<Value>& word : words)
    names.push_back(word.name);
  return list_of(names);
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WORD_H
