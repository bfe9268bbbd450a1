// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BINARY_SCANNER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BINARY_SCANNER_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace Program {

/// Reads numbers from bytes, whatever the order of the bytes here and there.
class Binary_scanner
{
public:
  /// reads `bytes`, in which the first byte of a number is the most significant one if `is_big_endian`.
  Binary_scanner(std::string_view bytes, bool is_big_endian)
    : m_bytes(bytes)
    , m_is_big_endian(is_big_endian)
  {}

  /// returns the number of bytes that are left.
  std::size_t size() const { return m_bytes.size(); }

  /// reads a number, and returns whether there were enough bytes.
  template <class Number>
  bool read(Number& number)
  {
    constexpr std::size_t n = sizeof(Number);
    using Bits = std::conditional_t<
        n == 1, std::uint8_t,
        std::conditional_t<n == 2, std::uint16_t, std::conditional_t<n == 4, std::uint32_t, std::uint64_t>>>;
    static_assert(sizeof(Bits) == n, "A number has 1, 2, 4 or 8 bytes.");
    if(m_bytes.size() < n)
      return false;
    std::uint64_t bits = 0;
    for(std::size_t k = 0; k < n; ++k)
      bits = bits << 8 | static_cast<unsigned char>(m_bytes[m_is_big_endian ? k : n - 1 - k]);
    const Bits narrow = static_cast<Bits>(bits);
    std::memcpy(&number, &narrow, n);
    m_bytes.remove_prefix(n);
    return true;
  }

private:
  std::string_view m_bytes;
  bool m_is_big_endian;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BINARY_SCANNER_H
