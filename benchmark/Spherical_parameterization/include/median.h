// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MEDIAN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MEDIAN_H

#include <algorithm>
#include <vector>

namespace benchmarks {

// The median of `values`, of which there is at least one.
inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MEDIAN_H
