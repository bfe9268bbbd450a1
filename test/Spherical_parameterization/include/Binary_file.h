#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BINARY_FILE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BINARY_FILE_H

#include "standard_library.h"

// The bytes of a number, the most significant one first or last.
template <class Bits, class Number>
std::string bytes_of(Number number, bool is_big_endian)
{
  static_assert(sizeof(Bits) == sizeof(Number), "The bits are those of the number.");
  Bits bits;
  std::memcpy(&bits, &number, sizeof(bits));
  std::string result;
  for(std::size_t k = 0; k < sizeof(bits); ++k)
    result += static_cast<char>(bits >> 8 * (is_big_endian ? sizeof(bits) - 1 - k : k) & 0xff);
  return result;
}

// A binary PLY or STL file.
struct Binary_file
{
  explicit Binary_file(bool is_big)
    : is_big_endian(is_big)
  {}

  Binary_file& operator<<(const std::string& text) { return content += text, *this; }
  Binary_file& operator<<(float x) { return content += bytes_of<std::uint32_t>(x, is_big_endian), *this; }
  Binary_file& operator<<(double x) { return content += bytes_of<std::uint64_t>(x, is_big_endian), *this; }
  Binary_file& operator<<(std::uint8_t x) { return content += static_cast<char>(x), *this; }
  Binary_file& operator<<(std::int16_t x) { return content += bytes_of<std::uint16_t>(x, is_big_endian), *this; }
  Binary_file& operator<<(std::uint32_t x) { return content += bytes_of<std::uint32_t>(x, is_big_endian), *this; }

  bool is_big_endian;
  std::string content;
};

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BINARY_FILE_H
