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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERICAL_HARMONICS_FILES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERICAL_HARMONICS_FILES_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Harmonics/spherical_harmonics_files.h>
#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {
namespace internal {

inline std::ostringstream text_with_all_digits()
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  return text;
}

// Returns the degree for which there are `n` coefficients.
inline std::size_t degree_with(std::size_t n, const char* what)
{
  const auto size = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(n))));
  if(n == 0 || size * size != n)
    throw File_error("The file has ", n, " ", what,
                     ", but degrees up to L have (L + 1)^2: it is truncated, or no file of ", "spherical harmonics.");
  if(size - 1 > Spherical_harmonics_3::max_degree)
    throw File_error("The degree is ", size - 1, ", but at most ", Spherical_harmonics_3::max_degree, " is read.");
  return size - 1;
}

// Reads numbers and punctuation marks; errors state the line.
class Coef_parser
{
public:
  explicit Coef_parser(std::string_view text)
    : m_text(text)
  {}

  void expect(char sign)
  {
    skip_blanks();
    if(m_position == m_text.size())
      throw File_error("Line ", m_line, ": the file ends where '", sign, "' is expected: ", truncated);
    if(m_text[m_position] != sign)
      throw File_error("Line ", m_line, ": ", in_quotes(m_text.substr(m_position, 1)), " is where '", sign,
                       "' is expected: the file is damaged, or no .coef file of SPHARM-PDM.");
    ++m_position;
  }

  void expect_end()
  {
    skip_blanks();
    if(m_position < m_text.size())
      throw File_error("Line ", m_line, ": there is more behind the last coefficient: the file is damaged.");
  }

  double number()
  {
    skip_blanks();
    const std::size_t end = (std::min)(m_text.find_first_of(",{} \t\r\n", m_position), m_text.size());
    const std::string_view word = m_text.substr(m_position, end - m_position);
    if(word.empty() && end == m_text.size())
      throw File_error("Line ", m_line, ": the file ends where a number is expected: ", truncated);
    double result = 0.;
    if(!Number_text::is_number(word, result) || !std::isfinite(result))
      throw File_error("Line ", m_line, ": ", in_quotes(word), " is no finite number.");
    m_position = end;
    return result;
  }

private:
  void skip_blanks()
  {
    for(; m_position < m_text.size() && std::string_view(" \t\r\n").find(m_text[m_position]) != std::string_view::npos;
        ++m_position)
      if(m_text[m_position] == '\n')
        ++m_line;
  }

  std::string_view m_text;
  std::size_t m_position = 0, m_line = 1;
};

// Calls f(l, m, factor) for the coefficients in the order of SPHARM-PDM. A coefficient in the file is that of the real
// orthonormal harmonic times the factor, since the file has sqrt(2) times the real and imaginary parts of complex
// harmonics.
template <class Function>
void for_each_in_coef(std::size_t degree, const Function& f)
{
  for(std::size_t l = 0; l <= degree; ++l)
  {
    f(l, std::ptrdiff_t(0), 1.);
    for(std::ptrdiff_t m = 1; m <= static_cast<std::ptrdiff_t>(l); ++m)
    {
      f(l, m, std::sqrt(2.));
      f(l, -m, std::sqrt(2.));
    }
  }
}

inline void read_coef(const std::string& content, Spherical_harmonics_3& result, std::string&)
{
  Coef_parser in(content);
  in.expect('{');
  const double n = in.number();
  constexpr std::size_t min_size = 7; // bytes of a coefficient, {0,0,0}
  if(!(n >= 1. && n <= static_cast<double>(content.size() / min_size)) || n != std::floor(n))
    throw File_error("The file says that it has ", n,
                     " coefficients, and is too short for that, or it is no .coef file: ", truncated);
  const std::size_t degree = degree_with(static_cast<std::size_t>(n), "coefficients");
  result = Spherical_harmonics_3(3, degree, Harmonic_normalization::orthonormal, true);
  for_each_in_coef(degree, [&](std::size_t l, std::ptrdiff_t m, double factor) {
    in.expect(',');
    in.expect('{');
    for(std::size_t k = 0; k < 3; ++k)
    {
      if(k > 0)
        in.expect(',');
      result.set_coefficient(k, l, m, in.number() / factor);
    }
    in.expect('}');
  });
  in.expect('}');
  in.expect_end();
}

