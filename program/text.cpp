#include "text.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <locale>
#include <new>
#include <numeric>
#include <sstream>
#include <system_error>

namespace Program {

std::filesystem::path path_of(const std::string& name)
{
#ifndef _WIN32
  return name;
#elif defined(__cpp_char8_t)
  return std::u8string(name.begin(), name.end());
#else
  return std::filesystem::u8path(name);
#endif
}

std::string name_of(const std::filesystem::path& path)
{
#ifdef _WIN32
  const auto name = path.generic_u8string();
  return std::string(name.begin(), name.end());
#else
  return path.string();
#endif
}

std::string message_of(const std::exception& error)
{
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "not enough memory" : error.what();
}

bool is_among(const std::string& word, const Words& words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string list_of(const Words& words, const std::string& last_separator)
{
  std::string list;
  for(std::size_t i = 0; i < words.size(); ++i)
    list += (i == 0 ? "" : (i + 1 < words.size() ? ", " : last_separator)) + words[i];
  return list;
}

std::string nearest_of(const std::string& word, const Words& candidates)
{
  std::string nearest;
  std::size_t least = (std::min)(std::size_t(3), word.size());
  for(const std::string& candidate : candidates)
  {
    std::vector<std::size_t> row(candidate.size() + 1); // distances of the beginnings of the candidate
    std::iota(row.begin(), row.end(), std::size_t(0));
    for(const char c : word)
      for(std::size_t j = 1, diagonal = row[0]++; j < row.size(); ++j)
      {
        const std::size_t above = row[j];
        row[j] = (std::min)({above + 1, row[j - 1] + 1, diagonal + (candidate[j - 1] == c ? 0 : 1)});
        diagonal = above;
      }
    if(row.back() < least)
    {
      least = row.back();
      nearest = candidate;
    }
  }
  return nearest;
}

Words split_list(const std::string& names)
{
  std::error_code ignored;
  if(std::filesystem::exists(path_of(names), ignored))
    return {names};
  Words result;
  for(std::size_t begin = 0; begin <= names.size();)
  {
    const std::size_t end = (std::min)(names.find(',', begin), names.size());
    result.push_back(names.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

bool is_number(const std::string& text, double& x)
{
  const SP::internal::Parsed_number<double> number = SP::internal::parse_number(text);
  x = number.value;
  return !text.empty() && number.size == text.size();
}

std::string fixed_text(double x, int digits, bool is_fixed)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  if(is_fixed)
    text << std::fixed;
  text << std::setprecision(digits) << x;
  return text.str();
}

} // namespace Program
