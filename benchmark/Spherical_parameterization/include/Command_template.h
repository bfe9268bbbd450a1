// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_COMMAND_TEMPLATE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_COMMAND_TEMPLATE_H

#include <filesystem>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmarks {

// `text` as one word of the shell.
inline std::string quoted(const std::string& text)
{
  std::string result = "'";
  for(const char c : text)
  {
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return result + '\'';
}

// A command line of the shell with {input} and {output} in the place of the names of a mesh and of its map, or with
// {input.obj}, say, for a program that asks for a format.
class Command_template
{
public:
  // \throws std::invalid_argument if `text` lacks one of the two, or asks for two formats of one
  explicit Command_template(const std::string& text)
  {
    static const std::regex placeholder("\\{(input|output)(\\.\\w+)?\\}");

    std::map<std::string, std::string> formats;
    std::sregex_iterator match(text.begin(), text.end(), placeholder);
    for(; match != std::sregex_iterator(); ++match)
    {
      const std::string name = match->str(1), format = match->str(2);
      if(formats.emplace(name, format).first->second != format)
      {
        throw std::invalid_argument("two formats of its " + name + " are in the command: " + text);
      }
      m_parts.push_back({match->prefix(), name == "input"});
      m_end = match->suffix();
    }
    for(const char* name : {"input", "output"})
    {
      if(formats.count(name) == 0)
      {
        throw std::invalid_argument('{' + std::string(name) + "} has to be in the command: " + text);
      }
    }
    m_input_format = formats["input"];
    m_output_format = formats["output"];
  }

  // The extension that a file has to have, with its dot; empty if none is named.
  const std::string& input_format() const { return m_input_format; }
  const std::string& output_format() const { return m_output_format; }

  std::string command(const std::filesystem::path& input, const std::filesystem::path& output) const
  {
    std::string result;
    for(const Part& part : m_parts)
    {
      result += part.text_before + quoted((part.is_input ? input : output).string());
    }
    return result + m_end;
  }

private:
  // The name of a file, and what is between it and the one before.
  struct Part
  {
    std::string text_before;
    bool is_input;
  };

  std::vector<Part> m_parts;
  std::string m_end;
  std::string m_input_format, m_output_format;
};

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_COMMAND_TEMPLATE_H
