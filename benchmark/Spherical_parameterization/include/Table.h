// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_TABLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_TABLE_H

#include <cstddef>
#include <iomanip>
#include <ios>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace benchmarks {

// `value` with so many digits after the point, or a power of ten if it would be long nevertheless.
inline std::string to_text(double value, int digits)
{
  std::ostringstream text;
  text << (value < 1e7 ? std::fixed : std::scientific) << std::setprecision(digits) << value;
  return text.str();
}

// A table that is printed row by row as the rows come, in Markdown or as comma-separated values. The first columns are
// for names, the others are for numbers.
class Table
{
public:
  Table(std::ostream& out, std::vector<std::string> header, bool is_csv, std::size_t number_of_names = 1)
    : m_out(out)
    , m_header(std::move(header))
    , m_is_csv(is_csv)
    , m_number_of_names(number_of_names)
  {
    add_row(m_header);
    if(!m_is_csv)
    {
      for(std::size_t i = 0; i < m_header.size(); ++i)
      {
        m_out << '|' << (is_name(i) ? ':' : '-') << std::string(width(i), '-') << (is_name(i) ? '-' : ':');
      }
      m_out << '|' << std::endl;
    }
  }

  // Prints the cells of a row, and dashes for the missing ones at its end.
  void add_row(std::vector<std::string> cells)
  {
    cells.resize(m_header.size(), "-");
    for(std::size_t i = 0; i < cells.size(); ++i)
    {
      if(m_is_csv)
      {
        m_out << (i == 0 ? "" : ",");
        if(is_name(i))
        {
          m_out << std::quoted(cells[i], '"', '"');
        }
        else
        {
          m_out << cells[i];
        }
      }
      else
      {
        m_out << "| " << std::setw(static_cast<int>(width(i))) << (is_name(i) ? std::left : std::right) << cells[i]
              << ' ';
      }
    }
    m_out << (m_is_csv ? "" : "|") << std::endl;
  }

private:
  std::size_t width(std::size_t column) const
  {
    constexpr std::size_t width_of_names = 24;
    return is_name(column) ? width_of_names : m_header[column].size();
  }

  bool is_name(std::size_t column) const { return column < m_number_of_names; }

  std::ostream& m_out;
  std::vector<std::string> m_header;
  bool m_is_csv;
  std::size_t m_number_of_names;
};

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_TABLE_H
