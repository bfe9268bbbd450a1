#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_LOCALE_OF_COMMAS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_LOCALE_OF_COMMAS_H

#include "standard_library.h"

#include <gtest/gtest.h>

#include <clocale>
#include <iostream>
#include <locale>

// As long as it lives, numbers are 1.234,5 for streams, as in Germany; and for the functions of C, where such a locale is
// installed or can be made.
class Locale_of_commas
{
public:
  Locale_of_commas()
    : m_previous(std::locale::global(std::locale(std::locale::classic(), new Commas)))
  {
#ifdef _WIN32
    std::setlocale(LC_ALL, "German_Germany");
#else
    static const bool is_installed = std::setlocale(LC_ALL, name) != nullptr;
    static const std::string folder = is_installed ? "" : make_locale();
    if(!folder.empty())
      setenv("LOCPATH", folder.c_str(), 1); // where setlocale() of glibc looks
    std::setlocale(LC_ALL, name);
    if(!folder.empty())
      unsetenv("LOCPATH");
#endif
  }

  ~Locale_of_commas()
  {
    std::locale::global(m_previous);
    std::setlocale(LC_ALL, "C");
  }

  Locale_of_commas(const Locale_of_commas&) = delete;
  Locale_of_commas& operator=(const Locale_of_commas&) = delete;

private:
#ifndef _WIN32
  static constexpr const char* name = "de_DE.ISO-8859-1";

  // returns a folder with the locale, which is the same for all tests
  static std::string make_locale()
  {
    const std::filesystem::path folder = std::filesystem::absolute("locales");
    const std::string made = (folder / name).string(), command = "localedef -i de_DE -f ISO-8859-1 '" + made + "'";
    std::filesystem::create_directories(folder);
    if(!std::filesystem::exists(made))
      std::cerr << "Makes a locale of commas: " << std::system(command.c_str()) << std::endl;
    return folder.string();
  }
#endif

  struct Commas : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };

  std::locale m_previous;
};

// What is read or written is the same in such a locale.
template <class Function>
void expect_same_with_commas(const Function& function)
{
  const auto expected = function();
  const Locale_of_commas commas;
  EXPECT_EQ(function(), expected);
}

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_LOCALE_OF_COMMAS_H
