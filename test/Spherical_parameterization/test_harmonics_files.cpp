// Files of coefficients: those of SPHARM-PDM as that program reads them, tables, and the messages on damaged ones.

#include "locale_of_commas.h"

#include <CGAL/Spherical_parameterization/Harmonics/spherical_harmonics_files.h>
#include <CGAL/Spherical_parameterization/Harmonics/reconstruct_from_spherical_harmonics.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

namespace {

namespace SP = CGAL::Spherical_parameterization;
using Direction_3 = CGAL::Simple_cartesian<double>::Point_3;

SP::Spherical_harmonics_3 numbered(std::size_t n_functions, std::size_t degree)
{
  SP::Spherical_harmonics_3 result(n_functions, degree);
  for(std::size_t k = 0; k < n_functions; ++k)
    for(std::size_t l = 0; l <= degree; ++l)
      for(std::ptrdiff_t m = -static_cast<std::ptrdiff_t>(l); m <= static_cast<std::ptrdiff_t>(l); ++m)
        result.set_coefficient(k, l, m, std::sin(1. + static_cast<double>(k + 10 * l) + 0.3 * static_cast<double>(m)));
  return result;
}

using Reader = SP::Error_code (*)(std::istream&, SP::Spherical_harmonics_3&, std::string&);

void expect_read(Reader read, const std::string& content, SP::Spherical_harmonics_3 expected)
{
  std::istringstream in(content);
  SP::Spherical_harmonics_3 result(1);
  std::string message = "none";
  ASSERT_EQ(read(in, result, message), SP::OK) << message;
  EXPECT_EQ(message, "");
  ASSERT_EQ(result.degree(), expected.degree());
  ASSERT_EQ(result.number_of_functions(), expected.number_of_functions());
  expected.convert(result.normalization(), result.has_phase());
  for(std::size_t k = 0; k < expected.number_of_functions(); ++k)
    for(std::size_t l = 0; l <= expected.degree(); ++l)
      for(std::ptrdiff_t m = -static_cast<std::ptrdiff_t>(l); m <= static_cast<std::ptrdiff_t>(l); ++m)
        EXPECT_NEAR(result.coefficient(k, l, m), expected.coefficient(k, l, m), 1e-15);
}

// Returns the message.
std::string refusal(Reader read, const std::string& content)
{
  std::istringstream in(content);
  SP::Spherical_harmonics_3 result(2, 7);
  std::string message;
  EXPECT_EQ(read(in, result, message), SP::ERROR_INVALID_HARMONICS_FILE) << content;
  EXPECT_EQ(result.degree(), 7u);
  EXPECT_NE(message, "");
  EXPECT_EQ(message.find('\n'), std::string::npos);
  return message;
}

template <class Write>
std::string text_of(const Write& write)
{
  std::ostringstream out;
  EXPECT_EQ(write(out), SP::OK);
  return out.str();
}

std::string coef_of(const SP::Spherical_harmonics_3& harmonics)
{
  return text_of([&](std::ostream& out) { return SP::IO::write_SPHARM_PDM(out, harmonics); });
}

std::string table_of(const SP::Spherical_harmonics_3& harmonics)
{
  return text_of([&](std::ostream& out) { return SP::IO::write_harmonics_table(out, harmonics); });
}

// What SPHARM-PDM takes coefficients for, with the polynomials written out: at the longitude p, the numbers {0, a, b} of an order m
// count as (a cos(m p) + b sin(m p)) sqrt((2 l + 1) / (4 pi) (l - m)! / (l + m)!) P_lm, with the phase of Condon and Shortley.
TEST(Coef_files, are_those_of_SPHARM_PDM)
{
  const std::string content =
      "{ 9,{1, 0, 0},\n{0, 2, 0},\n{0.5, 0, 0},\n{0, 0, -3},\n{0, 0, 0.25},\n{4, 0, 0},\n{0, 5, 0},\n"
      "{0, 0, 6},\n{0, 7, 0}}";
  std::istringstream in(content);
  SP::Spherical_harmonics_3 harmonics;
  std::string message;
  ASSERT_EQ(SP::IO::read_SPHARM_PDM(in, harmonics, message), SP::OK) << message;
  const double x = 0.48, y = -0.6, z = 0.64, pi = 3.14159265358979323846;
  std::vector<double> values;
  ASSERT_EQ(SP::evaluate_spherical_harmonics(harmonics, std::array<Direction_3, 1>{{{x, y, z}}}, values), SP::OK);
  const double n0 = std::sqrt(1. / (4. * pi)), n1 = std::sqrt(3. / (4. * pi)), n2 = std::sqrt(5. / (4. * pi));
  EXPECT_NEAR(values[0], n0 + 0.5 * -n1 * std::sqrt(0.5) * x + 4. * -3. * n2 * std::sqrt(1. / 6.) * x * z, 1e-14);
  EXPECT_NEAR(values[1],
              2. * n1 * z + 5. * -3. * n2 * std::sqrt(1. / 6.) * y * z +
                  7. * 3. * n2 * std::sqrt(1. / 24.) * 2. * x * y,
              1e-14);
  EXPECT_NEAR(values[2],
              -3. * -n1 * std::sqrt(0.5) * y + 0.25 * n2 * 0.5 * (3. * z * z - 1.) +
                  6. * 3. * n2 * std::sqrt(1. / 24.) * (x * x - y * y),
              1e-14);
}

TEST(Coef_files, are_read_as_they_were_written)
{
  for(const std::size_t degree : {0u, 1u, 7u})
    for(const bool has_phase : {false, true})
    {
      SP::Spherical_harmonics_3 harmonics = numbered(3, degree);
      expect_read(SP::IO::read_SPHARM_PDM, coef_of(harmonics), harmonics);
      harmonics.convert(SP::Harmonic_normalization::schmidt, has_phase);
      expect_read(SP::IO::read_SPHARM_PDM, coef_of(harmonics), harmonics);
    }
  std::ostringstream out;
  EXPECT_EQ(SP::IO::write_SPHARM_PDM(out, numbered(2, 3)), SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(SP::IO::write_harmonics_table(out, numbered(0, 3)), SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(out.str(), "");
  out.setstate(std::ios::badbit);
  EXPECT_EQ(SP::IO::write_SPHARM_PDM(out, numbered(3, 3)), SP::ERROR_CANNOT_WRITE_FILE);
}

TEST(Coef_files, that_are_cut_anywhere_are_refused)
{
  const std::string content = coef_of(numbered(3, 2));
  for(std::size_t n = 0; n < content.size(); ++n)
    refusal(SP::IO::read_SPHARM_PDM, content.substr(0, n));
}

// Whatever is in a file, it is read or refused.
TEST(Coef_files, with_any_bytes_come_to_an_end)
{
  std::mt19937 random(1);
  for(const Reader read : {Reader(SP::IO::read_SPHARM_PDM), Reader(SP::IO::read_harmonics_table)})
  {
    const std::string content = read == SP::IO::read_SPHARM_PDM ? coef_of(numbered(3, 2)) : table_of(numbered(2, 2));
    for(std::size_t k = 0; k < 2000; ++k)
    {
      std::string damaged = content;
      for(std::size_t i = 0; i < 1 + k % 3; ++i)
        damaged[random() % damaged.size()] = "{},-019.e\n \"\0x"[random() % 14];
      std::istringstream in(damaged);
      SP::Spherical_harmonics_3 result;
      std::string message;
      const SP::Error_code error = read(in, result, message);
      EXPECT_EQ(error == SP::OK, message.empty()) << damaged;
    }
  }
}

// Each with a part of what is reported.
void expect_refusals(Reader read, const std::vector<std::pair<std::string, const char*>>& table)
{
  for(const auto& [content, words] : table)
    EXPECT_NE(refusal(read, content).find(words), std::string::npos) << content;
}

TEST(Coef_files, are_refused_with_the_line)
{
  expect_refusals(SP::IO::read_SPHARM_PDM,
                  {{"degree,order,x,y,z,normalization,csphase\n0,0,1,2,3,4pi,1\n", "Line 1: 'd'"},
                   {"{ 3,{0,0,0},{0,0,0},{0,0,0}}", "(L + 1)^2"},
                   {"{ 4,{0,0,0},\n{0,0,0},\n{0,nan,0},\n{0,0,0}}", "Line 3: 'nan'"},
                   {"{ 1,{0,0}}", "','"},
                   {"{ 1,{0,0,0}} 1", "more"},
                   {"{ 1e300,{0,0,0}}", "coefficients"},
                   {"{ -4,{0,0,0}}", "coefficients"}});
}

TEST(Harmonics_tables, are_read_as_they_were_written)
{
  for(const std::size_t n_functions : {1u, 3u, 5u})
    for(const auto normalization : {SP::Harmonic_normalization::four_pi, SP::Harmonic_normalization::orthonormal,
                                    SP::Harmonic_normalization::schmidt})
      for(const bool has_phase : {false, true})
      {
        SP::Spherical_harmonics_3 harmonics = numbered(n_functions, 4);
        harmonics.convert(normalization, has_phase);
        expect_read(SP::IO::read_harmonics_table, table_of(harmonics), harmonics);
      }
}

// As R writes them: words are quoted, and rows may be sorted.
TEST(Harmonics_tables, are_those_of_other_programs)
{
  SP::Spherical_harmonics_3 expected(1, 1, SP::Harmonic_normalization::orthonormal, true);
  expected.set_coefficient(0, 1, -1, -2.5);
  expected.set_coefficient(0, 0, 0, 1.);
  expect_read(
      SP::IO::read_harmonics_table,
      "\"degree\",\"order\",\"f1\",\"normalization\",\"csphase\"\r\n1,1,0,\"ortho\",-1\r\n1,-1,-2.5,\"ortho\",-1\r\n"
      "1,0,0,\"ortho\",-1\r\n0,0,1,\"ortho\",-1\r\n",
      expected);
}

TEST(Harmonics_files, are_read_and_written_alike_in_every_locale)
{
  SP::Spherical_harmonics_3 harmonics = numbered(3, 31); // with 1024 coefficients, which a locale may group
  harmonics.set_coefficient(0, 0, 0, 1234.5);
  expect_same_with_commas([&] { return std::pair(coef_of(harmonics), table_of(harmonics)); });
  const std::string coef = coef_of(harmonics), table = table_of(harmonics);
  const Locale_of_commas commas;
  expect_read(SP::IO::read_SPHARM_PDM, coef, harmonics);
  expect_read(SP::IO::read_harmonics_table, table, harmonics);
}

TEST(Harmonics_tables, are_refused_with_the_line)
{
  const std::string names = "degree,order,f1,normalization,csphase\n",
                    rows = "0,0,1,4pi,1\n1,-1,2,4pi,1\n1,0,3,4pi,1\n";
  expect_refusals(SP::IO::read_harmonics_table, {{"", "Line 1"},
                                                 {coef_of(numbered(3, 1)), "Line 1"},
                                                 {names, "(L + 1)^2"},
                                                 {names + rows, "(L + 1)^2"},
                                                 {names + rows + "1,1,4,4pi", "Line 5"},
                                                 {names + rows + "1,0,4,4pi,1\n", "before"},
                                                 {names + rows + "1,2,4,4pi,1\n", "order 2"},
                                                 {names + rows + "1,1,4,unnorm,1\n", "'unnorm'"},
                                                 {names + rows + "1,1,4,ortho,1\n", "line 2"},
                                                 {names + rows + "1,1,4,4pi,-1\n", "line 2"},
                                                 {names + rows + "1,1,4,4pi,2\n", "csphase"},
                                                 {names + rows + "1,1,inf,4pi,1\n", "'inf'"},
                                                 {names + rows + "1,1,four,4pi,1\n", "'four'"}});
}

} // namespace