inline std::string coef_text(Spherical_harmonics_3 harmonics)
{
  harmonics.convert(Harmonic_normalization::orthonormal, true);
  std::ostringstream text = text_with_all_digits();
  text << "{ " << (harmonics.degree() + 1) * (harmonics.degree() + 1);
  for_each_in_coef(harmonics.degree(), [&](std::size_t l, std::ptrdiff_t m, double factor) {
    text << (l == 0 ? ",{" : ",\n{") << factor * harmonics.coefficient(0, l, m) << ", "
         << factor * harmonics.coefficient(1, l, m) << ", " << factor * harmonics.coefficient(2, l, m) << "}";
  });
  text << "}";
  return text.str();
}

inline constexpr std::pair<Harmonic_normalization, const char*> names_of_normalizations[] = {
    {Harmonic_normalization::four_pi, "4pi"},
    {Harmonic_normalization::orthonormal, "ortho"},
    {Harmonic_normalization::schmidt, "schmidt"}};

inline std::string table_text(const Spherical_harmonics_3& harmonics)
{
  const std::size_t n = harmonics.number_of_functions();
  std::ostringstream text = text_with_all_digits();
  text << "degree,order";
  for(std::size_t k = 0; k < n; ++k)
    if(n == 3)
      text << ',' << "xyz"[k];
    else
      text << ",f" << k + 1;
  text << ",normalization,csphase\n";
  const char* const word = names_of_normalizations[static_cast<std::size_t>(harmonics.normalization())].second;
  for(std::size_t l = 0; l <= harmonics.degree(); ++l)
    for(std::ptrdiff_t m = -static_cast<std::ptrdiff_t>(l); m <= static_cast<std::ptrdiff_t>(l); ++m)
    {
      text << l << ',' << m;
      for(std::size_t k = 0; k < n; ++k)
        text << ',' << harmonics.coefficient(k, l, m);
      text << ',' << word << ',' << (harmonics.has_phase() ? -1 : 1) << '\n';
    }
  return text.str();
}

// Returns the fields of a line, without quotes.
inline std::vector<std::string_view> fields_of(std::string_view line)
{
  std::vector<std::string_view> result;
  for(std::size_t begin = 0; begin <= line.size();)
  {
    const std::size_t end = (std::min)(line.find(',', begin), line.size());
    std::string_view field = line.substr(begin, end - begin);
    if(field.size() >= 2 && field.front() == '"' && field.back() == '"')
      field = field.substr(1, field.size() - 2);
    result.push_back(field);
    begin = end + 1;
  }
  return result;
}

