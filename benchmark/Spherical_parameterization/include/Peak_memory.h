// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_PEAK_MEMORY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_PEAK_MEMORY_H

#include <fstream>
#include <limits>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace benchmarks {

// The physical memory that the calling process has at most, beyond what it has when this object is made. The code of a
// program, which is read when it is first needed and is there once for all processes, does not count, not even what is
// read after the peak. Only Linux tells.
class Peak_memory
{
public:
  Peak_memory()
  {
    // What the allocator keeps of released memory would be used again without a trace.
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    std::ofstream("/proc/self/clear_refs") << 5; // the peak starts anew
    m_first_bytes = read_bytes("VmRSS:");
    m_first_bytes_of_files = read_bytes("RssFile:");
  }

  // In bytes; NaN where the system does not tell.
  double bytes() const
  {
    return read_bytes("VmHWM:") - m_first_bytes - (read_bytes("RssFile:") - m_first_bytes_of_files);
  }

private:
  static double read_bytes(const std::string& field)
  {
    std::ifstream status("/proc/self/status");
    std::string word;
    double kilobytes;
    while(status >> word)
    {
      if(word == field && status >> kilobytes)
      {
        return 1024. * kilobytes;
      }
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  double m_first_bytes, m_first_bytes_of_files;
};

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_PEAK_MEMORY_H
