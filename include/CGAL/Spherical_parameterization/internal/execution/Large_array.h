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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_LARGE_ARRAY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_LARGE_ARRAY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <boost/container/vector.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace CGAL::Spherical_parameterization::internal {

// Allocates arrays of some MiB in pages of 2 MiB, on Linux. The first accesses to pages of 4 KiB, which the allocator of
// the system usually requests for each array anew, took up to a fifth of the time of a map. Code with and without sanitizers
// must agree on the allocation, because it may be linked into one program.
template <class T>
class Huge_page_allocator
{
public:
  using value_type = T;

  Huge_page_allocator() = default;
  template <class U>
  Huge_page_allocator(const Huge_page_allocator<U>&)
  {}

  T* allocate(std::size_t n)
  {
#ifdef MADV_HUGEPAGE
    if(is_large(n))
      return static_cast<T*>(map(mapped_size(n)));
#endif
    return std::allocator<T>().allocate(n);
  }

  void deallocate(T* array, std::size_t n)
  {
#ifdef MADV_HUGEPAGE
    if(is_large(n))
    {
      munmap(array, mapped_size(n));
      return;
    }
#endif
    std::allocator<T>().deallocate(array, n);
  }

  friend bool operator==(const Huge_page_allocator&, const Huge_page_allocator&)
  {
    return true;
  }
  friend bool operator!=(const Huge_page_allocator&, const Huge_page_allocator&)
  {
    return false;
  }

private:
#ifdef MADV_HUGEPAGE
  // The alignment of huge pages, and a multiple of the size of other pages.
  static constexpr std::size_t huge_page = std::size_t(1) << 21, pages = std::size_t(1) << 16;

  static bool is_large(std::size_t n)
  {
    return n * sizeof(T) >= huge_page;
  }
  static std::size_t mapped_size(std::size_t n)
  {
    return (n * sizeof(T) + pages - 1) / pages * pages;
  }

  static void* map(std::size_t size)
  {
    void* const mapped = mmap(nullptr, size + huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if(mapped == MAP_FAILED)
      throw std::bad_alloc();
    char* const begin = static_cast<char*>(mapped);
    const std::size_t n_before = huge_page - 1 - (reinterpret_cast<std::uintptr_t>(begin) - 1) % huge_page;
    char* const array = begin + n_before;
    if(n_before > 0)
      munmap(begin, n_before);
    munmap(array + size, huge_page - n_before);
    madvise(array, size, MADV_HUGEPAGE); // without huge pages, it only takes longer
    return array;
  }
#endif
};

// An array that may be resized without initializing its elements, by boost::container::default_init.
template <class T>
using Large_array = boost::container::vector<T, Huge_page_allocator<T>>;

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_LARGE_ARRAY_H
