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

using Polygon = boost::container::small_vector<std::size_t, 3>; // a triangle needs no memory elsewhere

// A number of one of the types that files have, all of which a double can hold.
using File_number =
    std::variant<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t, float, double>;

// A property of the vertices, or of the faces, that is neither a coordinate nor the corners.
struct Property_values
{
  std::string name;
  File_number type; // in the file, by any number of that type
  std::vector<double> numbers;

  bool has_fractions() const { return std::holds_alternative<float>(type) || std::holds_alternative<double>(type); }
};

// What a mesh file holds, in the order of the file. All corners are indices of points. A file of values has neither.
struct Polygon_soup
{
  std::vector<Simple_cartesian<double>::Point_3> points;
  std::vector<Polygon> polygons;
  std::vector<Property_values> values_of_vertices, values_of_faces; // if they were asked for; their names are different
  std::vector<std::string> left_out;                                // in words, what there is beside them

  std::size_t number_of_vertices() const
  {
    return points.empty() && !values_of_vertices.empty() ? values_of_vertices.front().numbers.size() : points.size();
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_POLYGON_SOUP_H