inline void read_table(std::string_view content, Spherical_harmonics_3& result, std::string&)
{
  std::vector<std::string_view> lines;
  while(!content.empty())
  {
    const std::size_t end = (std::min)(content.find('\n'), content.size());
    std::string_view line = content.substr(0, end);
    content.remove_prefix((std::min)(end + 1, content.size()));
    if(!line.empty() && line.back() == '\r')
      line.remove_suffix(1);
    lines.push_back(line);
  }
  while(!lines.empty() && lines.back().empty())
    lines.pop_back();
  const std::vector<std::string_view> names = fields_of(lines.empty() ? std::string_view() : lines[0]);
  const std::size_t n_columns = names.size();
  if(n_columns < 5 || names[0] != "degree" || names[1] != "order" || names[n_columns - 2] != "normalization" ||
     names[n_columns - 1] != "csphase")
    throw File_error("Line 1: the columns have to be degree,order, one for each function, normalization,csphase.");
  const std::size_t degree = degree_with(lines.size() - 1, "lines of coefficients");
  const auto number = [&](std::size_t line, std::string_view field) {
    double x = 0.;
    if(!Number_text::is_number(field, x) || !std::isfinite(x))
      throw File_error("Line ", line + 1, ": ", in_quotes(field), " is no finite number.");
    return x;
  };
  std::vector<char> is_there(lines.size() - 1, 0);
  for(std::size_t i = 1; i < lines.size(); ++i)
  {
    const std::vector<std::string_view> fields = fields_of(lines[i]);
    if(fields.size() != n_columns)
      throw File_error("Line ", i + 1, ": there are ", fields.size(), " fields, but ", n_columns,
                       " names of columns: the file is damaged, or ", truncated);
    const std::string_view word = fields[n_columns - 2];
    const double phase = number(i, fields[n_columns - 1]);
    const auto* const found = std::find_if(std::begin(names_of_normalizations), std::end(names_of_normalizations),
                                           [&](const auto& normalization) { return word == normalization.second; });
    if(found == std::end(names_of_normalizations))
      throw File_error("Line ", i + 1, ": the normalization is ", in_quotes(word),
                       ", but 4pi, ortho and schmidt are read.");
    if(phase != 1. && phase != -1.)
      throw File_error("Line ", i + 1, ": csphase is ", phase,
                       "; it has to be 1, or -1 with the phase of Condon and Shortley.");
    if(i == 1)
      result = Spherical_harmonics_3(n_columns - 4, degree, found->first, phase < 0.);
    if(found->first != result.normalization() || (phase < 0.) != result.has_phase())
      throw File_error("Line ", i + 1, ": the normalization is another one than in line 2.");
    const double l = number(i, fields[0]), m = number(i, fields[1]);
    if(!(l >= 0. && l <= static_cast<double>(degree) && l == std::floor(l)) ||
       !(std::abs(m) <= l && m == std::floor(m)))
      throw File_error("Line ", i + 1, ": there is no degree ", l, " with the order ", m, " in a table of ",
                       lines.size() - 1, " lines.");
    char& is_known = is_there[static_cast<std::size_t>(l * l + l + m)];
    if(is_known)
      throw File_error("Line ", i + 1, ": the degree ", l, " with the order ", m, " was there before.");
    is_known = 1;
    for(std::size_t k = 0; k < n_columns - 4; ++k)
      result.set_coefficient(k, static_cast<std::size_t>(l), static_cast<std::ptrdiff_t>(m), number(i, fields[2 + k]));
  }
}

} // namespace internal

namespace IO {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_SPHARM_PDM(std::istream& in, Spherical_harmonics_3& harmonics,
                                                                  std::string& message)
{
  return internal::read_or_report(in, harmonics, message, internal::read_coef, ERROR_INVALID_HARMONICS_FILE);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code write_SPHARM_PDM(std::ostream& out,
                                                                   const Spherical_harmonics_3& harmonics)
{
  if(harmonics.number_of_functions() != 3)
    return ERROR_WRONG_PARAMETER;
  return internal::is_written(out, internal::coef_text(harmonics)) ? OK : ERROR_CANNOT_WRITE_FILE;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_harmonics_table(std::istream& in,
                                                                       Spherical_harmonics_3& harmonics,
                                                                       std::string& message)
{
  return internal::read_or_report(in, harmonics, message, internal::read_table, ERROR_INVALID_HARMONICS_FILE);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code write_harmonics_table(std::ostream& out,
                                                                        const Spherical_harmonics_3& harmonics)
{
  if(harmonics.number_of_functions() == 0)
    return ERROR_WRONG_PARAMETER;
  return internal::is_written(out, internal::table_text(harmonics)) ? OK : ERROR_CANNOT_WRITE_FILE;
}

} // namespace IO
} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERICAL_HARMONICS_FILES_IMPL_H
