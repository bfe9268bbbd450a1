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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EDGE_SET_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EDGE_SET_H

#include <CGAL/license/Spherical_parameterization.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A set of edges, each a pair of different vertices in either order: a table in which what has its place taken goes to
// the next free one. Only asked whether it has an edge, so that its order never shows.
class Edge_set
{
public:
  // There may be more edges than expected.
  explicit Edge_set(std::size_t expected_size)
  {
    std::size_t size = least_size;
    while(size < 2 * expected_size)
      size *= 2;
    m_table.resize(size, none);
  }

  bool contains(std::uint32_t a, std::uint32_t b) const { return m_table[place_of(key_of(a, b))] != none; }

  void insert(std::uint32_t a, std::uint32_t b)
  {
    if(2 * (m_size + 1) > m_table.size())
      grow();
    const std::uint64_t key = key_of(a, b);
    std::uint64_t& place = m_table[place_of(key)];
    m_size += place == none;
    place = key;
  }

private:
  static constexpr std::uint64_t none = 0; // no edge leads from vertex 0 to itself
  static constexpr std::size_t least_size = 64;

  static std::uint64_t key_of(std::uint32_t a, std::uint32_t b)
  {
    return static_cast<std::uint64_t>((std::min)(a, b)) << 32 | (std::max)(a, b);
  }

  // where a key is, or would be
  std::size_t place_of(std::uint64_t key) const
  {
    const std::size_t mask = m_table.size() - 1;
    // The upper bits of the product depend on all bits of the key.
    std::size_t place = static_cast<std::size_t>(key * 0x9e3779b97f4a7c15u >> 20) & mask;
    while(m_table[place] != none && m_table[place] != key)
      place = (place + 1) & mask;
    return place;
  }

  void grow()
  {
    std::vector<std::uint64_t> old(2 * m_table.size(), none);
    old.swap(m_table);
    for(const std::uint64_t key : old)
      if(key != none)
        m_table[place_of(key)] = key;
  }

  std::vector<std::uint64_t> m_table; // its size is a power of two
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EDGE_SET_H
