#include "text.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <new>
#include <sstream>
#include <system_error>

namespace Program {

std::string message_of(const std::exception& error)
{
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "the memory does not suffice" : error.what();
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

Words split_list(const std::string& names)
{
  std::error_code ignored;
  if(std::filesystem::exists(names, ignored))
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
  char* end = nullptr;
  x = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0';
}

std::string fixed_text(double x, int digits, bool is_fixed)
{
  std::ostringstream text;
  if(is_fixed)
    text << std::fixed;
  text << std::setprecision(digits) << x;
  return text.str();
}

} // namespace Program
