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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_POLYGON_SOUP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_POLYGON_SOUP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

using Polygon = boost::container::small_vector<std::size_t, 3>; // a triangle needs no heap memory

// A number of a type that occurs in files, all of which are representable by double.
using File_number =
    std::variant<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t, float, double>;

// A property of the vertices, or of the faces, other than coordinates and corners.
struct Property_values
{
  std::string name;
  File_number type; // in the file, as any number of that type
  std::vector<double> numbers;

  bool has_fractions() const { return std::holds_alternative<float>(type) || std::holds_alternative<double>(type); }
};

// The content of a mesh file, in the order of the file. All corners are indices of points. A file of values has
// neither.
struct Polygon_soup
{
  std::vector<Simple_cartesian<double>::Point_3> points;
  std::vector<Polygon> polygons;
  std::vector<Property_values> values_of_vertices, values_of_faces; // if requested; their names are different
  std::vector<std::string> left_out;                                // a description of the data that were skipped

  std::size_t number_of_vertices() const
  {
    return points.empty() && !values_of_vertices.empty() ? values_of_vertices.front().numbers.size() : points.size();
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_POLYGON_SOUP_H
