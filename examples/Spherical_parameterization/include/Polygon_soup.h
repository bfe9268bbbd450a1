// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

namespace Program {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;

/// What a mesh file holds, in the order of the file.
struct Polygon_soup
{
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H
